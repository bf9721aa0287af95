// Free rigid bodies that conduct. They move as those that do not: forces, mass and inertia are the
// same. What is inside conducts as in a body that is held. Insulated, a hot block that falls on a
// plate of elements gives it heat until both are at T = (C1 T1 + C2 T2)/(C1 + C2); early both
// faces are at that of half-spaces, T = (e1 T1 + e2 T2)/(e1 + e2), e = sqrt(k rho cp).
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kMaterials = R"(
materials:
  nylon: {density: 1150, elastic: {E: 3 GPa, nu: 0.4}, thermal: {cp: 1700, k: 0.25}}
  oak: {density: 700, elastic: {E: 1.5 GPa, nu: 0.3}, thermal: {cp: 1200, k: 0.3}}
)";

const std::string kDrop = kMaterials + R"(
time: {end: 1.2 ms, max_step: 0.8 us}
heat: conduct
parameters: {angle: 0 deg}
bodies:
  plate: {material: nylon, shape: {box: {min: [-30 mm, -30 mm, -9 mm], max: [30 mm, 30 mm, 0]}},
    cells: [10, 10, 3]}
  cube:
    rigid: true
    material: oak
    shape: {box: {min: [-9 mm, -11 mm, 8 mm], max: [11 mm, 9 mm, 28 mm]},
      rotate: {axis: [1, -1, 0], angle: $angle, about: [1 mm, -1 mm, 18 mm]}}
    cells: [1, 1, 1]
    velocity: [1, 0, -10]
contact: {default: {friction: 0.3}}
measures: {bounce: {restitution: {body: cube}}}
output: {history: 10 us}
)";

/// Largest difference of a column of two runs, of its largest value or that of its vector.
Real difference(const Simulation& one, const Simulation& other, const std::string& name) {
  const auto a = one.column(name), b = other.column(name);
  Real apart = 0, largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) apart = std::max(apart, std::fabs(a[i] - b[i]));
  const std::size_t dot = name.size() - 2;
  for (const char* axis : {"x", "y", "z"}) {
    const bool vector = name[dot] == '.' && name.back() >= 'x' && name.back() <= 'z';
    for (const Real v : one.column(vector ? name.substr(0, dot + 1) + axis : name)) {
      largest = std::max(largest, std::fabs(v));
    }
  }
  return largest > 0 ? apart / largest : apart;
}

// A cube that falls flat, on an edge and on a corner. With one element its faces are those of a
// cube that does not conduct, and so are all sums but for their order: 1e-12.
TEST(FreeRigidHeat, ItMovesLikeABodyThatDoesNotConduct) {
  for (const char* angle : {"0 deg", "20 deg", "54.7356 deg"}) {
    const std::string turned = std::string("parameters.angle=") + angle;
    const auto warm = simulate_text(kDrop, {turned});
    const auto cold = simulate_text(kDrop, {turned, "heat=off"});
    ASSERT_EQ(warm.failure, "");
    EXPECT_GT(cold.last("body.cube.velocity.z"), -2) << angle;  // it has been stopped
    ASSERT_EQ(warm.steps, cold.steps);
    for (const auto& name : cold.columns) {
      if (name.ends_with(".heat") || name.ends_with("drift")) continue;
      EXPECT_LT(difference(cold, warm, name), 1e-12) << name << " " << angle;
    }
    EXPECT_LT(warm.worst_drift, 1e-12) << angle;
    EXPECT_GT(warm.last("body.cube.heat"), 0) << angle;  // of friction
    EXPECT_LT(std::fabs(warm.last("heat.drift")), 1e-12) << angle;
    // Means over its points are those of the body.
    EXPECT_NEAR(warm.measures.at("bounce"), cold.measures.at("bounce"), 1e-12) << angle;
  }
}

// On its edge and on its corner it touches by the same few planes whatever the elements behind:
// mass and centre of 4 x 4 x 4 of them are those of the cube to rounding, which bounces enlarge.
TEST(FreeRigidHeat, ElementsBehindItsFacesChangeNothing) {
  for (const char* angle : {"20 deg", "54.7356 deg"}) {
    const std::string turned = std::string("parameters.angle=") + angle;
    const auto coarse = simulate_text(kDrop, {turned});
    const auto fine = simulate_text(kDrop, {turned, "bodies.cube.cells=[4, 4, 4]"});
    ASSERT_EQ(fine.failure, "");
    for (const char* name : {"body.cube.position.z", "body.cube.velocity.x", "body.cube.spin.y",
                             "body.cube.force.z", "energy.contact.friction", "body.cube.heat"}) {
      EXPECT_LT(difference(coarse, fine, name), 1e-10) << name << " " << angle;
    }
  }
}

const std::string kSpinning = R"(
time: {end: 5 ms, max_step: 5 us}
materials: {copper: {density: 8900, elastic: {E: 120 GPa, nu: 0.34}, thermal: {cp: 390, k: 390}}}
bodies:
  far: {material: copper, shape: {box: {min: [1, 0, 0], max: [1.02, 0.02, 0.02]}}, cells: [1, 1, 1]}
  block:
    rigid: true
    material: copper
    temperature: 300 K
    shape: {box: {min: [0, 0, 0], max: [12 mm, 8 mm, 4 mm]}}
    cells: [6, 4, 2]
    velocity: [3, 1, -2]
    spin: {axis: [1, 2, 0.5], rate: 400 rad/s, about: [1 mm, 0, 0]}
contact: {default: {ignore: true}}
boundaries:
  lamp: {body: block, where: {side: max-x}, flux: 2e7}
  air: {body: block, where: {side: min-y}, convection: {h: 1e5, T: 250 K}}
  ice: {body: block, where: {side: max-z}, temperature: 280 K, from: 4 ms}
measures:
  corner: {point: {body: block, at: [12 mm, 0, 0], field: temperature}}
  mean: {mean: {body: block, field: temperature}}
output: {history: 0.1 ms}
)";

// A block that spins by two radians while boundaries heat and cool it is a still one to itself: the
// geometry of its elements is the same to rounding, 1e-16 of positions of centimetres over elements
// of millimetres, in a thousand steps.
TEST(FreeRigidHeat, ItsFieldTurnsWithIt) {
  const auto spins = simulate_text(kSpinning);
  const auto still =
      simulate_text(kSpinning, {"bodies.block.motion={velocity: [0, 0, 0]}",
                                "bodies.block.velocity=null", "bodies.block.spin=null"});
  ASSERT_EQ(spins.failure, "");
  ASSERT_EQ(still.failure, "");
  ASSERT_EQ(spins.steps, still.steps);
  EXPECT_GT(std::fabs(spins.last("body.block.rotation.y")), 1);
  EXPECT_GT(still.measures.at("corner"), 310);
  for (const char* name : {"corner", "mean"}) {
    EXPECT_NEAR(spins.measures.at(name), still.measures.at(name), 1e-10) << name;
  }
  const Real lamp = 2e7 * 8e-3 * 4e-3;
  EXPECT_NEAR(spins.last("boundary.lamp.heat_rate"), lamp, 1e-12 * lamp);
  const Real heat = std::fabs(still.last("body.block.heat"));
  EXPECT_NEAR(spins.last("body.block.heat"), still.last("body.block.heat"), 1e-12 * heat);
  EXPECT_LT(std::fabs(spins.last("heat.drift")), 1e-12);
  EXPECT_LT(spins.worst_drift, 1e-12);
  // Nothing pushes it: its centre goes straight on.
  const Real vx = spins.first("body.block.velocity.x");
  EXPECT_NEAR(spins.last("body.block.position.x"), 6e-3 + vx * 5e-3, 1e-14);
}

// So soft that steps are long, and so conductive that heat is through in some of them.
const std::string kMixture = R"(
time: {end: 0.4 s}
materials:
  hot: {density: 2000, elastic: {E: 4 MPa, nu: 0.3}, thermal: {cp: 500, k: 5000}}
  cold: {density: 1000, elastic: {E: 4 MPa, nu: 0.3}, thermal: {cp: 800, k: 4000}}
bodies:
  plate: {material: cold, temperature: 300 K, cells: [4, 4, 2],
    shape: {box: {min: [-4 mm, -4 mm, -3 mm], max: [4 mm, 4 mm, 0]}}}
  block: {rigid: true, material: hot, temperature: 900 K, cells: [2, 2, 2], velocity: [0, 0, -0.2],
    shape: {box: {min: [-2 mm, -2 mm, 0.5 mm], max: [2 mm, 2 mm, 4.5 mm]}}}
boundaries: {foot: {body: plate, where: {side: min-z}, fix: [x, y, z]}}
gravity: [0, 0, -9.81]
damping: {rate: 100}
contact: {default: {heat: perfect, friction: 0}}
measures:
  hottest: {max: {body: block, field: temperature}}
  coldest: {min: {body: plate, field: temperature}}
output: {history: 1 ms}
)";

// C = rho cp V of 64 mm^3 and 192 mm^3: 0.064 and 0.1536 J/K, so that T = 476.47 K. Differences
// fade over L = 7.5 mm in L^2/(pi^2 alpha) = 1 ms while the bodies touch, which they do all but
// some bounces of 0.4 s; what is left is rounding.
TEST(FreeRigidHeat, AFallingBlockAndItsPlateComeToTheTemperatureOfTheirMixture) {
  const auto run = simulate_text(kMixture);
  ASSERT_EQ(run.failure, "");
  const Real block = 2000 * 500 * 64e-9, plate = 1000 * 800 * 192e-9;
  const Real mixture = (block * 900 + plate * 300) / (block + plate);
  EXPECT_NEAR(run.measures.at("hottest"), mixture, 1e-8 * mixture);
  EXPECT_NEAR(run.measures.at("coldest"), mixture, 1e-8 * mixture);
  const Real given = block * (900 - mixture);
  EXPECT_NEAR(run.last("body.block.heat"), -given, 1e-8 * given);
  const auto of_block = run.column("body.block.heat"), of_plate = run.column("body.plate.heat");
  for (std::size_t i = 0; i < of_block.size(); ++i) {
    EXPECT_NEAR(of_block[i], -of_plate[i], 1e-12 * given) << i;
  }
  for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  // It fell 0.5 mm before it gave anything: 2.4 ms at 0.2 m/s.
  EXPECT_EQ(of_block[2], 0);
  EXPECT_LT(of_block[10], 0);
  EXPECT_LT(run.worst_drift, 1e-12);
}

// The same on particles, and of a body that follows its forces along one axis alone.
TEST(FreeRigidHeat, ItWarmsParticlesAndMovesInPartAsPrescribed) {
  const auto run = simulate_text(
      kMixture, {"time.end=20 ms", "bodies.plate.method=sph", "bodies.plate.cells=null",
                 "bodies.plate.size=1 mm", "bodies.block.motion={velocity: [0, 0, free]}"});
  ASSERT_EQ(run.failure, "");
  const Real given = -run.last("body.block.heat");
  EXPECT_GT(given, 1);
  EXPECT_NEAR(run.last("body.plate.heat"), given, 1e-12 * given);
  EXPECT_NEAR(run.last("body.block.position.x"), 0, 1e-17);
  EXPECT_LT(run.worst_drift, 1e-9);
}

// Heat passes between rigid bodies where one of them is free: contact finds them pressed. The floor
// takes what the block gives, or leads it away where it is held at a temperature.
TEST(FreeRigidHeat, ItWarmsARigidFloor) {
  const std::string motion = "bodies.plate.motion={velocity: [0, 0, 0]}";
  const std::vector<std::string> overrides = {"time.end=20 ms", "bodies.plate.rigid=true", motion,
                                              "boundaries=null"};
  const auto run = simulate_text(kMixture, overrides);
  ASSERT_EQ(run.failure, "");
  const Real given = -run.last("body.block.heat");
  EXPECT_GT(given, 1);
  EXPECT_NEAR(run.last("body.plate.heat"), given, 1e-12 * given);
  EXPECT_LT(run.worst_drift, 1e-12);
  const auto held = simulate_text(
      kMixture,
      {"time.end=0.2 s", "measures.coldest=null", "boundaries=null", "materials.cold=null",
       "bodies.plate={rigid: true, shape: {box: {min: [-4 mm, -4 mm, -3 mm], max: [4 mm, "
       "4 mm, 0]}}, motion: {temperature: 300 K}}"});
  ASSERT_EQ(held.failure, "");
  EXPECT_NEAR(held.measures.at("hottest"), 300, 1e-6 * 300);
  EXPECT_NEAR(held.last("body.block.heat"), -0.064 * 600, 1e-6 * 0.064 * 600);
  EXPECT_LT(std::fabs(held.last("heat.drift")), 1e-12);
}

// Half-spaces of decks/half-spaces, the hot one a free rigid rod, as soft as feathers so that
// contact bounds no step; tolerances are those of contact_heat_test.
TEST(FreeRigidHeat, AFreeRodAndElementsMeetAtTheTemperatureBetween) {
  const auto run = simulate_shipped(
      "half-spaces", {"materials.aluminium.elastic={E: 1 MPa, nu: 0.3}",
                      "materials.steel.elastic={E: 1 MPa, nu: 0.3}", "bodies.hot.rigid=true",
                      "boundaries.hot_still=null", "boundaries.cold_still.where={side: max-x}"});
  ASSERT_EQ(run.failure, "");
  const Real e1 = std::sqrt(237.0 * 2700 * 900), e2 = std::sqrt(44.5 * 7850 * 475);
  const Real between = (e1 * 500 + e2 * 20) / (e1 + e2);
  const Real depth = std::sqrt(4 * 237.0 / 2700 / 900 * 0.01);
  const Real inside = 500 + (between - 500) * std::erfc(1e-3 / depth);
  EXPECT_NEAR(run.measures.at("contact") - 273.15, between, 0.005 * 480);
  EXPECT_NEAR(run.measures.at("inside_hot") - 273.15, inside, 4.8);
  EXPECT_NEAR(run.last("body.hot.heat"), -run.last("body.cold.heat"),
              1e-12 * run.last("body.cold.heat"));
}

// Plane strain and axisymmetry: momentum, energy and heat close, and bits are those of any threads,
// skin and restart.
TEST(FreeRigidHeat, PlanesAndRings) {
  const std::string plane = kMaterials + R"(
geometry: plane-strain
depth: 0.1 m
time: {end: 1.2 ms}
bodies:
  plate: {material: nylon, shape: {box: {min: [-40 mm, -10 mm], max: [40 mm, 0]}}, cells: [16, 3]}
  tile: {rigid: true, material: oak, temperature: 700 K, size: 5 mm, velocity: [1, -5],
    shape: {polygon: {points: [[-10 mm, 3 mm], [20 mm, 10 mm], [0, 23 mm], [-8 mm, 15 mm]],
      corners: [0, 1, 2, 3]}}, spin: {rate: 60 rad/s, about: [3 mm, 12 mm]}}
contact: {default: {friction: 0.3, heat: perfect}}
output: {history: 10 us}
)";
  const std::string ring = kMaterials + R"(
geometry: axisymmetric
time: {end: 0.5 ms}
bodies:
  plate: {material: nylon, shape: {cylinder: {radius: 40 mm, length: 10 mm, base: [0, -10 mm]}},
    cells: [16, 4]}
  tile: {rigid: true, material: oak, temperature: 700 K, size: 2 mm, velocity: [0, -5],
    shape: {sphere: {radius: 10 mm, center: [0, 11 mm]}}}
contact: {default: {friction: 0.3, heat: perfect}}
output: {history: 10 us}
)";
  for (const auto& text : {plane, ring}) {
    const auto run = simulate_text(text, {}, {.threads = 1});
    ASSERT_EQ(run.failure, "");
    EXPECT_GT(run.last("body.tile.velocity.y"), -4.9);  // it has touched
    EXPECT_NEAR(run.last("momentum.y"), run.first("momentum.y"),
                1e-12 * std::fabs(run.first("momentum.y")));
    EXPECT_LT(run.last("body.tile.heat"), 0);
    for (const Real drift : run.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
    EXPECT_LT(run.worst_drift, 1e-12);
    const auto split = simulate_text(text, {}, {.threads = 2, .split_at = 300});
    EXPECT_LT(split.steps_here, split.steps);
    EXPECT_EQ(split.rows, run.rows);
    EXPECT_EQ(split.hashes, run.hashes);
    EXPECT_EQ(simulate_text(text, {"contact.skin=3 mm"}).hashes, run.hashes);
  }
}

}  // namespace
}  // namespace brunt::test
