// Spread of the mass of a neighbourhood: sums over the neighbours of a row, of which the particle
// itself is none, however often it fills the row up to whole packs.
//
// The sums are found again one pair at a time: V_j, V_j r and V_j r r^T with r = x_j - x_i over all
// j of the row, and V_i. They are of at most eight numbers of one size, so 1e-14 of the largest is
// twenty roundings.
#include "sph/spread.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "sample.hpp"

namespace brunt {
namespace {

template <int Dim>
std::vector<MotionRecord<Dim>> neighbourhood(std::size_t n) {
  using Record = MotionRecord<Dim>;
  std::mt19937_64 random(7);
  std::vector<Record> records(n);
  for (auto& record : records) {
    for (int d = 0; d < Dim; ++d) {
      record.data[d] = test::kDp * (static_cast<Real>(random() >> 11) * 0x1p-53 - 0.5);
    }
    record.data[Record::kInverse] = 1 / (1.7 * test::kDp);
    record.data[Record::kVolume] = std::pow(test::kDp, Dim) * (1 + 0.01 * (&record - &records[0]));
  }
  return records;
}

template <int Dim>
SpreadSums<Dim> by_pairs(const std::vector<MotionRecord<Dim>>& motion, std::size_t n) {
  constexpr int volume = MotionRecord<Dim>::kVolume;
  const Real* own = motion[0].data;
  SpreadSums<Dim> sums{own[volume], Vec<Dim>::Zero(), Eigen::Matrix<Real, Dim, Dim>::Zero()};
  for (std::size_t j = 1; j <= n; ++j) {
    Vec<Dim> arm;
    for (int d = 0; d < Dim; ++d) arm[d] = motion[j].data[d] - own[d];
    sums.total += motion[j].data[volume];
    sums.first += motion[j].data[volume] * arm;
    sums.second += motion[j].data[volume] * arm * arm.transpose();
  }
  return sums;
}

/// All neighbours are within half a support.
template <int Dim, class Kernel>
void expect_sums_of_neighbours() {
  constexpr LocalIndex own = 0;
  const auto motion = neighbourhood<Dim>(9);
  for (LocalIndex n = 1; n <= 8; ++n) {
    std::vector<LocalIndex> row;
    for (LocalIndex j = 1; j <= n; ++j) row.push_back(j);
    while (row.size() % 8 != 0) row.push_back(own);
    const auto sums = spread_sums<Dim, Kernel>(motion.data(), own, row);
    const auto right = by_pairs<Dim>(motion, static_cast<std::size_t>(n));
    const Real volume = 9 * std::pow(test::kDp, Dim), length = test::kDp;
    EXPECT_NEAR(sums.total, right.total, 1e-14 * volume) << n;
    EXPECT_LT((sums.first - right.first).norm(), 1e-14 * volume * length) << n;
    EXPECT_LT((sums.second - right.second).norm(), 1e-14 * volume * length * length) << n;
  }
}

TEST(Spread, CountsNoParticleThatFillsItsOwnRow) {
  expect_sums_of_neighbours<2, CubicKernel>();
  expect_sums_of_neighbours<3, CubicKernel>();
  expect_sums_of_neighbours<2, QuadraticKernel>();
  expect_sums_of_neighbours<3, QuadraticKernel>();
  expect_sums_of_neighbours<3, HyperbolicKernel>();
  expect_sums_of_neighbours<3, WendlandC2Kernel>();
  expect_sums_of_neighbours<2, WendlandC4Kernel>();
}

}  // namespace
}  // namespace brunt
