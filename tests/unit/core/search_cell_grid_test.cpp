// The grid's promises: every entity stands in one cell or in the oversize list; two entities no
// further apart, by component, than the larger of their extents lie in linked cells; memory goes
// with the number of entities and not with the domain.
#include "core/search/cell_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace brunt {
namespace {

bool holds(std::span<const LocalIndex> list, LocalIndex value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

struct Sample {
  std::vector<Vec<2>> x;
  std::vector<Real> extent;
};

Sample graded_sample(int n) {
  std::mt19937 random(11);
  std::uniform_real_distribution<Real> unit(0, 1);
  Sample s;
  for (int i = 0; i < n; ++i) {
    s.x.emplace_back(unit(random), unit(random));
    s.extent.push_back(0.002 * std::pow(100.0, unit(random)));
  }
  return s;
}

std::vector<LocalIndex> cell_of_each(const CellGrid<2>& grid, std::size_t n) {
  std::vector<LocalIndex> cell_of(n, -1);
  for (LocalIndex cell = 0; cell < grid.n_cells(); ++cell) {
    EXPECT_TRUE(std::is_sorted(grid.members(cell).begin(), grid.members(cell).end()));
    for (const LocalIndex i : grid.members(cell)) {
      EXPECT_EQ(cell_of[i], -1);
      cell_of[i] = cell;
    }
  }
  return cell_of;
}

TEST(CellGrid, LinksTheCellsOfAllThatMayMeet) {
  const Sample s = graded_sample(1500);
  const CellGrid<2> grid(s.x, s.extent);
  const auto cell_of = cell_of_each(grid, s.x.size());
  for (LocalIndex i = 0; i < 1500; ++i) {
    ASSERT_NE(cell_of[i] >= 0, holds(grid.oversize(), i));
    for (LocalIndex j = 0; j < 1500 && cell_of[i] >= 0; ++j) {
      const Real apart = (s.x[i] - s.x[j]).cwiseAbs().maxCoeff();
      if (cell_of[j] < 0 || apart > std::max(s.extent[i], s.extent[j])) continue;
      EXPECT_TRUE(holds(grid.forward(cell_of[i]), cell_of[j]) ||
                  holds(grid.backward(cell_of[i]), cell_of[j]));
    }
  }
}

TEST(CellGrid, NamesEachLinkOnce) {
  const Sample s = graded_sample(1500);
  const CellGrid<2> grid(s.x, s.extent);
  for (LocalIndex cell = 0; cell < grid.n_cells(); ++cell) {
    EXPECT_EQ(grid.forward(cell)[0], cell);
    for (const LocalIndex other : grid.forward(cell)) {
      EXPECT_EQ(std::count(grid.forward(cell).begin(), grid.forward(cell).end(), other), 1);
      EXPECT_FALSE(other != cell && holds(grid.forward(other), cell));
    }
  }
}

TEST(CellGrid, FewOfASizeGoToTheOversizeList) {
  // 31 entities 1000 times as large as 2000 others: one short of a level of their own.
  Sample s = graded_sample(2000);
  std::fill(s.extent.begin(), s.extent.end(), 0.01);
  std::fill(s.extent.begin(), s.extent.begin() + 31, 10.0);
  EXPECT_EQ(CellGrid<2>(s.x, s.extent).oversize().size(), 31u);
  s.extent[31] = 10.0;
  EXPECT_EQ(CellGrid<2>(s.x, s.extent).oversize().size(), 0u);
}

TEST(CellGrid, FarEntityAddsOneCell) {
  Sample s = graded_sample(2000);
  std::fill(s.extent.begin(), s.extent.end(), 0.01);
  const LocalIndex before = CellGrid<2>(s.x, s.extent).n_cells();
  s.x.emplace_back(1e9, -1e9);
  s.extent.push_back(0.01);
  const CellGrid<2> grid(s.x, s.extent);
  EXPECT_EQ(grid.n_cells(), before + 1);
  EXPECT_TRUE(grid.oversize().empty());
}

}  // namespace
}  // namespace brunt
