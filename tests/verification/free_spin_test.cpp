// An elastic block that spins freely, slowly, ten turns. Internal forces
// have no moment and act where points are, so that velocity Verlet keeps angular momentum to
// rounding: 1e-12, whatever the elements. It starts without stress and swells to its centrifugal
// forces: that and its ringing take a part of its energy of the order of (w a/c)^2, 1e-6 here, the
// same with all Gauss points; no kind of hourglass control takes any (1e-15).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/scene/scene.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kDeck = R"(
title: A block that spins
geometry: 3d
time: {end: 1.256637 s}
materials: {m: {density: 7850 kg/m^3, elastic: {E: 2 GPa, nu: 0.3}}}
bodies:
  block:
    material: m
    shape: {box: {min: [-10 mm, -10 mm, -10 mm], max: [10 mm, 10 mm, 10 mm]}}
    cells: [2, 1, 1]
    spin: {axis: [1, 2, 3], rate: 50 rad/s, about: [0, 0, 0]}
output: {history: 0.1 s}
)";

Vec3 angular_momentum(const Points<3>& points) {
  Vec3 sum = Vec3::Zero();
  for (LocalIndex k = 0; k < points.size(); ++k) {
    sum += points.mass[k] * points.x[k].cross(points.v[k]);
  }
  return sum;
}

class FreeSpin : public testing::TestWithParam<const char*> {};

TEST_P(FreeSpin, KeepsItsAngularMomentumAndItsEnergy) {
  Vec3 start = Vec3::Zero();
  Real worst = 0;
  SceneHooks hooks;
  hooks.built = [&](Scene<3>& scene) { start = angular_momentum(scene.solids[0]->points()); };
  hooks.step_done = [&](Scene<3>& scene, const Clock&) {
    const Vec3 now = angular_momentum(scene.solids[0]->points());
    worst = std::max(worst, (now - start).norm());
  };
  const auto run = simulate_text(kDeck, {"bodies.block.element=" + std::string(GetParam())},
                                 {.threads = 1}, hooks);
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(worst, 1e-12 * start.norm());
  EXPECT_GT(start.norm(), 0);
  const Real kinetic = run.first("energy.kinetic");
  EXPECT_NEAR(run.last("energy.kinetic"), kinetic, 1.5e-6 * kinetic);
  EXPECT_LT(std::fabs(run.last("energy.hourglass")), 1e-12 * kinetic);
  EXPECT_LT(run.worst_drift, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Elements, FreeSpin,
                         testing::Values("{hourglass: {stiffness: 0.05}}",
                                         "{hourglass: {assumed_strain: 1}}", "{integration: full}",
                                         "{type: tet4}"));

}  // namespace
}  // namespace brunt::test
