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

}  // namespace
}  // namespace brunt::test
