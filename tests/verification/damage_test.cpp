// Materials that fail, in scenes.
//   Fracture energy: a bar of concrete without lateral strain, 0.4 m long and 40 mm square, with
//   f_t
// of 3 MPa and E of 30 GPa, is pulled apart at 2 mm/s. One row of its elements fails and takes
// G_f = 100 J/m^2 of its section; the rest unloads (0.4 m is less than 2 E G_f/f_t^2 = 0.67 m: it
// does not snap). The work of all stresses, once the halves are free, is that energy whatever the
// size of elements. 5 % is the gate; at twice the speed waves let a second row begin (6 to 8 %).
//   Spall: a pulse that jumps to p0 and falls linearly over a length l meets a free surface. Where
// tension reaches f_t, l f_t/(2 p0) below it, the material parts; the surface has slowed from
//   2 p0/(rho c) to 2 (p0 - f_t)/(rho c)
// by then, and the release of that tension brings it back to 2 p0/(rho c) (Antoun et al., Spall
// Fracture, 2003, ch. 2). Under a tensile cut-off instead it never comes back.
//   Opened: a block at 400 K fails in its first steps and is opened to eight times its volume. No
// stress does any work then, no viscosity is in what expands, and no heat flows: T = 400 K
// exp(gamma0 (1 - J_0)), J_0 = 1/(1 - gamma0 E/K) the volume without stress, E < f_t^2/K the energy
// of the first steps: within 0.04 K of 400 K. By the whole volume it would be 3e-4 K.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

std::string pulled_bar(const std::string& size, const std::string& element) {
  return R"(
title: A bar of concrete that is pulled apart
geometry: plane-strain
depth: 40 mm
time: {end: 60 ms}
materials:
  concrete:
    density: 2400 kg/m^3
    elastic: {E: 30 GPa, nu: 0}
    damage: {principal_stress: 3 MPa, energy: 100 J/m^2}
bodies:
  bar:
    material: concrete
    shape: {box: {min: [0, 0], max: [400 mm, 40 mm]}}
    size: )" +
         size + "\n    element: {integration: " + element + R"(}
boundaries:
  left: {body: bar, where: {side: min-x}, velocity: [-1 mm/s, free]}
  right: {body: bar, where: {side: max-x}, velocity: [1 mm/s, free]}
measures:
  failed: {max: {body: bar, field: damage}}
output: {every: 1 s, history: 0.1 ms}
)";
}

TEST(Damage, ACrackTakesItsEnergyWhateverTheElements) {
  const Real energy = 100 * 0.04 * 0.04;
  for (const char* const element : {"one-point", "q1p0", "full"}) {
    for (const char* const size : {"40 mm", "20 mm", "10 mm"}) {
      const auto run = simulate_text(pulled_bar(size, element));
      EXPECT_EQ(run.failure, "") << size;
      EXPECT_EQ(run.measures.at("failed"), 1.0) << size << ' ' << element;
      EXPECT_NEAR(run.last("energy.internal") / energy, 1, 0.05) << size << ' ' << element;
      EXPECT_LT(run.worst_drift, 1e-10);
    }
  }
}

/// Velocities of a free surface that a triangular pulse of 150 m/s at first reaches.
struct Surface {
  Real peak = 0, least = 0, back = 0;  ///< [m/s]
};

Surface surface_of(const std::string& limit) {
  const auto run = simulate_text(R"(
title: A pulse that falls linearly meets a free surface
geometry: plane-strain
time: {end: 4.3 us}
materials:
  aluminium:
    density: 2700 kg/m^3
    elastic: {E: 70 GPa, nu: 0.33}
    )" + limit + R"(
bodies:
  plate:
    material: aluminium
    shape: {box: {min: [0, 0], max: [12 mm, 0.008 mm]}}
    cells: [1500, 1]
boundaries:
  across: {body: plate, where: all, fix: [y]}
  pulse:
    body: plate
    where: {side: min-x}
    velocity: [{table: [[0, 0], [0.05 us, 150 m/s], [2.55 us, 0], [9 us, 0]], over: time}, free]
probes:
  surface: {body: plate, at: [12 mm, 0], fields: [velocity.x]}
output: {every: 1 s, history: 2 ns}
)");
  EXPECT_EQ(run.failure, "");
  const auto speed = run.column("probe.surface.velocity.x");
  const auto peak = std::max_element(speed.begin(), speed.end());
  const auto least = std::min_element(peak, speed.end());
  const auto back = std::max_element(least, speed.end());
  return {*peak, *least, *back};
}

TEST(Damage, TheSurfaceOfASpallComesBack) {
  const Real c = std::sqrt((70e9 / (3 * 0.34) + 4.0 / 3 * 70e9 / 2.66) / 2700);
  const Real fall = 2 * 2e9 / (2700 * c);
  const Surface spall = surface_of("damage: {principal_stress: 2 GPa}");
  EXPECT_NEAR(spall.peak, 300, 0.02 * 300);
  EXPECT_NEAR(spall.peak - spall.least, fall, 0.02 * fall);
  EXPECT_NEAR(spall.back - spall.least, fall, 0.02 * fall);
  const Surface held = surface_of("tensile_cutoff: 2 GPa");
  EXPECT_LT(held.back - held.least, 0.3 * fall);
}

std::string opened_block(const std::string& method, const std::string& heat) {
  return R"deck(
title: A block that fails and opens
geometry: 3d
time: {end: 50 us}
heat: )deck" +
         heat + R"deck(
materials:
  m:
    density: 2700 kg/m^3
    elastic: {E: 70 GPa, nu: 0.3}
    strength: {j2: {yield: 100 MPa}}
    damage: {mean_tension: 500 MPa}
    eos: {mie-gruneisen: {c0: 5300 m/s, s: 1.3, gamma0: 2}}
    thermal: {cp: 900 J/kg/K, k: 200 W/m/K}
bodies:
  a:
    material: m
    shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 10 mm]}}
    )deck" +
         method + R"deck(
    temperature: 400 K
    velocity: ["= 20000*x", "= 20000*y", "= 20000*z"]
boundaries:
  v: {body: a, where: all, velocity: ["= 20000*x", "= 20000*y", "= 20000*z"]}
probes: {p: {body: a, at: [5 mm, 5 mm, 5 mm], fields: [temperature, pressure, density]}}
output: {every: 1 s, history: 2 us}
)deck";
}

TEST(Damage, WhatHasOpenedKeepsItsTemperature) {
  for (const char* const method :
       {"cells: [2, 2, 2]", "cells: [2, 2, 2]\n    element: {integration: full}",
        "cells: [2, 2, 2]\n    element: {type: tet4}", "method: sph\n    size: 2 mm"}) {
    for (const char* const heat : {"adiabatic", "conduct"}) {
      SCOPED_TRACE(std::string(method) + ' ' + heat);
      const auto run = simulate_text(opened_block(method, heat));
      ASSERT_EQ(run.failure, "");
      EXPECT_EQ(run.last("probe.p.pressure"), 0);
      EXPECT_LT(run.last("probe.p.density"), 400);
      EXPECT_NEAR(run.last("probe.p.temperature"), 400, 0.1);
    }
  }
}

}  // namespace
}  // namespace brunt::test
