// A body that folds onto itself (contact.md 3, test 20). A tube of rubber between two rigid plates
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
Real narrowest(const Simulation& run) {
  const auto top = run.column("probe.top.displacement.y");
  const auto bottom = run.column("probe.bottom.displacement.y");
  Real opening = kInfinity;
  for (std::size_t i = 0; i < top.size(); ++i) {
    opening = std::min(opening, 0.036 + top[i] - bottom[i]);
  }
  return opening;
}

TEST(SelfContact, WallsOfATubeMeet) {
  const auto run = simulate_text(kTube);
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(narrowest(run), -5e-4);
  EXPECT_LT(narrowest(run), 1e-3);
  const auto planes = run.column("contact.inside.planes");
  EXPECT_GT(*std::max_element(planes.begin(), planes.end()), 10);
  EXPECT_LT(run.worst_drift, 1e-12);
  const auto through = simulate_text(kTube, {"contact.pairs.inside.ignore=true"});
  EXPECT_LT(narrowest(through), -2e-3);
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
