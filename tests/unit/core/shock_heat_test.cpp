/// What compression and viscosity do to the temperature of a point. With gamma rho constant,
/// eta = 1 - V/V0 and cp constant, dT = gamma0 T d(eta) + w/(rho0 cp) integrates to
///   T(E, eta) = T0 exp(gamma0 eta) + (E - E_S(eta))/(rho0 cp),
///   dE_S/d(eta) = p_cold(eta) + gamma0 E_S,  E_S(0) = 0:
/// on the isentrope (E = E_S) and on the Hugoniot (E = p_H eta/2) alike.
#include <gtest/gtest.h>

#include <cmath>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr Real kDensity = 2703, kHeat = 896, kStart = 300, kCapacity = kDensity * kHeat;
constexpr MieGruneisen kAluminium{5240, 1.40, 1.97};

Material aluminium() {
  Material made;
  made.density = kDensity, made.shear = 26e9;
  made.thermal = true, made.specific_heat = SpecificHeat(kHeat);
  made.strength = make_strength(NoStrength{}, {made.shear, kCapacity, 0.9});
  made.eos = make_eos(kAluminium, {kDensity, 70e9});
  made.bulk = made.eos->bulk_modulus();
  return made;
}

OneTile adiabatic_point(const Material& material) {
  OneTile points(material.initial_state(kTile, kStart, true));
  points.tile.adiabatic = true;
  return points;
}

/// To V/V0 = 1 - eta, with viscous work [J/m^3 reference].
void take_to(const Material& material, OneTile& points, Real eta, Real viscous = 0) {
  std::fill_n(points.tile.ratio, kTile, 1 - eta);
  std::fill_n(points.tile.viscous_work, kTile, viscous);
  material.update(points.at_first(), 1e-9);
  std::fill_n(points.tile.ratio_old, kTile, 1 - eta);
}

/// E_S(eta) [J/m^3], Runge-Kutta of the fourth order.
Real isentrope_energy(Real eta) {
  const MieGruneisenEquation law(kAluminium, kDensity);
  const auto slope = [&](Real x, Real e) {
    return law.cold_pressure(1 - x).pressure + kAluminium.gamma0 * e;
  };
  constexpr int steps = 400;
  const Real h = eta / steps;
  Real e = 0;
  for (int i = 0; i < steps; ++i) {
    const Real x = i * h, k1 = slope(x, e), k2 = slope(x + h / 2, e + h / 2 * k1);
    const Real k3 = slope(x + h / 2, e + h / 2 * k2), k4 = slope(x + h, e + h * k3);
    e += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return e;
}

// Rounding of some 10 steps, each of 1e-16 of T.
TEST(ShockHeat, IsentropicCompressionWarmsAndReleaseGivesItBack) {
  const Material metal = aluminium();
  OneTile points = adiabatic_point(metal);
  for (const Real eta : {0.01, 0.1, 0.25}) {
    take_to(metal, points, eta);
    const Real T = kStart * std::exp(1.97 * eta);
    EXPECT_NEAR(points.state.temperature[7], T, 1e-11);
    EXPECT_NEAR(points.state.compression_heat[7] / (kCapacity * (T - kStart)), 1, 1e-12);
  }
  for (const Real eta : {0.12, -0.02, 0.0}) take_to(metal, points, eta);
  EXPECT_NEAR(points.state.temperature[7], kStart, 1e-11);
  EXPECT_NEAR(points.state.compression_heat[7], 0, 1e-11 * kCapacity);
}

// Along the Rayleigh line p + q = rho0 U_s^2 eta, what the pressure leaves is viscous; the step is
// of second order: 2000 of them are within 1e-5 of the temperature that the state form gives.
TEST(ShockHeat, TheRayleighLineEndsAtTheTemperatureOfTheHugoniot) {
  const Material metal = aluminium();
  constexpr Real u = 2000, speed = 5240 + 1.40 * u, end = u / speed;
  constexpr int steps = 2000;
  OneTile points = adiabatic_point(metal);
  for (int i = 1; i <= steps; ++i) {
    const Real eta = end * i / steps, mean = end * (i - 0.5) / steps, change = end / steps;
    OneTile probe = points;  // the pressure at the end, to find the work of q
    const Real before = points.state.pressure[0];
    take_to(metal, probe, eta);
    const Real p = 0.5 * (before + probe.state.pressure[0]);
    take_to(metal, points, eta, (kDensity * speed * speed * mean - p) * change);
  }
  const Real hugoniot = 0.5 * kDensity * u * u;
  EXPECT_NEAR(points.state.energy[0] / hugoniot, 1, 1e-3);  // of q by the pressure without it
  const Real T =
      kStart * std::exp(1.97 * end) + (points.state.energy[0] - isentrope_energy(end)) / kCapacity;
  EXPECT_NEAR(points.state.temperature[0] / T, 1, 1e-3);
  EXPECT_GT(T, 1100);
}

TEST(ShockHeat, APointThatConductsLeavesTheTemperatureToItsBody) {
  const Material metal = aluminium();
  OneTile alone = adiabatic_point(metal), conducting = adiabatic_point(metal);
  conducting.tile.adiabatic = false;
  take_to(metal, alone, 0.1, 1e7);
  take_to(metal, conducting, 0.1, 1e7);
  EXPECT_EQ(conducting.state.temperature[0], kStart);
  EXPECT_EQ(conducting.state.compression_heat[0], alone.state.compression_heat[0]);
  EXPECT_NEAR(alone.state.compression_heat[0], kCapacity * (alone.state.temperature[0] - kStart),
              1e-12 * kCapacity * kStart);
}

// What was given is the enthalpy between the two temperatures, whatever cp does between them.
TEST(ShockHeat, TakesTheSpecificHeatOverTemperature) {
  Material metal = aluminium();
  Varying cp;
  cp.over = Varying::Over::temperature;
  cp.abscissa = {250, 350, 600}, cp.ordinate = {850, 1200, 900};
  metal.specific_heat = SpecificHeat(cp);
  OneTile points = adiabatic_point(metal);
  constexpr Real viscous = 5e7;
  take_to(metal, points, 0.05, viscous);
  const Real half = std::exp(0.5 * 1.97 * 0.05), T = points.state.temperature[3];
  const auto h = [&](Real at) { return kDensity * metal.specific_heat.enthalpy(at); };
  EXPECT_NEAR((h(T / half) - h(kStart * half)) / viscous, 1, 1e-9);  // in the middle of the step
  EXPECT_NEAR(points.state.compression_heat[3] / (h(T) - h(kStart)), 1, 1e-9);
}

// Beyond V/V0 = 1/(1 - (cutoff + gamma0 E)/K) a gap opens, and nothing expands. E is below cutoff
// times the strain of 0.02 within which that happens: gamma0 E/K is what of V/V0 may differ.
TEST(ShockHeat, AGapThatOpensAtTheCutOffDoesNotCool) {
  Material metal = aluminium();
  metal.tensile_cutoff = 1e9;
  OneTile points = adiabatic_point(metal);
  for (int i = 1; i <= 200; ++i) take_to(metal, points, -0.01 * i);
  const Real strain = 1e9 / (metal.bulk - 1e9), of_energy = 1.97 * 1e9 * 0.02 / metal.bulk;
  EXPECT_NEAR(points.state.temperature[0], kStart * std::exp(-1.97 * strain),
              kStart * 1.97 * of_energy);
}

TEST(ShockHeat, CostsNothingWhereHeatIsOffOrTheLawHasNoEnergy) {
  Material metal = aluminium();
  EXPECT_TRUE(metal.initial_state(1, kStart, false).compression_heat.empty());
  EXPECT_EQ(metal.initial_state(1, kStart, true).compression_heat.size(), std::size_t{kTile});
  metal.eos = make_eos(LinearEos{}, {kDensity, 70e9});
  EXPECT_TRUE(metal.initial_state(1, kStart, true).compression_heat.empty());
}

}  // namespace
}  // namespace brunt
