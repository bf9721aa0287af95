// Processes that are stepped s times faster (time.process_speed).
//
// Equivalence. With times t/s, velocities s v, rates s r, powers s P and forces and stresses as
// they are, the equations of motion are those of the density s^2 rho at the speed 1; heat c_p dT
// of that mass is the same where c_p is divided by s^2. For s = 4^n both runs make the same
// roundings: all results agree bit for bit, but masses and momenta, which have s^2 in them.
// Artificial stress, dampers and step limits go by the sound speed and follow.
//
// Inertia. A block of mass m, w wide and h high, is pressed between smooth faces, one of them a
// plane of symmetry, at v(t) = V (1 - cos(2 pi t/T))/2. Plastic flow keeps w h and makes of it v
// y/h and v x/h: the kinetic energy is m v^2 (1 + q)/6, q = (w/h)^2, and by its power the force of
// inertia
//   F = m a (1 + q)/3 + 2/3 m v^2 q/h.
// A process s times faster differs by (s^2 - 1) F, which is all that it may differ by. About that
// the force rings where yielding begins and changes the field, by less than half of F's amplitude
// while v grows, and by less than a tenth later. F at s = 10 is 1.4 % of the force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/watch/inertia_watch.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

std::string speed(Real s) { return "time.process_speed=" + std::to_string(s); }

/// Value at a time of a column, linear between rows.
Real at(const Simulation& run, const std::string& column, Real time) {
  const auto times = run.column("time"), values = run.column(column);
  const auto next = std::upper_bound(times.begin(), times.end() - 1, time) - times.begin();
  const Real part = (time - times[next - 1]) / (times[next] - times[next - 1]);
  return values[next - 1] + part * (values[next] - values[next - 1]);
}

// All that goes by time in one scene: cutting by a rigid tool with friction by speed, a block of
// particles that hits, heat by all ways, supports by tables and expressions, damping, rates.
const char* const kAll = R"yaml(
title: what goes by time
geometry: plane-strain
parameters: {density: 8960, cp: 383, tool: 7850}
time: {end: 40 us, max_step: 40 ns}
heat: conduct
materials:
  copper:
    density: $density
    elastic: {E: 124 GPa, nu: 0.34}
    strength: {johnson-cook: {A: 90 MPa, B: 292 MPa, n: 0.31, C: 0.025, rate_ref: 1, m: 1.09,
                              T_melt: 1356 K}}
    thermal: {cp: $cp, k: 386, expansion: 1.7e-5}
    damage: {johnson-cook: {D1: 0.5, D2: 4.9, D3: -3, D4: 0.014, rate: 2}}
  soft:
    density: $density
    elastic: {E: 12 GPa, nu: 0.3}
    strength: {j2: {yield: 100 MPa, hardening: 200 MPa}}
    thermal: {cp: $cp, k: {table: [[300 K, 100], [600 K, 200]], over: temperature}}
  steel: {density: $tool, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  block:
    material: copper
    shape: {box: {min: [0, 0], max: [8 mm, 2 mm]}}
    size: 0.5 mm
    temperature: 350 K
  tool:
    rigid: true
    shape: {box: {min: [8.01 mm, 1.4 mm], max: [9 mm, 3 mm]}}
    motion: {velocity: [-30 m/s, 0], spin: {rate: 400 rad/s, about: [9 mm, 3 mm]},
             temperature: {table: [[0, 400], [20 us, 500 K]], over: time}}
  grains:
    method: sph
    material: soft
    shape: {box: {min: [1 mm, 2.1 mm], max: [3 mm, 3.1 mm]}}
    size: 0.25 mm
    velocity: ["= 3 + 1e3*x", -60 m/s]
    spin: {rate: 100 rad/s, about: [2 mm, 2.6 mm]}
  free:
    rigid: true
    material: steel
    shape: {box: {min: [5 mm, 2.05 mm], max: [6 mm, 3 mm]}}
    velocity: [5 m/s, -20 m/s]
contact:
  default: {friction: {static: 0.4, kinetic: 0.2, decay: 0.1 s/m}, heat: {conductance: 1e5}}
  pairs:
    chip: {between: [block, tool], friction: "= 0.3 - v/200 - T/1e4", shear_limit: true}
    rain: {between: [block, grains], heat: perfect,
           friction: {table: [[0, 0.3], [40 m/s, 0.1]], over: slip_speed}}
boundaries:
  left: {body: block, where: {side: min-x},
         velocity: [{table: [[0, 0], [20 us, 5 m/s]], over: time}, free]}
  under: {body: block, where: {side: min-y}, velocity: [free, "= 4*sin(2e5*t)"], to: 30 us,
          convection: {h: 1e6, T: "= 300 + 1e6*t"}}
  lamp: {body: grains, where: {side: max-y}, flux: 1e8, from: 5 us}
  glow: {body: block, where: {side: max-x}, radiation: {emissivity: 0.8, T: 3000 K},
         pressure: {table: [[0, 0], [10 us, 20 MPa]], over: time}}
damping: {rate: 2000 1/s, until: 25 us}
probes:
  in: {body: block, at: [6 mm, 1 mm], fields: [velocity.x, acceleration.y, strain_rate,
       temperature, stress.xx, eps_p, damage]}
  grain: {body: grains, at: [2 mm, 2.6 mm],
          fields: [velocity.y, acceleration.x, temperature, pressure]}
sections: {middle: {body: block, plane: {axis: x, at: 3 mm}}}
measures:
  early: {max: {body: block, field: velocity.magnitude}, at: 7 us}
  fastest: {max: {body: block, field: acceleration.magnitude}}
  rate: {mean: {body: block, field: strain_rate}}
  there: {point: {body: block, field: velocity.x, at: [5 mm, 1 mm]}}
  hot: {max: {body: block, field: temperature}}
  falls: {speed: {body: free}}
  push: {history: {column: body.tool.force.x, reduce: integral, from: 5 us, to: 30 us}}
  mean_heat: {history: {column: boundary.glow.heat_rate, reduce: mean}}
stop: {when: "= body.tool.velocity.x > 0"}
output: {history: 0.5 us}
)yaml";

constexpr Real kFast = 4;  // a power of four: effusivities have a root in them

void expect_same_run(const Simulation& fast, const Simulation& dense) {
  ASSERT_EQ(fast.failure, "");
  ASSERT_EQ(dense.failure, "");
  ASSERT_EQ(fast.columns, dense.columns);
  ASSERT_EQ(fast.rows.size(), dense.rows.size());
  EXPECT_EQ(fast.steps, dense.steps);
  for (std::size_t c = 0; c < fast.columns.size(); ++c) {
    const std::string& column = fast.columns[c];
    const bool mass = column.ends_with(".mass") || column.starts_with("momentum.");
    for (std::size_t r = 0; r < fast.rows.size(); ++r) {
      ASSERT_EQ((mass ? kFast * kFast : 1) * fast.rows[r][c], dense.rows[r][c])
          << column << " in row " << r;
    }
  }
  EXPECT_EQ(fast.measures, dense.measures);
}

TEST(ProcessSpeed, IsTheSameAsMoreDensityBitForBit) {
  const auto fast = simulate_text(kAll, {speed(kFast)});
  const auto dense =
      simulate_text(kAll, {"parameters.density=" + std::to_string(8960 * kFast * kFast),
                           "parameters.cp=" + std::to_string(383 / kFast / kFast),
                           "parameters.tool=" + std::to_string(7850 * kFast * kFast)});
  expect_same_run(fast, dense);
  EXPECT_EQ(fast.rows.back()[0], 40e-6);
  EXPECT_GT(fast.last("energy.plastic_heat"), 0);
  EXPECT_GT(fast.last("heat.friction"), 0);
  EXPECT_NE(fast.last("heat.boundary"), 0);
}

TEST(ProcessSpeed, OneChangesNoBit) {
  const auto given = simulate_text(kAll), one = simulate_text(kAll, {speed(1)});
  EXPECT_EQ(given.rows, one.rows);
  EXPECT_EQ(given.hashes, one.hashes);
  EXPECT_EQ(given.measures, one.measures);
}

TEST(ProcessSpeed, ARestartChangesNoBit) {
  RunVariation split;
  split.split_at = 150;
  const auto whole = simulate_text(kAll, {speed(10)}),
             parts = simulate_text(kAll, {speed(10)}, split);
  EXPECT_LT(parts.steps_here, whole.steps);
  EXPECT_EQ(whole.rows, parts.rows);
  EXPECT_EQ(whole.hashes, parts.hashes);
  EXPECT_EQ(whole.measures, parts.measures);
  ASSERT_EQ(whole.inertia.size(), parts.inertia.size());
  for (std::size_t b = 0; b < whole.inertia.size(); ++b) {
    EXPECT_EQ(whole.inertia[b].end, parts.inertia[b].end);
    EXPECT_EQ(whole.inertia[b].mean, parts.inertia[b].mean);
  }
}

const char* const kUpset = R"yaml(
title: a block is pressed
geometry: plane-strain
parameters: {C: 0}
time: {end: 0.8 ms}
materials:
  steel:
    density: 7850
    elastic: {E: 200 GPa, nu: 0.3}
    strength: {johnson-cook: {A: 20 MPa, B: 700 MPa, n: 0.3, C: $C}}
bodies: {block: {material: steel, shape: {box: {min: [0, 0], max: [4 mm, 4 mm]}}, cells: [4, 4]}}
boundaries:
  below: {body: block, where: {side: min-y}, fix: [y]}
  left: {body: block, where: {side: min-x}, fix: [x]}
  above: {body: block, where: {side: max-y}, velocity: [free, "= -0.375*(1 - cos(2*pi*t/0.8e-3))"]
}
output: {history: 4 us}
)yaml";
constexpr Real kSide = 4e-3, kMass = 7850 * kSide * kSide;  // [m], [kg] for a depth of 1 m
constexpr Real kV = 0.75, kT = 0.8e-3, kRate = 2 * kPi / kT;
constexpr Real kInertia = 2.0 / 3 * kMass * (0.5 * kV * kRate);  // [N] amplitude of F
const char* const kForce = "boundary.above.reaction.y";

/// F(t) [N].
Real inertia(Real t) {
  const Real v = 0.5 * kV * (1 - std::cos(kRate * t)), a = 0.5 * kV * kRate * std::sin(kRate * t);
  const Real h = kSide - 0.5 * kV * (t - std::sin(kRate * t) / kRate);
  const Real q = std::pow(kSide / h, 4);
  return kMass * a * (1 + q) / 3 + 2.0 / 3 * kMass * v * v * q / h;
}

/// Forces over the same real times, and the work that is left once all is at rest again.
void expect_same_forces(const Simulation& slow, const Simulation& fast, Real s) {
  ASSERT_EQ(slow.failure, "");
  ASSERT_EQ(fast.failure, "");
  EXPECT_LT(static_cast<Real>(fast.steps), 1.05 * static_cast<Real>(slow.steps) / s);
  for (Real t = 0.04e-3; t < 0.79e-3; t += 0.01e-3) {
    const Real more = -(at(fast, kForce, t) - at(slow, kForce, t));
    const Real ringing = t < 0.5 * kT ? 0.5 : 0.1;
    EXPECT_NEAR(more, (s * s - 1) * inertia(t), ringing * s * s * kInertia) << t;
  }
  // What inertia takes while v grows it gives back; ringing over the way remains.
  const Real way = 0.5 * kV * kT;
  EXPECT_NEAR(fast.last("energy.internal"), slow.last("energy.internal"),
              0.5 * s * s * kInertia * way);
}

TEST(ProcessSpeed, PressingTakesTheSameForceOverRealTime) {
  const auto slow = simulate_text(kUpset), fast = simulate_text(kUpset, {speed(10)});
  expect_same_forces(slow, fast, 10);
  // Inertia alone is wrong: by s^2, where the field is the same.
  EXPECT_NEAR(at(fast, "energy.kinetic", 0.5 * kT) / at(slow, "energy.kinetic", 0.5 * kT), 100, 2);
  ASSERT_EQ(fast.inertia.size(), 1u);
  EXPECT_LT(fast.inertia[0].mean, InertiaWatch::kMuchInertia);
  EXPECT_TRUE(slow.inertia.empty());
  const auto too_fast = simulate_text(kUpset, {speed(200)});
  EXPECT_FALSE(inertia_warnings(too_fast.inertia, 200).empty());
}

// At 190 1/s C = 0.1 makes 1 + 0.1 ln 190 = 1.52 of the flow stress, and ten times that rate would
// make 1.75: 15 % of the force more, seven times the bound at its widest.
TEST(ProcessSpeed, FlowStressIsThatOfTheRealRate) {
  const std::string rate = "parameters.C=0.1";
  const auto slow = simulate_text(kUpset, {rate}), fast = simulate_text(kUpset, {rate, speed(10)});
  expect_same_forces(slow, fast, 10);
  EXPECT_NEAR(at(slow, kForce, 0.5 * kT) / at(simulate_text(kUpset), kForce, 0.5 * kT), 1.52, 0.03);
}

// Half-spaces in contact: fixed, their step is that of conduction, which goes by s. The same steps
// are taken, s times shorter: all is the same bit for bit where s is a power of two, and to the
// rounding of a few thousand steps elsewhere.
TEST(ProcessSpeed, HalfSpacesConductInRealTime) {
  const std::vector<std::string> coarse = {"parameters.size=0.2 mm"};
  const auto slow = simulate_shipped("half-spaces", coarse);
  const auto fast = simulate_shipped("half-spaces", {coarse[0], speed(8)});
  EXPECT_EQ(fast.rows, slow.rows);
  EXPECT_EQ(fast.measures, slow.measures);
  const auto ten = simulate_shipped("half-spaces", {coarse[0], speed(10)});
  for (const auto& [name, value] : slow.measures) {
    EXPECT_NEAR(ten.measures.at(name), value, 1e-10 * value) << name;
  }
  EXPECT_NEAR(slow.measures.at("contact"), 332.344403 + 273.15, 0.005 * 480);
}

// A rod between a fluid and a hot wall that shines on it, free to move, so that sound bounds the
// step: at s = 10 its step of heat is ten times as long. Explicit steps err by lambda dt/2 of a
// mode's change in its time constant, of the fastest mode that matters: Bi h/(rho cp L) and
// (pi/L)^2 alpha are below 1e3 1/s, dt is 8 us at s = 100: 0.4 % of the change.
TEST(ProcessSpeed, ConvectionAndRadiationActInRealTime) {
  const char* const rod = R"yaml(
title: a rod between a fluid and a wall
geometry: plane-strain
time: {end: 10 ms}
heat: conduct
ambient: 400 K
materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, thermal: {cp: 475, k: 44.5}}}
bodies: {rod: {material: steel, shape: {box: {min: [0, 0], max: [2 mm, 1 mm]}}, size: 0.5 mm}}
boundaries:
  fluid: {body: rod, where: {side: min-x}, convection: {h: 20000, T: "= 300 - 1000*t"}}
  wall: {body: rod, where: {side: max-x}, radiation: {emissivity: 0.9, T: 2500 K}}
measures:
  cold: {point: {body: rod, at: [0, 0.5 mm], field: temperature}}
  warm: {point: {body: rod, at: [2 mm, 0.5 mm], field: temperature}}
  drawn: {history: {column: boundary.fluid.heat_rate, reduce: integral}}
  shone: {history: {column: boundary.wall.heat_rate, reduce: integral}}
output: {history: 20 us}
)yaml";
  const auto slow = simulate_text(rod), fast = simulate_text(rod, {speed(100)});
  ASSERT_EQ(fast.failure, "");
  EXPECT_LT(fast.steps, slow.steps / 50);
  for (const char* place : {"cold", "warm"}) {
    const Real change = slow.measures.at(place) - 400;
    EXPECT_GT(std::fabs(change), 5) << place;
    EXPECT_NEAR(fast.measures.at(place) - 400, change, 0.004 * std::fabs(change)) << place;
  }
  for (const char* heat : {"drawn", "shone"}) {
    EXPECT_NEAR(fast.measures.at(heat) / slow.measures.at(heat), 1, 0.004) << heat;
  }
}

// A block that a pressure presses on a moving plane: the heat of friction is mu p A v t, less what
// the pressure lacks while it grows, whatever the speed. The block slips back by its own shear,
// mu p h/G = 0.9 um of the 2 mm that the plane goes; the pressure rings by the inertia of the
// block, s^2 rho h (p/E h)/t_r^2 with 0.4 ms: 1e-3 at s = 10.
TEST(ProcessSpeed, FrictionHeatsAsMuchOverRealTime) {
  const char* const slide = R"yaml(
title: a plane moves under a block
geometry: plane-strain
time: {end: 2 ms}
heat: conduct
ambient: 300 K
materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, thermal: {cp: 475, k: 44.5}}}
bodies:
  block: {material: steel, shape: {box: {min: [0, 0], max: [4 mm, 4 mm]}}, size: 0.5 mm}
  plane: {rigid: true, shape: {box: {min: [-4 mm, -1 mm], max: [8 mm, 0]}},
          motion: {velocity: [1 m/s, 0]}}
contact: {default: {friction: 0.3}}
boundaries:
  above: {body: block, where: {side: max-y}, fix: [x],
          pressure: {table: [[0, 0], [0.4 ms, 50 MPa]], over: time}}
measures:
  hot: {mean: {body: block, field: temperature}}
output: {history: 10 us}
)yaml";
  const auto slow = simulate_text(slide), fast = simulate_text(slide, {speed(10)});
  ASSERT_EQ(fast.failure, "");
  EXPECT_LT(fast.steps, slow.steps / 9);
  const Real exact = 0.3 * 50e6 * 4e-3 * 1 * (2e-3 - 0.2e-3);  // [J] for a depth of 1 m
  EXPECT_NEAR(slow.last("heat.friction"), exact, 2e-3 * exact);
  EXPECT_NEAR(fast.last("heat.friction"), exact, 2e-3 * exact);
  const Real rise = exact / (7850 * 475 * 16e-6);
  EXPECT_NEAR(slow.measures.at("hot") - 300, rise, 2e-3 * rise);
  EXPECT_NEAR(fast.measures.at("hot") - 300, rise, 2e-3 * rise);
}

// stop.at_rest, in real speeds and times: a bar that damping slows down is below 1 m/s from
// t = ln(10)/rate on, and stops 2 ms later; explicit damping errs by rate dt/2.
TEST(ProcessSpeed, StopsWaitInRealTime) {
  const char* const bar = R"yaml(
title: a bar comes to rest
geometry: plane-strain
time: {end: 10 ms}
materials: {m: {density: 1000, elastic: {E: 1 GPa, nu: 0.3}}}
bodies: {bar: {material: m, shape: {box: {min: [0, 0], max: [10 mm, 10 mm]}}, cells: [2, 2],
               velocity: [10 m/s, 0]}}
damping: {rate: 1000 1/s}
stop: {at_rest: {body: bar, below: 1 m/s, for: 2 ms}}
)yaml";
  for (const Real s : {1.0, 10.0}) {
    const auto run = simulate_text(bar, {speed(s)});
    EXPECT_NE(run.reason, "");
    EXPECT_NEAR(run.last("time"), std::log(10) / 1000 + 2e-3, 0.03e-3) << s;
    EXPECT_NEAR(run.last("body.bar.velocity.x"), 10 * std::exp(-1000 * run.last("time")), 0.01);
  }
}

}  // namespace
}  // namespace brunt::test
