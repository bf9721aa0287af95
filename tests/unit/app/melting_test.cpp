// thermal.T_melt: of laws that do not say it themselves. With A = 100 MPa, m = 1, T_ref = 300 K and
// T_melt = 900 K, T* = 1/2 at 600 K: 50 MPa are left, and eps_f = D1 (1 + D5 T*) = 0.1 (1 + 2/2).
#include <gtest/gtest.h>

#include "app/deck/deck.hpp"
#include "app/setup/materials.hpp"

namespace brunt {
namespace {

Deck metal(const std::string& strength, const std::string& damage, const std::string& thermal) {
  return load_deck_text(
             "time: {end: 1 us}\nmaterials:\n  metal: {density: 8000, elastic: {E: 100 GPa, nu: "
             "0.3}, strength: {johnson-cook: {A: 100 MPa, B: 0, n: 1, m: 1, T_ref: 300 K" +
                 strength + "}}, damage: {johnson-cook: {D1: 0.1, D5: 2, T_ref: 300 K" + damage +
                 "}}, thermal: {cp: 400" + thermal + R"(}}
bodies:
  bar: {material: metal, shape: {box: {min: [0, 0, 0], max: [4 mm, 1 mm, 1 mm]}}, size: 1 mm}
)",
             "metal.yaml")
      .deck;
}

Real stress_at(const Deck& deck, Real temperature) {
  const auto materials = make_materials(deck);
  const MaterialState state = materials[0]->initial_state(1, temperature, true);
  return materials[0]->strength->flow_stress(state, 0, 0);
}

Real strain_to_fail_at(const Deck& deck, Real temperature) {
  const auto law = std::get<JohnsonCookDamage>(deck.materials[0].value.melting_damage());
  return law.strain_to_fail(DamagePoint<Real>{0, 0, 0, temperature, 0, 1, 0});
}

TEST(Melting, OfThermalIsThatOfLawsWithoutOne) {
  const Deck deck = metal("", "", ", T_melt: 900 K");
  EXPECT_DOUBLE_EQ(stress_at(deck, 300), 100e6);
  EXPECT_DOUBLE_EQ(stress_at(deck, 600), 50e6);
  EXPECT_EQ(stress_at(deck, 900), 0);
  EXPECT_DOUBLE_EQ(strain_to_fail_at(deck, 600), 0.2);
}

TEST(Melting, OfTheStrengthIsThatOfDamage) {
  const Deck deck = metal(", T_melt: 900 K", "", "");
  EXPECT_DOUBLE_EQ(stress_at(deck, 600), 50e6);
  EXPECT_DOUBLE_EQ(strain_to_fail_at(deck, 600), 0.2);
}

TEST(Melting, OfALawIsItsOwn) {
  const Deck deck = metal("", ", T_melt: 900 K", "");  // the strength does not soften
  EXPECT_DOUBLE_EQ(stress_at(deck, 600), 100e6);
  EXPECT_DOUBLE_EQ(strain_to_fail_at(deck, 600), 0.2);
  const Deck same = metal(", T_melt: 900 K", ", T_melt: 900 K", ", T_melt: 900 K");
  EXPECT_DOUBLE_EQ(stress_at(same, 600), 50e6);
}

TEST(Melting, IsOne) {
  EXPECT_THROW(metal(", T_melt: 900 K", "", ", T_melt: 901 K"), DeckError);
  EXPECT_THROW(metal("", ", T_melt: 900 K", ", T_melt: 901 K"), DeckError);
  EXPECT_THROW(metal("", "", ""), DeckError);  // D5 = 2, and nothing says it
}

}  // namespace
}  // namespace brunt
