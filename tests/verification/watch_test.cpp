// Probes and sections. Columns of elements and of particles settle on a fixed foot under their own
// weight, g = 1e4 m/s^2, rho = 2000 kg/m^3, 2 mm wide, 1 m deep, 10 mm high. A section at rest
// carries the weight of the points beyond it, -m g: of quads of 1 mm, 4.5 mm above either side of
// the node row at 5.5 mm, for that row's lumped mass counts half at 10 mm; of particles 5 mm. Its
// moment about the origin is x m g, x that of the column's axis. Damping leaves exp(-15) of the
// motion in 30 us; 1e-4 allows for the slowest mode.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kColumns = R"yaml(
geometry: plane-strain
time: {end: 100 us}
gravity: [0, -1e4 m/s^2]
damping: {rate: 1e6 1/s}
materials:
  soft: {density: 2000 kg/m^3, elastic: {E: 10 GPa, nu: 0}}
bodies:
  quads: {material: soft, shape: {box: {min: [2 mm, 0], max: [4 mm, 10 mm]}}, size: 1 mm}
  particles:
    method: sph
    smoothing: 1.2
    material: soft
    shape: {box: {min: [12 mm, 0], max: [14 mm, 10 mm]}}
    size: 0.5 mm
boundaries:
  quads_foot: {body: quads, where: {side: min-y}, fix: [x, y]}
  particles_foot: {body: particles, where: {side: min-y}, fix: [x, y]}
probes:
  node: {body: quads, at: [3 mm, 4.9 mm], fields: [displacement.y, stress.yy]}
  particle: {body: particles, at: [13 mm, 5 mm], fields: [displacement.y, stress.yy]}
sections:
  quads: {body: quads, plane: {axis: y, at: 5.5 mm}}
  nodes: {body: quads, plane: {axis: y, at: 5 mm}}
  particles: {body: particles, plane: {axis: y, at: 5 mm}}
measures:
  node: {point: {body: quads, at: [3 mm, 4.9 mm], field: displacement.y}}
  stress: {point: {body: quads, at: [3 mm, 4.9 mm], field: stress.yy}}
  particle: {point: {body: particles, at: [13 mm, 5 mm], field: displacement.y}}
  pressed: {history: {column: section.particles.force.y, reduce: last}}
output: {history: 10 us}
)yaml";

TEST(Sections, CarryTheWeightBeyondThem) {
  const auto run = simulate_text(kColumns);
  ASSERT_EQ(run.failure, "");
  const Real square_metre = 2000 * 1e4 * 2e-3;  // [N/m] weight of a metre of the column
  for (const char* name : {"section.quads.", "section.nodes."}) {
    const Real weight = square_metre * 4.5e-3;
    EXPECT_NEAR(run.last(name + std::string("force.y")), -weight, 1e-4 * weight);
    EXPECT_NEAR(run.last(name + std::string("force.x")), 0, 1e-4 * weight);
    EXPECT_NEAR(run.last(name + std::string("moment.z")), -3e-3 * weight, 1e-4 * 3e-3 * weight);
  }
  const Real weight = square_metre * 5e-3;
  EXPECT_NEAR(run.last("section.particles.force.y"), -weight, 1e-4 * weight);
  EXPECT_NEAR(run.last("section.particles.moment.z"), -13e-3 * weight, 1e-4 * 13e-3 * weight);
  EXPECT_EQ(run.measures.at("pressed"), run.last("section.particles.force.y"));
}

// A probe reads what a measure at the same place reads, bit for bit; and rows are those of a run in
// two parts.
TEST(Probes, ReadWhatMeasuresRead) {
  const auto run = simulate_text(kColumns);
  ASSERT_EQ(run.failure, "");
  EXPECT_EQ(run.last("probe.node.displacement.y"), run.measures.at("node"));
  EXPECT_EQ(run.last("probe.node.stress.yy"), run.measures.at("stress"));
  EXPECT_EQ(run.last("probe.particle.displacement.y"), run.measures.at("particle"));
  EXPECT_LT(run.measures.at("node"), 0);
  const auto split = simulate_text(kColumns, {}, {.threads = 2, .split_at = run.steps / 2});
  EXPECT_EQ(split.rows, run.rows);
}

}  // namespace
}  // namespace brunt::test
