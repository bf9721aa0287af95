// How far a plan expects elements to flatten.
#include "app/cli/forecast.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

Deck bar_against_wall(const std::string& strength, const std::string& speed) {
  return load_deck_text(
             "time: {end: 1 us}\nmaterials: {m: {density: 8000, elastic: {E: 200 GPa, nu: 0}" +
                 strength +
                 "}}\nbodies:\n  bar: {material: m, size: 1 mm, shape: {box: {min: [0, 0, 0], "
                 "max: [9 mm, 3 mm, 3 mm]}}, velocity: [" +
                 speed +
                 ", 0, 0]}\n  wall: {rigid: true, shape: {plane: {origin: [9 mm, 0, 0], normal: "
                 "[-1, 0, 0], extent: 1 m}}}\n",
             "deck")
      .deck;
}

// A perfectly plastic bar takes up rho v^2/2 = 8000 * 200^2 / 2 = 160 MJ/m^3 at a strain of 160/400
// = 0.4; its face is compressed up to six times as far: exp(2.4) times the steps. The strain is
// integrated in steps of 1e-3.
TEST(Forecast, APlasticBarStopsWhereItsEnergyIsTakenUp) {
  const auto flattening =
      flattening_of(bar_against_wall(", strength: {j2: {yield: 400 MPa}}", "200 m/s"));
  EXPECT_NEAR(flattening.strain, 0.4, 2e-3);
  EXPECT_EQ(flattening.speed, 200);
  EXPECT_NEAR(flattening.most_steps(), std::exp(2.4), 0.15);
}

// With R = H eps the energy is Y eps + H eps^2/2: 400 MPa and 800 MPa take 160 MJ/m^3 at
// (sqrt(400^2 + 2*800*160) - 400)/800 = 0.3062.
TEST(Forecast, HardeningStopsItEarlier) {
  const auto flattening = flattening_of(
      bar_against_wall(", strength: {j2: {yield: 400 MPa, hardening: 800 MPa}}", "200 m/s"));
  EXPECT_NEAR(flattening.strain, 0.3062, 2e-3);
}

// An elastic one is strained by v/c = 10/sqrt(200e9/8000) = 0.002 (nu = 0: M = E).
TEST(Forecast, ElasticBarsHardlyFlatten) {
  const auto flattening = flattening_of(bar_against_wall("", "10 m/s"));
  EXPECT_NEAR(flattening.strain, 0.002, 1e-9);
  EXPECT_LT(flattening.most_steps(), 1.02);
}

}  // namespace
}  // namespace brunt
