// The curve of a joint (Bandis, Lumsden & Barton 1983) with one memory, by hand: sigma = k u/(1 -
// u/V), k/(1 - u/V)^2 its slope, back along the tangent, so closed for good by u^2/V, with the loss
// k V^2 (-ln(1 - x) - x - x^2/2) of a cycle to x = u/V.
#include "contact/law/joint.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

// k_ni 3.5 GPa/m, V 0.57 mm: values of docs/theory/contact.md, section 9.
const HoldingSpring kBandis{
    .normal = 3.5e9, .shear = 3.5e9, .closure = ClosureLaw::of(HyperbolicClosure{0.57e-3})};

TEST(Joint, ClosesAlongTheHyperbola) {
  EXPECT_NEAR(kBandis.first_loading(0.5 * 0.57e-3), 1.995e6, 1e-6 * 1.995e6);
  EXPECT_NEAR(kBandis.first_loading(0.8 * 0.57e-3), 7.98e6, 1e-6 * 7.98e6);
  EXPECT_NEAR(kBandis.slope(0.5 * 0.57e-3), 4 * 3.5e9, 1);
  EXPECT_EQ(kBandis.pressure(-1e-5, 0), -3.5e4);
}

TEST(Joint, OpensAlongTheTangentAndKeepsItsResidualClosure) {
  for (const Real x : {0.25, 0.5, 0.75, 0.8}) {
    const Real most = x * 0.57e-3, residual = most * most / 0.57e-3;
    EXPECT_EQ(kBandis.pressure(most, most), kBandis.first_loading(most));
    EXPECT_NEAR(kBandis.pressure(residual + 1e-7, most), 1e-7 * kBandis.slope(most), 1e-2);
    EXPECT_EQ(kBandis.pressure(0.99 * residual, most), 0);
    // Closed again it follows the same line, and beyond the first curve.
    EXPECT_NEAR(kBandis.pressure(0.5 * (most + residual), most), 0.5 * kBandis.first_loading(most),
                1e-9 * kBandis.first_loading(most));
    EXPECT_EQ(kBandis.pressure(1.1 * most, most), kBandis.first_loading(1.1 * most));
  }
  EXPECT_NEAR(0.5 * 0.5 * 0.57, 0.1425, 1e-12);  // [mm] residual closures of the table
  EXPECT_NEAR(0.8 * 0.8 * 0.57, 0.3648, 1e-12);
}

// Work of the curve, by the trapezoidal rule, is what is stored and what is lost.
TEST(Joint, LosesTheLoopOfItsCycle) {
  EXPECT_NEAR(kBandis.lost(0.5 * 0.57e-3), 77.5, 0.05);
  EXPECT_NEAR(kBandis.lost(0.8 * 0.57e-3), 556.6, 0.05);
  auto capped = kBandis;
  capped.stiffest = 10 * kBandis.normal;
  for (const auto& spring : {kBandis, capped}) {
    for (const Real x : {0.25, 0.5, 0.75, 0.9}) {
      const int n = 20000;
      const Real most = x * 0.57e-3, du = most / n;
      Real work = 0;
      for (int i = 0; i < n; ++i) {
        work += 0.5 * du * (spring.first_loading(i * du) + spring.first_loading((i + 1) * du));
      }
      EXPECT_NEAR(work, spring.stored(most, most) + spring.lost(most), 1e-6 * work) << x;
    }
  }
}

// Where the step allows no steeper slope it goes on along a line; the pressure has no jump.
TEST(Joint, GoesOnStraightFromItsStiffestSlope) {
  auto spring = kBandis;
  spring.stiffest = 16 * kBandis.normal;
  const Real from = spring.capped_from();
  EXPECT_NEAR(from, 0.75 * 0.57e-3, 1e-15);
  EXPECT_NEAR(spring.first_loading(from * (1 + 1e-9)), spring.first_loading(from), 1);
  EXPECT_NEAR(spring.first_loading(from + 1e-5) - spring.first_loading(from),
              1e-5 * spring.stiffest, 1e-3);
  EXPECT_EQ(spring.slope(2 * from), spring.stiffest);
  // A thousand times k V close it less than V where nothing caps its slope (C30).
  const Real u = 0.57e-3 * (1 - 1 / 1001.0);
  EXPECT_NEAR(kBandis.first_loading(u), 1000 * 3.5e9 * 0.57e-3, 1e-6 * 1000 * 3.5e9 * 0.57e-3);
}

TEST(Joint, LinearWithoutALargestClosure) {
  const HoldingSpring spring{.normal = 2e9, .shear = 1e9};
  EXPECT_EQ(spring.pressure(1e-3, 5e-3), 2e6);
  EXPECT_EQ(spring.lost(5e-3), 0);
  EXPECT_NEAR(spring.stored(-1e-3, 0), 0.5 * 2e9 * 1e-6, 1e-9);
}

}  // namespace
}  // namespace brunt
