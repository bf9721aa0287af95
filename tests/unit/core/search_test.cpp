// The grid must give what brute force gives, entry for entry. Both decide by the same expression,
// so the comparison is exact; what can go wrong is a cell that is not looked at.
#include "core/search/search.hpp"

#include <gtest/gtest.h>

#include <omp.h>
#include <set>

#include <algorithm>
#include <cmath>
#include <random>

namespace brunt {
namespace {

template <int Dim>
struct Cloud {
  std::vector<Vec<Dim>> x;
  std::vector<Real> reach;
  std::vector<Label> label;

  void add(const Vec<Dim>& at, Real r, Label l = 0) {
    x.push_back(at);
    reach.push_back(r);
    label.push_back(l);
  }
  LocalIndex size() const { return static_cast<LocalIndex>(x.size()); }
  NeighbourList find(Real skin, SearchMode mode) const { return find(skin, mode, size()); }
  NeighbourList find(Real skin, SearchMode mode, LocalIndex n_rows) const {
    return shared_neighbours<Dim>(x, reach, label, skin, n_rows, 1, mode).list;
  }
};

template <int Dim>
Cloud<Dim> random_cloud(int n, Real smallest, Real largest, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> unit(-0.5, 0.5);
  Cloud<Dim> cloud;
  for (int i = 0; i < n; ++i) {
    Vec<Dim> at;
    for (int c = 0; c < Dim; ++c) at[c] = unit(random);
    const Real grade = std::pow(largest / smallest, unit(random) + 0.5);
    cloud.add(at, smallest * grade, static_cast<Label>(random() % 3 == 0));
  }
  return cloud;
}

/// Rows of up to eight of one label: what each of them needs, and themselves; in the order of the
/// first of them.
template <int Dim>
void expect_shared_as_brute(const Cloud<Dim>& cloud, Real skin, const NeighbourList& brute) {
  const auto n_rows = static_cast<LocalIndex>(brute.offset.size() - 1);
  const auto shared =
      shared_neighbours<Dim>(cloud.x, cloud.reach, cloud.label, skin, n_rows, 8, SearchMode::grid);
  ASSERT_EQ(shared.row_of.size(), slot_of(n_rows));
  std::size_t n_points = 0;
  LocalIndex before = -1;
  for (std::size_t row = 0; row < shared.n_rows(); ++row) {
    const auto members = shared.points_of(row);
    ASSERT_TRUE(!members.empty() && members.size() <= 8);
    std::set<LocalIndex> needed;
    for (const LocalIndex i : members) {
      EXPECT_EQ(slot_of(shared.row_of[slot_of(i)]), row);
      EXPECT_EQ(cloud.label[slot_of(i)], cloud.label[slot_of(members.front())]);
      if (members.size() > 1) needed.insert(i);
      const auto begin = brute.neighbour.begin();
      needed.insert(begin + brute.offset[slot_of(i)], begin + brute.offset[slot_of(i) + 1]);
    }
    EXPECT_TRUE(std::ranges::equal(shared.neighbours_of(row), needed));
    const LocalIndex first = *std::ranges::min_element(members);
    EXPECT_GT(first, before);
    before = first, n_points += members.size();
  }
  EXPECT_EQ(n_points, slot_of(n_rows));
}

template <int Dim>
void expect_as_brute(const Cloud<Dim>& cloud, Real skin) {
  for (const LocalIndex n_rows : {cloud.size(), cloud.size() / 3, 0}) {
    const NeighbourList grid = cloud.find(skin, SearchMode::grid, n_rows);
    const NeighbourList brute = cloud.find(skin, SearchMode::brute, n_rows);
    EXPECT_EQ(grid.offset, brute.offset);
    EXPECT_EQ(grid.neighbour, brute.neighbour);
    EXPECT_EQ(grid.offset.size(), static_cast<std::size_t>(n_rows) + 1);
    expect_shared_as_brute(cloud, skin, brute);
  }
}

template <int Dim>
std::vector<SearchBox<Dim>> boxes_of(const Cloud<Dim>& cloud) {
  std::vector<SearchBox<Dim>> boxes(cloud.x.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (int c = 0; c < Dim; ++c) {
      boxes[i].lo[c] = cloud.x[i][c] - cloud.reach[i];
      boxes[i].hi[c] = cloud.x[i][c] + cloud.reach[i];
    }
  }
  return boxes;
}

template <int Dim>
std::size_t expect_pairs_as_brute(const std::vector<SearchBox<Dim>>& boxes) {
  const auto admits = [](LocalIndex i, LocalIndex j) { return (i + j) % 5 != 0; };
  const auto grid = overlapping_pairs<Dim>(boxes, admits, SearchMode::grid);
  const auto brute = overlapping_pairs<Dim>(boxes, admits, SearchMode::brute);
  EXPECT_EQ(grid, brute);
  EXPECT_TRUE(std::is_sorted(grid.begin(), grid.end()));
  return grid.size();
}

template <typename D>
class Search : public testing::Test {};
using Dims = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(Search, Dims);

TYPED_TEST(Search, EqualSizesAsBrute) {
  const auto cloud = random_cloud<TypeParam::value>(3000, 0.03, 0.03, 1);
  expect_as_brute(cloud, 0.0);
  expect_as_brute(cloud, 0.01);
  EXPECT_GT(expect_pairs_as_brute<TypeParam::value>(boxes_of(cloud)), 1000u);
}

TYPED_TEST(Search, SizesGradedOneToThousandAsBrute) {
  const auto cloud = random_cloud<TypeParam::value>(3000, 0.0003, 0.3, 2);
  expect_as_brute(cloud, 0.0);
  expect_as_brute(cloud, 0.002);
  EXPECT_GT(expect_pairs_as_brute<TypeParam::value>(boxes_of(cloud)), 1000u);
}

TYPED_TEST(Search, FewLargeAmongManySmallAsBrute) {
  auto cloud = random_cloud<TypeParam::value>(2000, 0.01, 0.012, 3);
  const auto large = random_cloud<TypeParam::value>(5, 0.3, 20, 4);
  for (std::size_t i = 0; i < large.x.size(); ++i) cloud.add(large.x[i], large.reach[i]);
  expect_as_brute(cloud, 0.001);
  expect_pairs_as_brute<TypeParam::value>(boxes_of(cloud));
}

TYPED_TEST(Search, StretchedFacesAsBrute) {
  constexpr int kDim = TypeParam::value;
  auto boxes = boxes_of(random_cloud<kDim>(2000, 0.03, 0.03, 5));
  for (std::size_t i = 0; i < boxes.size(); i += 20) boxes[i].hi[i % kDim] += 60;  // x 1000
  EXPECT_GT(expect_pairs_as_brute<kDim>(boxes), 1000u);
  for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i].hi[i % kDim] += 60;
  expect_pairs_as_brute<kDim>(boxes);
}

TYPED_TEST(Search, FarPointsAsBrute) {
  constexpr int kDim = TypeParam::value;
  auto cloud = random_cloud<kDim>(1000, 0.02, 0.02, 6);
  const auto apart = [](Real first, Real all) -> Vec<kDim> {
    Vec<kDim> at = Vec<kDim>::Constant(all);
    at[0] += first;
    return at;
  };
  for (const Real far : {1e6, 1e9, -1e9, 1e15, 1e200}) {
    cloud.add(apart(0, far), 0.02);
    cloud.add(apart(0.03, far), 0.02);
  }
  expect_as_brute(cloud, 0.005);
  expect_pairs_as_brute<kDim>(boxes_of(cloud));
  // All of it far away: spacing of doubles there is 1.2e-7 m.
  for (auto& x : cloud.x) x[0] += 1e9;
  expect_as_brute(cloud, 0.005);
  expect_pairs_as_brute<kDim>(boxes_of(cloud));
}

TYPED_TEST(Search, LatticePointsOnTheEdgeOfReachAsBrute) {
  // Distances are multiples of 0.1 up to rounding, the reach is one of them: every pair at that
  // distance is decided by the last bit.
  constexpr int kDim = TypeParam::value;
  Cloud<kDim> cloud;
  for (int i = 0; i < 1000; ++i) {
    Vec<kDim> at;
    for (int c = 0, rest = i; c < kDim; ++c, rest /= 10) at[c] = 0.1 * (rest % 10);
    if (kDim == 2) at[1] += 0.1 * 10 * (i / 100);
    cloud.add(at, 0.1);
  }
  expect_as_brute(cloud, 0.0);
  expect_pairs_as_brute<kDim>(boxes_of(cloud));
}

TYPED_TEST(Search, CoincidentPointsAreNeighboursOfOneAnother) {
  // 50 points at one place: each has the 49 others, with no reach at all and with some.
  constexpr int kDim = TypeParam::value;
  for (const Real reach : {0.0, 1.0}) {
    Cloud<kDim> cloud;
    for (int i = 0; i < 50; ++i) cloud.add(Vec<kDim>::Constant(0.3), reach);
    expect_as_brute(cloud, 0.0);
    EXPECT_EQ(cloud.find(0.0, SearchMode::grid).neighbour.size(), 50u * 49u);
    expect_pairs_as_brute<kDim>(boxes_of(cloud));
  }
}

TYPED_TEST(Search, NothingAndOnePoint) {
  constexpr int kDim = TypeParam::value;
  Cloud<kDim> cloud;
  expect_as_brute(cloud, 0.1);
  EXPECT_EQ(expect_pairs_as_brute<kDim>({}), 0u);
  cloud.add(Vec<kDim>::Zero(), 1.0);
  expect_as_brute(cloud, 0.1);
  EXPECT_EQ(expect_pairs_as_brute<kDim>(boxes_of(cloud)), 0u);
}

TYPED_TEST(Search, BoxesThatAreNoneOverlapAsInBrute) {
  constexpr int kDim = TypeParam::value;
  auto boxes = boxes_of(random_cloud<kDim>(500, 0.02, 0.03, 7));
  std::swap(boxes[10].lo, boxes[10].hi);
  boxes[20].lo[0] = std::nan("");
  boxes[30].lo.fill(-kInfinity);
  boxes[30].hi.fill(kInfinity);
  expect_pairs_as_brute<kDim>(boxes);
}

TYPED_TEST(Search, OneAndTwoThreadsGiveTheSame) {
  constexpr int kDim = TypeParam::value;
  const auto cloud = random_cloud<kDim>(20000, 0.01, 0.05, 8);
  const auto boxes = boxes_of(cloud);
  const auto any = [](LocalIndex, LocalIndex) { return true; };
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto list_1 = cloud.find(0.0, SearchMode::grid);
  const auto pairs_1 = overlapping_pairs<kDim>(boxes, any, SearchMode::grid);
  omp_set_num_threads(2);
  const auto list_2 = cloud.find(0.0, SearchMode::grid);
  const auto pairs_2 = overlapping_pairs<kDim>(boxes, any, SearchMode::grid);
  omp_set_num_threads(before);
  EXPECT_EQ(list_1.neighbour, list_2.neighbour);
  EXPECT_EQ(list_1.offset, list_2.offset);
  EXPECT_EQ(pairs_1, pairs_2);
}

TEST(SearchSmall, NamesTheNeighboursOfThreePoints) {
  // At 0, 1 and 2.5 with reach 0.5 each and skin 0.25: 0-1 (1 <= 1.25) alone; with skin 0.5 also
  // 1-2 (1.5 <= 1.5); another label ends a pair.
  Cloud<2> cloud;
  for (const Real at : {0.0, 1.0, 2.5}) cloud.add({at, 0}, 0.5);
  EXPECT_EQ(cloud.find(0.25, SearchMode::grid).neighbour, (std::vector<LocalIndex>{1, 0}));
  EXPECT_EQ(cloud.find(0.5, SearchMode::grid).neighbour, (std::vector<LocalIndex>{1, 0, 2, 1}));
  cloud.label[0] = 7;
  EXPECT_EQ(cloud.find(0.5, SearchMode::grid).neighbour, (std::vector<LocalIndex>{2, 1}));
}

TEST(SearchSmall, AsksTheMaskWithTheSmallerIndexFirst) {
  const std::vector<SearchBox<2>> boxes(40, SearchBox<2>{{0, 0}, {1, 1}});
  bool ordered = true;
  const auto admits = [&](LocalIndex i, LocalIndex j) {
    if (i >= j) ordered = false;
    return i == 3;
  };
  const auto pairs = overlapping_pairs<2>(boxes, admits, SearchMode::grid);
  EXPECT_TRUE(ordered);
  EXPECT_EQ(pairs.size(), 36u);  // 3 with 4 ... 39
}

}  // namespace
}  // namespace brunt
