/// Particles are driven into a thin tube of gas, whose walls fold about them. A particle behind one
/// wall and before another belongs to the side from which it entered; a run that goes on from a
/// checkpoint repeats the last choice, and must come to the same: by the face with which that
/// choice began, not by that with which it ended (random deck 521, whose ranks differed after step
/// 384; here 242 of 246).
#include <gtest/gtest.h>

#include "tests/support/simulate.hpp"

namespace brunt {
namespace {
using namespace test;

constexpr const char* kDeck = R"(
title: particles in a tube of gas
geometry: 3d
time: {end: 6e-5, min_step: 1e-10}
materials:
  stone:
    density: 2209.05
    elastic: {E: 2.25567e+10, nu: 0.2}
    strength: {j2: {yield: 2.90742e+07, hardening: 1e+07}}
  gas: {density: 1035.38, eos: {ideal-gas: {gamma: 1.4, pressure: 109991}}}
bodies:
  stone:
    method: sph
    material: stone
    shape:
      box:
        min: [-0.00328466, -0.00328466, 0.000140597]
        max: [0.00328466, 0.00328466, 0.0119259]
    size: 0.00142215
  tube:
    material: gas
    shape:
      tube:
        inner: 0.00134722
        outer: 0.00269444
        length: 0.00595041
        base: [-0.00197878, 0, 0.0119464]
        axis: z
    element: {hourglass: {viscous: 0.1}}
    size: 0.00116399
    velocity: [0, 0, -39.0846]
    spin: {axis: z, rate: -20.6735, about: [0, 0, 0.0149216]}
contact: {default: {stiffness: 0.142041}}
output: {every: 1 s, history: 0.3 us, state_hash: true}
)";

TEST(PinchedTube, GoesOnFromAnyStepAsItWas) {
  const auto whole = simulate_text(kDeck);
  ASSERT_EQ(whole.failure, "");
  ASSERT_GT(whole.steps, 200);
  for (std::int64_t at = whole.steps - 30; at < whole.steps; ++at) {
    EXPECT_EQ(simulate_text(kDeck, {}, {.split_at = at}).hashes, whole.hashes) << at;
  }
}

}  // namespace
}  // namespace brunt
