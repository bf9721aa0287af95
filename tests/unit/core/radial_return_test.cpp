/// The return to the yield surface: at its end the equivalent stress is the flow stress at the new
/// state. The solver leaves 1e-10 of the increment (a Newton step of 1e-5, squared), and 3 G of an
/// increment is below the trial stress: 1e-9 of the flow stress where the trial is below ten of it.
#include "core/materials/radial_return.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>
#include <random>

#include "core/materials/j2.hpp"
#include "core/materials/johnson_cook.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr Real kShear = 46e9, kHeatCapacity = 8960 * 383, kTaylorQuinney = 0.9;
const StrengthInputs kInputs{kShear, kHeatCapacity, kTaylorQuinney};

JohnsonCook copper() {
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025;
  law.m = 1.09, law.T_melt = 1356, law.T_ref = 298;
  law.prepare();
  return law;
}

/// Elastic, yielding, fresh, hot and molten points with all components of strain and stress.
OneTile mixed_points() {
  OneTile points(full_state(298));
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> digit(-1, 1);
  for (std::size_t i = 0; i < kTile; ++i) {
    Real mean = 0;
    for (std::size_t c = 0; c < 6; ++c) {
      points.state.deviator[c][i] = 60e6 * digit(random);
      mean += c < 3 ? points.state.deviator[c][i] / 3 : 0;
      points.tile.strain[c][i] = 1e-3 * std::pow(10, 1.5 * digit(random)) * digit(random);
    }
    for (std::size_t c = 0; c < 3; ++c) points.state.deviator[c][i] -= mean;
    points.state.eps_p[i] = i % 3 == 0 ? 0 : std::pow(10, -2 + 2 * digit(random));
    points.state.temperature[i] = i % 7 == 0 ? 1400 : 700 + 600 * digit(random);
    points.tile.ratio_old[i] = 1 + 0.1 * digit(random);
    points.tile.ratio[i] = points.tile.ratio_old[i] * (1 + 0.01 * digit(random));
    if (i % 5 == 0) {
      for (auto& component : points.tile.strain) component[i] *= 1e-5;
    }
  }
  points.tile.adiabatic = true;
  return points;
}

TEST(RadialReturn, EndsOnTheYieldSurfaceOfTheNewState) {
  const JohnsonCook law = copper();
  const RadialReturn<JohnsonCook> strength(law, kInputs);
  OneTile points = mixed_points();
  strength.update(points.at_first(), 1e-7);
  int plastic = 0, elastic = 0;
  for (std::size_t i = 0; i < kTile; ++i) {
    const MaterialState& s = points.state;
    const Real q = equivalent_stress(s, i);
    const Real flow = law.flow_stress(s.eps_p[i], s.strain_rate[i], s.temperature[i]);
    if (s.strain_rate[i] > 0) {
      ++plastic;
      EXPECT_NEAR(q, flow, 1e-9 * std::max(flow, 10e6)) << i;
    } else {
      ++elastic;
      EXPECT_LE(q, flow * (1 + 1e-12)) << i;
    }
  }
  EXPECT_GT(plastic, 10);
  EXPECT_GT(elastic, 2);
}

// In steady flow the stress begins and ends on the yield surface and the work of the deviator is
// 1/2 (s_old + s_new) : strain; what of it is not in s:s/4G is plastic. Nothing here is approximate
// for strain along the stress, so the tolerance is the solver's.
// What is asked of a point is the law at its plastic strain, last rate and temperature, or at the
// temperature that is given where heat is off.
TEST(RadialReturn, TellsTheFlowStressOfAPoint) {
  const JohnsonCook law = copper();
  const RadialReturn<JohnsonCook> strength(law, kInputs);
  OneTile points = mixed_points();
  strength.update(points.at_first(), 1e-7);
  auto& state = points.state;
  for (std::size_t i = 0; i < kTile; ++i) {
    EXPECT_EQ(strength.flow_stress(state, i, 500),
              law.flow_stress(state.eps_p[i], state.strain_rate[i], state.temperature[i]));
  }
  state.temperature.clear();
  EXPECT_EQ(strength.flow_stress(state, 1, 500),
            law.flow_stress(state.eps_p[1], state.strain_rate[1], 500.0));
  EXPECT_EQ(ElasticStrength(kShear).flow_stress(state, 1, 500), kInfinity);
}

TEST(RadialReturn, HeatIsTheTaylorQuinneyPartOfPlasticWork) {
  const RadialReturn<JohnsonCook> strength(copper(), kInputs);
  OneTile points(full_state(298));
  points.tile.adiabatic = true;
  constexpr Real strain = 3e-4, ratio = 0.9;
  std::fill_n(points.tile.ratio_old, kTile, ratio);
  std::fill_n(points.tile.ratio, kTile, ratio);
  std::fill_n(points.tile.strain[xy], kTile, strain);
  const auto elastic_energy = [&] {
    return std::pow(points.state.deviator[xy][0], 2) / (2 * kShear);
  };
  for (int step = 0; step < 50; ++step) {
    const Real s_old = points.state.deviator[xy][0], e_old = elastic_energy();
    const Real heat_old = points.state.heat[0], T_old = points.state.temperature[0];
    strength.update(points.at_first(), 3e-8);
    const Real plastic_work =
        (s_old + points.state.deviator[xy][0]) * strain - (elastic_energy() - e_old);
    const Real heat = points.state.heat[0] - heat_old;
    if (step < 10) continue;  // those that cross from elastic to plastic
    EXPECT_NEAR(heat / (ratio * kTaylorQuinney * plastic_work), 1, 1e-9);
    EXPECT_NEAR((points.state.temperature[0] - T_old) * kHeatCapacity / heat, 1, 1e-9);
  }
}

TEST(RadialReturn, TemperatureIsTheCallersWhereHeatIsConducted) {
  const RadialReturn<JohnsonCook> strength(copper(), kInputs);
  OneTile points(full_state(500));
  std::fill_n(points.tile.strain[xy], kTile, 5e-3);
  strength.update(points.at_first(), 1e-7);
  EXPECT_EQ(points.state.temperature[3], 500.0);
  EXPECT_GT(points.state.heat[3], 0.0);
}

TEST(RadialReturn, RunsWithoutHeat) {
  const JohnsonCook law = copper();
  const RadialReturn<JohnsonCook> strength(law, kInputs);
  OneTile points(full_state(298));
  points.state.heat.clear();
  points.state.temperature.clear();
  points.tile.fixed_temperature = 500;
  std::fill_n(points.tile.strain[xy], kTile, 5e-3);
  strength.update(points.at_first(), 1e-7);
  const Real flow = law.flow_stress(points.state.eps_p[0], points.state.strain_rate[0], 500.0);
  EXPECT_NEAR(equivalent_stress(points.state, 0) / flow, 1, 1e-9);
}

// Linear hardening has the closed form d = (q_trial - sigma_y) / (3 G + H).
TEST(RadialReturn, OfLinearHardeningIsTheClosedForm) {
  J2 law{400e6, Varying{}};
  law.hardening->constant = 1e9;
  const RadialReturn<J2> strength(law, kInputs);
  OneTile points(full_state(298));
  std::fill_n(points.tile.strain[xy], kTile, 0.01);
  strength.update(points.at_first(), 1e-7);
  const Real q_trial = std::sqrt(3.0) * 2 * kShear * 0.01;
  const Real increment = (q_trial - 400e6) / (3 * kShear + 1e9);
  EXPECT_NEAR(points.state.eps_p[0] / increment, 1, 1e-13);
  EXPECT_NEAR(equivalent_stress(points.state, 0) / (400e6 + 1e9 * increment), 1, 1e-12);
  EXPECT_NEAR(points.state.strain_rate[0] / (increment / 1e-7), 1, 1e-13);
}

TEST(RadialReturn, MoltenPointsFlow) {  // C22
  const RadialReturn<JohnsonCook> strength(copper(), kInputs);
  OneTile points(full_state(1400));
  points.tile.adiabatic = true;
  std::fill_n(points.tile.strain[xy], kTile, 1e-2);
  for (int step = 0; step < 3; ++step) strength.update(points.at_first(), 1e-7);
  // 3 G d = q_trial to one rounding: what is left is 1e-16 of it
  EXPECT_LT(equivalent_stress(points.state, 0), 1e-15 * 2 * kShear * 1e-2);
  EXPECT_EQ(points.state.temperature[0], 1400.0);  // no strength, no heat
  // a step whose own heat melts the point: 10 of strain near the melting point
  OneTile melting(full_state(1340));
  melting.tile.adiabatic = true;
  std::fill_n(melting.tile.strain[xy], kTile, 10);
  for (int step = 0; step < 20; ++step) {
    strength.update(melting.at_first(), 1e-7);
    const Real q = equivalent_stress(melting.state, 0);
    EXPECT_TRUE(std::isfinite(q) && std::isfinite(melting.state.temperature[0]));
    // the mean flow stress heats; it sinks to nothing as the melting point is reached
    EXPECT_LE(melting.state.temperature[0], 1e4);
    EXPECT_LE(q, copper().flow_stress(300.0, 1e9, 1340.0));
  }
}

// The stress after a strain of 1 % grows with the rate, and the solver needs few steps: C23.
TEST(RadialReturn, RatesFromNothingToABillionAreMonotone) {
  const JohnsonCook law = copper();
  Real last = 0;
  int most = 0;
  for (int decade = -12 * 4; decade <= 9 * 4; ++decade) {
    const Real rate = std::pow(10, decade / 4.0), inverse_dt = rate / 0.01;
    ReturnPoint<Real> p{};
    p.q_trial = 3 * kShear * 0.01, p.temperature = 298;
    const auto near = law.near(0.0, 298.0);  // n < 1 at eps_p = 0: an infinite slope
    p.q_old = near.static_stress();
    p.heating = kTaylorQuinney / kHeatCapacity;
    p.hi = p.q_trial / (3 * kShear);
    p.increment = 1e-7 * p.hi;
    p.active = true;
    int iterations = 0;
    for (; p.active && iterations < 50; ++iterations) {
      return_step(p, near, {kShear, 0.01 / rate, inverse_dt}, iterations);
    }
    EXPECT_FALSE(p.active) << rate;
    most = std::max(most, iterations);
    const Real q = p.q_trial - 3 * kShear * p.increment;
    // below rate_ref nothing depends on the rate: equal to the solver's 1e-10
    EXPECT_GE(q, last * (1 - 1e-9)) << rate;
    if (rate > 2) {
      EXPECT_GT(q, last);
    }
    const Real T = 298 + 0.5 * p.heating * (p.q_old + q) * p.increment;
    EXPECT_NEAR(q / law.flow_stress(p.increment, p.increment * inverse_dt, T), 1, 1e-9) << rate;
    last = q;
  }
  EXPECT_LE(most, 20);  // 50 are allowed
}

TEST(RadialReturn, BracketsHoldForHostileSteps) {
  const JohnsonCook law = copper();
  const RadialReturn<JohnsonCook> strength(law, kInputs);
  for (const Real dt : {1e-300, 1e-15, 1e-9, 1.0, 1e12}) {
    for (const Real strain : {1e-3, 1.0, 1e3}) {
      OneTile points(full_state(298));
      std::fill_n(points.tile.strain[xy], kTile, strain);
      strength.update(points.at_first(), dt);
      const MaterialState& s = points.state;
      EXPECT_TRUE(std::isfinite(s.eps_p[0]) && s.eps_p[0] >= 0) << dt << ' ' << strain;
      EXPECT_TRUE(std::isfinite(equivalent_stress(s, 0))) << dt << ' ' << strain;
    }
  }
}

void expect_same_bits(const MaterialState& a, std::size_t i, const MaterialState& b,
                      std::size_t j) {
  const auto bits = [](Real x) { return std::bit_cast<std::uint64_t>(x); };
  for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(bits(a.deviator[c][i]), bits(b.deviator[c][j]));
  EXPECT_EQ(bits(a.eps_p[i]), bits(b.eps_p[j]));
  EXPECT_EQ(bits(a.strain_rate[i]), bits(b.strain_rate[j]));
  EXPECT_EQ(bits(a.temperature[i]), bits(b.temperature[j]));
  EXPECT_EQ(bits(a.heat[i]), bits(b.heat[j]));
}

TEST(RadialReturn, LanesHaveTheBitsOfAReal) {
  OneTile packs = mixed_points(), reals = mixed_points();
  RadialReturn<JohnsonCook, Pack>(copper(), kInputs).update(packs.at_first(), 1e-7);
  RadialReturn<JohnsonCook, Real>(copper(), kInputs).update(reals.at_first(), 1e-7);
  for (std::size_t i = 0; i < kTile; ++i) expect_same_bits(packs.state, i, reals.state, i);
}

TEST(RadialReturn, NeighboursInATileChangeNoBit) {
  const RadialReturn<JohnsonCook> strength(copper(), kInputs);
  OneTile in_order = mixed_points();
  const OneTile source = mixed_points();
  strength.update(in_order.at_first(), 1e-7);
  std::array<std::size_t, kTile> place;
  std::iota(place.begin(), place.end(), 0U);
  std::mt19937_64 random(8);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(place.begin(), place.end(), random);
    OneTile shuffled = mixed_points();
    for (std::size_t i = 0; i < kTile; ++i) {
      const std::size_t j = place[i];
      for (std::size_t c = 0; c < 6; ++c) {
        shuffled.state.deviator[c][j] = source.state.deviator[c][i];
        shuffled.tile.strain[c][j] = source.tile.strain[c][i];
      }
      shuffled.state.eps_p[j] = source.state.eps_p[i];
      shuffled.state.temperature[j] = source.state.temperature[i];
      shuffled.tile.ratio[j] = source.tile.ratio[i];
      shuffled.tile.ratio_old[j] = source.tile.ratio_old[i];
    }
    strength.update(shuffled.at_first(), 1e-7);
    for (std::size_t i = 0; i < kTile; ++i) {
      expect_same_bits(in_order.state, i, shuffled.state, place[i]);
    }
  }
}

SpecificHeat specific_heat(std::vector<Real> temperature, std::vector<Real> value) {
  Varying given;
  given.over = Varying::Over::temperature;
  given.abscissa = std::move(temperature), given.ordinate = std::move(value);
  return SpecificHeat(given);
}

/// Points of a law at 298 K that shear adiabatically so many times.
template <class Law>
OneTile sheared(const RadialReturn<Law>& strength, SymmetricIndex component, Real strain,
                int steps) {
  OneTile points(full_state(298));
  points.tile.adiabatic = true;
  std::fill_n(points.tile.strain[component], kTile, strain);
  for (int step = 0; step < steps; ++step) strength.update(points.at_first(), 1e-7);
  return points;
}

// cp = a + b T, a = 300, b = 0.5 from 200 to 1200 K, perfect plasticity: all plastic work is Y
// eps_p, so that 0.9 Y eps_p = rho (a (T - T0) + b (T^2 - T0^2)/2), whatever the steps. The root is
// closed form; a hundred steps each round T to an ulp, 1e-13 of it.
TEST(RadialReturn, AdiabaticHeatIsTheEnthalpyOfATable) {
  constexpr Real kYield = 400e6, kDensity = 8960, a = 300, b = 0.5;
  const auto cp = specific_heat({200, 1200}, {a + 200 * b, a + 1200 * b});
  const RadialReturn<J2> strength(J2{kYield, {}},
                                  {kShear, kDensity * cp.least(), kTaylorQuinney, &cp, kDensity});
  const OneTile points = sheared(strength, xy, 5e-3, 100);
  const auto& state = points.state;
  EXPECT_GT(state.eps_p[3], 0.5);
  EXPECT_NEAR(state.heat[3], kTaylorQuinney * kYield * state.eps_p[3], 1e-12 * state.heat[3]);
  const Real h = a * 298 + 0.5 * b * 298 * 298 + state.heat[3] / kDensity;
  EXPECT_NEAR(state.temperature[3], (std::sqrt(a * a + 2 * b * h) - a) / b, 1e-10);
}

// Softening sees the temperature at the end of the step to second order in the rise of the step:
// at 0.25 K a step, the flow stress at the state left is that of the law to 1e-6 of it.
TEST(RadialReturn, SofteningFollowsATable) {
  const auto cp = specific_heat({300, 305, 310}, {383, 3830, 383});
  const JohnsonCook law = copper();
  const RadialReturn<JohnsonCook> strength(law,
                                           {kShear, 8960 * cp.least(), kTaylorQuinney, &cp, 8960});
  const OneTile points = sheared(strength, zx, 2e-3, 400);
  const auto& state = points.state;
  EXPECT_GT(state.temperature[0], 310);
  EXPECT_NEAR(8960 * (cp.enthalpy(state.temperature[0]) - cp.enthalpy(298)), state.heat[0],
              1e-10 * state.heat[0]);
  const Real flow = law.flow_stress(state.eps_p[0], state.strain_rate[0], state.temperature[0]);
  EXPECT_NEAR(equivalent_stress(state, 0), flow, 1e-6 * flow);
}

}  // namespace
}  // namespace brunt
