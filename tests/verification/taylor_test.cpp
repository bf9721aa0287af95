// Taylor bar of bilinear copper at 227 m/s: L 32.4 mm, R 3.2 mm, 80 us. The
// gate is code to code: an independent axisymmetric Q1P0 program gave, at 8 x 80 elements,
//   t us            10     20     30     40     50     60     70     80
//   length mm   30.143 28.077 26.209 24.590 23.252 22.244 21.621 21.453
//   radius mm    5.150  6.140  6.764  7.097  7.191  7.188  7.188  7.186
// and foot radii of 7.159, 7.186, 7.197, 7.212 mm at 5, 8, 10, 16 elements a radius, towards 7.22.
// As there, the wall is u_z = 0 on the foot. The shipped decks have a rigid anvil in contact
// instead, on which the rim of the foot may roll.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// The shipped deck with the wall of the reference.
std::vector<std::string> held_foot() {
  return {"contact.default.ignore=true",
          "boundaries.foot={body: bar, where: {side: min-y}, fix: [y]}"};
}

TEST(TaylorAxisymmetric, FollowsTheReferenceHistory) {
  static constexpr Real length[] = {30.143, 28.077, 26.209, 24.590, 23.252, 22.244, 21.621, 21.453};
  static constexpr Real radius[] = {5.150, 6.140, 6.764, 7.097, 7.191, 7.188, 7.188, 7.186};
  std::vector<std::string> overrides = held_foot();
  for (int k = 1; k < 8; ++k) {
    const std::string at = std::to_string(10 * k), n = std::to_string(k);
    overrides.push_back("measures.length" + n + "={extent: {body: bar, axis: y}, at: " + at +
                        " us}");
    overrides.push_back("measures.radius" + n + "={extent: {body: bar, axis: x}, at: " + at +
                        " us}");
  }
  const auto run = simulate_shipped("taylor-bar-axisymmetric", overrides);
  ASSERT_EQ(run.failure, "");
  for (int k = 1; k <= 8; ++k) {
    const auto n = k < 8 ? std::to_string(k) : std::string();
    EXPECT_NEAR(1e3 * run.measures.at("length" + n), length[k - 1], 0.1) << 10 * k << " us";
    EXPECT_NEAR(1e3 * run.measures.at(k < 8 ? "radius" + n : "foot_radius"), radius[k - 1], 0.06)
        << 10 * k << " us";
  }
  EXPECT_NEAR(run.measures.at("strain"), 3.22, 0.15);
  EXPECT_LT(run.worst_drift, 0.01);
}

TEST(TaylorAxisymmetric, FootRadiusRisesTowardsTheConvergedOne) {
  Real before = 0;
  for (const char* cells : {"[5, 50]", "[8, 80]", "[10, 100]"}) {
    auto overrides = held_foot();
    overrides.push_back(std::string("bodies.bar.cells=") + cells);
    const auto run = simulate_shipped("taylor-bar-axisymmetric", overrides);
    ASSERT_EQ(run.failure, "") << cells;
    const Real radius = 1e3 * run.measures.at("foot_radius");
    EXPECT_GT(radius, before) << cells;
    EXPECT_LT(radius, 7.22 + 0.02) << cells;
    before = radius;
  }
}

const char* const kHeldFoot =
    "contact: {default: {ignore: true}}\n"
    "boundaries: {foot: {body: bar, where: {side: min-z}, fix: [z]}}\n";
/// The same bar in 3D; extra stands among the keys of the bar.
std::string bar3(const std::string& extra, const std::string& wall) {
  return R"(
title: Taylor bar in 3D
geometry: 3d
time: {end: 80 us, safety: 0.9}
)" + kTaylorCopper +
         R"(bodies:
  bar:
    material: copper
    shape: {cylinder: {radius: 3.2 mm, length: 32.4 mm, base: [0, 0, 0], axis: z}}
    velocity: [0, 0, -227 m/s]
)" + extra +
         R"(
)" + wall +
         R"(
measures:
  length: {extent: {body: bar, axis: z}}
  width: {extent: {body: bar, axis: x}}
output: {history: 0.5 us}
)";
}

TEST(TaylorLong, OnePointHexesWithViscousHourglass) {
  const auto run = simulate_text(
      bar3("    method: fe\n    cells: [8, 8, 80]\n    element: {hourglass: {viscous: 0.1}}",
           kHeldFoot));
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(1e3 * run.measures.at("length"), 21.48, 0.15);
  EXPECT_NEAR(0.5e3 * run.measures.at("width"), 7.12, 0.10);
  EXPECT_LT(run.worst_drift, 0.01);
}

TEST(TaylorLong, Q1P0HexesHaveTheLengthAndFootOfTheReference) {
  const auto run = simulate_text(
      bar3("    method: fe\n    cells: [8, 8, 80]\n    element: {integration: q1p0}", kHeldFoot));
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(1e3 * run.measures.at("length"), 21.43, 0.15);
  EXPECT_NEAR(0.5e3 * run.measures.at("width"), 7.20, 0.10);
  EXPECT_LT(run.worst_drift, 0.01);
}

/// Diameter [m] of a body of particles about the z axis at a height [m]: a line through the radii
/// of its outermost particles, by sector and layer within two spacings of it. (The widest of a band
/// would be that of its lower edge: the bar is a cone there.)
Real diameter_at(const BodyView& bar, Real height) {
  constexpr std::size_t kSectors = 24, kLayers = 4;
  std::array<std::pair<Real, Real>, kSectors * kLayers> outermost{};  // radius, z
  for (std::size_t i = 0; i < bar.point_radius.size(); ++i) {
    const Real* x = bar.position.data() + 3 * i;
    const Real spacing = 2 * bar.point_radius[i], up = (x[2] - height) / spacing + 2;
    if (!(up >= 0 && up < kLayers)) continue;
    const Real turn = (std::atan2(x[1], x[0]) / kPi + 1) / 2;
    const auto sector = std::min(static_cast<std::size_t>(turn * kSectors), kSectors - 1);
    auto& best = outermost[sector * kLayers + static_cast<std::size_t>(up)];
    best = std::max(best, {std::hypot(x[0], x[1]) + 0.5 * spacing, x[2]});
  }
  Real n = 0, z = 0, r = 0, zz = 0, zr = 0;  // sums of the least squares
  for (const auto& [radius, at] : outermost) {
    if (radius == 0) continue;
    const Real dz = at - height;
    n += 1, z += dz, r += radius, zz += dz * dz, zr += dz * radius;
  }
  return 2 * (zz * r - z * zr) / (n * zz - z * z);
}

// The deck that ships, at 10 particles a radius. W(0.2 L0) = 8.07 mm by the same reference.
TEST(TaylorLong, ParticlesHaveTheLengthAndFootOfTheReference) {
  const auto run = simulate_shipped("taylor-bar-sph", {"parameters.spacing=0.32 mm"});
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(1e3 * run.measures.at("length"), 21.43, 0.03 * 21.43);
  EXPECT_NEAR(0.5e3 * run.measures.at("foot_diameter"), 7.20, 0.06 * 7.20);
  EXPECT_NEAR(1e3 * diameter_at(run.bodies.at("bar"), 0.2 * 32.4e-3), 8.07, 0.02 * 8.07);
  EXPECT_LT(run.worst_drift, 0.01);
}

}  // namespace
}  // namespace brunt::test
