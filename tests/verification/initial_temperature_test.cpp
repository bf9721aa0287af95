// Temperatures at time 0 that depend on the place, against closed forms.
//   An insulated bar with T = T0 + A cos(pi x/L) keeps that shape: it is an eigenfunction of
// d2T/dx2 without flux at both ends, so that A decays as exp(-a pi^2 t/L^2), a = k/(rho cp).
// Elements of length h have it as an eigenvector too, whose rate is less by (pi h/L)^2/12 (lumped
// capacities), 0.2 % of it at h = L/20. Tetrahedra lie askew, and of particles the layers at the
// ends lack neighbours.
//   A bar that is pulled evenly, so far that all of it yields, has everywhere the flow stress at
// its own temperature: A (1 - ((T - T_ref)/(T_melt - T_ref))^m) of Johnson-Cook without hardening.
//   Work w of plastic flow heats by beta w/(rho cp) wherever the point began.
//   Each point is free of stress at the temperature it begins with: one rise D everywhere, whatever
// it was, lengthens a free bar by alpha D without stress, and nothing happens before.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// A body of each kind of element and of particles, in its geometry.
struct Kind {
  const char* geometry;
  const char* body;  ///< what is added to it
  Real most;         ///< [K] by which a cosine of 55 K may be off
};
constexpr Kind kKinds[] = {
    {"3d", "size: 1 mm, element: {integration: one-point}", 0.1},
    {"3d", "size: 1 mm, element: {integration: q1p0}", 0.1},
    {"3d", "size: 1 mm, element: {integration: full}", 0.1},
    {"3d", "size: 1 mm, element: {type: tet4}", 0.5},
    {"3d", "size: 1 mm, method: sph", 1},
    {"3d", "size: 1 mm, method: sph, formulation: total", 1},
    {"plane-strain", "size: 1 mm, element: {integration: full}", 0.1},
    {"plane-strain", "size: 1 mm, method: sph", 1},
    {"axisymmetric", "size: 1 mm, element: {integration: one-point}", 0.1},
};
bool is_flat(const Kind& kind) { return std::string(kind.geometry) != "3d"; }

/// The bar lies along y, in axisymmetry the axis.
constexpr Real kLength = 20e-3;
std::string shape(const Kind& kind) {
  return is_flat(kind) ? "shape: {box: {min: [0, 0], max: [4 mm, 20 mm]}}"
                       : "shape: {box: {min: [0, 0, 0], max: [4 mm, 20 mm, 4 mm]}}";
}
std::string fixed(const Kind& kind) { return is_flat(kind) ? "[x, y]" : "[x, y, z]"; }

/// [m] centres of the cells of a view, three components each.
std::vector<Real> cell_centers(const BodyView& view) {
  const auto corners = static_cast<std::size_t>(view.corners);
  std::vector<Real> centers(3 * view.n_cells(), 0.0);
  for (std::size_t k = 0; k < view.connectivity.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) {
      centers[3 * (k / corners) + c] +=
          view.position[3 * static_cast<std::size_t>(view.connectivity[k]) + c] / view.corners;
    }
  }
  return centers;
}

/// Values of a field, of points or of elements, with where they are.
template <class F>
void for_values(const BodyView& view, const char* name, F f) {
  for (const auto* fields : {&view.cell_fields, &view.point_fields}) {
    const Field* field = field_named(*fields, name);
    if (field == nullptr) continue;
    const auto places = fields == &view.point_fields ? view.position : cell_centers(view);
    for (std::size_t k = 0; k < field->values.size(); ++k) f(places[3 * k + 1], field->values[k]);
    return;
  }
  FAIL() << "no field " << name;
}

Real decayed(Real time) {
  const Real diffusivity = 44.5 / (7850 * 475.0);
  return std::exp(-diffusivity * kPi * kPi * time / (kLength * kLength));
}

std::string cosine_deck(const Kind& kind, const std::string& more) {
  return std::string("title: a cosine of temperatures\ngeometry: ") + kind.geometry + R"(
time: {end: 2 s}
materials:
  steel:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    thermal: {cp: 475 J/kg/K, k: 44.5 W/m/K}
contact: {default: {ignore: true}}
output: {history: 0.5 s}
)" + more +
         "bodies:\n  bar: {material: steel, temperature: \"= 400 + 100 * cos(pi * y / 20e-3)\", " +
         shape(kind) + ", " + kind.body + "}\n";
}

TEST(InitialTemperature, ACosineDecaysAsItself) {
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(std::string(kind.geometry) + ": " + kind.body);
    const auto run = simulate_text(cosine_deck(
        kind, "boundaries: {still: {body: bar, where: all, fix: " + fixed(kind) + "}}\n"));
    ASSERT_EQ(run.failure, "");
    EXPECT_LT(std::abs(run.last("heat.drift")), 1e-12);
    Real worst = 0;
    for_values(run.bodies.at("bar"), "temperature", [&](Real y, Real T) {
      worst = std::max(worst, std::abs(T - 400 - 100 * decayed(2) * std::cos(kPi * y / kLength)));
    });
    EXPECT_LT(worst, kind.most);
  }
}

TEST(InitialTemperature, RigidBodiesConductIt) {
  const Kind kind{"3d", "size: 1 mm, rigid: true", 0.1};
  const auto run = simulate_text(cosine_deck(kind, ""));
  ASSERT_EQ(run.failure, "");
  Real worst = 0;
  for_values(run.bodies.at("bar"), "temperature", [&](Real y, Real T) {
    worst = std::max(worst, std::abs(T - 400 - 100 * decayed(2) * std::cos(kPi * y / kLength)));
  });
  EXPECT_LT(worst, kind.most);
}

/// A bar that is pulled evenly along y; its upper half is hot.
std::string pulled_deck(const Kind& kind, const std::string& material, const std::string& heat) {
  const std::string velocity = is_flat(kind) ? R"([0, "= 100 * y"])" : R"([0, "= 100 * y", 0])";
  return std::string("title: a bar with a hot half\ngeometry: ") + kind.geometry +
         "\ntime: {end: 100 us}\nheat: " + heat + "\nmaterials:\n  steel:\n" +
         "    density: 7850 kg/m^3\n    elastic: {E: 200 GPa, nu: 0.3}\n" + material +
         "bodies:\n  bar: {material: steel, temperature: \"= y < 10e-3 ? 298 : 798\", " +
         shape(kind) + ", " + kind.body + ", velocity: " + velocity +
         "}\nboundaries: {pull: {body: bar, where: all, velocity: " + velocity +
         "}}\ncontact: {default: {ignore: true}}\noutput: {history: 10 us, state_hash: true}\n";
}
const char* const kSoftening =
    "    strength: {johnson-cook: {A: 400 MPa, B: 0, n: 1, C: 0, m: 0.8, T_melt: 1798 K, "
    "T_ref: 298 K}}\n";

TEST(InitialTemperature, EachHalfYieldsAtItsOwn) {
  const Real cold = 400e6, hot = 400e6 * (1 - std::pow(500.0 / 1500, 0.8));
  for (const Kind& kind : kKinds) {
    // Without heat, and where heat is off, the temperature of the start is that for ever.
    for (const bool thermal : {false, true}) {
      SCOPED_TRACE(std::string(kind.geometry) + ": " + kind.body);
      const std::string material =
          kSoftening + std::string(thermal ? "    thermal: {cp: 475, k: 44.5}\n" : "");
      const auto run = simulate_text(pulled_deck(kind, material, "off"), {"bodies.bar.size=2 mm"});
      ASSERT_EQ(run.failure, "");
      Real worst = 0;
      for_values(run.bodies.at("bar"), "von_mises", [&](Real y, Real stress) {
        worst = std::max(worst, std::abs(stress - (y < 10.1e-3 ? cold : hot)));
      });
      EXPECT_LT(worst, 1e-6 * cold);
    }
  }
}

TEST(InitialTemperature, PlasticHeatComesOnTop) {
  const std::string material =
      "    strength: {j2: {yield: 400 MPa}}\n    thermal: {cp: 475, taylor_quinney: 0.9}\n";
  for (const Kind& kind : kKinds) {
    SCOPED_TRACE(std::string(kind.geometry) + ": " + kind.body);
    const auto run =
        simulate_text(pulled_deck(kind, material, "adiabatic"), {"bodies.bar.size=2 mm"});
    ASSERT_EQ(run.failure, "");
    std::vector<Real> strain;
    for_values(run.bodies.at("bar"), "eps_p", [&](Real, Real value) { strain.push_back(value); });
    std::size_t k = 0;
    for_values(run.bodies.at("bar"), "temperature", [&](Real y, Real T) {
      const Real rise = 0.9 * 400e6 * strain[k++] / (7850 * 475);
      EXPECT_GT(rise, 0.4);
      // Work is of the volume by now, which a pull makes larger by 1 % at the end.
      EXPECT_NEAR(T - (y < 10.1e-3 ? 298 : 798), rise, 0.011 * rise);
    });
  }
}

// t1 is 20 times as long as sound needs along the bar, as in expansion_test.cpp.
TEST(InitialTemperature, WhatBeginsUnevenlyExpandsEvenly) {
  const std::string field = "300 + 100 * cos(pi * x / 10e-3)";
  for (const char* kind :
       {"element: {integration: one-point}", "element: {integration: full}",
        "element: {type: tet4}", "method: sph", "method: sph\n    formulation: total"}) {
    SCOPED_TRACE(kind);
    Real early = 0;
    SceneHooks hooks;
    hooks.moved = [&](std::int64_t step, const std::function<BodyView(Label)>& body) {
      if (step > 1) return;
      for_values(body(0), "von_mises", [&](Real, Real value) { early = std::max(early, value); });
    };
    const std::string rise = " + 25 * (1 - cos(pi * min(1, t/100e-6)))";
    const std::string deck = R"(
title: a bar that is heated
geometry: 3d
time: {end: 110 us}
materials:
  steel:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    thermal: {cp: 450, k: 20, expansion: 1.2e-5 1/K}
bodies:
  bar:
    material: steel
    shape: {box: {min: [-5 mm, -0.75 mm, -0.5 mm], max: [5 mm, 0.75 mm, 0.5 mm]}}
    size: 0.5 mm
    temperature: "= )" + field +
                             "\"\n    " + kind + R"(
boundaries: {heat: {body: bar, where: all, temperature: "= )" +
                             field + rise + "\"}}\noutput: {every: 1 s, history: 1 us}\n";
    const auto run = simulate_text(deck, {}, {}, hooks);
    ASSERT_EQ(run.failure, "");
    EXPECT_LT(early, 1e3);
    constexpr Real kStretch = 1.2e-5 * 50;
    const BodyView& view = run.bodies.at("bar");
    const auto& u = field_named(view.point_fields, "displacement")->values;
    Real sum = 0, square = 0;
    for (std::size_t i = 0; i < u.size(); i += 3) {
      const Real x = view.position[i] - u[i];
      sum += u[i] * x, square += x * x;
    }
    EXPECT_NEAR(sum / square / kStretch, 1, 0.005);
    Real largest = 0;
    for_values(view, "von_mises", [&](Real, Real value) { largest = std::max(largest, value); });
    EXPECT_LT(largest, 0.02 * 200e9 * kStretch);
    EXPECT_LT(run.worst_drift, 1e-9);
  }
}

// Two blocks slide over a floor that is cold on the left and hot on the right; friction is of the
// mean temperature of both sides, 0.1 at 300 K and 0.5 at 400 K: each loses mu g t. The weight
// comes on the springs of contact within the first 1 % of that.
TEST(InitialTemperature, FacesOfRigidBodiesShowThatOfTheirMiddle) {
  const auto run = simulate_text(R"(
title: A floor whose halves have other temperatures
geometry: 3d
time: {end: 1 ms}
materials: {nylon: {density: 1100 kg/m^3, elastic: {E: 1 GPa, nu: 0.4}}}
gravity: [0, 0, -9.81 m/s^2]
bodies:
  left:
    material: nylon
    shape: {box: {min: [-15 mm, -5 mm, 0], max: [-5 mm, 5 mm, 5 mm]}}
    size: 5 mm
    velocity: [1 m/s, 0, 0]
    temperature: 300 K
  right:
    material: nylon
    shape: {box: {min: [5 mm, -5 mm, 0], max: [15 mm, 5 mm, 5 mm]}}
    size: 5 mm
    velocity: [1 m/s, 0, 0]
    temperature: "= 290 + 1e3 * x"
  floor:
    rigid: true
    shape: {box: {min: [-20 mm, -20 mm, -5 mm], max: [20 mm, 20 mm, 0]}}
    size: 5 mm
    temperature: "= x < 0 ? 300 : 500"
contact: {default: {friction: {table: [[300, 0.1], [400, 0.5]], over: temperature}}}
)");
  ASSERT_EQ(run.failure, "");
  const Real fall = 9.81 * 1e-3;
  EXPECT_NEAR(1 - run.last("body.left.velocity.x"), 0.1 * fall, 0.01 * fall);
  EXPECT_NEAR(1 - run.last("body.right.velocity.x"), 0.5 * fall, 0.01 * fall);
}

// Of bodies that are all rigid heat is computed.
TEST(InitialTemperature, ALoneRigidBarEvensOut) {
  const auto run = simulate_text(R"yaml(
title: a rigid bar evens out on its way
geometry: 3d
time: {end: 3 s}
materials: {steel: {density: 7850, elastic: {E: 200 GPa, nu: 0.3}, thermal: {k: 44.5, cp: 475}}}
bodies:
  bar:
    rigid: true
    material: steel
    motion: {velocity: [1 mm/s, 0, 0]}
    temperature: "= 300 + 100*cos(pi*y/0.02)"
    shape: {box: {min: [0, 0, 0], max: [4 mm, 20 mm, 4 mm]}}
    size: 1 mm
measures: {hot: {max: {body: bar, field: temperature}}}
)yaml");
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.measures.at("hot"), 300 + 100 * decayed(3), 0.2);
}

// A restart takes the state as it was, and does not begin it again; nor do threads change a bit.
TEST(InitialTemperature, RestartsAndThreadsGoOnWithTheSameBits) {
  const std::string material = std::string(kSoftening) +
                               "    thermal: {cp: {table: [[200, 400], [1500, 800]], over: "
                               "temperature}, k: 44.5, expansion: 1.2e-5 1/K}\n";
  for (const Kind& kind : kKinds) {
    for (const char* heat : {"adiabatic", "auto", "off"}) {
      SCOPED_TRACE(std::string(kind.geometry) + ": " + kind.body + ", " + heat);
      const std::vector<std::string> brief{"time.end=20 us", "output.history=1 us",
                                           "boundaries.pull.where={side: max-y}",
                                           "bodies.bar.velocity=null", "bodies.bar.size=2 mm"};
      const std::string deck = pulled_deck(kind, material, heat);
      const Simulation whole = simulate_text(deck, brief);
      ASSERT_EQ(whole.failure, "");
      RunVariation split, threads;
      split.split_at = 10;
      threads.threads = 2;
      for (const RunVariation& variation : {split, threads}) {
        const Simulation other = simulate_text(deck, brief, variation);
        EXPECT_EQ(other.hashes, whole.hashes);
        EXPECT_EQ(other.rows, whole.rows);
      }
    }
  }
}

}  // namespace
}  // namespace brunt::test
