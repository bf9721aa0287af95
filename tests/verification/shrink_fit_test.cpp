// A ring that is too large by d for the one about it, radii a < b < c, both of E, ends free
// (Lame 1852; Timoshenko & Goodier, Theory of Elasticity, section 28):
//   p = (E d/b) (c^2 - b^2)(b^2 - a^2)/(2 b^2 (c^2 - a^2)),
// 34.03 MPa for 20, 30, 40 mm, 0.03 mm and 210 GPa. The surfaces move by
//   u(c) = 2 p b^2 c/(E (c^2 - b^2)),  u(a) = -2 p b^2 a/(E (b^2 - a^2)).
// Contact gives by its penetration, which the history tells: d less that is what the rings feel.
// 1 %: 16 elements across a ring leave 0.1 % of u, and damping has left the rest at 1e-3.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kInner = 20e-3, kMiddle = 30e-3, kOuter = 40e-3, kTooLarge = 0.03e-3, kE = 210e9;

std::string rings(const std::string& stiffness) {
  return R"(
title: Shrink fit
geometry: axisymmetric
time: {end: 0.4 ms, safety: 0.5}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 210 GPa, nu: 0.3}}}
bodies:
  inner:
    material: steel
    shape: {box: {min: [20 mm, 0], max: [30.015 mm, 2.5 mm]}}
    cells: [16, 4]
  outer:
    material: steel
    shape: {box: {min: [29.985 mm, 0], max: [40 mm, 2.5 mm]}}
    cells: [16, 4]
contact: {default: {initial_overlap: press, friction: 0, stiffness: )" +
         stiffness + R"(}}
damping: {rate: 1e5 1/s}
output: {every: 1 s, history: 1 us}
)";
}

/// Mean radial displacement of the nodes that stood at a radius.
Real moved(const BodyView& view, Real radius) {
  const auto& u = field_named(view.point_fields, "displacement")->values;
  Real sum = 0;
  int n = 0;
  for (std::size_t i = 0; i < u.size(); i += 3) {
    if (std::abs(view.position[i] - u[i] - radius) > 1e-6) continue;
    sum += u[i], ++n;
  }
  return sum / n;
}

TEST(ShrinkFit, RingsPressEachOtherAsLameSays) {
  const Real a = kInner * kInner, b = kMiddle * kMiddle, c = kOuter * kOuter;
  for (const char* const stiffness : {"1", "4"}) {
    SCOPED_TRACE(stiffness);
    const auto run = simulate_text(rings(stiffness));
    ASSERT_EQ(run.failure, "");
    const Real felt = kTooLarge - run.last("contact.inner-outer.max_penetration");
    EXPECT_GT(felt, 0.7 * kTooLarge);
    const Real pressure = kE * felt / kMiddle * (c - b) * (b - a) / (2 * b * (c - a));
    const Real out = moved(run.bodies.at("outer"), kOuter);
    const Real in = moved(run.bodies.at("inner"), kInner);
    EXPECT_NEAR(out * kE * (c - b) / (2 * b * kOuter) / pressure, 1, 0.01);
    EXPECT_NEAR(-in * kE * (b - a) / (2 * b * kInner) / pressure, 1, 0.01);
    EXPECT_LT(run.worst_drift, 1e-9);
  }
}

}  // namespace
}  // namespace brunt::test
