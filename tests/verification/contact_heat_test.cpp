// Heat across contacts. Half-spaces: T = (e1 T1 + e2 T2)/(e1 + e2) at the
// contact, e = sqrt(k rho cp); inside, T + (T_i - T) erfc(|x| / sqrt(4 alpha t)). Rod: q =
// dT/(L/k1 + 1/h + L/k2). Tolerances are those of the page: 0.5 % of 480 K at the contact, 1 % of
// it inside, 0.5 % of the rod's.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kZero = 273.15;
constexpr Real kAluminium = 237, kSteel = 44.5;  // [W/m/K]

Real effusivity(Real k, Real rho, Real cp) { return std::sqrt(k * rho * cp); }

void expect_half_spaces(const Simulation& run, Real t) {
  ASSERT_EQ(run.failure, "");
  const Real e1 = effusivity(kAluminium, 2700, 900), e2 = effusivity(kSteel, 7850, 475);
  const Real between = (e1 * 500 + e2 * 20) / (e1 + e2);
  const auto inside = [&](Real far, Real k, Real rho, Real cp) {
    return far + (between - far) * std::erfc(1e-3 / std::sqrt(4 * k / rho / cp * t));
  };
  EXPECT_NEAR(run.measures.at("contact") - kZero, between, 0.005 * 480);
  EXPECT_NEAR(run.measures.at("inside_hot") - kZero, inside(500, kAluminium, 2700, 900), 4.8);
  EXPECT_NEAR(run.measures.at("inside_cold") - kZero, inside(20, kSteel, 7850, 475), 4.8);
  EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
  // What one loses the other gains.
  EXPECT_NEAR(run.last("body.hot.heat"), -run.last("body.cold.heat"),
              1e-12 * run.last("body.cold.heat"));
}

TEST(HalfSpaces, HexesMeetAtTheTemperatureBetween) {
  expect_half_spaces(simulate_shipped("half-spaces"), 0.01);
}

// Meshes that do not match, and quads.
TEST(HalfSpaces, MeshesNeedNotMatch) {
  expect_half_spaces(
      simulate_shipped("half-spaces", {"bodies.cold.size=[0.1 mm, 0.07 mm, 0.1 mm]"}), 0.01);
  expect_half_spaces(
      simulate_shipped(
          "half-spaces",
          {"geometry=plane-strain", "bodies.cold.size=[0.1 mm, 0.07 mm]",
           "bodies.hot.shape={box: {min: [-$length, 0], max: [0, $width]}}",
           "bodies.cold.shape={box: {min: [0, 0], max: [$length, $width]}}",
           "boundaries.hot_still.fix=[x, y]", "boundaries.cold_still.fix=[x, y]",
           "measures.contact.point.at=[0, 0]", "measures.inside_hot.point.at=[-1 mm, 0]",
           "measures.inside_cold.point.at=[1 mm, 0]"}),
      0.01);
}

void expect_rod(const std::vector<std::string>& overrides, Real conductance) {
  const auto run = simulate_shipped("composite-rod", overrides);
  ASSERT_EQ(run.failure, "");
  const Real flux = 100 / (0.05 / kAluminium + 1 / conductance + 0.05 / kSteel);
  EXPECT_NEAR(run.last("contact.aluminium-steel.heat_rate"), -flux * 25e-6, 5e-3 * flux * 25e-6);
  EXPECT_NEAR(run.measures.at("before") - kZero, 100 - flux * 0.05 / kAluminium, 0.5);
  EXPECT_NEAR(run.measures.at("behind") - kZero, flux * 0.05 / kSteel, 0.5);
}

TEST(CompositeRod, CarriesTheHeatOfItsResistances) {
  expect_rod({}, 1e4);
  expect_rod({"contact.default.heat=perfect"}, kInfinity);
}

// Heat of friction and of plastic work is all that a hot block and a cold plate store together,
// and the heat of friction is what friction took from their motion.
TEST(HotBlock, HeatAddsUp) {
  const auto run = simulate_shipped("hot-block", {"time.end=60 us"});
  ASSERT_EQ(run.failure, "");
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  EXPECT_GT(run.last("heat.friction"), 0);
  EXPECT_NEAR(run.last("heat.friction"), run.last("energy.contact.friction"),
              1e-10 * run.last("energy.contact.friction"));
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
}

}  // namespace
}  // namespace brunt::test
