// Blocks that rock and arches (reference values by exact integrals of the rotation about a corner;
// Housner 1963): a block of 0.2 m x 1 m let go at half of alpha = atan(b/h) stands upright after
// 0.34709 s, one of 0.5 m x 2 m after 0.49380 s; pushed upright they fall over with 0.7486 and
// 0.6529 rad/s. A semicircular arch of dry stones holds a line of thrust where it is thicker than
// 0.107 of its radius.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

struct RockingBlock {
  Real width, height;  ///< [m]
  Real upright_at, overturns_with;
  Real alpha() const { return std::atan(width / height); }
};
constexpr RockingBlock kBlocks[] = {{0.2, 1, .34709, .7486}, {0.5, 2, .49380, .6529}};

std::vector<std::string> block_of(const RockingBlock& block) {
  return {"parameters.width=" + std::to_string(block.width) + " m",
          "parameters.height=" + std::to_string(block.height) + " m"};
}

TEST(Masonry, ABlockRocksInItsQuarterPeriod) {
  for (const auto& block : kBlocks) {
    auto set = block_of(block);
    set.push_back("parameters.end=" + std::to_string(1.03 * block.upright_at) + " s");
    const auto run = simulate_shipped("rocking-block", set);
    ASSERT_EQ(run.failure, "");
    const auto time = run.column("time"), turn = run.column("body.block.rotation.z");
    const Real upright = 0.5 * block.alpha();
    Real at = 0;
    for (std::size_t k = 1; k < turn.size() && at == 0; ++k) {
      if (turn[k] < upright) continue;
      at =
          time[k - 1] + (time[k] - time[k - 1]) * (upright - turn[k - 1]) / (turn[k] - turn[k - 1]);
    }
    EXPECT_NEAR(at, block.upright_at, 0.01 * block.upright_at);
    EXPECT_LT(run.worst_drift, 1e-9);
  }
}

TEST(MasonryLong, ABlockFallsOverFromItsSpeedOn) {
  for (const auto& block : kBlocks) {
    for (const Real part : {0.99, 1.01}) {
      auto set = block_of(block);
      set.insert(set.end(),
                 {"parameters.part=0", "parameters.end=2.2 s",
                  "parameters.push=" + std::to_string(part * block.overturns_with) + " rad/s"});
      const auto turn = simulate_shipped("rocking-block", set).column("body.block.rotation.z");
      const Real farthest = -*std::min_element(turn.begin(), turn.end());
      if (part < 1) {
        EXPECT_LT(farthest, block.alpha());
      } else {
        EXPECT_GT(farthest, 2 * block.alpha());
      }
    }
  }
}

/// Height of the crown at the end of a run.
Real crown_of(const char* deck, const std::vector<std::string>& set) {
  const auto run = simulate_shipped(deck, set);
  EXPECT_EQ(run.failure, "");
  return run.last("body.s11.position.y");
}

TEST(MasonryLong, AnArchOfRigidBlocksStandsAndFalls) {
  EXPECT_NEAR(crown_of("masonry-arch", {}), 0.998, 0.002);
  const std::string stiff = "materials.stone.elastic.E=200 GPa";
  EXPECT_NEAR(crown_of("masonry-arch", {stiff, "parameters.thickness=0.109"}), 0.998, 0.001);
  EXPECT_LT(crown_of("masonry-arch", {stiff, "parameters.thickness=0.1055"}), 0.9);
  EXPECT_LT(crown_of("masonry-arch", {"parameters.mu=0"}), 0.7);
}

TEST(MasonryLong, AnArchOfHexesStandsAndFalls) {
  EXPECT_NEAR(crown_of("masonry-arch/hexes", {}), 0.9978, 1e-3);
  EXPECT_LT(crown_of("masonry-arch/hexes", {"parameters.thickness=0.09"}), 0.95);
  EXPECT_LT(crown_of("masonry-arch/hexes", {"parameters.mu=0"}), 0.95);
}

}  // namespace
}  // namespace brunt::test
