// Eight particles of a tile at a time have the bits of four. Gradients from small to beyond the
// largest of a step, stresses in tension and in compression, with and without correction and
// artificial stress: every number that a tile publishes agrees bit for bit.
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "sph/tile_passes.hpp"

namespace brunt {
namespace {

/// A tile that is thrown at random, with the state of its points.
template <int Dim>
struct RandomTile {
  Real deviator[6][kTile] = {}, pressure[kTile] = {}, bulk[kTile] = {};
  TileStress<Dim> stress = {};
  MaterialTile tile = {};

  explicit RandomTile(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<Real> even(-1, 1);
    for (int k = 0; k < kTile; ++k) {
      const Real size = std::pow(10.0, 3 * even(random) - 2.5);
      for (auto& row : stress.gradient) row[k] = size * even(random);
      for (auto& row : stress.correction) row[k] = even(random);
      for (auto& row : stress.moment) row[k] = even(random);
      for (auto& row : deviator) row[k] = k % 7 == 0 ? 0.0 : 1e8 * even(random);
      pressure[k] = 3e8 * even(random), bulk[k] = 1e11 * (2 + even(random));
      tile.ratio_old[k] = 1 + 0.3 * even(random);
    }
  }
  TilePoints points() {
    TilePoints all{{}, pressure, bulk, 8960, 4.6e10};
    for (int c = 0; c < 6; ++c) all.deviator[c] = deviator[c];
    return all;
  }
};

template <int Dim>
void expect_same(const RandomTile<Dim>& a, const RandomTile<Dim>& b) {
  EXPECT_EQ(0, std::memcmp(a.deviator, b.deviator, sizeof a.deviator));
  EXPECT_EQ(0, std::memcmp(a.tile.strain, b.tile.strain, sizeof a.tile.strain));
  EXPECT_EQ(0, std::memcmp(a.tile.ratio, b.tile.ratio, sizeof a.tile.ratio));
  EXPECT_EQ(0, std::memcmp(&a.stress, &b.stress, sizeof a.stress));
}

template <int Dim>
void compare(const SphOptions& options) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    RandomTile<Dim> four(seed), eight(seed);
    strain_points<Dim, Pack>(four.points(), {}, four.stress, four.tile);
    strain_points_by<Dim, Wide>(eight.points(), {}, eight.stress, eight.tile);
    expect_same(four, eight);
    stress_points<Dim, Pack>(four.points(), options, four.tile.ratio, {}, four.stress);
    stress_points_by<Dim, Wide>(eight.points(), options, eight.tile.ratio, {}, eight.stress);
    expect_same(four, eight);
  }
}

TEST(WideTile, HasTheBitsOfFour) {
  if (!can_run_wide()) GTEST_SKIP() << "needs a processor with AVX-512";
  for (const bool correction : {true, false}) {
    for (const Real artificial : {0.0, 0.3}) {
      SphOptions options;
      options.correction = correction;
      options.artificial_stress = artificial;
      compare<2>(options);
      compare<3>(options);
    }
  }
}

}  // namespace
}  // namespace brunt
