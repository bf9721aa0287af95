// Work that is shared among threads is done once each, on a team, alone, and within a team.
#include "core/parallel/threads.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace brunt {
namespace {

/// Gives the team its threads back.
struct WithThreads {
  explicit WithThreads(int threads) : before(omp_get_max_threads()) {
    omp_set_num_threads(threads);
  }
  ~WithThreads() { omp_set_num_threads(before); }
  int before;
};

TEST(Threads, ForEachVisitsAllOnce) {
  for (const int threads : {1, 2, 3}) {
    const WithThreads with(threads);
    for (const int n : {0, 1, 10, 11, 1000}) {
      std::vector<int> visits(static_cast<std::size_t>(n), 0);
      for_each(n, 10, [&](int i) { ++visits[static_cast<std::size_t>(i)]; });
      EXPECT_EQ(visits, std::vector<int>(visits.size(), 1)) << threads << " threads, " << n;
    }
  }
}

TEST(Threads, AnyScheduleSharesTheWork) {
  for (const int threads : {1, 2}) {
    for (const bool is_worth : {false, true}) {
      const WithThreads with(threads);
      std::vector<int> visits(1000, 0);
      int teams = 0;
      on_threads(is_worth, [&] {
#pragma omp atomic
        ++teams;
#pragma omp for schedule(dynamic, 1)
        for (std::size_t i = 0; i < visits.size(); ++i) ++visits[i];
      });
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), 0), 1000);
      EXPECT_EQ(teams, is_worth ? threads : 1);
    }
  }
}

// Each thread of a team that asks for work of its own does all of it.
TEST(Threads, WithinATeamEachDoesItsOwn) {
  const WithThreads with(2);
  int wrong = 0;
  on_threads(true, [&] {
    std::vector<int> visits(100, 0);
    for_each(visits.size(), 10, [&](std::size_t i) { ++visits[i]; });
#pragma omp critical
    wrong += visits != std::vector<int>(100, 1);
  });
  EXPECT_EQ(wrong, 0);
}

}  // namespace
}  // namespace brunt
