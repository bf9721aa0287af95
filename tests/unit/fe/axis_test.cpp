// Axisymmetric elements on the axis, a disc of n elements h wide, H high, against closed forms.
// - Pressure all round: sigma_rr = sigma_tt = -p, of u_r = a r, holds every node still but those of
//   the rim, with 2 pi R H p on each of its elements, whatever the integration.
// - One-point elements have v_r/r of their middle for the hoop strain: at the axis it is that of
//   rr, whatever the field. Of u_r = a r + b r^3 both are a + b h^2, where the means over the
//   element are a + b h^2/2 and a + 3 b h^2/2: their sum is exact, and the error of each is of
//   second order. (Cylindrical wave J1(k r): (k h)^2/16.)
// - Even push on both ends: contact gives a node p int N_I 2 pi r dr, h^2/6 2 pi p at the axis and
//   i h^2 2 pi p at i h. One-point elements push back with equal shares of the ring 2 pi r A that
//   they measure: h^2/4 at the axis. Stresses in balance with the push are then not even: with no
//   hourglass control, -s_k = p (1 + (-1)^k/(3 (2 k - 1))), k from the axis on, 2/3 p in the first,
//   10/9 p in the second, by the balance of each node, s_k (2 k - 1) + s_k+1 (2 k + 1) = 4 k p. At
//   the rim it ends with n even. What resists hourglasses leaves less of it. Masses are in equal
//   shares too, so that a push that begins moves the axis by 2/3 of what it moves the others. q1p0
//   takes an even push evenly, and all of an end moves as one.
// Strains are 1e-6: what is of second order in them is 1e-6 of a force, 1e-5 with what adds up.
#include <gtest/gtest.h>

#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

constexpr Real kStrain = 1e-6, kYoung = 200e9;
constexpr int kAcross = 4;
constexpr Real kWidth = 0.5e-3, kHeight = 0.8e-3;  // [m] of an element

/// A disc of one layer, displaced.
struct Disc {
  Material material = elastic(kYoung, 0, 7850);  // sigma_zz = E eps_zz, and none across
  std::unique_ptr<FiniteElements<2>> body;

  template <class Displacement>
  Disc(Integration integration, Displacement&& u) {
    ElementOptions options;
    options.bulk_viscosity = {0, 0};
    options.hourglass = StiffnessHourglass{0};
    const Vec<2> size(kAcross * kWidth, kHeight), corner(0, -0.5 * kHeight);
    body = make_body(box_mesh<2>({kAcross, 1}, corner, size), material,
                     {Geometry::axisymmetric, integration}, options);
    std::vector<Vec<2>> x = body->points().x;
    for (auto& place : x) place += u(place);
    step_to(*body, x, 1e-9);
  }
  const Vec<2>& force(int column, bool upper) const {
    return body->points().f[column + (upper ? kAcross + 1 : 0)];
  }
  std::array<Real, 6> stress(LocalIndex element, int g = 0) const {
    const auto& block = body->blocks()[0];
    return stress_at(block.state, block.point(element, g));
  }
};

const auto kWays = {Integration::one_point, Integration::q1p0, Integration::full};

TEST(Axis, PressureAllRoundIsInBalance) {
  const Real p = kYoung * kStrain;
  const Real rim = 2 * kPi * kAcross * kWidth * kHeight * p;
  for (const Integration how : kWays) {
    const Disc disc(how, [](const Vec<2>& x) { return Vec<2>(-kStrain * x[0], 0); });
    for (LocalIndex e = 0; e < kAcross; ++e) {
      const auto s = disc.stress(e);
      EXPECT_NEAR(s[xx], -p, 1e-5 * p);
      EXPECT_NEAR(s[zz], -p, 1e-5 * p);
      EXPECT_NEAR(s[yy], 0, 1e-5 * p);
    }
    for (const bool upper : {false, true}) {
      for (int i = 0; i < kAcross; ++i) EXPECT_LT(disc.force(i, upper).norm(), 1e-5 * rim) << i;
      EXPECT_NEAR(disc.force(kAcross, upper)[0], rim / 2, 1e-5 * rim);
    }
  }
}

TEST(Axis, HoopStrainIsThatOfTheMiddle) {
  const Real a = kStrain, b = -0.5 * kStrain / (kWidth * kWidth);
  const Disc disc(Integration::one_point,
                  [&](const Vec<2>& x) { return Vec<2>(a * x[0] + b * std::pow(x[0], 3), 0); });
  const Real both = kYoung * (a + b * kWidth * kWidth);
  EXPECT_NEAR(disc.stress(0)[xx], both, 1e-5 * kYoung * a);
  EXPECT_NEAR(disc.stress(0)[zz], both, 1e-5 * kYoung * a);
}

/// What an even push p on an end gives to the nodes of column i [N].
Real push_on(int i, Real p) {
  const Real ring = 2 * kPi * kWidth * kWidth * p;
  if (i == 0) return ring / 6;
  return i == kAcross ? ring * (0.5 * kAcross - 1.0 / 6) : ring * i;
}

TEST(Axis, EvenPushIsTwoThirdsOfWhatOnePointElementsTake) {
  const Real p = kYoung * kStrain;
  const Real scale = push_on(1, p);
  const auto squeezed = [](Real shortening) {  // of the upper half [m]
    return [=](const Vec<2>& x) { return Vec<2>(0, x[1] > 0 ? -shortening : shortening); };
  };
  for (const Integration how : kWays) {
    const bool one_point = how == Integration::one_point;
    const Disc even(how, squeezed(0.5 * kStrain * kHeight));
    for (int i = 0; i <= kAcross; ++i) {
      const bool end = i == 0 || i == kAcross;
      Real expected = push_on(i, p);
      if (one_point && end) expected += (i == 0 ? 1 : -1) * scale / 12;  // h^2/4 for h^2/6
      EXPECT_NEAR(even.force(i, true)[1], expected, 1e-5 * scale) << i;
    }
  }
  // What the push gives in the first instant: p/(rho H/2) where the end moves as one.
  const Real acceleration = p / (7850 * 0.5 * kHeight);
  for (const Integration how : kWays) {
    const Disc disc(how, squeezed(0));
    for (int i = 0; i <= kAcross; ++i) {
      Real expected = acceleration;
      if (how == Integration::one_point && i == 0) expected *= 2.0 / 3;
      if (how == Integration::one_point && i == kAcross) {
        expected *= (0.5 * kAcross - 1.0 / 6) / (0.5 * kAcross - 0.25);
      }
      EXPECT_NEAR(push_on(i, p) / disc.body->points().mass[i], expected, 1e-12 * expected) << i;
    }
  }
}

// The pattern of stresses that is in balance with the push, where nothing resists hourglasses.
TEST(Axis, StressesOfOnePointElementsUnderAnEvenPush) {
  const Real p = kYoung * kStrain, scale = push_on(1, p);
  // The mean shortening of an element's two columns is that of its stress.
  std::array<Real, kAcross + 1> shortening = {0.5 * kStrain * kHeight};
  std::array<Real, kAcross> stress;
  for (int k = 1; k <= kAcross; ++k) {
    stress[k - 1] = p * (1 + (k % 2 == 0 ? 1 : -1) / (3.0 * (2 * k - 1)));
    shortening[k] = stress[k - 1] / kYoung * kHeight - shortening[k - 1];
  }
  const Disc disc(Integration::one_point, [&](const Vec<2>& x) {
    const Real u = shortening[static_cast<std::size_t>(std::lround(x[0] / kWidth))];
    return Vec<2>(0, x[1] > 0 ? -u : u);
  });
  EXPECT_NEAR(disc.stress(0)[yy], -2 * p / 3, 1e-5 * p);
  for (int k = 0; k < kAcross; ++k) EXPECT_NEAR(disc.stress(k)[yy], -stress[k], 1e-5 * p) << k;
  for (int i = 0; i <= kAcross; ++i) {
    EXPECT_NEAR(disc.force(i, true)[1], push_on(i, p), 1e-5 * scale) << i;
    EXPECT_NEAR(disc.force(i, false)[1], -push_on(i, p), 1e-5 * scale) << i;
  }
}

}  // namespace
}  // namespace brunt
