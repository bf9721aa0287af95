#include "core/parallel/partition.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/parallel/boxes.hpp"

namespace brunt {
namespace {

/// Zoltan starts MPI; this ends it.
const ParallelSession& session() {
  static int argc = 0;
  static char** argv = nullptr;
  static const ParallelSession one(argc, argv);
  return one;
}

struct Cloud {
  std::vector<Vec3> x;
  std::vector<Real> weight;
};

/// A bar along z, five times as long as wide.
Cloud bar(std::size_t n) {
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> unit(0, 1);
  Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    cloud.x.emplace_back(unit(random), unit(random), 5 * unit(random));
    cloud.weight.push_back(1 + static_cast<Real>(i % 5));
  }
  return cloud;
}

TEST(Partition, ForMoreRanksThanThereAreSpreadsTheWeight) {
  const auto& ranks = session().ranks();
  const Cloud cloud = bar(4000);
  for (const int parts : {1, 2, 3, 7, 64}) {
    const Partition partition = make_partition<3>(ranks, cloud.x, cloud.weight, parts);
    std::vector<Real> weight(static_cast<std::size_t>(parts), 0.0);
    Real sum = 0;
    for (std::size_t i = 0; i < cloud.x.size(); ++i) {
      weight.at(static_cast<std::size_t>(partition.of(i))) += cloud.weight[i];
      sum += cloud.weight[i];
    }
    // Zoltan is asked for 1 %; each of at most log2(64) cuts may be off by the heaviest point.
    for (const Real one : weight) EXPECT_NEAR(one, sum / parts, 0.01 * sum / parts + 6 * 5);
  }
}

// Fewer points with weight than parts: each has a part of its own, and the other parts nothing.
TEST(Partition, OfFewerPointsThanPartsLeavesPartsEmpty) {
  Cloud cloud = bar(3);
  cloud.x.emplace_back(0.5, 0.5, 2.5), cloud.weight.push_back(0);
  const Partition partition = make_partition<3>(session().ranks(), cloud.x, cloud.weight, 5);
  std::set<int> owners;
  for (GlobalId i = 0; i < 3; ++i) owners.insert(partition.of(i));
  EXPECT_EQ(owners.size(), 3U);
  EXPECT_EQ(owners.count(partition.of(3)), 1U);
}

TEST(Partition, FirstCutGoesAcrossTheLongestSide) {
  const Cloud cloud = bar(1000);
  const Partition partition = make_partition<3>(session().ranks(), cloud.x, cloud.weight, 2);
  Real highest_of_low = 0, lowest_of_high = 5;
  const int low = partition.of(static_cast<GlobalId>(
      std::min_element(cloud.x.begin(), cloud.x.end(),
                       [](const Vec3& a, const Vec3& b) { return a[2] < b[2]; }) -
      cloud.x.begin()));
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    if (partition.of(i) == low) highest_of_low = std::max(highest_of_low, cloud.x[i][2]);
    if (partition.of(i) != low) lowest_of_high = std::min(lowest_of_high, cloud.x[i][2]);
  }
  EXPECT_LT(highest_of_low, lowest_of_high);
}

TEST(Partition, PointsWithoutWeightShapeNoPart) {
  const Cloud cloud = bar(1000);
  Cloud with_wall = cloud;
  for (const Real x : {-20.0, 20.0}) {
    for (const Real z : {-0.1, 4.9}) {
      with_wall.x.emplace_back(x, x, z);
      with_wall.weight.push_back(0);
    }
  }
  const Partition plain = make_partition<3>(session().ranks(), cloud.x, cloud.weight, 4);
  const Partition partition =
      make_partition<3>(session().ranks(), with_wall.x, with_wall.weight, 4);
  ASSERT_EQ(partition.owner.size(), plain.owner.size() + 4);
  EXPECT_TRUE(std::equal(plain.owner.begin(), plain.owner.end(), partition.owner.begin()));
  // At the ends of the bar, where four parts lie one behind the other.
  const auto end = [&](bool high) {
    const auto less = [&](const Vec3& a, const Vec3& b) { return high != (a[2] < b[2]); };
    const auto at = std::min_element(cloud.x.begin(), cloud.x.end(), less) - cloud.x.begin();
    return partition.of(static_cast<GlobalId>(at));
  };
  EXPECT_EQ(partition.of(1000), end(false));
  EXPECT_EQ(partition.of(1001), end(true));
  EXPECT_EQ(partition.of(1002), end(false));
  EXPECT_EQ(partition.of(1003), end(true));
}

TEST(Boxes, RunsHoldAllAndMeetWhatOverlaps) {
  std::vector<SearchBox<2>> boxes;
  for (int i = 0; i < 1000; ++i) boxes.push_back({{1.0 * i, 0}, {i + 0.5, 1}});
  const auto runs = runs_of<2>(boxes);
  ASSERT_EQ(runs.size(), 128U);
  EXPECT_EQ(meeting<2>(boxes, runs).size(), boxes.size());
  const std::vector<SearchBox<2>> other = {{{2.6, 0}, {2.9, 1}}, {{3.5, 1}, {4.0, 2}}};
  EXPECT_EQ(meeting<2>(boxes, other), (std::vector<LocalIndex>{3, 4}));
  EXPECT_TRUE(meeting<2>(boxes, {}).empty());
  EXPECT_TRUE(runs_of<2>({}).empty());
}

}  // namespace
}  // namespace brunt
