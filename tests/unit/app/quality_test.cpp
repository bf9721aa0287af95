// What `quality` sets, and that a deck's own keys come before it.
#include "app/deck/quality.hpp"

#include <gtest/gtest.h>

#include <string>

#include "app/deck/deck.hpp"

namespace brunt::deck {
namespace {

/// A metal, an elastic bar and particles; `more` stands in the deck besides.
LoadedDeck scene(const std::string& more, const std::vector<std::string>& overrides = {}) {
  return load_deck_text(R"(
geometry: 3d
time: {end: 1 us}
materials:
  glass: {density: 2500, elastic: {E: 70 GPa, nu: 0.2}}
  lead: {density: 11300, elastic: {E: 16 GPa, nu: 0.44}, strength: {j2: {yield: 12 MPa}}}
  concrete: {density: 2440, strength: {concrete-cap: {fc: 30 MPa}}}
bodies:
  glass: {material: glass, shape: {box: {min: [0, 0, 0], max: [1 cm, 1 cm, 1 cm]}}, size: 5 mm}
  lead: {material: lead, shape: {box: {min: [2 cm, 0, 0], max: [3 cm, 1 cm, 1 cm]}}, size: 5 mm}
  own:
    material: lead
    shape: {box: {min: [6 cm, 0, 0], max: [7 cm, 1 cm, 1 cm]}}
    size: 5 mm
    element: {hourglass: {viscous: 0.1}}
  slab:
    material: concrete
    shape: {box: {min: [8 cm, 0, 0], max: [9 cm, 1 cm, 1 cm]}}
    size: 5 mm
  drops:
    method: sph
    material: lead
    shape: {box: {min: [4 cm, 0, 0], max: [5 cm, 1 cm, 1 cm]}}
    size: 5 mm
contact:
  pairs:
    a: {between: [glass, lead], friction: 0.1}
    b: {between: [lead, drops], stiffness: 3}
)" + more,
                        "scene.yaml", overrides);
}

Integration of(const LoadedDeck& loaded, const char* body) {
  return integration_of(loaded.deck, loaded.deck.bodies[*label_of(loaded.deck, body)].value);
}

TEST(Quality, DefaultIsWhatStandsInTheOptions) {
  const Levers& levers = levers_of(Quality::standard);
  EXPECT_EQ(levers.contact_stiffness, PairOptions{}.stiffness);
  EXPECT_EQ(levers.integration, ElementOptions{}.integration);
  EXPECT_EQ(levers.smoothing, SphOptions{}.smoothing);
  EXPECT_EQ(scene("").hash, scene("quality: default\n").hash);
}

TEST(Quality, SetsWhatTheDeckLeavesOut) {
  for (const Quality quality : {Quality::quick, Quality::standard, Quality::careful}) {
    const std::string word = kQualities[static_cast<std::size_t>(quality)];
    const LoadedDeck loaded = scene("quality: " + word + "\n");
    const Levers& levers = levers_of(quality);
    EXPECT_EQ(loaded.deck.contact.fallback.stiffness, levers.contact_stiffness) << word;
    EXPECT_EQ(loaded.deck.contact.pairs[0].value.options.stiffness, levers.contact_stiffness);
    EXPECT_EQ(loaded.deck.contact.pairs[1].value.options.stiffness, 3) << "the deck's own";
    EXPECT_EQ(loaded.deck.bodies[0].value.element.integration, levers.integration) << word;
    EXPECT_EQ(loaded.deck.bodies[4].value.sph.smoothing, levers.smoothing) << word;
    EXPECT_EQ(loaded.hash, scene("", {"quality=" + word}).hash) << "by an override";
  }
}

TEST(Quality, CarefulIntegratesFullyWhereAMaterialFlowsAsMetalsDo) {
  const LoadedDeck loaded = scene("quality: careful\n");
  EXPECT_EQ(of(loaded, "glass"), Integration::one_point) << "assumed strain bends right";
  EXPECT_EQ(of(loaded, "lead"), Integration::q1p0);
  EXPECT_EQ(of(loaded, "slab"), Integration::one_point) << "concrete changes its volume";
  EXPECT_EQ(of(loaded, "own"), Integration::one_point) << "its hourglass control is the deck's";
  const LoadedDeck one = scene("quality: careful\n", {"bodies.lead.element.integration=one-point"});
  EXPECT_EQ(of(one, "lead"), Integration::one_point) << "the deck's own";
}

TEST(Quality, ItsEchoReadsBackToTheSameDeck) {
  const LoadedDeck loaded = scene("quality: careful\n");
  EXPECT_EQ(load_deck_text(loaded.resolved, "echo.yaml").resolved, loaded.resolved);
}

TEST(Quality, AWordThatIsNoneIsRefused) { EXPECT_THROW(scene("quality: best\n"), DeckError); }

}  // namespace
}  // namespace brunt::deck
