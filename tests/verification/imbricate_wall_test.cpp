// The first example of the common-plane paper: a projectile at 139 m/s goes through an imbricate
// wall of concrete that nobody holds (decks/brick-wall-2d, coarse and shortened to what it takes to
// slow down). What the wall gains the projectile loses; it slows down and never turns back or
// speeds up; energies close; and a kilometre away all goes the same way: 1e-10, of the rounding of
// places, 1e-13 m in elements of 12.5 mm.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

Simulation strike(std::vector<std::string> more) {
  more.insert(more.end(), {"parameters.size=12.5 mm", "time.end=0.5 ms"});
  return simulate_shipped("brick-wall-2d", more);
}

TEST(ImbricateWall, SlowsAProjectileAndKeepsMomentumAndEnergy) {
  const auto run = strike({});
  ASSERT_EQ(run.failure, "");
  const auto speed = run.column("body.projectile.velocity.x");
  for (std::size_t k = 1; k < speed.size(); ++k) {
    EXPECT_LE(speed[k], speed[k - 1] + 1e-9 * 139) << k;
  }
  EXPECT_GT(speed.back(), 100);
  EXPECT_LT(speed.back(), 120);  // 110.6 of 139 m/s
  const auto along = run.column("momentum.x"), across = run.column("momentum.y");
  for (std::size_t k = 0; k < along.size(); ++k) {
    EXPECT_NEAR(along[k], along[0], 1e-13 * along[0]) << k;
    EXPECT_NEAR(across[k], 0, 1e-13 * along[0]) << k;
  }
  EXPECT_LT(run.worst_drift, 1e-12);
  EXPECT_LT(run.created, 0.002);  // 0.11 %, of contact.pairs
}

TEST(ImbricateWall, GoesTheSameWayAKilometreAway) {
  const auto here = strike({});
  const auto there = strike({"bodies.wall.shape.translate=[1000 m, 1000 m]",
                             "bodies.projectile.shape.translate=[1000 m, 1000 m]"});
  ASSERT_EQ(here.failure + there.failure, "");
  ASSERT_EQ(here.rows.size(), there.rows.size());
  for (const char* column : {"body.projectile.velocity.x", "body.wall.velocity.x", "energy.kinetic",
                             "energy.contact.friction"}) {
    const auto a = here.column(column), b = there.column(column);
    Real largest = 0;
    for (const Real value : a) largest = std::max(largest, std::fabs(value));
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_NEAR(b[k], a[k], 1e-10 * largest) << column << ' ' << k;
    }
  }
}

}  // namespace
}  // namespace brunt::test
