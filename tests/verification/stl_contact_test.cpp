// A rigid box from an STL file, two triangles a side, and the same from `box`, one quad a side, hit
// by particles and by hexes: the same answer. A particle feels its nearest point, so that nothing
// but rounding can differ. Between faces k g is integrated over their overlap, whose parts add up
// to the same force and moment however they are cut, and is shared among corners at each part's
// centre of pressure: where a diagonal runs through a face of hexes, only that may differ.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"
#include "tests/support/stl_box.hpp"

namespace brunt::test {
namespace {

const std::string kDeck = R"(
parameters: {x: 0 mm, y: 0 mm}
time: {end: 3 ms, max_step: 5 us}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 10 MPa, nu: 0.3}}
  oak: {density: 700 kg/m^3, elastic: {E: 1.5 GPa, nu: 0.3}}
contact: {default: {friction: 0.3}}
output: {history: 50 us}
)";
const std::string kBodies = R"(
bodies:
  block:
    material: rubber
    shape:
      box: {min: [-9 mm, -9 mm, 0.313 mm], max: [9 mm, 9 mm, 12.313 mm]}
      translate: [$x, $y, 0]
    size: 3 mm
    velocity: [0.47 m/s, 0.2 m/s, -1.5 m/s]
  box: {rigid: true, )";

/// The block on a box of triangles or quads, held or free.
Simulation hit(bool triangles, bool free, const std::vector<std::string>& overrides) {
  const std::string shape =
      triangles ? "file: " + write_stl_box("box", {-30, -30, -20}, {30, 30, 0}) + ", scale: 1 mm"
                : "shape: {box: {min: [-30 mm, -30 mm, -20 mm], max: [30 mm, 30 mm, 0]}}";
  const std::string material = free ? "material: oak, velocity: [0, 0, 0.2 m/s], " : "";
  return simulate_text(kDeck + kBodies + material + shape + "}\n", overrides);
}

/// Largest difference of a column over its largest value.
Real difference(const Simulation& a, const Simulation& b, const std::string& column) {
  const auto one = a.column(column), other = b.column(column);
  EXPECT_EQ(one.size(), other.size());
  Real worst = 0, largest = 0;
  for (std::size_t i = 0; i < std::min(one.size(), other.size()); ++i) {
    worst = std::max(worst, std::fabs(one[i] - other[i]));
    largest = std::max(largest, std::fabs(one[i]));
  }
  EXPECT_GT(largest, 0) << column;
  return worst / largest;
}

/// By how much the answers differ, a number a column.
std::vector<Real> differences(bool free, const std::vector<std::string>& overrides) {
  const auto mesh = hit(true, free, overrides), box = hit(false, free, overrides);
  EXPECT_EQ(mesh.failure + box.failure, "");
  EXPECT_GT(box.last("body.block.velocity.z"), 0);  // it came back
  EXPECT_EQ(mesh.steps, box.steps);
  std::vector<std::string> columns = {"body.block.velocity.x", "body.block.velocity.z",
                                      "body.block.internal", "contact.block-box.force.z"};
  if (free) columns.insert(columns.end(), {"body.box.velocity.z", "body.box.spin.x"});
  std::vector<Real> all;
  all.reserve(columns.size());
  for (const auto& column : columns) all.push_back(difference(mesh, box, column));
  return all;
}

void expect_same(const std::vector<std::string>& overrides, Real tolerance) {
  for (const bool free : {false, true}) {
    for (const Real off : differences(free, overrides)) EXPECT_LT(off, tolerance) << free;
  }
}

// Some hundred steps of roundings of 1e-16.
TEST(StlContact, ParticlesFeelTheSameBox) {
  expect_same({"bodies.block.method=sph", "parameters.x=3 mm", "parameters.y=-2 mm"}, 1e-12);
}

// A file that is inside out is the same body, held or free: it would touch nothing from outside.
TEST(StlContact, ABoxThatIsInsideOutIsTurned) {
  for (const bool free : {false, true}) {
    const auto run = [&](bool outward) {
      const std::string file = write_stl_box("turned", {-30, -30, -20}, {30, 30, 0}, outward);
      const std::string material = free ? "material: oak, velocity: [0, 0, 0.2 m/s], " : "";
      return simulate_text(kDeck + kBodies + material + "file: " + file + ", scale: 1 mm}\n",
                           {"bodies.block.method=sph"});
    };
    const auto inside_out = run(false), box = run(true);
    ASSERT_EQ(inside_out.failure + box.failure, "");
    EXPECT_GT(box.last("body.block.velocity.z"), 0);
    for (const std::string column : {"body.block.velocity.z", "contact.block-box.force.z"}) {
      EXPECT_LT(difference(inside_out, box, column), 1e-12) << column;
    }
    EXPECT_NEAR(inside_out.last("body.box.position.z"), box.last("body.box.position.z"), 1e-12);
  }
}

// Friction sees slips of some um in places of some cm, and roundings of 1e-11 of them, which
// nodes that stick and let go make larger.
TEST(StlContact, HexesWithinATriangleFeelTheSameBox) {
  const std::vector<std::string> within = {"parameters.x=15 mm", "parameters.y=-15 mm"};
  expect_same(within, 1e-6);
  auto smooth = within;
  smooth.emplace_back("contact.default.friction=0");
  expect_same(smooth, 1e-12);
}

// What is shared otherwise is the change of the pressure over a face, and vanishes with its size:
// elements half as large differ by less than half.
TEST(StlContact, HexesOnADiagonalFeelTheSameBoxAsTheyBecomeSmaller) {
  for (const bool free : {false, true}) {
    const std::vector<std::string> across = {"parameters.x=3 mm", "parameters.y=-2 mm",
                                             "bodies.block.element.hourglass={stiffness: 0.05}"};
    auto fine = across;
    fine.emplace_back("bodies.block.size=1.5 mm");
    const auto large = differences(free, across), small = differences(free, fine);
    for (std::size_t i = 0; i < large.size(); ++i) {
      EXPECT_LT(large[i], 1e-3) << i << free;
      EXPECT_LT(small[i], 0.5 * large[i]) << i << free;
    }
  }
}

}  // namespace
}  // namespace brunt::test
