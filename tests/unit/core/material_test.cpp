/// The material as a whole: which fields a state has, the order strength - equation of state -
/// cut-off, and the energy that the equation of state is given.
#include "core/materials/material.hpp"

#include <gtest/gtest.h>

#include "core/materials/catalog.hpp"
#include "one_tile.hpp"

namespace brunt {
namespace {

constexpr Real kDensity = 8930, kShear = 46e9, kBulk = 139e9;

Material made_of(const StrengthLaw& strength, const EosLaw& eos) {
  Material made;
  made.density = kDensity, made.shear = kShear;
  made.thermal = true, made.specific_heat = SpecificHeat(383);
  made.strength = make_strength(strength, {kShear, kDensity * 383, 0.9});
  made.eos = make_eos(eos, {kDensity, kBulk});
  made.bulk = made.eos->bulk_modulus();
  return made;
}

TEST(Material, StateHasTheFieldsThatTheModelsNeed) {
  const Material elastic = made_of(NoStrength{}, LinearEos{});
  const MaterialState plain = elastic.initial_state(kTile + 1, 298, false);
  EXPECT_EQ(plain.size(), std::size_t{2 * kTile});
  EXPECT_EQ(plain.bulk[2 * kTile - 1], kBulk);
  EXPECT_TRUE(plain.eps_p.empty() && plain.strain_rate.empty() && plain.temperature.empty());
  EXPECT_TRUE(plain.heat.empty() && plain.energy.empty());
  EXPECT_FALSE(elastic.yields());

  const Material metal = made_of(J2{400e6, {}}, MieGruneisen{3940, 1.489, 1.96});
  const MaterialState full = metal.initial_state(1, 350, true);
  for (const auto* field : {&full.eps_p, &full.strain_rate, &full.temperature, &full.heat,
                            &full.energy, &full.pressure, &full.deviator[5]}) {
    EXPECT_EQ(field->size(), std::size_t{kTile});
  }
  EXPECT_EQ(full.temperature[kTile - 1], 350.0);
  EXPECT_TRUE(metal.initial_state(1, 350, false).heat.empty());
  EXPECT_TRUE(metal.initial_state(0, 350, true).temperature.empty());
}

// p = K (theta - 1), theta = (1 + alpha (T - T0))^3, of points that are held, each with its own T0.
TEST(Material, ExpandsFromWhereEachPointBegan) {
  Material metal = made_of(NoStrength{}, LinearEos{});
  metal.expansion = 1e-5;
  OneTile points(metal.initial_state(kTile, 298, true));
  EXPECT_TRUE(points.state.start_temperature.empty());
  points.state.start_temperature.resize(kTile);
  for (std::size_t k = 0; k < kTile; ++k) points.state.start_temperature[k] = 300 + 10.0 * k;
  points.state.temperature = points.state.start_temperature;
  metal.update(points.at_first(), 1e-7);
  EXPECT_EQ(points.state.pressure[7], 0.0);
  points.state.temperature[7] += 50;
  metal.update(points.at_first(), 1e-7);
  EXPECT_EQ(points.state.pressure[6], 0.0);
  EXPECT_NEAR(points.state.pressure[7] / (kBulk * (std::pow(1 + 50e-5, 3) - 1)), 1, 1e-12);
}

// s = 2 G (strain - trace/3), by hand for strain (3, 0, 0) and shear 1 of 1e-3; p = K (V0/V - 1).
TEST(Material, IsHookesLawForSmallStrain) {
  const Material metal = made_of(NoStrength{}, LinearEos{});
  OneTile points(metal.initial_state(kTile, 298, false));
  std::fill_n(points.tile.strain[xx], kTile, 3e-3);
  std::fill_n(points.tile.strain[zx], kTile, 1e-3);
  std::fill_n(points.tile.ratio, kTile, 1.003);
  metal.update(points.at_first(), 1e-7);
  EXPECT_NEAR(points.state.deviator[xx][5] / (2 * kShear * 2e-3), 1, 1e-14);
  EXPECT_NEAR(points.state.deviator[yy][5] / (2 * kShear * -1e-3), 1, 1e-14);
  EXPECT_NEAR(points.state.deviator[zz][5] / (2 * kShear * -1e-3), 1, 1e-14);
  EXPECT_EQ(points.state.deviator[xy][5], 0.0);
  EXPECT_NEAR(points.state.deviator[zx][5] / (2 * kShear * 1e-3), 1, 1e-14);
  EXPECT_NEAR(points.state.pressure[5] / (kBulk * (1 / 1.003 - 1)), 1, 1e-13);
}

// Shear of an elastic point stores s:s/4G = 2 G strain^2 of shear, here per volume V = 0.9 V0, and
// the equation of state hears of it.
TEST(Material, WorkOfTheDeviatorReachesTheEquationOfState) {
  const Material metal = made_of(NoStrength{}, MieGruneisen{3940, 1.489, 1.96});
  OneTile points(metal.initial_state(kTile, 298, false));
  std::fill_n(points.tile.ratio, kTile, 0.9);
  std::fill_n(points.tile.ratio_old, kTile, 0.9);
  std::fill_n(points.tile.strain[yz], kTile, 1e-3);
  for (int step = 0; step < 4; ++step) metal.update(points.at_first(), 1e-7);
  EXPECT_NEAR(points.state.energy[9] / (0.9 * 2 * kShear * 16e-6), 1, 1e-13);
}

TEST(Material, TensionIsCutOffAndItsWorkIsThatOfTheHeldPressure) {
  Material metal = made_of(NoStrength{}, MieGruneisen{3940, 1.489, 1.96});
  metal.tensile_cutoff = 1e9;
  OneTile points(metal.initial_state(kTile, 298, false));
  std::fill_n(points.tile.ratio, kTile, 1.05);
  metal.update(points.at_first(), 1e-7);
  EXPECT_EQ(points.state.pressure[0], -1e9);
  EXPECT_NEAR(points.state.energy[0] / (0.5 * 1e9 * 0.05), 1, 1e-12);
  std::fill_n(points.tile.ratio_old, kTile, 1.05);
  std::fill_n(points.tile.ratio, kTile, 0.99);  // it closes and resists
  metal.update(points.at_first(), 1e-7);
  EXPECT_GT(points.state.pressure[0], 1e9);
}

TEST(Material, TilesDoNotTouchTheirNeighbours) {
  const Material metal = made_of(J2{400e6, {}}, LinearEos{});
  OneTile points(metal.initial_state(3 * kTile, 298, true));
  std::fill_n(points.tile.strain[xy], kTile, 0.1);
  points.tile.adiabatic = true;
  metal.update(points.at_first(kTile), 1e-7);
  const MaterialState& s = points.state;
  EXPECT_GT(s.eps_p[kTile], 0);
  EXPECT_GT(s.eps_p[2 * kTile - 1], 0);
  for (const std::size_t i : {std::size_t{0}, std::size_t{kTile - 1}, std::size_t{2 * kTile}}) {
    EXPECT_EQ(s.eps_p[i], 0);
    EXPECT_EQ(s.deviator[xy][i], 0);
    EXPECT_EQ(s.temperature[i], 298);
  }
}

TEST(Catalog, DefaultsAreTheFirstAndNamesAreThoseOfTheDeck) {
  EXPECT_FALSE(make_strength(StrengthLaw{}, {kShear, 0, 0})->yields());
  EXPECT_EQ(make_eos(EosLaw{}, {kDensity, kBulk})->bulk_modulus(), kBulk);
  EXPECT_STREQ(J2::deck_name, "j2");
  EXPECT_STREQ(JohnsonCook::deck_name, "johnson-cook");
  EXPECT_STREQ(MieGruneisen::deck_name, "mie-gruneisen");
  EXPECT_STREQ(LinearEos::deck_name, "linear");
  EXPECT_STREQ(NoStrength::deck_name, "none");
  JohnsonCook law;
  EXPECT_FALSE(make_strength(law, {kShear, 0, 0})->needs_temperature());
  law.T_melt = 1000;
  EXPECT_TRUE(make_strength(law, {kShear, 0, 0})->needs_temperature());
}

}  // namespace
}  // namespace brunt
