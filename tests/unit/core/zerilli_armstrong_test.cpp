/// Zerilli & Armstrong against the formula as printed, with the constants of their paper of 1987:
/// OFHC copper (fcc) and Armco iron (bcc); slopes, which come of dual numbers, against central
/// differences; and the return of a tile of points to the yield surface of their new state.
#include "core/materials/zerilli_armstrong.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

static_assert(FlowLaw<ZerilliArmstrong>);

ZerilliArmstrong copper() {
  ZerilliArmstrong law;
  law.C0 = 65e6, law.C2 = 890e6, law.C3 = 0.0028, law.C4 = 0.000115;
  return law;
}

ZerilliArmstrong iron() {
  ZerilliArmstrong law;
  law.C0 = 65e6, law.C1 = 1033e6, law.C3 = 0.00698, law.C4 = 0.000415;
  law.C5 = 266e6, law.n = 0.289;
  return law;
}

TEST(ZerilliArmstrong, IsThePrintedFormula) {
  // eq. 16: C0 + C2 sqrt(eps) exp(-C3 T + C4 T ln rate)
  const Real fcc =
      65e6 + 890e6 * std::sqrt(0.3) * std::exp(-0.0028 * 500 + 0.000115 * 500 * std::log(1e4));
  EXPECT_NEAR(copper().flow_stress(0.3, 1e4, 500.0) / fcc, 1, 4e-15);
  // eq. 19: C0 + C1 exp(-C3 T + C4 T ln rate) + C5 eps^n
  const Real bcc = 65e6 + 1033e6 * std::exp(-0.00698 * 400 + 0.000415 * 400 * std::log(3e3)) +
                   266e6 * std::pow(0.2, 0.289);
  EXPECT_NEAR(iron().flow_stress(0.2, 3e3, 400.0) / bcc, 1, 4e-15);
}

TEST(ZerilliArmstrong, LimitsAreThoseOfTheModel) {
  for (const auto& law : {copper(), iron()}) {
    EXPECT_EQ(law.flow_stress(0.1, 0.0, 300.0), law.flow_stress(0.1, law.rate_min, 300.0));
    EXPECT_LT(law.flow_stress(0.1, 1.0, 300.0), law.flow_stress(0.1, 1e3, 300.0));
    EXPECT_GT(law.flow_stress(0.1, 1.0, 300.0), law.flow_stress(0.1, 1.0, 600.0));
    EXPECT_TRUE(law.needs_temperature());
  }
  EXPECT_EQ(copper().flow_stress(0.0, 1e3, 300.0), 65e6);
}

TEST(ZerilliArmstrong, NearAPointItIsTheSameLawWithItsSlopes) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> digit(0, 1);
  for (const auto& law : {copper(), iron()}) {
    for (int i = 0; i < 500; ++i) {
      const Real eps_p = std::pow(10, -4 + 4 * digit(random)), increment = eps_p * digit(random);
      const Real rate = std::pow(10, -2 + 8 * digit(random)), T = 200 + 1000 * digit(random);
      const Real e = eps_p + increment;
      const auto flow = law.near(eps_p, 300.0).at(increment, rate, T);
      EXPECT_EQ(flow.value, law.flow_stress(e, rate, T));
      EXPECT_EQ(law.near(eps_p, T).static_stress(), law.flow_stress(eps_p, 0.0, T));
      EXPECT_LE(law.static_floor(eps_p, T), law.flow_stress(eps_p, 0.0, T));
      const auto slope = [](auto&& f, Real x) {  // central: error h^2 f'''/6 and 1e-16 f/h
        const Real h = 1e-5 * x;
        return (f(x + h) - f(x - h)) / (2 * h);
      };
      const Real scale = 1e-6 * flow.value;
      const auto of_strain = [&](Real x) { return law.flow_stress(x, rate, T); };
      const auto of_rate = [&](Real x) { return law.flow_stress(e, x, T); };
      const auto of_heat = [&](Real x) { return law.flow_stress(e, rate, x); };
      EXPECT_NEAR(flow.d_eps_p * e, slope(of_strain, e) * e, scale);
      EXPECT_NEAR(flow.d_rate * rate, slope(of_rate, rate) * rate, scale);
      EXPECT_NEAR(flow.d_temperature * T, slope(of_heat, T) * T, scale);
    }
    // Where roots and powers are steepest they are no number less.
    const auto fresh = law.near(0.0, 300.0).at(0.0, 0.0, 300.0);
    EXPECT_TRUE(std::isfinite(fresh.d_rate) && std::isfinite(fresh.d_temperature));
    EXPECT_FALSE(std::isnan(fresh.d_eps_p));
  }
}

// The solver leaves 1e-10 of the increment of plastic strain, and 3 G of it is below the trial
// stress: 1e-9 of the flow stress where the trial is below ten of it (radial_return_test.cpp).
TEST(ZerilliArmstrong, PointsEndOnTheYieldSurfaceOfTheNewState) {
  constexpr Real kShear = 46e9;
  for (const auto& law : {copper(), iron()}) {
    const auto strength = make_strength(law, {kShear, 8960 * 383, 0.9});
    OneTile points(full_state(298));
    points.tile.adiabatic = true;
    std::mt19937_64 random(12);
    std::uniform_real_distribution<Real> digit(-1, 1);
    for (std::size_t i = 0; i < kTile; ++i) {
      for (std::size_t c = 0; c < 6; ++c) points.tile.strain[c][i] = 1e-3 * digit(random);
      points.state.eps_p[i] = i % 3 == 0 ? 0 : 0.1 * (1 + digit(random));
      points.state.temperature[i] = 600 + 300 * digit(random);
    }
    int plastic = 0;
    for (int step = 0; step < 5; ++step) strength->update(points.at_first(), 1e-7);
    for (std::size_t i = 0; i < kTile; ++i) {
      const MaterialState& s = points.state;
      const Real flow = law.flow_stress(s.eps_p[i], s.strain_rate[i], s.temperature[i]);
      if (s.strain_rate[i] == 0) continue;
      ++plastic;
      EXPECT_NEAR(equivalent_stress(s, i), flow, 1e-9 * flow) << i;
      EXPECT_GT(s.temperature[i], 300);
    }
    EXPECT_GT(plastic, kTile / 2);
  }
}

}  // namespace
}  // namespace brunt
