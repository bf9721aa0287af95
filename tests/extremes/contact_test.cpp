// Extremes of contact: stiff penalties in a corner, moduli a factor of 200,000
// apart, blocks that stand on each other, and edges that are passed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/law/springs.hpp"
#include "tests/support/materials.hpp"
#include "tests/support/simulate.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt::test {
namespace {

using brunt::testing::ContactScene;

constexpr Real kSpacing = 1, kDensity = 1, kModulus = 1;  // [m], [kg/m^3], [Pa]: c = 1 m/s

/// A particle of 1 kg in the corner of three rigid walls that face it.
ContactScene<3> corner(Real stiffness) {
  ContactScene<3> scene;
  scene.options.fallback.stiffness = stiffness;
  auto& walls = scene.add_group();
  const Real far = 4;
  scene.add_face(walls, {{0, 0, 0}, {far, 0, 0}, {far, far, 0}, {0, far, 0}}, 0, 0, 0);
  scene.add_face(walls, {{0, 0, 0}, {0, far, 0}, {0, far, far}, {0, 0, far}}, 0, 0, 0);
  scene.add_face(walls, {{0, 0, 0}, {0, 0, far}, {far, 0, far}, {far, 0, 0}}, 0, 0, 0);
  scene.add_particle(scene.add_group(), Vec3::Constant(0.5 * kSpacing + 1e-3), 0.5 * kSpacing,
                     kModulus, kDensity * kSpacing * kSpacing * kSpacing);
  scene.start();
  return scene;
}

// Thrown into the corner at v = 0.04 c along each axis the particle overlaps each wall by less
// than v/c dp sqrt(rho dp^3 / k dp^-2) = 0.04 dp / sqrt(phi), under 5 % of dp for phi = 1. With the
// default damping it never leaves faster than it came, whatever the stiffness and although steps as
// long as its limits allow meet the walls within a step, which gives or takes (w dt)^2/8 of a
// bounce.
TEST(ContactExtremes, NoStiffnessThrowsACornerParticleOut) {
  for (const Real stiffness : {1.0, 10.0, 100.0}) {
    auto scene = corner(stiffness);
    auto& particle = scene.groups[1].points;
    const Real speed = 0.04;
    particle.v[0] = Vec3::Constant(-speed);
    const Real start = scene.kinetic(0);
    Real deepest = 0, dt = 0;
    for (int step = 0; step < 100000 && particle.x[0][0] < 0.5 * kSpacing + 2e-3; ++step) {
      dt = std::min(0.9 * scene.contact->stable_step().step, 0.01);
      scene.step(dt);
      deepest = std::max(deepest, 0.5 * kSpacing - particle.x[0].minCoeff());
    }
    EXPECT_GT(particle.v[0].minCoeff(), 0) << stiffness;
    EXPECT_LT(deepest, 0.05 * kSpacing) << stiffness;
    EXPECT_GT(deepest, 0) << stiffness;
    EXPECT_LE(0.5 * particle.mass[0] * particle.v[0].squaredNorm(), (1 + 1e-6) * start)
        << stiffness;
  }
}

// C6 without damping: what a bounce gives or takes, (w dt)^2/8 of its energy, is below 1e-6 in
// steps of a thousandth of what they allow, w dt < 0.002.
TEST(ContactExtremes, NoStiffnessThrowsACornerParticleOutUndamped) {
  for (const Real stiffness : {1.0, 10.0, 100.0}) {
    auto scene = corner(stiffness);
    scene.options.fallback.damping = 0;
    scene.start();
    auto& particle = scene.groups[1].points;
    particle.v[0] = Vec3::Constant(-0.04);
    const Real start = scene.kinetic(0), dt = 1e-3 * scene.contact->stable_step().step;
    Real deepest = 0;
    for (int step = 0; step < 100000 && particle.x[0][0] < 0.5 * kSpacing + 2e-3; ++step) {
      scene.step(dt);
      deepest = std::max(deepest, 0.5 * kSpacing - particle.x[0].minCoeff());
    }
    EXPECT_GT(particle.v[0].minCoeff(), 0) << stiffness;
    EXPECT_NEAR(deepest, 0.04 / std::sqrt(stiffness) * kSpacing, 1e-3 * kSpacing) << stiffness;
    EXPECT_NEAR(0.5 * particle.mass[0] * particle.v[0].squaredNorm(), start, 1e-6 * start)
        << stiffness;
  }
}

const std::string kSoftAndHard = R"(
title: rubber on steel, or steel on rubber
geometry: 3d
parameters: {speed: 1 m/s}
time: {end: 1 ms}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 MPa, nu: 0.3}}
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  block:
    shape: {box: {min: [-4 mm, -4 mm, 0], max: [4 mm, 4 mm, 8 mm]}}
    size: 2 mm
    velocity: [0, 0, -$speed]
  plate:
    shape: {box: {min: [-10 mm, -10 mm, -6 mm], max: [10 mm, 10 mm, 0]}}
)";

struct Pairing {
  const char *block, *plate;  // their methods
  bool soft_block;            // on a hard plate; else the other way round
  const char* size;           // of the plate
};

// A spring in series of both sides is as soft as the softer one: at 1 m/s = 0.03 c of rubber
// of c = 37 m/s the one sinks into the other by v/c dp / phi = 5.5 % of 2 mm, less than 10 %, be
// they elements or particles, and whichever is hit (the edges of a hard block press up to 2.5 times
// as much as its middle does: it falls at half the speed); and no contact asks for a shorter step
// than a face's own spring does before it touches anything (A5).
TEST(ContactExtremes, SoftOnHardCostsNoStep) {
  for (const Pairing& pairing :
       {Pairing{"sph", "fe", true, "5 mm"}, Pairing{"fe", "fe", true, "5 mm"},
        Pairing{"sph", "sph", true, "2 mm"}, Pairing{"sph", "fe", false, "2 mm"},
        Pairing{"fe", "fe", false, "2 mm"}, Pairing{"sph", "sph", false, "2 mm"}}) {
    const char* soft = pairing.soft_block ? "block" : "plate";
    SCOPED_TRACE(std::string(pairing.block) + " on " + pairing.plate + ", soft " + soft);
    const Real own_spring = 0.98 * surface_step_ratio(0.5, 0.1);  // 2 %: footprints of particles
    int seen = 0;
    SceneHooks hooks;
    hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
      StepLimit solids;
      for (const auto& solid : scene.solids) solids.take(solid->stable_step());
      const auto step_limit = scene.contact->stable_step();
      // The step that `end` cuts allows four of its own length.
      if (clock.dt() < 0.5 * solids.step) return;
      EXPECT_GE(step_limit.step, own_spring * solids.step) << step_limit.reason;
      ++seen;
    };
    const auto run = simulate_text(
        kSoftAndHard,
        {std::string("bodies.block.method=") + pairing.block,
         std::string("bodies.plate.method=") + pairing.plate,
         std::string("bodies.block.material=") + (pairing.soft_block ? "rubber" : "steel"),
         std::string("bodies.plate.material=") + (pairing.soft_block ? "steel" : "rubber"),
         std::string("bodies.plate.size=") + pairing.size,
         std::string("parameters.speed=") + (pairing.soft_block ? "1 m/s" : "0.5 m/s")},
        {}, hooks);
    ASSERT_EQ(run.failure, "");
    EXPECT_GT(seen, 1000);
    const auto depths = run.column("contact.block-plate.max_penetration");
    const Real deepest = *std::max_element(depths.begin(), depths.end());
    EXPECT_GT(deepest, 0.01 * 2e-3);
    EXPECT_LT(deepest, 0.1 * 2e-3);
    const std::string column = std::string("body.") + soft + ".velocity.z";
    const Real speed = pairing.soft_block ? 1 : 0.5;
    EXPECT_GT(std::fabs(run.last(column) - run.first(column)), 0.5 * speed);
    EXPECT_LT(run.worst_drift, 1e-10);
  }
}

const std::string kStanding = kRubber + R"(
title: a block of rubber stands
geometry: 3d
time: {end: 1 s}
bodies:
  block: {material: rubber, shape: {box: {min: [0, 0, 0], max: [20 mm, 20 mm, 20 mm]}}, BLOCK}
  floor: FLOOR
gravity: [0, 0, -9.81 m/s^2]
output: {every: 1 s, history: 1 ms}
)";

std::string with(std::string text, const std::string& word, const std::string& by) {
  return text.replace(text.find(word), word.size(), by);
}

// Weight that comes at once shakes the block about m g with its own period, 4 L/c = 0.7 ms, and
// throws it no higher than it stood. Bulk viscosity and the damping of contact take some 14 % of
// the amplitude a period (measured; a block of 1 MPa, 3.2 times as slow, rings by a fifth of its
// weight after 50 ms and by 1 % after 100): 70 periods leave 3e-5 of it after 50 ms. What is left
// then is noise of contact, and its rms shall be below 1 % of the weight; at no row does the force
// fall below 0.9 of it. A rigid block has the springs of its contact and of the plate alone.
TEST(ContactExtremes, BlocksStandStill) {
  const std::string rigid =
      "{rigid: true, shape: {plane: {origin: [10 mm, 10 mm, 0], normal: z, "
      "extent: 60 mm}}}";
  const std::string plate =
      "{material: rubber, cells: [3, 3, 1], shape: {box: {min: [-10 mm, "
      "-10 mm, -10 mm], max: [30 mm, 30 mm, 0]}}}\nboundaries: "
      "{foot: {body: floor, where: {side: min-z}, fix: [x, y, z]}}";
  const std::string elements = "cells: [4, 4, 4]",
                    particles = "method: sph, smoothing: 1.2, size: 4 mm";
  struct Case {
    std::string block, floor;
  };
  for (const Case& each : {Case{elements, rigid}, Case{elements, plate}, Case{particles, rigid},
                           Case{particles, plate}, Case{"rigid: true", plate}}) {
    const std::string what = each.block + " on " + each.floor;
    const auto run = simulate_text(with(with(kStanding, "BLOCK", each.block), "FLOOR", each.floor));
    ASSERT_EQ(run.failure, "") << what;
    const Real weight = run.first("body.block.mass") * 9.81;
    const auto time = run.column("time"), force = run.column("contact.block-floor.force.z");
    const auto height = run.column("body.block.position.z");
    Real squares = 0, least = kInfinity, highest = 0;
    int rows = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      highest = std::max(highest, height[i] - height[0]);
      if (time[i] < 0.05) continue;
      least = std::min(least, force[i]);
      squares += std::pow(force[i] / weight - 1, 2);
      ++rows;
    }
    ASSERT_GT(rows, 900);
    EXPECT_GT(least, 0.9 * weight) << what;
    EXPECT_LT(highest, 1e-9) << what;
    EXPECT_LT(std::sqrt(squares / rows), 0.01) << what;
    EXPECT_LT(std::fabs(run.last("body.block.velocity.z")), 1e-3) << what;
  }
}

/// Faces of a block that meet at the edge x = 0, z = 0: a top over x < 0 and a side below x = 0,
/// each of 3 x 3 quads of an element of 1 m that share their corners; stiffness 0: rigid.
void add_edge(ContactScene<3>& scene, Real stiffness) {
  auto& block = scene.add_group();
  const auto node = [&](const Vec3& x) {
    const auto& known = block.points.x;
    const auto found = std::find(known.begin(), known.end(), x);
    if (found != known.end()) return static_cast<LocalIndex>(found - known.begin());
    return scene.add_point(block, x, stiffness > 0 ? 1.0 : 0.0);
  };
  const auto add_face = [&](const std::array<Vec3, 4>& corners) {
    auto& facet = block.surface.facets.emplace_back();
    for (std::size_t c = 0; c < 4; ++c) facet.node[c] = node(corners[c]);
    scene.name(block, facet, stiffness, 1);
  };
  for (int i = -3; i < 0; ++i) {
    for (int j = -1; j < 2; ++j) {
      add_face({Vec3(i, j, 0), Vec3(i + 1, j, 0), Vec3(i + 1, j + 1, 0), Vec3(i, j + 1, 0)});
      add_face({Vec3(0, j, i), Vec3(0, j + 1, i), Vec3(0, j + 1, i + 1), Vec3(0, j, i + 1)});
    }
  }
}

// A ball, which is a particle of its radius, is led over the edge: along the top, about the
// edge and down the side, 0.1 r deep all the way, then past the edge on a straight line, 0.57 r
// from it. Its force is a function of the distance to the nearest point: its work is that of a
// potential, 0 here, where the ball is as deep, or as free, at the end as at the start. The normal
// turns with the way: 90 degrees in 90 parts. Work is the sum of F . dx at mid-step: 1e-4 of the
// force times the radius is the error of the sum.
TEST(ContactExtremes, ABallLedOverAnEdgeTurnsItsNormalSmoothly) {
  for (const Real stiffness : {0.0, 1e6}) {
    ContactScene<3> scene;
    scene.options.fallback.damping = 0;
    add_edge(scene, stiffness);
    const Real r = 0.25, reach = 0.9 * r;
    scene.add_particle(scene.add_group(), Vec3(-2, 0.3, reach), r, 1e6, 1);
    scene.start();
    auto& x = scene.groups[1].points.x[0];
    Real work = 0, widest = 0, largest = 0;
    Vec3 force = Vec3::Zero();
    const auto move = [&](const Vec3& to) {
      const Vec3 from = x;
      x = to;
      scene.evaluate();
      const Vec3 now = scene.force(1);
      work += 0.5 * (force + now).dot(to - from);
      if (force.norm() > 0 && now.norm() > 0) {
        const Real cosine = force.dot(now) / force.norm() / now.norm();
        widest = std::max(widest, std::acos(std::min(cosine, 1.0)));
      }
      force = now;
      largest = std::max(largest, force.norm());
    };
    move(x);
    work = 0;
    const int steps = 200;
    for (int i = 1; i <= steps; ++i) move(Vec3(-2 + 2.0 * i / steps, 0.3 + 0.4 * i / steps, reach));
    for (int i = 1; i <= 90; ++i) {
      const Real angle = kPi / 2 * (1 - i / 90.0);
      move(Vec3(reach * std::cos(angle), 0.7, reach * std::sin(angle)));
    }
    for (int i = 1; i <= steps; ++i) move(Vec3(reach, 0.7 - 0.4 * i / steps, -2.0 * i / steps));
    EXPECT_GT(largest, 0) << stiffness;
    EXPECT_LT(std::fabs(work), 0.01 * largest * r) << stiffness;
    EXPECT_LT(widest, 15 * kPi / 180) << stiffness;

    // Off the block, then past the edge at an angle, then off it: no force at either end.
    scene.groups[1].points.x[0] = Vec3(-0.5, 0.3, 0.7);
    scene.evaluate();
    force = scene.force(1), work = 0, widest = 0, largest = 0;
    EXPECT_EQ(force.norm(), 0);
    const Vec3 from = x, to(0.7, 0.3, -0.5);
    for (int i = 1; i <= 400; ++i) move(from + i / 400.0 * (to - from));
    EXPECT_EQ(force.norm(), 0);
    EXPECT_GT(largest, 0);
    EXPECT_LT(std::fabs(work), 0.01 * largest * r) << stiffness;
    EXPECT_LT(widest, 15 * kPi / 180) << stiffness;
  }
}

const std::string kRolledOff = R"(
title: a rigid ball goes over the edge of a table of elements
time: {end: 0.4 s}
materials:
  rubber: {density: 1000 kg/m^3, elastic: {E: 1 MPa, nu: 0.3}}
boundaries:
  still: {body: table, where: all, fix: ALL}
contact: {default: {friction: 0, damping: 0}}
output: {every: 0.1 s, history: 1 us}
bodies:
  ball:
    rigid: true
    material: rubber
)";
const std::string kBallInSpace = R"(
    shape: {sphere: {radius: 10 mm, center: [-20 mm, 0, 10 mm]}}
    cells: [16, 16, 16]
    velocity: [0.2 m/s, 0, 0]
  table:
    material: rubber
    shape: {box: {min: [-40 mm, -20 mm, -20 mm], max: [0, 20 mm, 0]}}
    cells: [4, 4, 2]
geometry: 3d
gravity: [0, 0, -9.81 m/s^2]
)";
const std::string kBallInPlane = R"(
    shape: {sphere: {radius: 10 mm, center: [-20 mm, 10 mm]}}
    cells: [16, 16]
    velocity: [0.2 m/s, 0]
  table:
    material: rubber
    shape: {box: {min: [-40 mm, -20 mm], max: [0, 0]}}
    cells: [4, 2]
geometry: plane-strain
gravity: [0, -9.81 m/s^2]
)";

/// How the force on the ball turns between steps that follow each other.
struct Turns {
  int steps = 0;
  Real widest = 0, farthest = 0;  // [rad] of a step, and from the upright towards the edge
  Turns(const Simulation& run, const std::string& up) {
    EXPECT_EQ(run.rows.size(), static_cast<std::size_t>(run.steps + 1));  // a row a step
    const auto along = run.column("contact.ball-table.force.x");
    const auto upward = run.column("contact.ball-table.force." + up);
    for (std::size_t i = 1; i < along.size(); ++i) {
      const Vec<2> before(along[i - 1], upward[i - 1]), now(along[i], upward[i]);
      if (before.norm() == 0 || now.norm() == 0) continue;
      ++steps;
      const Real across = before[0] * now[1] - before[1] * now[0];
      widest = std::max(widest, std::fabs(std::atan2(across, before.dot(now))));
      farthest = std::max(farthest, std::atan2(now[0], now[1]));
    }
  }
};

// C9 of faces on faces: a ball of facets, or a disc, bounces along a held table, goes over its edge
// and falls. Contact without friction and damping has nothing but springs, which hold no energy
// once it is off: what it took from the motion between is 0, within 1 % of m g r (0.2 % of the
// ball, 0.15 % of the disc). The ledger has all of it. Its force leans over as the ball does, by
// more than 45 degrees. The ball's turns by less than 15 degrees in a step (9.7), as the page asks.
// The disc has no third direction over which its facets meet the edge one after the other: where a
// corner of it passes that of the table the rims of both facets do not cancel for some 20 um, less
// than a step, and the force turns by 20 degrees and back; the facets themselves turn by 6.
// Asked: 25.
void expect_goes_over(const Simulation& run, const std::string& up, Real widest) {
  ASSERT_EQ(run.failure, "");
  const Real weight = run.first("body.ball.mass") * 9.81, radius = 10e-3;
  EXPECT_LT(run.last("body.ball.position." + up), -2 * radius);
  EXPECT_EQ(run.last("contact.ball-table.force." + up), 0);
  const Turns turns(run, up);
  EXPECT_GT(turns.steps, 300);
  EXPECT_GT(turns.farthest, 45 * kPi / 180);
  EXPECT_LT(turns.widest, widest);
  Real work = 0;
  for (const char* column : {"spring", "damping", "friction", "pairs"}) {
    work += run.last(std::string("energy.contact.") + column);
  }
  EXPECT_LT(std::fabs(work), 0.01 * weight * radius);
  // What is left is a fall: m v^2/2 + m g z of start and end.
  const Real height = run.first("body.ball.position." + up) - run.last("body.ball.position." + up);
  const Real gained = run.last("body.ball.kinetic") - run.first("body.ball.kinetic");
  EXPECT_NEAR(gained, weight * height, 0.01 * weight * radius);
  EXPECT_LT(run.worst_drift, 1e-12);
}

TEST(ContactExtremes, ABallGoesOverTheEdgeOfATable) {
  expect_goes_over(simulate_text(with(kRolledOff, "ALL", "[x, y, z]") + kBallInSpace), "z",
                   15 * kPi / 180);
}
TEST(ContactExtremes, ADiscGoesOverTheEdgeOfATable) {
  expect_goes_over(simulate_text(with(kRolledOff, "ALL", "[x, y]") + kBallInPlane), "y",
                   25 * kPi / 180);
}

}  // namespace
}  // namespace brunt::test
