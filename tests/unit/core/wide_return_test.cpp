/// Eight points at a time return to the yield surface with the bits of one: tiles of points at
/// random, some elastic, some melted, some far beyond their yield stress, by every law that has a
/// version of eight lanes, against RadialReturn of one Real at a time.
#include "core/materials/wide_return.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "core/wide_lanes.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr StrengthInputs kInputs{46e9, 8960.0 * 383, 0.9};

OneTile points_at_random(unsigned seed) {
  OneTile points(full_state(298));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> digit(-1, 1);
  for (std::size_t i = 0; i < kTile; ++i) {
    const Real strain = std::pow(10, -3 + 2 * digit(random));
    for (std::size_t c = 0; c < 6; ++c) {
      points.tile.strain[c][i] = strain * digit(random);
      points.state.deviator[c][i] = (c < 2 ? 1e8 : 0) * digit(random);
    }
    points.state.deviator[2][i] = -points.state.deviator[0][i] - points.state.deviator[1][i];
    points.state.eps_p[i] = i % 3 == 0 ? 0 : std::pow(10, -2 + 2 * digit(random));
    points.state.temperature[i] = i % 7 == 0 ? 1400 : 700 + 600 * digit(random);
    points.tile.ratio[i] = 1 + 0.01 * digit(random);
  }
  points.tile.adiabatic = true;
  return points;
}

template <class Law>
void expect_bits_of_a_real(const Law& law) {
  if constexpr (FlowLaw<Law>) {
    const auto wide = make_wide_strength(law, kInputs);
    ASSERT_NE(wide, nullptr);
    const RadialReturn<Law, Real> one(law, kInputs);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      OneTile eights = points_at_random(seed), ones = points_at_random(seed);
      for (int step = 0; step < 5; ++step) {
        wide->update(eights.at_first(), 1e-7);
        one.update(ones.at_first(), 1e-7);
      }
      const auto expect_same = [](const std::vector<Real>& a, const std::vector<Real>& b) {
        for (std::size_t i = 0; i < kTile; ++i) {
          EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i]));
        }
      };
      for (std::size_t c = 0; c < 6; ++c) {
        expect_same(eights.state.deviator[c], ones.state.deviator[c]);
      }
      expect_same(eights.state.eps_p, ones.state.eps_p);
      expect_same(eights.state.temperature, ones.state.temperature);
      expect_same(eights.state.heat, ones.state.heat);
    }
  } else {
    EXPECT_EQ(make_wide_strength(law, kInputs), nullptr);
  }
}

TEST(WideReturn, HasTheBitsOfAReal) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  J2 j2;
  j2.yield = 2e8;
  expect_bits_of_a_real(j2);
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025, law.m = 1.09, law.T_melt = 1356;
  expect_bits_of_a_real(law);
  expect_bits_of_a_real(NoStrength{});
}

}  // namespace
}  // namespace brunt
