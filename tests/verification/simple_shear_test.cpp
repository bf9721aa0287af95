// Simple shear by gamma at a held volume turns by gamma/2 for each gamma of strain: Jaumann's rate
// of a hypoelastic body gives, in closed form (Dienes 1979),
//   s_xy = G sin(gamma), s_xx = -s_yy = G (1 - cos(gamma)).
// Through whole decks, in 1000 steps to gamma = 1: a step leaves out step^2/6 of the strain
// (tests/unit/core/rotation_test.cpp), 2e-7 of G; the gate is 1e-3. Particles of the updated
// formulation at the two sharp corners have too few neighbours for a whole correction
// (docs/decisions/088-gradient-correction-limit.md): those within.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

// So heavy that no element bounds the step: 1000 steps are those of max_step.
const std::string kDeck = R"(
title: Simple shear
geometry: plane-strain
time: {end: 1 s, max_step: 1 ms}
materials: {m: {density: 1e12 kg/m^3, elastic: {K: 3 MPa, G: 1 MPa}}}
bodies:
  b:
    material: m
    shape: {box: {min: [0, 0], max: [1 m, 1 m]}}
    size: 0.1 m
boundaries:
  all: {body: b, where: all, velocity: ["= y", 0]}
measures:
  low: {min: {body: b, field: stress.xy, where: {box: {min: [0.29, 0.29], max: [0.71, 0.71]}}}}
  high: {max: {body: b, field: stress.xy, where: {box: {min: [0.29, 0.29], max: [0.71, 0.71]}}}}
  xx: {mean: {body: b, field: stress.xx, where: {box: {min: [0.29, 0.29], max: [0.71, 0.71]}}}}
  yy: {mean: {body: b, field: stress.yy, where: {box: {min: [0.29, 0.29], max: [0.71, 0.71]}}}}
output: {history: 0.1 s}
)";

void expect_closed_form(const std::vector<std::string>& overrides, Real tolerance) {
  const auto run = simulate_text(kDeck, overrides);
  ASSERT_EQ(run.failure, "");
  ASSERT_EQ(run.steps, 1000);
  constexpr Real kG = 1e6;
  EXPECT_NEAR(run.measures.at("low"), kG * std::sin(1.0), tolerance * kG);
  EXPECT_NEAR(run.measures.at("high"), kG * std::sin(1.0), tolerance * kG);
  EXPECT_NEAR(run.measures.at("xx"), kG * (1 - std::cos(1.0)), tolerance * kG);
  EXPECT_NEAR(run.measures.at("yy"), -kG * (1 - std::cos(1.0)), tolerance * kG);
}

TEST(SimpleShear, OfElementsIsThatOfJaumann) {
  for (const char* integration : {"one-point", "q1p0", "full"}) {
    SCOPED_TRACE(integration);
    expect_closed_form({"bodies.b.element.integration=" + std::string(integration)}, 1e-6);
  }
}

TEST(SimpleShear, OfElementsInSpaceToo) {
  for (const char* type : {"hex8", "tet4"}) {
    SCOPED_TRACE(type);
    expect_closed_form(
        {"geometry=3d", "bodies.b.shape.box={min: [0, 0, 0], max: [1 m, 1 m, 0.2 m]}",
         "bodies.b.element.type=" + std::string(type), "boundaries.all.velocity=['= y', 0, 0]",
         "measures.low.min.where=all", "measures.high.max.where=all", "measures.xx.mean.where=all",
         "measures.yy.mean.where=all"},
        1e-6);
  }
}

TEST(SimpleShear, OfParticlesToo) {
  for (const char* formulation : {"updated", "total"}) {
    SCOPED_TRACE(formulation);
    expect_closed_form({"bodies.b.method=sph", "bodies.b.formulation=" + std::string(formulation)},
                       1e-6);
  }
}

}  // namespace
}  // namespace brunt::test
