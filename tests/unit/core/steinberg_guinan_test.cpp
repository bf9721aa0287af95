/// Steinberg, Cochran & Guinan against the formula as printed, with the constants of their paper of
/// 1980 for OFHC copper, at points computed by hand; slopes against central differences; and the
/// return of points to the flow stress at the pressure of the same step.
#include "core/materials/steinberg_guinan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

static_assert(PressureLaw<SteinbergGuinan> && !FlowLaw<SteinbergGuinan>);

constexpr Real kShear = 47.7e9, kBulk = 137e9, kDensity = 8930;

SteinbergGuinan steinberg_copper() {
  SteinbergGuinan law;
  law.Y0 = 0.12e9, law.Y_max = 0.64e9, law.beta = 36, law.n = 0.45;
  law.A = 28.3e-12, law.B = 3.77e-4;
  return law;
}

Real at(const SteinbergGuinan& law, Real eps_p, Real T, Real p, Real eta) {
  return law.flow_stress(PressureState<Real>{{eps_p, 0, T}, p, eta});
}

Material made_of(const SteinbergGuinan& law, const EosLaw& eos) {
  Material made;
  made.density = kDensity, made.shear = kShear, made.bulk = kBulk;
  made.thermal = true, made.specific_heat = SpecificHeat(383);
  made.strength = make_strength(law, {kShear, kDensity * 383, 0.9});
  made.eos = make_eos(eos, EosInputs{kDensity, kBulk});
  return made;
}

TEST(SteinbergGuinan, IsThePrintedFormula) {
  // 0.12 GPa (1 + 36 0.1)^0.45 = 0.12 4.6^0.45 = 0.12 * 1.987197 = 0.238464 GPa
  EXPECT_NEAR(at(steinberg_copper(), 0.1, 300, 0, 1), 0.2384637e9, 100);
  // at 20 GPa and eta = 1.12: 28.3e-12 20e9 / 1.12^(1/3) = 0.566 / 1.038499 = 0.545017
  EXPECT_NEAR(at(steinberg_copper(), 0.1, 300, 20e9, 1.12) / at(steinberg_copper(), 0.1, 300, 0, 1),
              1.545017, 1e-6);
  // at 800 K: 1 - 3.77e-4 500 = 0.8115
  EXPECT_NEAR(at(steinberg_copper(), 0.1, 800, 0, 1) / at(steinberg_copper(), 0.1, 300, 0, 1),
              0.8115, 1e-12);
  // both add up
  EXPECT_NEAR(at(steinberg_copper(), 0, 800, 20e9, 1.12) / 0.12e9, 1 + 0.545017 - 0.1885, 1e-6);
  // hardening reaches 0.64 GPa where 1 + 36 eps = (0.64/0.12)^(1/0.45) = 41.26: 1.118
  EXPECT_LT(at(steinberg_copper(), 1.11, 300, 0, 1), 0.64e9);
  EXPECT_DOUBLE_EQ(at(steinberg_copper(), 1.13, 300, 0, 1), 0.64e9);
  SteinbergGuinan worked = steinberg_copper();
  worked.eps_i = 0.06;
  EXPECT_DOUBLE_EQ(at(worked, 0.04, 300, 0, 1), at(steinberg_copper(), 0.1, 300, 0, 1));
}

TEST(SteinbergGuinan, HasNoStrengthBelowNone) {
  EXPECT_EQ(at(steinberg_copper(), 0.1, 300 + 1 / 3.77e-4 + 1, 0, 1), 0);
  EXPECT_EQ(at(steinberg_copper(), 0.1, 300, -40e9, 0.9), 0);
  EXPECT_EQ(at(steinberg_copper(), 1e3, 1e7, 0, 1), 0);
}

TEST(SteinbergGuinan, SlopesAreThoseOfTheFormula) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<Real> digit(0, 1);
  for (int i = 0; i < 500; ++i) {
    const Real eps_p = digit(random), T = 300 + 900 * digit(random), p = 30e9 * digit(random);
    const Real eta = 1 + 0.2 * digit(random);
    const PressureState<Real> here{{eps_p, 0, T}, p, eta};
    const PressureState<Real> along{{1, 0, 200 * digit(random)}, 5e9 * digit(random), 0};
    const auto flow = steinberg_copper().along(here, along);
    const auto moved = [&](Real x) {
      return at(steinberg_copper(), eps_p + x, T + along.temperature * x, p + along.pressure * x,
                eta);
    };
    EXPECT_EQ(flow.value, moved(0));
    const Real h = 1e-5;
    EXPECT_NEAR(flow.slope[0], (moved(h) - moved(-h)) / (2 * h), 1e-5 * flow.value) << eps_p;
  }
}

// The solver leaves 1e-10 of the increment of plastic strain, and 3 G of it is below the trial
// stress: 1e-9 of the flow stress where the trial is below ten of it.
TEST(SteinbergGuinan, PointsEndOnTheYieldSurfaceOfThePressureOfTheStep) {
  const SteinbergGuinan law = steinberg_copper();
  const Material made = made_of(law, LinearEos{});
  OneTile points(made.initial_state(kTile, 298, true));
  points.tile.adiabatic = true;
  std::mt19937_64 random(12);
  std::uniform_real_distribution<Real> digit(-1, 1);
  for (std::size_t i = 0; i < kTile; ++i) {
    for (auto& component : points.tile.strain) component[i] = 1e-3 * digit(random);
  }
  for (int step = 0; step < 40; ++step) {
    for (std::size_t i = 0; i < kTile; ++i) {
      points.tile.ratio_old[i] = points.tile.ratio[i];
      points.tile.ratio[i] *= 1 - 2e-3 * (i % 2 == 0);  // up to 11 GPa
    }
    made.update(points.at_first(), 1e-8);
  }
  int plastic = 0;
  for (std::size_t i = 0; i < kTile; ++i) {
    const MaterialState& s = points.state;
    if (s.strain_rate[i] == 0) continue;
    ++plastic;
    const Real eta = 1 / points.tile.ratio[i];
    const Real flow = at(law, s.eps_p[i], s.temperature[i], s.pressure[i], eta);
    EXPECT_NEAR(equivalent_stress(s, i) / flow, 1, 1e-9) << i;
    EXPECT_NEAR(made.strength->flow_stress(s, i, 298) / flow, 1, 1e-9);
    EXPECT_GT(s.temperature[i], 298);
  }
  EXPECT_GT(plastic, kTile / 2);
}

// Uniaxial strain to 20 GPa: the strength behind a shock is that at its pressure, so the axial
// stress exceeds the pressure by 2/3 of it.
TEST(SteinbergGuinan, ShockPressureHardens) {
  SteinbergGuinan law = steinberg_copper();
  law.B = 0;  // as cold: what heat does is tested above
  Material made = made_of(law, MieGruneisen{3940, 1.489, 1.99});
  OneTile points(made.initial_state(kTile, 298, true));
  const int steps = 2000;
  const Real de = std::log(0.88) / steps;
  for (auto& strain : points.tile.strain[xx]) strain = de;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < kTile; ++i) {
      points.tile.ratio_old[i] = points.tile.ratio[i];
      points.tile.ratio[i] = std::exp((step + 1) * de);
    }
    made.update(points.at_first(), 1e-9);
  }
  const MaterialState& s = points.state;
  EXPECT_GT(s.pressure[3], 20e9);
  const Real flow = at(law, s.eps_p[3], 298, s.pressure[3], 1 / 0.88);
  EXPECT_NEAR(equivalent_stress(s, 3) / flow, 1, 1e-6);
  EXPECT_GT(flow, 1.5 * at(law, s.eps_p[3], 298, 0, 1));
}

TEST(SteinbergGuinan, HostileStepsStayNumbers) {
  const Material made = made_of(steinberg_copper(), MieGruneisen{3940, 1.489, 1.99});
  OneTile points(made.initial_state(kTile, 298, true));
  points.tile.adiabatic = true;
  std::mt19937_64 random(2);
  std::uniform_real_distribution<Real> digit(-1, 1);
  for (int step = 0; step < 300; ++step) {
    for (std::size_t i = 0; i < kTile; ++i) {
      for (auto& component : points.tile.strain) component[i] = 0.3 * std::pow(digit(random), 5);
      points.tile.ratio_old[i] = points.tile.ratio[i];
      points.tile.ratio[i] = 0.9 + 0.3 * digit(random);
    }
    made.update(points.at_first(), 1e-8);
    for (std::size_t i = 0; i < kTile; ++i) {
      const MaterialState& s = points.state;
      ASSERT_TRUE(std::isfinite(equivalent_stress(s, i) + s.pressure[i] + s.temperature[i]))
          << step;
      ASSERT_LT(equivalent_stress(s, i), 100e9);
    }
  }
}

}  // namespace
}  // namespace brunt
