// A free brick wall, three courses of two bricks that are one or two elements high, is hit by an
// inclined steel bar at 70 m/s. Nobody puts energy in but the bar: what forces of contact do
// besides springs, dampers and friction (contact.pairs) stays below 0.5 % of it, or a warning says
// where contacts are deep or did not hold. The momentum of all along the blow is the bar's.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr int kCourses = 3, kBricksInACourse = 2;

std::string deck_of_wall(Real tilt, Real speed, Real brick_size, Real friction) {
  std::string text = "title: A bar hits a free brick wall\ngeometry: 3d\ntime: {end: 2 ms}\n";
  text += R"(
materials:
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
  brick: {density: 1900 kg/m^3, elastic: {E: 15 GPa, nu: 0.2}}
output: {every: 1 s, history: 10 us}
bodies:
  bar:
    material: steel
    size: 40 mm
    shape:
      box: {min: [-150 mm, -20 mm, -20 mm], max: [150 mm, 20 mm, 20 mm]}
      translate: [200 mm, -150 mm, 160 mm]
      rotate: {axis: z, angle: )" +
          std::to_string(tilt) + " deg}\n    velocity: [0, " + std::to_string(speed) + ", 0]\n";
  for (int course = 0; course < kCourses; ++course) {
    for (int k = 0; k < kBricksInACourse; ++k) {
      const int x = 200 * k + 100 * (course % 2), z = 100 * course;
      const auto corner = [](int at_x, int at_y, int at_z) {
        return "[" + std::to_string(at_x) + " mm, " + std::to_string(at_y) + " mm, " +
               std::to_string(at_z) + " mm]";
      };
      text += "  brick" + std::to_string(course) + std::to_string(k) +
              ": {material: brick, size: " + std::to_string(brick_size) +
              ", shape: {box: {min: " + corner(x, 0, z) +
              ", max: " + corner(x + 200, 100, z + 100) + "}}}\n";
    }
  }
  return text + "contact: {default: {friction: " + std::to_string(friction) + "}}\n";
}

void expect_wall(Real tilt, Real size, Real friction) {
  constexpr Real kSpeed = 70;
  const Simulation run = simulate_text(deck_of_wall(tilt, kSpeed, size, friction));
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.last("body.bar.velocity.y"), 0.8 * kSpeed) << "it met the wall";
  EXPECT_NEAR(run.last("momentum.y") / run.first("momentum.y"), 1, 1e-9);
  Real pairs = 0;
  for (const Real at : run.column("energy.contact.pairs")) {
    pairs = std::max(pairs, std::fabs(at) / run.largest_energy());
  }
  EXPECT_TRUE(pairs < 0.005 || !run.warnings.empty()) << pairs;
}

TEST(WallHit, KeepsItsEnergyOrIsToldOf) {
  for (const Real tilt : {60.0, 20.0}) {
    for (const Real size : {0.1, 0.05}) {
      for (const Real friction : {0.0, 0.4}) {
        SCOPED_TRACE(testing::Message() << tilt << ' ' << size << ' ' << friction);
        expect_wall(tilt, size, friction);
      }
    }
  }
}

}  // namespace
}  // namespace brunt::test
