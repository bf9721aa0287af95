// Free rigid bodies in whole decks: closed forms of collisions, slopes, falls and drag; momentum,
// angular momentum and energy with elements, particles, held faces and each other.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kMaterials = R"(
materials:
  steel: {density: 7800, elastic: {E: 200 GPa, nu: 0.3}}
  brass: {density: 8500, elastic: {E: 100 GPa, nu: 0.35}}
  aluminium: {density: 2700, elastic: {E: 70 GPa, nu: 0.33}}
  nylon: {density: 1150, elastic: {E: 3 GPa, nu: 0.4}}
  oak: {density: 700, elastic: {E: 1.5 GPa, nu: 0.3}}
)";

Simulation run(const std::string& text, const std::vector<std::string>& overrides = {},
               const SceneHooks& hooks = {}) {
  return simulate_text(kMaterials + text, overrides, {}, hooks);
}

/// Angular momentum of all points and free bodies about the scene's origin, at a whole step.
Vec3 angular_momentum(const Scene<3>& scene) {
  Vec3 sum = Vec3::Zero();
  for (const auto& solid : scene.solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      sum += points.mass[i] * points.x[i].cross(points.v[i]);
    }
  }
  for (const auto& body : scene.rigid->all()) {
    sum += body.state.momentum + body.state.mass * body.state.x.cross(body.state.v);
  }
  return sum;
}

/// How far the angular momentum leaves that of the start, of the sum of its parts' sizes.
struct MomentWatch {
  Vec3 start = Vec3::Zero();
  bool seen = false;
  Real worst = 0;  // [N m s]
  SceneHooks hooks() {
    SceneHooks hooks;
    hooks.step_done = [this](const Scene<3>& scene, const Clock&) {
      const Vec3 now = angular_momentum(scene);
      if (!seen) start = now, seen = true;
      worst = std::max(worst, (now - start).norm());
    };
    return hooks;
  }
};

const std::string kHeadOn = R"(
time: {end: 0.8 ms, max_step: 20 ns}
bodies:
  left: {rigid: true, material: steel, velocity: [10, 0, 0],
         shape: {box: {min: [-22 mm, 0, 0], max: [-2 mm, 20 mm, 20 mm]}}}
  right: {rigid: true, material: brass, velocity: [-5, 0, 0],
          shape: {box: {min: [2 mm, 0, 0], max: [12 mm, 20 mm, 20 mm]}}}
contact: {default: {friction: 0.3, damping: 0}}
)";

// Two boxes of 62.4 and 34 g, flat on each other at 10 and -5 m/s: u = (m1 v1 + m2 v2)/(m1 + m2),
// v' = 2 u - v. The spring of one side turns motion back without loss; entering and leaving contact
// between two steps costs order (omega dt)^2 of the energy, here 1e-5.
TEST(Rigid, TwoBoxesHeadOnExchangeMomentum) {
  const auto result = run(kHeadOn);
  ASSERT_EQ(result.failure, "");
  const Real left = 7800 * 8e-6, right = 8500 * 4e-6;
  const Real common = (left * 10 - right * 5) / (left + right);
  EXPECT_NEAR(result.last("body.left.mass"), left, 1e-15);
  EXPECT_NEAR(result.last("body.left.velocity.x"), 2 * common - 10, 1e-4 * 15);
  EXPECT_NEAR(result.last("body.right.velocity.x"), 2 * common + 5, 1e-4 * 15);
  EXPECT_NEAR(result.last("momentum.x"), left * 10 - right * 5, 1e-15);
  EXPECT_EQ(result.last("energy.contact.spring"), 0);
  EXPECT_LT(std::fabs(result.last("energy.contact.pairs")), 1e-4 * result.first("energy.kinetic"));
  EXPECT_LT(result.worst_drift, 1e-12);
  EXPECT_NEAR(result.last("body.left.spin.z"), 0, 1e-9);
}

// With damping the boxes part more slowly, and what is lost stands in its column.
TEST(Rigid, DampingTakesWhatItBooks) {
  const auto result = run(kHeadOn, {"contact.default.damping=0.1"});
  const Real apart = result.last("body.right.velocity.x") - result.last("body.left.velocity.x");
  EXPECT_LT(apart, 0.98 * 15);
  EXPECT_GT(apart, 0.6 * 15);
  const Real lost = result.first("energy.kinetic") - result.last("energy.kinetic");
  EXPECT_NEAR(lost, result.last("energy.contact.damping"), 1e-3 * lost);
  EXPECT_LT(result.worst_drift, 1e-12);
}

const std::string kSlope = R"(
time: {end: 40 ms}
parameters: {mu: 0.3, g: 9.81 m/s^2}
bodies:
  block: {rigid: true, material: oak, shape: {box: {min: [-30 mm, -20 mm, 0],
    max: [30 mm, 20 mm, 20 mm]}}}
  slope: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 400 mm}}}
gravity: [= 0.5*$g, 0, = -cos(pi/6)*$g]
contact: {default: {friction: $mu, damping: 1}}
output: {history: 0.5 ms}
)";

// A slope of 30 deg, which gravity shows: a = g (sin 30 - mu cos 30). A block that settles into its
// springs first is pressed by its weight on average.
TEST(Rigid, BlockSlidesDownASlope) {
  const auto result = run(kSlope);
  ASSERT_EQ(result.failure, "");
  const Real a = 9.81 * (0.5 - 0.3 * std::cos(kPi / 6));
  EXPECT_NEAR(result.last("body.block.velocity.x"), a * 0.04, 1e-3 * a * 0.04);
  EXPECT_NEAR(result.last("body.block.position.x"), a * 0.04 * 0.04 / 2, 2e-3 * a * 8e-4);
  // Its friction is mu of its weight on the slope, and its heat what gravity gave but motion.
  const Real weight = 700 * 48e-6 * 9.81 * std::cos(kPi / 6);
  EXPECT_NEAR(result.last("energy.contact.friction"),
              0.3 * weight * result.last("body.block.position.x"), 1e-2 * 0.3 * weight * 2e-3);
  EXPECT_LT(result.worst_drift, 1e-12);
}

// tan 30 = 0.577 < 0.6: it stays where it is, but for the shear of its springs, under a micrometre.
TEST(Rigid, BlockThatIsGrippedStays) {
  const auto result = run(kSlope, {"parameters.mu=0.6"});
  ASSERT_EQ(result.failure, "");
  EXPECT_LT(std::fabs(result.last("body.block.position.x")), 1e-6);
  EXPECT_LT(result.worst_drift, 1e-10);  // of an energy that is next to none
}

const std::string kDrop = R"(
time: {end: 1.2 ms, max_step: 0.5 us}
parameters: {angle: 0 deg}
bodies:
  plate: {material: nylon, shape: {box: {min: [-30 mm, -30 mm, -9 mm], max: [30 mm, 30 mm, 0]}},
    cells: [10, 10, 3]}
  cube:
    rigid: true
    material: oak
    shape: {box: {min: [-9 mm, -11 mm, 8 mm], max: [11 mm, 9 mm, 28 mm]},
      rotate: {axis: [1, -1, 0], angle: $angle, about: [1 mm, -1 mm, 18 mm]}}
    velocity: [1, 0, -10]
contact: {default: {friction: 0.3}}
output: {history: 10 us}
)";

// A cube that falls flat, on an edge and on a corner onto a plate that nothing holds: no force
// comes from outside, so that both momenta stay to rounding (1e-12 of that of the cube, about a
// centimetre), and all energy columns sum up to the start's.
TEST(Rigid, CubeOnAPlateKeepsMomentaAndEnergy) {
  for (const char* angle : {"0 deg", "20 deg", "54.7356 deg"}) {
    MomentWatch watch;
    const auto result = run(kDrop, {std::string("parameters.angle=") + angle}, watch.hooks());
    ASSERT_EQ(result.failure, "") << angle;
    const Real momentum = 700 * 8e-6 * 10;
    EXPECT_GT(result.last("body.cube.velocity.z"), -2) << angle;  // it has been stopped
    for (const char* axis : {"x", "y", "z"}) {
      const std::string column = std::string("momentum.") + axis;
      EXPECT_NEAR(result.last(column), result.first(column), 1e-12 * momentum) << angle << axis;
    }
    EXPECT_LT(watch.worst, 1e-12 * momentum * 0.01) << angle;
    EXPECT_LT(result.worst_drift, 1e-12) << angle;
    // What the chords of points leave is the angle of a step, 2e-4, times what forces change in it,
    // a thirteenth where a corner reaches into the barrier; all steps are alike but the last one,
    // which `end` shortens.
    const auto integration = result.column("energy.integration");
    EXPECT_LT(std::fabs(integration[integration.size() - 2]), 1.5e-5 * 0.28) << angle;
  }
}

// The same of a steel box that particles hit off its centre while it turns. Angular momentum is
// kept to rounding too where particles have no artificial stress, whose forces have a moment (unit
// sph angular_momentum_test.cpp).
TEST(Rigid, ParticlesOnABoxKeepMomentaAndEnergy) {
  MomentWatch watch;
  const auto result = run(R"(
time: {end: 0.15 ms}
bodies:
  block: {method: sph, smoothing: 1.2, material: aluminium, size: 2 mm,
    shape: {box: {min: [-6 mm, -6 mm, 11 mm],
    max: [6 mm, 6 mm, 17 mm]}}, velocity: [0, 0, -20], artificial_stress: 0}
  box: {rigid: true, material: steel, shape: {box: {min: [-5 mm, -12 mm, 0],
    max: [15 mm, 12 mm, 10 mm]}}, spin: {axis: y, rate: 100 rad/s, about: [5 mm, 0, 5 mm]}}
contact: {default: {friction: 0.3}}
output: {history: 5 us}
)",
                          {}, watch.hooks());
  ASSERT_EQ(result.failure, "");
  const Real momentum = std::fabs(result.first("momentum.z"));
  EXPECT_GT(std::fabs(result.last("body.box.velocity.z")), 0.1);
  EXPECT_NEAR(result.last("momentum.z"), result.first("momentum.z"), 1e-12 * momentum);
  EXPECT_LT(result.worst_drift, 1e-12);
  EXPECT_LT(watch.worst, 1e-12 * momentum * 0.01);
}

// Plane strain: a triangle with spin on a plate, both free.
TEST(Rigid, TriangleOnAPlateInPlaneStrain) {
  const auto result = run(R"(
geometry: plane-strain
depth: 0.1 m
time: {end: 2.5 ms}
bodies:
  plate: {material: nylon, shape: {box: {min: [-40 mm, -10 mm], max: [40 mm, 0]}}, cells: [16, 3]}
  tri:
    rigid: true
    material: oak
    shape: {polygon: {points: [[-10 mm, 5 mm], [20 mm, 12 mm], [0, 25 mm]]}}
    velocity: [1, -5]
    spin: {rate: 60 rad/s, about: [3 mm, 14 mm]}
contact: {default: {friction: 0.3}}
output: {history: 10 us}
)");
  ASSERT_EQ(result.failure, "");
  EXPECT_EQ(result.first("body.tri.spin.z"), 60);
  EXPECT_GT(std::fabs(result.last("body.tri.spin.z") - 60), 1);  // it has touched
  for (const char* column : {"momentum.x", "momentum.y"}) {
    EXPECT_NEAR(result.last(column), result.first(column), 1e-12 * 0.09);
  }
  EXPECT_LT(result.worst_drift, 1e-12);
}

// Axisymmetric: a ball moves along the axis alone.
TEST(Rigid, BallOnARoundPlate) {
  const auto result = run(R"(
geometry: axisymmetric
time: {end: 0.5 ms}
bodies:
  plate: {material: nylon, shape: {cylinder: {radius: 40 mm, length: 10 mm, base: [0, -10 mm]}},
    cells: [16, 4]}
  ball: {rigid: true, material: oak, shape: {sphere: {radius: 10 mm, center: [0, 11 mm]}},
    velocity: [0, -5]}
contact: {default: {friction: 0.3}}
output: {history: 10 us}
)");
  ASSERT_EQ(result.failure, "");
  EXPECT_GT(result.last("body.ball.velocity.y"), 0);
  EXPECT_EQ(result.last("body.ball.position.x"), 0);
  EXPECT_NEAR(result.last("momentum.y"), result.first("momentum.y"), 1e-12 * 0.0145);
  EXPECT_LT(result.worst_drift, 1e-12);
}

// Two components prescribed, one free under gravity: z = z0 + v t - g t^2/2 but for the first half
// step, which no force has yet (g dt t/2), and x as prescribed to rounding.
TEST(Rigid, FreeComponentFallsWhileTheOthersArePrescribed) {
  const auto result = run(R"(
time: {end: 0.1 s, max_step: 10 us}
bodies:
  box: {rigid: true, material: oak, shape: {box: {min: [0, 0, 0], max: [1 cm, 1 cm, 1 cm]}},
    velocity: [0, 0, 2], motion: {velocity: [3, -1, free]}}
gravity: [0, 0, -9.81]
output: {history: 1 ms}
)");
  ASSERT_EQ(result.failure, "");
  EXPECT_NEAR(result.last("body.box.position.x"), 0.005 + 0.3, 1e-14);
  EXPECT_NEAR(result.last("body.box.position.y"), 0.005 - 0.1, 1e-14);
  EXPECT_NEAR(result.last("body.box.position.z"), 0.005 + 0.2 - 9.81 * 0.005, 1.1 * 9.81 * 5e-7);
  EXPECT_NEAR(result.last("body.box.velocity.z"), 2 - 0.981, 1.1 * 9.81 * 5e-6);
  EXPECT_NEAR(result.last("body.box.force.z"), -700 * 1e-6 * 9.81, 1e-15);
  EXPECT_LT(result.worst_drift, 1e-12);
}

// A wheel that is driven, off its centre, and may rise: what its drive does stands in `boundary`,
// and all columns sum up.
TEST(Rigid, DrivenWheelClosesItsBalance) {
  const auto result = run(R"(
time: {end: 1.5 ms}
bodies:
  plate: {material: nylon, shape: {box: {min: [-40 mm, -30 mm, -9 mm], max: [40 mm, 30 mm, 0]}},
    cells: [12, 10, 3]}
  wheel:
    rigid: true
    material: oak
    shape: {cylinder: {radius: 15 mm, length: 20 mm, base: [-10 mm, -10 mm, 17 mm], axis: y}}
    velocity: [0, 0, -3]
    motion: {velocity: [4, 0, free], spin: {axis: y, rate: 500 rad/s, about: [-9 mm, 0, 18 mm]}}
contact: {default: {friction: 0.3}}
output: {history: 10 us}
)");
  ASSERT_EQ(result.failure, "");
  EXPECT_LT(result.worst_drift, 1e-12);
  EXPECT_LT(result.last("energy.boundary"), -0.01);  // the drive gave what friction took
  EXPECT_NEAR(result.last("body.wheel.rotation.y"), 0.75, 1e-12);
  EXPECT_NEAR(result.last("body.wheel.spin.y"), 500, 1e-10);
}

// Drag of rate r on all points: v = -g/r (1 - exp(-r t)), L = L0 exp(-r t); the drag is that of the
// middle of a step, half a step late: r dt/2 = 5e-5.
TEST(Rigid, WeightAndDragActOnBodies) {
  const auto result = run(R"(
time: {end: 0.1 s, max_step: 10 us}
bodies:
  box: {rigid: true, material: oak, shape: {box: {min: [0, 0, 0], max: [1 cm, 1 cm, 1 cm]}},
    spin: {axis: [1, 0, 0], rate: 20 rad/s, about: [0, 5 mm, 5 mm]}}
gravity: [0, 0, -9.81]
damping: {rate: 10}
output: {history: 1 ms}
)");
  ASSERT_EQ(result.failure, "");
  const Real decay = std::exp(-1.0);
  EXPECT_NEAR(result.last("body.box.velocity.z"), -0.981 * (1 - decay), 1e-4);
  EXPECT_NEAR(result.last("body.box.spin.x"), 20 * decay, 1e-3);
  EXPECT_NEAR(result.last("body.box.rotation.x"), 2 * (1 - decay), 1e-4);
  EXPECT_LT(result.worst_drift, 1e-12);
}

// Each brick is a body of its own: a wall of three courses comes to rest, and the floor carries its
// weight; rotation and spin are no columns of several bodies.
TEST(Rigid, BricksOfAWallComeToRestOnEachOther) {
  const auto result = run(R"(
time: {end: 0.2 s}
parameters: {E: 10 MPa}
bodies:
  floor: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 1 m}}}
  wall: {rigid: true, material: foam, shape: {brick-wall: {bricks: [3, 1, 3],
    brick: [200 mm, 100 mm, 60 mm], origin: [-300 mm, -50 mm, 0]}}}
gravity: [0, 0, -9.81]
damping: {rate: 200}
contact: {default: {friction: 0.5}}
stop: {at_rest: {body: wall, below: 0.02 mm/s, for: 5 ms}}
measures:
  height: {extent: {body: wall, axis: z}}
  foot: {point: {body: wall, at: [0, 0, 0], field: displacement.z}}
output: {history: 1 ms}
)",
                          {"materials.foam={density: 700, elastic: {E: $E, nu: 0.3}}"});
  ASSERT_EQ(result.failure, "");
  const Real weight = 700 * 0.6 * 0.1 * 0.18 * 9.81;
  EXPECT_LT(result.last("time"), 0.19);  // at rest before its time
  EXPECT_NEAR(result.last("body.floor.force.z"), -weight, 1e-3 * weight);
  EXPECT_NEAR(result.last("body.wall.mass"), weight / 9.81, 1e-12);
  EXPECT_THROW(result.index("body.wall.spin.x"), std::invalid_argument);
  // Its drag is below 200 1/s 0.02 mm/s = 0.4 permille of the weight. Bricks settle by pressure
  // over k = 0.5 M/h: fractions of a millimetre.
  EXPECT_NEAR(result.measures.at("height"), 0.18, 2e-4);
  EXPECT_LT(result.measures.at("foot"), 0);
  EXPECT_LT(result.worst_drift, 1e-10);
}

// A cube that rattles between two held planes, turning, in the largest step that its limit allows,
// is stable: its kinetic energy is never above that of the start by more than what the scheme makes
// of entering contact between steps.
TEST(Rigid, LargestStepIsStable) {
  const auto result = run(R"(
time: {end: 20 ms, safety: 1}
bodies:
  cube: {rigid: true, material: oak, shape: {box: {min: [-1 cm, -1 cm, 0],
    max: [1 cm, 1 cm, 2 cm]}}, velocity: [0, 0, 0.5], spin: {axis: [1, 0.3, 0], rate: 5 rad/s,
      about: [0, 0, 1 cm]}}
  floor: {rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 10 cm}}}
  roof: {rigid: true, shape: {plane: {origin: [0, 0, 20.02 mm], normal: [0, 0, -1], extent: 10 cm}}}
contact: {default: {damping: 0.1}}
output: {history: 20 us}
)");
  ASSERT_EQ(result.failure, "");
  const Real start = result.first("energy.kinetic");
  for (const Real kinetic : result.column("energy.kinetic")) EXPECT_LT(kinetic, 1.02 * start);
  EXPECT_LT(result.worst_drift, 1e-12);
}

// A tool that turns about a place beside it while that place moves: x = c + v t + R(wt)(x0 - c),
// v + w x (x - c - v t). It has no mass; a held plate stays in its middle.
TEST(Rigid, DrivenBodiesSayWhereTheyAre) {
  const auto result = run(R"(
time: {end: 1 ms, max_step: 10 us}
bodies:
  tool: {rigid: true, shape: {box: {min: [10 mm, 0, 0], max: [30 mm, 10 mm, 10 mm]}},
    motion: {velocity: [-3, 2, 1], spin: {axis: z, rate: 500 rad/s, about: [0, 0, 0]}}}
  plate: {rigid: true, shape: {plane: {origin: [1, 2, -1], normal: [1, 0, 1], extent: 0.2}}}
  apart: {rigid: true, material: oak, shape: {box: {min: [9, 0, 0], max: [9.1, 0.1, 0.1]}}}
)");
  ASSERT_EQ(result.failure, "");
  const Real angle = 0.5, c = std::cos(angle), s = std::sin(angle);
  const Vec3 arm(0.02 * c - 0.005 * s, 0.02 * s + 0.005 * c, 0.005), v(-3, 2, 1);
  const Vec3 x = arm + 1e-3 * v, rate = v + 500 * Vec3(-arm[1], arm[0], 0);
  for (const int axis : {0, 1, 2}) {
    const std::string end = std::string(".") + kAxes[axis];
    EXPECT_NEAR(result.last("body.tool.position" + end), x[axis], 1e-12);
    EXPECT_NEAR(result.last("body.tool.velocity" + end), rate[axis], 1e-9);
    EXPECT_NEAR(result.last("body.plate.position" + end), Vec3(1, 2, -1)[axis], 1e-12);
    EXPECT_EQ(result.last("body.plate.velocity" + end), 0);
  }
  EXPECT_EQ(result.last("body.tool.mass"), 0);
}

}  // namespace
}  // namespace brunt::test
