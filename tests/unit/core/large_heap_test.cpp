// Large blocks stand side by side. What was given back is handed out again, the smallest range that
// does, and never is there more at once than what was in use at once before, but for parts of large
// pages: the pages that are there are counted in /proc/self/statm, of which the process has a few
// beside.
#include "core/large_heap.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

namespace brunt {
namespace {

constexpr std::size_t kMiB = std::size_t{1} << 20;

struct Taken {
  char* at;
  std::size_t bytes;
};

Taken take(LargeHeap& heap, std::size_t bytes) {
  std::size_t given = bytes;
  char* const at = static_cast<char*>(heap.take(given));
  EXPECT_NE(at, nullptr);
  EXPECT_GE(given, bytes);
  EXPECT_LT(given, bytes + LargeHeap::kPage);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(at) % LargeHeap::kPage, 0U);
  std::memset(at, 1, given);
  return {at, given};
}

void give(LargeHeap& heap, const Taken& taken) { heap.give_back(taken.at, taken.bytes); }

/// Not asked where a sanitizer has memory of its own.
[[maybe_unused]] std::size_t resident() {
  std::size_t all = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> all >> pages;
  return pages * 4096;
}

TEST(LargeHeap, BlocksStandSideBySide) {
  LargeHeap heap;
  const Taken first = take(heap, 3 * kMiB), second = take(heap, kMiB / 2 + 1);
  const Taken third = take(heap, 4 * kMiB);
  EXPECT_EQ(second.at + second.bytes, first.at);
  EXPECT_EQ(third.at + third.bytes, second.at);
  for (const Taken& one : {first, second, third}) give(heap, one);
}

TEST(LargeHeap, WhatIsGivenBackIsHandedOutAgain) {
  LargeHeap heap;
  heap.keep(true);
  const Taken first = take(heap, 10 * kMiB);
  give(heap, first);
  EXPECT_GE(heap.kept(), 10 * kMiB);
  const Taken part = take(heap, 5 * kMiB), rest = take(heap, 5 * kMiB);
  for (const Taken& one : {part, rest}) {
    EXPECT_GE(one.at, first.at);
    EXPECT_LE(one.at + one.bytes, first.at + first.bytes);
  }
  EXPECT_LE(heap.kept(), LargeHeap::kLargePage);
  give(heap, part), give(heap, rest);
  heap.keep(false);
  EXPECT_LE(heap.kept(), 2 * LargeHeap::kLargePage);
}

TEST(LargeHeap, TheSmallestRangeOfMemoryThatDoesIsTaken) {
  LargeHeap heap;
  heap.keep(true);
  const Taken large = take(heap, 24 * kMiB), wall = take(heap, kMiB);
  const Taken fits = take(heap, 20 * kMiB), other_wall = take(heap, kMiB);
  const Taken small = take(heap, 18 * kMiB), last_wall = take(heap, kMiB);
  for (const Taken& one : {large, fits, small}) give(heap, one);
  EXPECT_EQ(take(heap, 19 * kMiB).at, fits.at + kMiB);
  EXPECT_EQ(take(heap, 21 * kMiB).at, large.at + 3 * kMiB);
  EXPECT_EQ(take(heap, 18 * kMiB).at, small.at);
  for (const Taken& one : {wall, other_wall, last_wall}) EXPECT_EQ(*one.at, 1);
}

TEST(LargeHeap, NeighboursThatAreGivenBackBecomeOneRange) {
  LargeHeap heap;
  heap.keep(true);
  std::vector<Taken> some;
  for (int k = 0; k < 8; ++k) some.push_back(take(heap, 3 * kMiB));
  for (const int k : {1, 3, 5, 0, 7, 2, 6, 4}) give(heap, some[static_cast<std::size_t>(k)]);
  EXPECT_EQ(take(heap, 24 * kMiB).at, some.back().at);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(LargeHeap, NeverMoreAtOnceThanWasInUse) {
  LargeHeap heap;
  heap.keep(true);
  const std::size_t before = resident();
  const Taken some = take(heap, 80 * kMiB), wall = take(heap, kMiB), more = take(heap, 120 * kMiB);
  give(heap, some), give(heap, more);
  EXPECT_GE(heap.kept(), 200 * kMiB);
  const Taken other = take(heap, 160 * kMiB);  // neither holds as much
  EXPECT_LE(heap.kept() + other.bytes, 201 * kMiB + 3 * LargeHeap::kLargePage);
  EXPECT_LE(resident(), before + 201 * kMiB + 4 * LargeHeap::kLargePage);
  give(heap, other), give(heap, wall);
}

TEST(LargeHeap, WhatIsNotKeptGoesBackToTheSystem) {
  LargeHeap heap;
  const std::size_t before = resident();
  for (int k = 0; k < 200; ++k) {  // as frames of a long run
    const Taken some = take(heap, 41 * kMiB), more = take(heap, 33 * kMiB);
    give(heap, k % 2 == 0 ? some : more), give(heap, k % 2 == 0 ? more : some);
  }
  EXPECT_LE(resident(), before + 4 * LargeHeap::kLargePage);
  EXPECT_LE(heap.kept(), 2 * LargeHeap::kLargePage);
}
#endif

/// Bytes of a block tell whose it is: none is handed out twice, and none loses what is in it.
TEST(LargeHeap, BlocksKeepWhatIsInThemAndNeverOverlap) {
  std::mt19937 random(3);
  LargeHeap heap;
  struct Marked {
    Taken taken;
    char mark;
  };
  std::vector<Marked> live;
  const auto is_whole = [](const Marked& one) {
    return std::all_of(one.taken.at, one.taken.at + one.taken.bytes,
                       [&](char c) { return c == one.mark; });
  };
  for (int k = 0; k < 1500; ++k) {
    if (k % 100 == 0) heap.keep(random() % 2 == 0);
    if (live.size() < 30 && random() % 5 < 3) {
      const auto mark = static_cast<char>(k);
      live.push_back({take(heap, 1 + random() % (k % 7 == 0 ? 9 * kMiB : kMiB)), mark});
      std::memset(live.back().taken.at, mark, live.back().taken.bytes);
    } else if (!live.empty()) {
      std::swap(live[random() % live.size()], live.back());
      ASSERT_TRUE(is_whole(live.back()));
      give(heap, live.back().taken);
      live.pop_back();
    }
  }
  for (const Marked& one : live) {
    EXPECT_TRUE(is_whole(one));
    give(heap, one.taken);
  }
}

TEST(LargeHeap, ThreadsTakeTurns) {
  LargeHeap heap;
  heap.keep(true);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&heap, t] {
      std::mt19937 random(static_cast<unsigned>(t));
      for (int k = 0; k < 200; ++k) {
        const Taken one = take(heap, 1 + random() % kMiB);
        std::memset(one.at, t, one.bytes);
        EXPECT_TRUE(std::all_of(one.at, one.at + one.bytes, [t](char c) { return c == t; }));
        give(heap, one);
      }
    });
  }
  for (auto& thread : threads) thread.join();
}

/// More ranges than the heap can list: what comes back then is not lost, but goes to the system.
TEST(LargeHeap, ManyRangesAreNoHarm) {
  LargeHeap heap;
  heap.keep(true);
  std::vector<Taken> some;
  for (int k = 0; k < 3000; ++k) some.push_back(take(heap, LargeHeap::kPage));
  for (std::size_t k = 0; k < some.size(); k += 2) give(heap, some[k]);
  for (std::size_t k = 1; k < some.size(); k += 2) EXPECT_EQ(*some[k].at, 1);
  const Taken large = take(heap, kMiB);
  give(heap, large);
  for (std::size_t k = 1; k < some.size(); k += 2) give(heap, some[k]);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(LargeHeap, SaysThatTheSystemHasNoRoom) {
  LargeHeap heap;
  std::size_t bytes = std::size_t{1} << 61;
  EXPECT_EQ(heap.take(bytes), nullptr);
  // Where addresses are limited, what is asked for is had as long as there is room for it alone.
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  std::size_t all = 0, pages = 0;
  std::ifstream("/proc/self/statm") >> all >> pages;
  const rlimit tight{all * 4096 + 7 * kMiB, before.rlim_max};
  setrlimit(RLIMIT_AS, &tight);
  bytes = 3 * kMiB;
  void* const at = heap.take(bytes);
  std::size_t more = 64 * kMiB;
  void* const beyond = heap.take(more);
  setrlimit(RLIMIT_AS, &before);
  EXPECT_NE(at, nullptr);
  EXPECT_EQ(beyond, nullptr);
}
#endif

}  // namespace
}  // namespace brunt
