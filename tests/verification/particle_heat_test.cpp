// Heat between particles of two bodies, and between particles and hexes: half-spaces in perfect
// contact, T = (e1 T1 + e2 T2)/(e1 + e2) = 332.34 degC at the contact, inside T +
// (T_i - T) erfc(|x| / sqrt(4 alpha t)). With particles 2 % of 480 K, at the contact and 1 mm
// inside. The temperature at the contact is that with which as much heat reaches it over half a
// spacing as leaves it, or that of the hexes' nodes there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kZero = 273.15, kTime = 0.01, kTolerance = 0.02 * 480;  // [K], [s], [K]

struct HalfSpace {
  Real k, rho, cp, start;  // [W/m/K], [kg/m^3], [J/kg/K], [degC]
  Real effusivity() const { return std::sqrt(k * rho * cp); }
};
constexpr HalfSpace kHot{237, 2700, 900, 500}, kCold{44.5, 7850, 475, 20};

Real between() {
  return (kHot.effusivity() * kHot.start + kCold.effusivity() * kCold.start) /
         (kHot.effusivity() + kCold.effusivity());
}

/// Largest error [K] of a body next to 1 mm inside, and the mean temperature [degC] of its layer
/// next to the contact, which is half a spacing inside, or on it.
struct Profile {
  Real worst = 0, inside = 0, temperature = 0;
};

Profile profile(const BodyView& body, const HalfSpace& half) {
  const auto field = std::find_if(body.point_fields.begin(), body.point_fields.end(),
                                  [](const Field& f) { return f.name == "temperature"; });
  const std::size_t n = field->values.size();
  Profile profile;
  profile.inside = body.corners == 0 ? 0.05e-3 : 0.0;
  Real nearest = kInfinity, sum = 0;
  int count = 0;
  const auto x = [&](std::size_t i) { return body.position[3 * i] * (half.start > 100 ? -1 : 1); };
  for (std::size_t i = 0; i < n; ++i) nearest = std::min(nearest, x(i));
  for (std::size_t i = 0; i < n; ++i) {
    const Real depth = x(i) - nearest + profile.inside, T = field->values[i] - kZero;
    const Real exact =
        half.start + (between() - half.start) *
                         std::erfc(depth / std::sqrt(4 * half.k / half.rho / half.cp * kTime));
    if (std::fabs(depth - 1e-3) < 0.06e-3) {
      profile.worst = std::max(profile.worst, std::fabs(T - exact));
    }
    if (x(i) < nearest + 1e-9) sum += T, ++count;
  }
  profile.temperature = sum / count;
  return profile;
}

void expect_half_spaces(const std::vector<std::string>& overrides) {
  auto all = overrides;  // conduction prefers few neighbours: the layer at the contact is thin
  for (const auto& one : overrides) {
    const auto method = one.find("method=sph");
    if (method != std::string::npos) all.push_back(one.substr(0, method) + "smoothing=1.2");
  }
  const auto run = simulate_shipped("half-spaces", all);
  ASSERT_EQ(run.failure, "");
  const Profile hot = profile(run.bodies.at("hot"), kHot),
                cold = profile(run.bodies.at("cold"), kCold);
  EXPECT_LT(hot.worst, kTolerance);
  EXPECT_LT(cold.worst, kTolerance);
  // A node on the contact has all the weight.
  const Real to_hot = kHot.k / std::max(hot.inside, 1e-9),
             to_cold = kCold.k / std::max(cold.inside, 1e-9);
  const Real contact = (to_hot * hot.temperature + to_cold * cold.temperature) / (to_hot + to_cold);
  EXPECT_NEAR(contact, between(), kTolerance);
  testing::Test::RecordProperty("contact", std::to_string(contact));
  testing::Test::RecordProperty("worst", std::to_string(std::max(hot.worst, cold.worst)));
  EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
  EXPECT_NEAR(run.last("body.hot.heat"), -run.last("body.cold.heat"),
              1e-12 * run.last("body.cold.heat"));
}

TEST(ParticleHeat, HalfSpacesOfParticles) {
  expect_half_spaces({"bodies.hot.method=sph", "bodies.cold.method=sph"});
}

TEST(ParticleHeat, HalfSpacesOfParticlesAndHexes) {
  expect_half_spaces({"bodies.hot.method=sph"});
  expect_half_spaces({"bodies.cold.method=sph"});
}

// Each layer lies in the hollows of the other, so that a particle touches four: sqrt(1/2) of a
// spacing apart, a little less for rounding.
TEST(ParticleHeat, LatticesNeedNotMatch) {
  expect_half_spaces(
      {"bodies.hot.method=sph", "bodies.cold.method=sph", "parameters.width=0.4 mm",
       "bodies.cold.shape={box: {min: [0, 0, 0], max: [$length, $width, $width]}, translate: "
       "[-0.0294 mm, 0.05 mm, 0.05 mm]}"});
}

// Two bodies that are bonded conduct as one.
TEST(ParticleHeat, BondedBodiesConductAsOne) {
  expect_half_spaces({"bodies.hot.method=sph", "bodies.cold.method=sph",
                      "contact.default={bonded: true, heat: perfect}"});
}

}  // namespace
}  // namespace brunt::test
