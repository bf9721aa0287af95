// Soil after Drucker and Prager in decks: uniaxial strain in elements of all kinds and in
// particles, triaxial compression, Rankine's pressure at rest, restarts.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const std::string kRock = R"(
materials:
  rock:
    density: 2000 kg/m^3
    elastic: {K: 10 GPa, G: 6 GPa}
    strength: {drucker-prager: {cohesion: 100 kPa, friction_angle: 20 deg, dilation_angle: 10 deg}}
    thermal: {cp: 800 J/kg/K, taylor_quinney: 1}
)";

struct Kind {
  const char* geometry;
  const char* body;  ///< what is added to it
};

/// A block that is strained along y alone, 1e-3 in 0.1 ms: all of its points have a prescribed
/// motion.
std::string strained(const Kind& kind) {
  const bool flat = std::string(kind.geometry) != "3d";
  return std::string("title: uniaxial strain\ngeometry: ") + kind.geometry + kRock + R"(
time: {end: 0.1 ms}
bodies:
  block:
    material: rock
    size: 5 mm
    shape: {box: {min: )" +
         (flat ? "[0, 0], max: [20 mm, 20 mm]" : "[0, 0, 0], max: [20 mm, 20 mm, 20 mm]") + "}}\n" +
         kind.body + R"(
boundaries:
  all: {body: block, where: all, velocity: )" +
         (flat ? "[0, \"= -10*y\"]" : "[0, \"= -10*y\", 0]") + R"(}
measures:
  strain: {mean: {body: block, field: eps_p}}
  pressure: {mean: {body: block, field: pressure}}
  axial: {mean: {body: block, field: stress.yy}}
  side: {mean: {body: block, field: stress.xx}}
  volume: {mean: {body: block, field: plastic_volume}}
)";
}

/// dq/dp of the cone that touches Mohr and Coulomb's pyramid in triaxial compression.
Real slope(Real degrees) {
  const Real s = std::sin(degrees * kPi / 180);
  return 6 * s / (3 - s);
}

// After yield dl/de = (2 G - B K)/(3 G + B K D) as in tests/unit/core/drucker_prager_test.cpp.
// Strains are 1e-3, and so is what finite strain adds; particles as elements, since their gradients
// are exact for a linear motion.
TEST(Soil, UniaxialStrainIsTheClosedFormInAllFormulations) {
  const Real K = 10e9, G = 6e9, B = slope(20), D = slope(10);
  const Real A = 1e5 / std::tan(20 * kPi / 180) * B, e = 1e-3;
  const Real yield = A / (2 * G - B * K);
  const Real flow = (2 * G - B * K) / (3 * G + B * K * D) * (e - yield);
  const Real p = K * (e + D * flow), q = A + B * p;
  for (const Kind& kind :
       {Kind{"3d", "    element: {integration: one-point}"},
        Kind{"3d", "    element: {integration: q1p0}"},
        Kind{"3d", "    element: {integration: full}"},
        Kind{"plane-strain", "    element: {integration: one-point}"},
        Kind{"plane-strain", "    element: {integration: q1p0}"},
        Kind{"axisymmetric", "    element: {integration: one-point}"},
        Kind{"axisymmetric", "    element: {integration: full}"}, Kind{"3d", "    method: sph"},
        Kind{"plane-strain", "    method: sph"}}) {
    const Simulation run = simulate_text(strained(kind));
    SCOPED_TRACE(std::string(kind.geometry) + kind.body + run.failure);
    EXPECT_NEAR(run.measures.at("strain") / flow, 1, 5e-3);
    EXPECT_NEAR(run.measures.at("pressure") / p, 1, 5e-3);
    EXPECT_NEAR(run.measures.at("side") - run.measures.at("axial"), q, 5e-3 * q);
    EXPECT_NEAR((run.measures.at("volume") - 1) / (D * flow), 1, 5e-3);
    EXPECT_LT(run.worst_drift, 1e-10);
    // Heat is q - D p at the flow, per volume of time 0: the old and the new one as straight lines.
    const Real volume = std::string(kind.geometry) == "3d"             ? 8e-6
                        : std::string(kind.geometry) == "axisymmetric" ? kPi * 8e-6
                                                                       : 4e-4;
    const Real at_yield = A + (B - D) * K * yield, at_end = A + (B - D) * p;
    EXPECT_NEAR(run.last("energy.plastic_heat") / (0.5 * (at_yield + at_end) * flow * volume), 1,
                1e-2);
  }
}

// Sides held by a force, the top pushed slowly: Mohr and Coulomb's sigma_1 = N sigma_3 + 2 c
// sqrt(N) with the stresses as they are, N = 3. 1 %: what still rings.
TEST(Soil, TriaxialStrengthIsMohrAndCoulombs) {
  const auto run_at = [](const std::string& force, const std::string& element) {
    return simulate_text(R"(
title: triaxial compression
geometry: 3d
time: {end: 20 ms}
damping: {rate: 4000 1/s}
materials:
  sand:
    density: 2000 kg/m^3
    elastic: {K: 100 MPa, G: 60 MPa}
    strength: {drucker-prager: {cohesion: 10 kPa, friction_angle: 30 deg, dilation_angle: 5 deg}}
bodies:
  cube:
    material: sand
    size: 5 mm
    shape: {box: {min: [0, 0, 0], max: [10 mm, 10 mm, 10 mm]}}
    element: {integration: )" +
                         element + R"(}
boundaries:
  x: {body: cube, where: {side: min-x}, fix: [x]}
  y: {body: cube, where: {side: min-y}, fix: [y]}
  z: {body: cube, where: {side: min-z}, fix: [z]}
  push_x: {body: cube, where: {side: max-x}, force: [{table: [[0, 0], [2 ms, )" +
                         force +
                         R"(]], over: time}, 0, 0]}
  push_y: {body: cube, where: {side: max-y}, force: [0, {table: [[0, 0], [2 ms, )" +
                         force +
                         R"(]], over: time}, 0]}
  press:
    body: cube
    where: {side: max-z}
    velocity: [free, free, {table: [[0, 0], [5 ms, -10 mm/s]], over: time}]
measures:
  axial: {mean: {body: cube, field: stress.zz}}
  side: {mean: {body: cube, field: stress.xx}}
  strain: {min: {body: cube, field: eps_p}}
)");
  };
  Real last = 0;
  for (const char* force : {"0 N", "-5 N", "-20 N"}) {  // 0, 50, 200 kPa
    for (const char* element : {"one-point", "q1p0", "full"}) {
      const Simulation run = run_at(force, element);
      SCOPED_TRACE(std::string(force) + element + run.failure);
      const Real side = -run.measures.at("side"), axial = -run.measures.at("axial");
      EXPECT_GT(run.measures.at("strain"), 1e-3);
      EXPECT_NEAR(axial / (3 * side + 2 * 10e3 * std::sqrt(3.0)), 1, 1e-2);
      EXPECT_LT(run.worst_drift, 1e-10);
      EXPECT_GE(axial, 0.99 * last);
      last = axial;
    }
  }
}

// Sand between smooth walls yields under its weight until its sides carry 1/N of the vertical
// stress (Rankine 1857). 2 %: damped, so that it comes to rest from one side.
TEST(Soil, SandBetweenWallsPressesWithRankinesShare) {
  const Simulation run = simulate_text(R"(
title: sand between walls
geometry: plane-strain
time: {end: 0.2 s}
gravity: [0, -9.81 m/s^2]
damping: {rate: 600 1/s}
materials:
  sand:
    density: 1600 kg/m^3
    elastic: {K: 1 MPa, G: 1 MPa}
    strength: {drucker-prager: {cohesion: 0 Pa, friction_angle: 30 deg}}
bodies:
  column: {material: sand, size: 20 mm, shape: {box: {min: [0, 0], max: [20 mm, 200 mm]}}}
boundaries:
  walls: {body: column, where: all, fix: [x]}
  ground: {body: column, where: {side: min-y}, fix: [y]}
measures:
  vertical: {point: {body: column, field: stress.yy, at: [10 mm, 50 mm]}}
  side: {point: {body: column, field: stress.xx, at: [10 mm, 50 mm]}}
)");
  EXPECT_EQ(run.failure, "");
  EXPECT_NEAR(run.measures.at("vertical"), -1600 * 9.81 * 0.15, 0.02 * 1600 * 9.81 * 0.15);
  EXPECT_NEAR(run.measures.at("side") / run.measures.at("vertical"), 1.0 / 3, 0.02 / 3);
}

/// Dry sand of elements and of particles falls on the ground, opens, and dilates.
const std::string kFalling = R"(
title: sand falls
geometry: plane-strain
time: {end: 3 ms}
gravity: [0, -9.81 m/s^2]
materials:
  sand:
    density: 1600 kg/m^3
    elastic: {K: 2 MPa, G: 1 MPa}
    strength: {drucker-prager: {cohesion: 0 Pa, friction_angle: 30 deg, dilation_angle: 8 deg}}
    eos: {mie-gruneisen: {c0: 35 m/s, s: 1.5, gamma0: 1}}
    thermal: {cp: 800 J/kg/K}
bodies:
  grains:
    {method: sph, material: sand, size: 1 mm, velocity: [0, -2 m/s],
     shape: {box: {min: [0, 0.5 mm], max: [10 mm, 10.5 mm]}}}
  lump:
    {material: sand, size: 2 mm, velocity: [0, -2 m/s],
     shape: {box: {min: [20 mm, 0.1 mm], max: [30 mm, 10.1 mm]}}}
  ground: {rigid: true, shape: {box: {min: [-20 mm, -5 mm], max: [50 mm, 0]}}, size: 5 mm}
contact: {default: {friction: 0.5}}
measures:
  opening: {max: {body: grains, field: opening}}
  volume: {max: {body: grains, field: plastic_volume}}
  lump: {max: {body: lump, field: opening}}
)";

TEST(Soil, ARestartAndOtherThreadsChangeNoBit) {
  const Simulation plain = simulate_text(kFalling, {}, {.threads = 1});
  EXPECT_EQ(plain.failure, "");
  EXPECT_GT(plain.measures.at("opening"), 1.0001);
  EXPECT_GT(plain.measures.at("volume"), 1.0001);
  EXPECT_GT(plain.measures.at("lump"), 1.0001);
  EXPECT_LT(plain.worst_drift, 1e-10);
  EXPECT_LT(plain.created, 0.05);
  for (const RunVariation& other :
       {RunVariation{.threads = 2}, RunVariation{.threads = 1, .split_at = plain.steps / 2},
        RunVariation{.threads = 2, .rearrange_every_step = true}}) {
    EXPECT_EQ(simulate_text(kFalling, {}, other).hashes, plain.hashes);
  }
}

}  // namespace
}  // namespace brunt::test
