// Stress at time 0 in decks: rock that carries its weight from the start, a bar that is let go,
// pressure alone, restarts.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// A body of each kind of element and of particles, in its geometry.
struct Kind {
  const char* name;
  const char* geometry;
  const char* body;  ///< what is added to it
  Real most;         ///< what a test allows it
};

bool is_flat(const Kind& kind) { return std::string(kind.geometry) != "3d"; }

// Rock of density rho0 on a smooth bed between smooth walls, height H, carries its weight: z up,
//   sigma_v = -rho0 g (H - z),   sigma_h = nu/(1 - nu) sigma_v.
// Let go without stress, its top falls as far as the wave from the bed has to come: to g H/c,
// c the speed of plane waves. With the stress its forces are in balance but for the density: that
// under pressure p is rho0 (1 + p/K), so a share p_max/K < 1.2e-5 of the weight is left over, which
// moves it by no more than that share of g H/c. Elements of one point, q1p0 and full integrate a
// stress that is linear over a regular mesh exactly, and so do tetrahedra with the pressures of
// their nodes. In axisymmetry sigma_h is the radial and the hoop stress.
std::string rock_deck(const Kind& kind, const std::string& size, bool stressed) {
  const bool flat = is_flat(kind);
  const std::string v = flat ? "y" : "z", rock = "= -2700 * 9.81 * (10 - " + v + ")";
  const std::string side = flat ? "= -900 * 9.81 * (10 - y)" : "= -900 * 9.81 * (10 - z)";
  std::string deck = std::string("title: rock under its weight\ngeometry: ") + kind.geometry + R"(
time: {end: 10 ms}
materials: {rock: {density: 2700 kg/m^3, elastic: {E: 20 GPa, nu: 0.25}}}
gravity: )" + (flat ? "[0, -9.81 m/s^2]" : "[0, 0, -9.81 m/s^2]") +
                     R"(
bodies:
  block:
    material: rock
    size: )" + size + R"(
    shape: {box: {min: )" +
                     (flat ? "[0, 0], max: [4 m, 10 m]" : "[0, 0, 0], max: [4 m, 3 m, 10 m]") +
                     "}}\n" + kind.body + "\n";
  if (stressed) {
    deck += "    stress: {" + v + v + ": \"" + rock + "\", xx: \"" + side + "\", " +
            (flat ? "zz" : "yy") + ": \"" + side + "\"}\n";
  }
  deck += R"(boundaries:
  bed: {body: block, where: {side: min-)" +
          v + "}, fix: [" + v + R"(]}
  left: {body: block, where: {side: min-x}, fix: [x]}
  right: {body: block, where: {side: max-x}, fix: [x]}
)";
  if (!flat) {
    deck += R"(  front: {body: block, where: {side: min-y}, fix: [y]}
  back: {body: block, where: {side: max-y}, fix: [y]}
)";
  }
  return deck + "output: {history: 0.1 ms}\n";
}

struct Speeds {
  Real greatest = 0;  ///< [m/s] of any point along any axis
  Real mean = 0;      ///< [m/s] of the centre of mass along the vertical, its greatest
};
Speeds speeds_of(const Kind& kind, const std::string& size, bool stressed) {
  Speeds speeds;
  SceneHooks hooks;
  hooks.moved = [&](std::int64_t, const std::function<BodyView(Label)>& body) {
    const BodyView view = body(0);
    for (const Real component : field_named(view.point_fields, "velocity")->values) {
      speeds.greatest = std::max(speeds.greatest, std::abs(component));
    }
  };
  const Simulation run = simulate_text(rock_deck(kind, size, stressed), {}, {}, hooks);
  EXPECT_EQ(run.failure, "") << kind.name;
  EXPECT_LT(run.worst_drift, 1e-9) << kind.name;
  for (const Real mean :
       run.column(std::string("body.block.velocity.") + (is_flat(kind) ? "y" : "z"))) {
    speeds.mean = std::max(speeds.mean, std::abs(mean));
  }
  return speeds;
}

TEST(InitialStress, RockThatCarriesItsWeightStaysStill) {
  const Real modulus = 24e9;  // E (1 - nu)/((1 + nu)(1 - 2 nu))
  const Real fall = 9.81 * 10 / std::sqrt(modulus / 2700);
  for (const Kind& kind :
       {Kind{"one-point", "3d", "    element: {integration: one-point}", 1.2e-5},
        Kind{"q1p0", "3d", "    element: {integration: q1p0}", 1.2e-5},
        Kind{"full", "3d", "    element: {integration: full}", 1.2e-5},
        Kind{"tet4", "3d", "    element: {type: tet4}", 1.2e-5},
        Kind{"quads", "plane-strain", "    element: {integration: one-point}", 1.2e-5},
        Kind{"quads of q1p0", "plane-strain", "    element: {integration: q1p0}", 1.2e-5},
        Kind{"rings", "axisymmetric", "    element: {integration: one-point}", 1.2e-5},
        Kind{"rings of q1p0", "axisymmetric", "    element: {integration: q1p0}", 1.2e-5},
        Kind{"full rings", "axisymmetric", "    element: {integration: full}", 1.2e-5}}) {
    SCOPED_TRACE(kind.name);
    const Speeds without = speeds_of(kind, "1 m", false), with = speeds_of(kind, "1 m", true);
    EXPECT_NEAR(without.greatest / fall, 1, 0.15);  // the front is a few elements wide
    EXPECT_LT(with.greatest / fall, kind.most);
  }
}

// Particles bear the stress on their edges by the two or three layers within reach of them, of
// which a boundary holds the first: those settle. That is of first order in the spacing over H: of
// the speed of the centre of mass without the stress 11 % are left with 10 particles over the
// height, 6 % with 20 in the plane; 10 % and 6 % in space.
TEST(InitialStress, RockOfParticlesSettlesByPartsOfASpacing) {
  for (const char* geometry : {"plane-strain", "3d"}) {
    const Kind kind{"particles", geometry, "    method: sph", 0};
    for (const auto& [size, most] : {std::pair("1 m", 0.12), std::pair("0.5 m", 0.07)}) {
      SCOPED_TRACE(std::string(geometry) + size);
      const Speeds without = speeds_of(kind, size, false), with = speeds_of(kind, size, true);
      EXPECT_LT(with.mean / without.mean, most);
    }
  }
}

// A free bar, nu = 0, with the uniform stress sigma: c = sqrt(E/rho). Let go at both ends it
// shortens; each end moves inwards with sigma/(rho c) until the wave from the other one comes at
// L/c, then outwards until 2 L/c, and so on. The energy at the start is sigma^2/2E times volume,
// and the sum stays. 2 %: fronts of some elements; energies 0.2 %: sigma/E = 5e-4 is not small to
// first order.
TEST(InitialStress, BarThatIsLetGoSwingsWithTheSpeedOfItsStress) {
  const Real sigma = 100e6, young = 200e9, c = std::sqrt(young / 8000), speed = sigma / (8000 * c);
  const Real length = 0.1, passage = length / c, volume = length * 4e-6;
  for (const Kind& kind : {Kind{"one-point", "3d", "    element: {integration: one-point}", 0.02},
                           Kind{"q1p0", "3d", "    element: {integration: q1p0}", 0.02},
                           Kind{"tet4", "3d", "    element: {type: tet4}", 0.02},
                           Kind{"particles", "3d", "    method: sph", 0.02}}) {
    SCOPED_TRACE(kind.name);
    std::vector<Real> crossings;
    Real time = 0, last = 0, sum = 0;
    int counted = 0;
    SceneHooks hooks;
    hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
      time = clock.time();
      const auto& points = scene.solids[0]->points();
      Real left = 0, mass = 0;
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        if (points.x_start[i][0] + scene.origin[0] > 0.6e-3) continue;
        left += points.mass[i] * points.v[i][0], mass += points.mass[i];
      }
      left /= mass;
      if (time > 0.2 * passage && time < 0.9 * passage) sum += left, ++counted;
      if (left * last < 0) crossings.push_back(time);
      last = left;
    };
    const Simulation run = simulate_text(std::string(R"(
title: a bar let go
geometry: 3d
time: {end: 45 us}
materials: {steel: {density: 8000 kg/m^3, elastic: {E: 200 GPa, nu: 0}}}
bodies:
  bar:
    material: steel
    size: 1 mm
    shape: {box: {min: [0, 0, 0], max: [100 mm, 2 mm, 2 mm]}}
    stress: {xx: 100 MPa}
)") + kind.body + "\noutput: {history: 1 us}\n",
                                         {}, {}, hooks);
    EXPECT_EQ(run.failure, "");
    EXPECT_NEAR(sum / counted / speed, 1, kind.most);
    ASSERT_GE(crossings.size(), 2u);
    EXPECT_NEAR(crossings[0] / passage, 1, kind.most);
    EXPECT_NEAR((crossings[1] - crossings[0]) / passage, 1, kind.most);
    const Real stored = sigma * sigma / (2 * young) * volume;
    EXPECT_NEAR(run.first("energy.internal") / stored, 1, 2e-3);
    EXPECT_LT(run.worst_drift, 1e-9);
    EXPECT_LT(run.created, 1e-3);
    for (const Real internal : run.column("energy.internal")) EXPECT_GT(internal, -2e-3 * stored);
  }
}

// Pressure alone. p = K (1/r - 1) has rho/rho0 = 1/r = 1 + p/K, and so has the mass of a given
// volume. Mie and Grueneisen's law, with the energy E = p (1 - r)/2 of the compression from rest,
// is on its Hugoniot: p = rho0 c0^2 eta/(1 - s eta)^2, eta = 1 - r. Held on all sides it keeps the
// pressure to the rounding of volumes: 3e-16 K were measured, 1e-14 K are allowed.
TEST(InitialStress, PressureComesWithItsDensityAndStays) {
  const Real p = 2e9, bulk = 100e9, c0 = 4000, s = 1.5;
  const Real a = p / (8000 * c0 * c0);  // eta = a (1 - s eta)^2
  const Real eta = ((2 * a * s + 1) - std::sqrt(4 * a * s + 1)) / (2 * a * s * s);
  for (const Kind& kind :
       {Kind{"one-point", "3d", "    element: {integration: one-point}", 0},
        Kind{"q1p0", "3d", "    element: {integration: q1p0}", 0},
        Kind{"full", "3d", "    element: {integration: full}", 0},
        Kind{"tet4", "3d", "    element: {type: tet4}", 0},
        Kind{"plane strain", "plane-strain", "", 0}, Kind{"axisymmetric", "axisymmetric", "", 0},
        Kind{"axisymmetric, full", "axisymmetric", "    element: {integration: full}", 0},
        Kind{"particles", "3d", "    method: sph", 0}}) {
    for (const bool shock : {false, true}) {
      SCOPED_TRACE(std::string(kind.name) + (shock ? ", mie-gruneisen" : ""));
      const std::string eos =
          shock ? ", eos: {mie-gruneisen: {c0: 4000 m/s, s: 1.5, gamma0: 2}}" : "";
      Real low = kInfinity, high = -kInfinity;
      SceneHooks hooks;
      hooks.moved = [&](std::int64_t, const std::function<BodyView(Label)>& body) {
        const BodyView view = body(0);
        const auto* field = field_named(view.cell_fields, "pressure");
        if (field == nullptr) field = field_named(view.point_fields, "pressure");
        for (const Real value : field->values)
          low = std::min(low, value), high = std::max(high, value);
      };
      const Simulation run =
          simulate_text(std::string("title: pressed\ngeometry: ") + kind.geometry + R"(
time: {end: 5 us}
materials: {metal: {density: 8000 kg/m^3, elastic: {K: 100 GPa, G: 40 GPa})" +
                            eos + R"(}}
bodies:
  block:
    material: metal
    size: 2 mm
    stress: {xx: -2 GPa, yy: -2 GPa, zz: -2 GPa}
    shape: {box: {min: )" +
                            (is_flat(kind) ? "[0, 0], max: [10 mm, 10 mm]"
                                           : "[0, 0, 0], max: [10 mm, 10 mm, 10 mm]") +
                            "}}\n" + kind.body + R"(
boundaries: {all: {body: block, where: all, fix: )" +
                            (is_flat(kind) ? "[x, y]" : "[x, y, z]") + "}}\n",
                        {}, {}, hooks);
      EXPECT_EQ(run.failure, "");
      const Real K = shock ? 8000 * c0 * c0 : bulk;
      EXPECT_NEAR(low, p, 1e-14 * K);
      EXPECT_NEAR(high, p, 1e-14 * K);
      const Real volume = std::string(kind.geometry) == "3d"             ? 1e-6
                          : std::string(kind.geometry) == "axisymmetric" ? kPi * 1e-6
                                                                         : 1e-4;
      const Real density = 8000 * (shock ? 1 / (1 - eta) : 1 + p / bulk);
      EXPECT_NEAR(run.last("body.block.mass") / (density * volume), 1, 1e-12);
      const Real ratio = 8000 / density;
      const Real stored = 0.5 * p * (1 - ratio) * volume / ratio;
      EXPECT_NEAR(run.first("energy.internal") / stored, 1, 1e-12);
    }
  }
}

// A restart takes the state as it was, and does not begin it again; nor do threads change a bit.
TEST(InitialStress, RestartsAndThreadsGoOnWithTheSameBits) {
  for (const char* kind : {"element={integration: one-point}", "element={integration: full}",
                           "element={type: tet4}", "method=sph"}) {
    SCOPED_TRACE(kind);
    const std::string deck = R"deck(
title: a block with a stress of its own
geometry: 3d
time: {end: 6 us}
materials:
  steel:
    density: 8000 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    strength: {j2: {yield: 900 MPa}}
bodies:
  block:
    material: steel
    size: 1 mm
    shape: {box: {min: [0, 0, 0], max: [6 mm, 4 mm, 4 mm]}}
    stress: {xx: "= 2e10 * x", yy: "= -1e8 * sin(500 * z)", xy: 40 MPa, yz: "= 1e10 * (y - 2e-3)"}
output: {history: 0.5 us, state_hash: true}
)deck";
    const std::vector<std::string> of_kind{std::string("bodies.block.") + kind};
    const Simulation whole = simulate_text(deck, of_kind);
    ASSERT_EQ(whole.failure, "");
    RunVariation split, threads;
    split.split_at = 10;
    threads.threads = 2;
    for (const RunVariation& variation : {split, threads}) {
      const Simulation other = simulate_text(deck, of_kind, variation);
      EXPECT_EQ(other.hashes, whole.hashes);
      EXPECT_EQ(other.rows, whole.rows);
    }
  }
}

}  // namespace
}  // namespace brunt::test
