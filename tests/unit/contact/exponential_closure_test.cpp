// The exponential closure of a joint (Malama & Kulatilake 2003), by hand: u = V (1 - exp(-sigma/(k
// V))), so sigma = -k V ln(1 - u/V), with the slope k exp(sigma/(k V)), half closed at k V ln 2. Of
// its work k V^2 [(1 - x) ln(1 - x) + x], x = u/V, opening along the tangent gives back sigma^2/2
// times (1 - x)/k.
#include "contact/law/exponential_closure.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/law/joint.hpp"

namespace brunt {
namespace {

constexpr Real kSlope = 3.5e9, kMost = 0.57e-3;
HoldingSpring joint() {
  return {.normal = kSlope, .shear = kSlope, .closure = ClosureLaw::of(ExponentialClosure{kMost})};
}

TEST(ExponentialClosure, ClosesAsPrinted) {
  const HoldingSpring spring = joint();
  EXPECT_NEAR(spring.first_loading(0.5 * kMost), kSlope * kMost * std::log(2.0), 1e-6);
  for (const Real sigma : {1e4, 1e5, 1e6, 1e7}) {
    const Real u = kMost * (1 - std::exp(-sigma / (kSlope * kMost)));
    EXPECT_NEAR(spring.first_loading(u), sigma, 1e-9 * sigma);
    const Real slope = kSlope * std::exp(sigma / (kSlope * kMost));
    EXPECT_NEAR(spring.slope(u), slope, 1e-9 * slope);
    EXPECT_NEAR(ExponentialClosure{kMost}.closure_at(kSlope, slope), u, 1e-9 * u);
  }
  // From no closure on as the hyperbola, and softer than it further on.
  EXPECT_NEAR(spring.slope(0), kSlope, 1e-6);
  EXPECT_LT(spring.first_loading(0.5 * kMost),
            HyperbolicClosure{kMost}.pressure(kSlope, 0.5 * kMost));
  EXPECT_EQ(spring.pressure(-1e-5, 0), -1e-5 * kSlope);
}

// Work of the curve, by the trapezoidal rule, is what is stored and what is lost; so beyond the
// slope from which it goes on along a line.
TEST(ExponentialClosure, WorkIsStoredOrLost) {
  auto capped = joint();
  capped.stiffest = 3 * kSlope;
  EXPECT_NEAR(capped.capped_from(), kMost * 2 / 3, 1e-12);
  for (const auto& spring : {joint(), capped}) {
    for (const Real x : {0.25, 0.5, 0.75, 0.9}) {
      const int n = 20000;
      const Real most = x * kMost, du = most / n;
      Real work = 0;
      for (int i = 0; i < n; ++i) {
        work += 0.5 * du * (spring.first_loading(i * du) + spring.first_loading((i + 1) * du));
      }
      EXPECT_NEAR(work, spring.stored(most, most) + spring.lost(most), 1e-6 * work) << x;
      EXPECT_GT(spring.lost(most), 0);
    }
  }
}

TEST(ExponentialClosure, OpensAlongTheTangent) {
  const HoldingSpring spring = joint();
  const Real most = 0.6 * kMost, p = spring.first_loading(most);
  const Real residual = most - p * (1 - 0.6) / kSlope;
  EXPECT_NEAR(spring.pressure(0.5 * (most + residual), most), 0.5 * p, 1e-9 * p);
  EXPECT_EQ(spring.pressure(0.99 * residual, most), 0);
  EXPECT_EQ(spring.pressure(1.1 * most, most), spring.first_loading(1.1 * most));
}

}  // namespace
}  // namespace brunt
