// A body that folds onto itself. A tube of rubber between two rigid plates
// that come together buckles inward and its walls meet: without contact they pass through each
// other by more than their thickness of 2 mm, with it by less than half an element (at which faces
// of one body let go). A plate one element thick, paired with itself, stays as it was: its faces
// see each other from behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kTube = kRubber + R"(
title: a tube is crushed flat and touches itself inside
geometry: plane-strain
parameters: {speed: 5 m/s, size: 1 mm}
time: {end: 3.3 ms}
bodies:
  tube:
    material: rubber
    shape: {tube: {inner: 18 mm, outer: 20 mm, base: [0, 0]}}
    size: $size
  above:
    rigid: true
    shape: {plane: {origin: [0, 20 mm], normal: [0, -1], extent: 80 mm}}
    motion: {velocity: [0, -$speed]}
  below:
    rigid: true
    shape: {plane: {origin: [0, -20 mm], normal: [0, 1], extent: 80 mm}}
    motion: {velocity: [0, $speed]}
contact:
  pairs:
    inside: {between: [tube, tube], friction: 0.3}
probes:
  top: {body: tube, at: [0, 18 mm], fields: [displacement.y]}
  bottom: {body: tube, at: [0, -18 mm], fields: [displacement.y]}
output: {history: 5 us}
)";

/// [m] the smallest opening between the two walls.
Real narrowest(const Simulation& run, const std::string& axis = "y") {
  const auto top = run.column("probe.top.displacement." + axis);
  const auto bottom = run.column("probe.bottom.displacement." + axis);
  Real opening = kInfinity;
  for (std::size_t i = 0; i < top.size(); ++i) {
    opening = std::min(opening, 0.036 + top[i] - bottom[i]);
  }
  return opening;
}

/// The walls meet; where the tube may not touch itself they pass through each other.
void expect_walls_meet(std::vector<std::string> overrides) {
  const auto run = simulate_text(kTube, overrides);
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(narrowest(run), -5e-4);
  EXPECT_LT(narrowest(run), 1e-3);
  const auto planes = run.column("contact.inside.planes");
  EXPECT_GT(*std::max_element(planes.begin(), planes.end()), 10);
  EXPECT_LT(run.worst_drift, 1e-12);
  overrides.emplace_back("contact.pairs.inside.ignore=true");
  EXPECT_LT(narrowest(simulate_text(kTube, overrides)), -2e-3);
}

TEST(SelfContact, WallsOfATubeMeet) { expect_walls_meet({}); }

// A wall of one element, both sides free, lets go at a quarter of it, 0.5 mm (q1p0: one-point
// elements in one layer do not bend).
TEST(SelfContact, WallsOfOneElementMeet) {
  expect_walls_meet({"parameters.size=2 mm", "bodies.tube.element={integration: q1p0}"});
}

TEST(SelfContact, KeepsItsBits) {
  const auto run = simulate_text(kTube);
  RunVariation threads, lists, halves;
  threads.threads = 2;
  lists.rearrange_every_step = true;
  halves.split_at = run.steps - 20;
  for (const auto& variation : {threads, lists, halves}) {
    EXPECT_EQ(simulate_text(kTube, {}, variation).hashes, run.hashes);
  }
  EXPECT_EQ(simulate_text(kTube, {"contact.skin=2 mm"}).hashes, run.hashes);
}

const std::string kTubeInSpace = kRubber + R"(
title: a short tube is crushed flat and touches itself inside
geometry: 3d
parameters: {speed: 5 m/s}
time: {end: 3.3 ms}
bodies:
  tube:
    material: rubber
    shape: {tube: {inner: 18 mm, outer: 20 mm, length: 4 mm, base: [0, -2 mm, 0], axis: y}}
    size: 1 mm
  above:
    rigid: true
    shape: {plane: {origin: [0, 0, 20 mm], normal: [0, 0, -1], extent: 80 mm}}
    motion: {velocity: [0, 0, -$speed]}
  below:
    rigid: true
    shape: {plane: {origin: [0, 0, -20 mm], normal: z, extent: 80 mm}}
    motion: {velocity: [0, 0, $speed]}
contact:
  pairs:
    inside: {between: [tube, tube], friction: 0.3}
probes:
  top: {body: tube, at: [0, 0, 18 mm], fields: [displacement.z]}
  bottom: {body: tube, at: [0, 0, -18 mm], fields: [displacement.z]}
output: {history: 5 us}
)";

/// How many points of a tube about y lie inside elements of the outer half of its wall that are not
/// their own: on the inner side of all six mean planes of their faces.
int count_crossed(const BodyView& tube) {
  const auto& moved = field_named(tube.point_fields, "displacement")->values;
  const auto at = [&](std::int64_t point) {
    const auto i = 3 * static_cast<std::size_t>(point);
    return Vec3(tube.position[i], tube.position[i + 1], tube.position[i + 2]);
  };
  const auto radius_at_start = [&](std::int64_t point) {
    const auto i = 3 * static_cast<std::size_t>(point);
    return std::hypot(tube.position[i] - moved[i], tube.position[i + 2] - moved[i + 2]);
  };
  constexpr std::array<std::array<int, 4>, 6> kSides = {
      {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
  const auto n = static_cast<std::int64_t>(tube.position.size() / 3);
  int crossed = 0;
  for (auto hex = tube.connectivity.begin(); hex != tube.connectivity.end(); hex += 8) {
    Real radius = 0;
    Vec3 center = Vec3::Zero();
    for (int c = 0; c < 8; ++c) radius += radius_at_start(hex[c]) / 8, center += at(hex[c]) / 8;
    if (radius < 19e-3) continue;
    for (std::int64_t point = 0; point < n; ++point) {
      const Vec3 x = at(point);
      if ((x - center).norm() > 1.5e-3 || std::find(hex, hex + 8, point) != hex + 8) continue;
      bool inside = true;
      for (const auto& side : kSides) {
        const Vec3 a = at(hex[side[0]]), b = at(hex[side[1]]), c = at(hex[side[2]]),
                   d = at(hex[side[3]]);
        const Vec3 normal = (c - a).cross(d - b), middle = 0.25 * (a + b + c + d);
        inside = inside && normal.dot(x - middle) * normal.dot(center - middle) > 0;
      }
      crossed += inside;
    }
  }
  return crossed;
}

// As in the plane; at its end no point has gone through the inner half of the wall.
TEST(SelfContact, WallsOfATubeMeetInSpace) {
  const auto run = simulate_text(kTubeInSpace);
  ASSERT_EQ(run.failure, "");
  const auto through = simulate_text(kTubeInSpace, {"contact.pairs.inside.ignore=true"});
  EXPECT_GT(narrowest(run, "z"), -5e-4);
  EXPECT_LT(narrowest(run, "z"), 1e-3);
  EXPECT_EQ(count_crossed(run.bodies.at("tube")), 0);
  const auto planes = run.column("contact.inside.planes");
  EXPECT_GT(*std::max_element(planes.begin(), planes.end()), 10);
  EXPECT_LT(run.worst_drift, 1e-12);
  EXPECT_LT(narrowest(through, "z"), -2e-3);
  EXPECT_GT(count_crossed(through.bodies.at("tube")), 10);
}

const std::string kPlate = kRubber + R"(
title: a plate one element thick
geometry: 3d
time: {end: 0.1 ms}
bodies:
  plate:
    material: rubber
    shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 1 mm]}}
    cells: [5, 5, 1]
contact:
  pairs:
    itself: {between: [plate, plate]}
)";

TEST(SelfContact, AThinPlateDoesNotFeelItself) {
  const auto run = simulate_text(kPlate);
  ASSERT_EQ(run.failure, "");
  const auto without = simulate_text(kPlate, {"contact.pairs.itself.ignore=true"});
  EXPECT_EQ(run.column("energy.kinetic"), without.column("energy.kinetic"));
  for (const Real planes : run.column("contact.itself.planes")) EXPECT_EQ(planes, 0);
}

}  // namespace
}  // namespace brunt::test
