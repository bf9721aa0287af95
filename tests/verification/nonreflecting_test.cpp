// A nonreflecting boundary lets plane waves out: of a pulse of wavelength 20 elements that meets it
// along its normal, less than 1 % comes back (Lysmer & Kuhlemeyer 1969: nothing, but for the
// elements), pressure wave and shear wave; what left is in the books.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

/// A bar of 200 elements, held across the wave. Its left end moves as one sine of 20 elements, then
/// rests; `along`: in its direction, a pressure wave, or across, a shear wave. The pulse passes
/// x = 100 mm once; what came back would do so too before 0.38/c.
Simulation wave(const std::string& geometry, bool along, bool open) {
  const bool flat = geometry != "3d";
  const Real c = along ? std::sqrt((1e9 + 4.0 / 3 * 0.6e9) / 1000) : std::sqrt(0.6e9 / 1000);
  const auto text = [](Real value) { return std::to_string(1e6 * value) + " us"; };
  const std::string pulse = "\"= t < " + std::to_string(1e6 * 0.02 / c) + "e-6 ? 0.1*sin(2*pi*t*" +
                            std::to_string(c / 0.02) + ") : 0\"";
  const std::string others = flat ? "" : ", 0";
  return simulate_text("title: a wave leaves\ngeometry: " + geometry +
                       "\ntime: {end: " + text(0.39 / c) + R"(}
materials: {soft: {density: 1000 kg/m^3, elastic: {K: 1 GPa, G: 0.6 GPa}}}
bodies:
  bar:
    material: soft
    shape: {box: {min: [0, 0)" +
                       others + "], max: [200 mm, 1 mm" + (flat ? "" : ", 1 mm") +
                       R"(]}}
    cells: [200, 1)" + (flat ? "" : ", 1") +
                       R"(]
    element: {bulk_viscosity: {linear: 0, quadratic: 0}}
boundaries:
  across: {body: bar, where: all, fix: )" +
                       (along ? (flat ? "[y]" : "[y, z]") : (flat ? "[x]" : "[x, z]")) + R"(}
  drive: {body: bar, where: {side: min-x}, velocity: [)" +
                       (along ? pulse + ", free" : "free, " + pulse) + (flat ? "" : ", free") +
                       R"(]}
)" + (open ? "  far: {body: bar, where: {side: max-x}, nonreflecting: true}\n" : "") +
                       "probes: {middle: {body: bar, at: [100 mm, 0.5 mm" +
                       (flat ? "" : ", 0.5 mm") + "], fields: [velocity." + (along ? "x" : "y") +
                       "]}}\noutput: {history: " + text(1e-4 / c) + "}\n");
}

TEST(Nonreflecting, PlaneWavesDoNotComeBack) {
  for (const char* geometry : {"plane-strain", "3d"}) {
    for (const bool along : {true, false}) {
      const auto run = wave(geometry, along, true), closed = wave(geometry, along, false);
      ASSERT_EQ(run.failure, "");
      const char* column = along ? "probe.middle.velocity.x" : "probe.middle.velocity.y";
      const auto largest = [&](const Simulation& of, Real from, Real to) {
        Real most = 0;
        const auto time = of.column("time"), v = of.column(column);
        for (std::size_t k = 0; k < v.size(); ++k) {
          if (time[k] >= from * time.back() && time[k] <= to * time.back())
            most = std::max(most, std::fabs(v[k]));
        }
        return most;
      };
      // It passes the middle at 100 to 120 mm of its way, and comes back at 300 to 320 of 390.
      const Real passed = largest(run, 0, 0.5), back = largest(run, 0.7, 1);
      EXPECT_NEAR(passed, 0.1, 0.01);
      EXPECT_LT(back, 0.01 * passed) << geometry << " " << along;
      EXPECT_GT(largest(closed, 0.7, 1), 0.8 * passed);
      EXPECT_LT(run.worst_drift, 1e-10);
      EXPECT_LT(run.last("energy.kinetic"), 2e-3 * closed.last("energy.kinetic"));
    }
  }
}

// A column of 0.2 m x 1 m x 1 m stands under 5 MPa in the stress that carries it, at rest: its
// support holds 1 MN, and the dashpots beside, which nothing moves, give nothing. They stand on
// points that the support holds too: its force is none of theirs.
TEST(Nonreflecting, ForcesThatASupportTakesMoveNoDashpot) {
  const auto run = simulate_text(R"(title: a column at rest under its load
geometry: plane-strain
time: {end: 0.5 ms}
materials:
  rock: {density: 2700 kg/m^3, elastic: {E: 20 GPa, nu: 0}}
bodies:
  column:
    material: rock
    shape: {box: {min: [0, 0], max: [0.2 m, 1 m]}}
    size: 0.1 m
    stress: {yy: -5 MPa}
boundaries:
  open: {body: column, where: {side: max-x}, nonreflecting: true}
  held: {body: column, where: {side: min-y}, fix: [y]}
  load: {body: column, where: {side: max-y}, pressure: 5 MPa}
output: {history: 0.05 ms}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.column("boundary.held.reaction.y").back(), 1e6, 1e-6 * 1e6);
  EXPECT_LT(std::fabs(run.column("boundary.open.force.y").back()), 1e-6 * 1e6);
  EXPECT_LT(run.column("energy.kinetic").back(), 1e-12);  // of 125 J
}

}  // namespace
}  // namespace brunt::test
