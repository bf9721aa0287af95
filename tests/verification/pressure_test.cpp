// Follower pressure on faces against closed forms: a thick tube (Lame), a free plate, a body under
// pressure all around, a body that turns, and the resultant on an axisymmetric end.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// Mean radial displacement [m] of the points that were at this radius [m] at time 0; the radius is
/// x, or the distance from the z axis.
Real radial_displacement(const BodyView& view, Real radius, bool axisymmetric) {
  const auto& moved = field_named(view.point_fields, "displacement")->values;
  Real sum = 0;
  int n = 0;
  for (std::size_t i = 0; i < view.position.size(); i += 3) {
    const Real x = view.position[i] - moved[i], y = view.position[i + 1] - moved[i + 1];
    const Real r = axisymmetric ? x : std::hypot(x, y);
    if (std::fabs(r - radius) > 1e-3 * radius) continue;
    sum += axisymmetric ? moved[i] : (x * moved[i] + y * moved[i + 1]) / r;
    ++n;
  }
  EXPECT_GT(n, 2);
  return sum / n;
}

// Lame, plane strain, a = 10 mm, b = 20 mm, p = 1 MPa inside:
//   u(r) = (1 + nu) p a^2/(E (b^2 - a^2)) ((1 - 2 nu) r + b^2/r)
// Damped until it rests; displacements of 1e-4 of the size change nothing of the geometry. 0.5 %:
// ten elements across the wall, and faces of 4 degrees along the bore.
void expect_tube(const std::string& geometry, const std::string& shape,
                 const std::string& boundaries) {
  const auto run = simulate_text("title: thick tube\ngeometry: " + geometry + R"(
time: {end: 0.15 ms}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies: {tube: {material: steel, )" +
                                 shape + R"(}}
damping: {rate: 4e5 1/s}
output: {history: 1 us}
boundaries:
)" + boundaries);
  ASSERT_EQ(run.failure, "");
  const Real a = 10e-3, b = 20e-3, nu = 0.3, E = 200e9, p = 1e6;
  const auto u = [&](Real r) {
    return (1 + nu) * p * a * a / (E * (b * b - a * a)) * ((1 - 2 * nu) * r + b * b / r);
  };
  const bool axisymmetric = geometry == "axisymmetric";
  const auto& tube = run.bodies.at("tube");
  EXPECT_NEAR(radial_displacement(tube, a, axisymmetric), u(a), 5e-3 * u(a)) << geometry;
  EXPECT_NEAR(radial_displacement(tube, b, axisymmetric), u(b), 5e-3 * u(b)) << geometry;
  EXPECT_LT(run.last("energy.kinetic"), 1e-6 * run.last("energy.internal"));
  // Half of the work of a pressure that comes at once is left as strain, the damping has the rest.
  EXPECT_NEAR(run.last("energy.internal"), -0.5 * run.last("energy.boundary"),
              1e-2 * run.last("energy.internal"));
  EXPECT_LT(run.worst_drift, 1e-10);
}
constexpr const char* kInside =
    "  bore: {body: tube, where: surface, pressure: \"= sqrt(x^2 + y^2)"
    " < 0.015 ? 1e6 : 0\"}\n";

TEST(Pressure, ThickTubeOfRings) {
  expect_tube("axisymmetric", "shape: {box: {min: [10 mm, 0], max: [20 mm, 2 mm]}}, cells: [10, 2]",
              "  flat: {body: tube, where: all, fix: [y]}\n"
              "  bore: {body: tube, where: {side: min-x}, pressure: 1 MPa}\n");
}

TEST(Pressure, ThickTubeInPlaneStrain) {
  expect_tube("plane-strain", "shape: {tube: {inner: 10 mm, outer: 20 mm}}, size: 1 mm", kInside);
}

TEST(Pressure, ThickTubeInSpace) {
  expect_tube("3d", "shape: {tube: {inner: 10 mm, outer: 20 mm, length: 2 mm}}, size: 1 mm",
              kInside + std::string("  flat: {body: tube, where: all, fix: [z]}\n"));
}

// A free plate without lateral strain (nu = 0, no bulk viscosity, which pushes sideways) under p =
// p0 t/T on one face: its momentum is A p0 t^2/(2 T), exactly, since steps integrate what is linear
// in time exactly.
TEST(Pressure, FreePlateTakesTheImpulse) {
  for (const char* element : {"hex8", "tet4"}) {
    const auto run = simulate_text(R"(
title: free plate
geometry: 3d
time: {end: 20 us}
materials: {metal: {density: 2700 kg/m^3, elastic: {E: 70 GPa, nu: 0}}}
bodies:
  plate:
    material: metal
    element: {type: )" + std::string(element) +
                                   R"(, bulk_viscosity: {linear: 0, quadratic: 0}}
    shape: {box: {min: [0, 0, 0], max: [10 mm, 8 mm, 2 mm]}}
    cells: [5, 4, 2]
boundaries:
  blast:
    body: plate
    where: {side: min-z}
    pressure: {table: [[0, 0], [20 us, 10 MPa]], over: time}
output: {history: 1 us}
)");
    ASSERT_EQ(run.failure, "") << element;
    const Real momentum = 10e-3 * 8e-3 * 0.5 * 10e6 * 20e-6;
    const bool mean_pressure = std::string(element) == "tet4";  // its averages bend the face
    EXPECT_NEAR(run.last("momentum.z"), momentum, (mean_pressure ? 1e-3 : 1e-8) * momentum);
    EXPECT_NEAR(run.last("boundary.blast.force.z"), 10e-3 * 8e-3 * 10e6,
                (mean_pressure ? 1e-2 : 1e-8) * 800);
    EXPECT_NEAR(run.last("momentum.x"), 0, (mean_pressure ? 1e-4 : 1e-9) * momentum);
    EXPECT_LT(run.worst_drift, 1e-10);
    const Real moved = run.last("energy.kinetic") + run.last("energy.internal") +
                       run.last("energy.hourglass") + run.last("energy.integration");
    EXPECT_NEAR(-run.last("energy.boundary"), moved, 1e-9 * moved);
    EXPECT_GT(moved, 0);
  }
}

/// [m^3] of all cells.
Real volume_of(const BodyView& view) {
  Real sum = 0;
  for (const Real one : view.cell_volume) sum += one;
  return sum;
}

// Pressure all around: forces are the gradient of the volume, so that they push the body nowhere
// and their work is p times the volume that it lost; at rest V = V0/(1 + p/K), as p = K (rho/rho0 -
// 1).
TEST(Pressure, AllAroundIsWorkOnTheVolume) {
  struct Case {
    const char *geometry, *shape;
    Real volume;
  };
  for (const auto& [geometry, shape, volume] :
       {Case{"3d", "{box: {min: [0, 0, 0], max: [4 mm, 3 mm, 2 mm]}}", 24e-9},
        Case{"3d", "{cylinder: {radius: 2 mm, length: 3 mm, base: [0, 0, 0], axis: z}}", 0},
        Case{"axisymmetric", "{box: {min: [1 mm, 0], max: [3 mm, 2 mm]}}", kPi * 8e-6 * 2e-3}}) {
    const std::string deck = std::string("title: under water\ngeometry: ") + geometry + R"(
time: {end: 40 us}
materials: {soft: {density: 1000 kg/m^3, elastic: {K: 1 GPa, G: 0.4 GPa}}}
bodies: {body: {material: soft, shape: )" +
                             shape + R"(, size: 0.5 mm}}
boundaries: {sea: {body: body, where: surface, pressure: 5 MPa}}
damping: {rate: 1e6 1/s}
output: {history: 1 us}
)";
    const auto run = simulate_text(deck), start = simulate_text(deck, {"time.end=1 ps"});
    ASSERT_EQ(run.failure, "");
    const Real before = volume_of(start.bodies.at("body")),
               after = volume_of(run.bodies.at("body"));
    if (volume > 0) {
      EXPECT_NEAR(before, volume, 1e-9 * volume);
    }
    // One-point rings are not in even compression to the last digit.
    const Real tolerance = std::string(geometry) == "3d" ? 1e-8 : 1e-5;
    EXPECT_NEAR(after, before / (1 + 5e6 / 1e9), tolerance * before);
    const Real work = 5e6 * (before - after);
    EXPECT_NEAR(-run.last("energy.boundary"), work, 1e-6 * work);
    for (const char* axis : {"x", "y"}) {
      if (std::string(geometry) == "axisymmetric" && *axis == 'x') continue;
      EXPECT_NEAR(run.last("momentum." + std::string(axis)), 0, 1e-15) << geometry;
    }
    EXPECT_LT(run.worst_drift, 1e-10);
  }
}

// A stiff block spins by a quarter of a turn: the pressure on its side turns with it.
TEST(Pressure, TurnsWithItsFaces) {
  const auto run = simulate_text(R"(
title: a turning block
geometry: plane-strain
depth: 2 mm
time: {end: 1.5707963267948966 ms}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 20 GPa, nu: 0.3}}}
bodies:
  block:
    material: steel
    shape: {box: {min: [-5 mm, -2 mm], max: [5 mm, 2 mm]}}
    cells: [10, 4]
    spin: {rate: 1000 rad/s, about: [0, 0]}
boundaries: {wind: {body: block, where: {side: min-y}, pressure: 1 kPa}}
output: {history: 10 us}
)");
  ASSERT_EQ(run.failure, "");
  const Real force = 1e3 * 10e-3 * 2e-3;  // upwards at first, then to the left
  EXPECT_NEAR(run.rows[1][run.index("boundary.wind.force.y")], force, 1e-3 * force);
  EXPECT_NEAR(run.last("boundary.wind.force.x"), -force, 2e-3 * force);
  EXPECT_NEAR(run.last("boundary.wind.force.y"), 0, 1e-2 * force);
  EXPECT_LT(run.worst_drift, 1e-9);
}

// On the end of a round bar the resultant is p pi R^2, of the whole ring.
TEST(Pressure, OnTheEndOfARoundBar) {
  const auto run = simulate_text(R"(
title: a round bar
geometry: axisymmetric
time: {end: 1 ns}
materials: {steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}}
bodies: {bar: {material: steel, shape: {box: {min: [0, 0], max: [3 mm, 5 mm]}}, cells: [3, 5]}}
boundaries: {end: {body: bar, where: {side: max-y}, pressure: 1 MPa}}
)");
  const Real force = kPi * 9e-6 * 1e6;
  EXPECT_NEAR(run.last("boundary.end.force.y"), -force, 1e-6 * force);
}

}  // namespace
}  // namespace brunt::test
