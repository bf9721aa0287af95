// Sharp rigid bodies of oak, free, fall at 2 m/s without friction on a floor point first, or on
// another of their kind whose edge crosses theirs. What they hit is held, so that they come back
// as they came: their energy is kept (1 %), and while they turn no deeper into it than their edge.
//
// A point of half angle a has no side that opposes a floor better than sin(a): faces that oppose
// each other by less than a box's edges do, 1/2, must count where bodies are sharp (FacingRamp).
// Edges that cross have none better than sin(a) sin(b), which is nothing: below some 10 degrees
// they push each other themselves (contact/geometry/edge_contact.hpp). tests/cases/chisel-4 and
// knives-12 ask for 1 mm at most.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"
#include "tests/support/source_path.hpp"

namespace brunt::test {
namespace {

Simulation fall(const std::string& name, Real half_angle, Real across = 90, Real roll = 0) {
  const Real half_width = 0.05 * std::tan(half_angle * kPi / 180);
  const std::string w = std::to_string(half_width), less = "-" + w;
  std::vector<std::string> overrides;
  if (name == "chisel-4") {
    overrides = {"bodies.up.shape.polygon.points=[[0, 0.001], [" + w + ", 0.051], [" + less +
                 ", 0.051]]"};
  } else {
    const std::string points = "=[[" + less + ", -0.05], [" + w + ", -0.05], [0, 0]]";
    overrides = {"bodies.low.shape.polygon.points" + points,
                 "bodies.up.shape.polygon.points" + points};
    const Real a = 0.5 * across * kPi / 180, x = std::sin(a), z = std::cos(a);
    const auto list = [](Real first, Real second, Real third) {
      return "=[" + std::to_string(first) + ", " + std::to_string(second) + ", " +
             std::to_string(third) + "]";
    };
    // Its middle, (0, 0, 0.05), comes to lie on the axis of y.
    overrides.push_back("bodies.up.shape.rotate.axis" + list(x, 0, z));
    overrides.push_back("bodies.up.shape.translate" +
                        list(-0.1 * x * z, 0.001, -0.1 * z * z + 0.05));
    if (roll != 0) {
      overrides.push_back("bodies.low.shape.rotate={axis: z, angle: " + std::to_string(roll) +
                          " deg}");
    }
  }
  overrides.push_back("time.end=6 ms");  // they part after 2 ms
  return simulate(load_deck(source_path("tests/cases/" + name + ".yaml"), overrides));
}

/// What contact makes is what steps at the limit of stability do: it goes with their square (knives
/// of 8 degrees: 1.1e-4, 3.0e-5, 1.1e-5 of the energy with a safety of 0.9, 0.45, 0.225).
/// deepest  [m] of the point, which starts 1 mm above
void expect_return(const Simulation& run, Real deepest) {
  ASSERT_EQ(run.failure, "");
  const auto height = run.column("body.up.position.y");
  EXPECT_GT(*std::min_element(height.begin(), height.end()), height.front() - 0.001 - deepest);
  EXPECT_GT(run.last("body.up.velocity.y"), 0);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1.5e-4 * run.first("energy.kinetic"));
}

TEST(Sharp, ChiselsComeBackFromAFloor) {
  for (const Real angle : {2, 4, 12, 30}) {
    SCOPED_TRACE(angle);
    expect_return(fall("chisel-4", angle), 0.001);
  }
}

TEST(Sharp, KnivesThatCrossComeBack) {
  for (const Real angle : {0.5, 2.0, 5.0, 8.0, 10.0, 12.0}) {
    SCOPED_TRACE(angle);
    expect_return(fall("knives-12", angle), 0.001);
  }
  for (const Real angle : {17, 30, 45}) {  // heavier, on the same spring
    SCOPED_TRACE(angle);
    expect_return(fall("knives-12", angle), 0.0025);
  }
}

// Knives whose edges cross 0.3 mm deep at time 0 feel no force until they have closed by more:
// at rest they stay, and thrown at each other they come back as others do. With the force of their
// overlap they made 100 % of the energy within 10 steps.
TEST(Sharp, KnivesThatOverlapAtTimeZeroFeelWhatTheyClose) {
  const std::string path = source_path("tests/cases/knives-12.yaml");
  const std::vector<std::string> overlap = {"bodies.up.shape.translate=[-0.05, -0.0003, 0]",
                                            "time.end=6 ms"};
  auto still = overlap;
  still.push_back("bodies.up.velocity=[0, 0, 0]");
  const Simulation rest = simulate(load_deck(path, still));
  EXPECT_EQ(rest.failure, "");
  EXPECT_EQ(rest.last("energy.kinetic"), 0);
  const Simulation thrown = simulate(load_deck(path, overlap));
  expect_return(thrown, 0.002);
  EXPECT_NEAR(thrown.last("energy.kinetic"), thrown.first("energy.kinetic"),
              0.005 * thrown.first("energy.kinetic"));  // contact damping takes 0.2 %
}

// Blades at other angles than the right one, and rolled about their edges, so that one side opposes
// the other body better and the other not at all: edges and faces share the force, or hand it over
// while they turn. The upper one, heavier on one side, begins to turn when it is hit.
TEST(Sharp, KnivesThatCrossAtAnyAngleComeBack) {
  // The upper knife hangs edge downwards by a half turn about (cos(a/2), 0, sin(a/2)), a from the
  // axis x to z; the lower one is rolled about its edge.
  for (const Real half_angle : {2.0, 6.0, 10.0}) {
    for (const Real across : {30.0, 60.0, 120.0}) {
      for (const Real roll : {0.0, 5.0, 15.0}) {
        SCOPED_TRACE(testing::Message() << half_angle << ' ' << across << ' ' << roll);
        expect_return(fall("knives-12", half_angle, across, roll), 0.001);
      }
    }
  }
}

// Free knives of elements, a rhombus in section so that its edge is as sharp as its elements, meet
// at 1 m/s each, as deep as they dent each other between their nodes. By symmetry they part as fast
// as they came, but for what still swings in them (0.3 %) and contact damping (0.4 %).
TEST(Sharp, KnivesOfElementsThatCrossComeBack) {
  for (const Real half_angle : {2.0, 12.0, 30.0}) {
    SCOPED_TRACE(half_angle);
    const std::string w = std::to_string(0.05 * std::tan(half_angle * kPi / 180));
    const std::string knife =
        "material: oak, size: 12.5 mm, shape: {polygon: {points: [[0, 0], [-" + w +
        ", -0.05], [0, -0.1], [" + w + ", -0.05]], corners: [0, 1, 2, 3], thickness: 0.1}, ";
    const Simulation run = simulate_text(
        "title: knives\ngeometry: 3d\ntime: {end: 4 ms}\n"
        "materials: {oak: {density: 700, elastic: {E: 1 GPa, nu: 0.3}}}\nbodies:\n  low: {" +
        knife + "translate: [0, 0, -0.05]}, velocity: [0, 1, 0]}\n  up: {" + knife +
        "rotate: {axis: [1, 0, 1], angle: 180 deg}, translate: [-0.05, 0.001, 0]}, "
        "velocity: [0, -1, 0]}\ncontact: {default: {friction: 0}}\n"
        "output: {history: 0.05 ms}\n");
    ASSERT_EQ(run.failure, "");
    EXPECT_GT(run.last("body.up.velocity.y"), 0.993);
    EXPECT_LT(run.last("body.low.velocity.y"), -0.993);
    EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.first("energy.kinetic"));
  }
}

// A rigid knife on one of elements of 5 mm, 12 degrees both, at the default step: 1.6 mm deep,
// where the fade of the blades' spring bends its energy 16 times as much as the spring itself.
// Without a bound of the step for that it made 174 % of the energy within 1.2 ms; a step of half
// the limit and one of a ninth lost 0.28 % (contact.pairs: tips that are dented by a fifth of an
// element).
TEST(Sharp, AKnifeOfElementsIsDentedWithoutEnergyOfItsOwn) {
  const auto run = simulate_text(R"(
geometry: 3d
time: {end: 4 ms}
materials: {oak: {density: 700 kg/m^3, elastic: {E: 1 GPa, nu: 0.3}}}
bodies:
  low:
    material: oak
    size: 5 mm
    shape:
      polygon:
        points: [[0, 0], [-10.6 mm, -50 mm], [0, -100 mm], [10.6 mm, -50 mm]]
        corners: [0, 1, 2, 3]
        thickness: 0.1 m
      translate: [0, 0, -50 mm]
  up:
    rigid: true
    material: oak
    shape:
      polygon: {points: [[-10.6 mm, -50 mm], [10.6 mm, -50 mm], [0, 0]], thickness: 0.1 m}
      rotate: {axis: [1, 0, 1], angle: 180 deg}
      translate: [-50 mm, 1 mm, 0]
    velocity: [0, -2 m/s, 0]
boundaries:
  foot: {body: low, where: {box: {min: [-1, -0.2, -1], max: [1, -0.09, 1]}}, fix: [x, y, z]}
contact: {default: {friction: 0}}
output: {every: 2 ms, history: 0.1 ms}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_GT(run.last("body.up.velocity.y"), 1.5);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 0.01 * run.first("energy.kinetic"));
}

}  // namespace
}  // namespace brunt::test
