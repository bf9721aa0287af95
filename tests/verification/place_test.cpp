/// Probes and measures at places between points. Between ends of 300 and 400 K that are l apart the
/// steady temperature is 300 K + 100 K x/l. Elements hold it exactly, and so do their shape
/// functions: what is left at the end is exp(-t pi^2 alpha/l^2) = exp(-63), and rounding. Columns
/// of particles do not conduct a linear profile exactly to their ends (0.1 K of 100 K with kernels
/// of 1.5 spacings), which moving least squares pass on: 0.3 K, where the nearest column is 2.2 K
/// off.
#include <gtest/gtest.h>

#include "app/setup/scene_builder.hpp"
#include "app/setup/scene_checks.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kText = R"(
title: Between 300 K and 400 K
geometry: plane-strain
time: {end: 60 s}
heat: conduct
ambient: 300 K
materials:
  m:
    density: 7850 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    thermal: {cp: 475 J/kg/K, k: 400 W/m/K}
bodies:
  cells: {material: m, shape: {box: {min: [0, 0], max: [10 mm, 3 mm]}}, cells: [7, 2]}
  particles:
    method: sph
    material: m
    shape: {box: {min: [0, 10 mm], max: [10 mm, 14 mm]}}
    size: 1 mm
boundaries:
  cells_still: {body: cells, where: all, fix: [x, y]}
  particles_still: {body: particles, where: all, fix: [x, y]}
  cells_cold: {body: cells, where: {side: min-x}, temperature: 300 K}
  cells_hot: {body: cells, where: {side: max-x}, temperature: 400 K}
  particles_cold: {body: particles, where: {side: min-x}, temperature: 300 K}
  particles_hot: {body: particles, where: {side: max-x}, temperature: 400 K}
probes:
  cells: {body: cells, at: [3.7 mm, 1.3 mm], fields: [temperature]}
  particles: {body: particles, at: [3.7 mm, 11.9 mm], fields: [temperature]}
measures:
  cells: {point: {body: cells, at: [3.7 mm, 1.3 mm], field: temperature}}
  particles: {point: {body: particles, at: [3.7 mm, 11.9 mm], field: temperature}}
output: {every: 60 s, history: 60 s}
)";

TEST(Place, BetweenPointsIsInterpolated) {
  const Simulation run = simulate_text(kText);
  ASSERT_EQ(run.failure, "");
  EXPECT_NEAR(run.last("probe.cells.temperature"), 337, 1e-6);
  EXPECT_EQ(run.measures.at("cells"), run.last("probe.cells.temperature"));
  // The ends of the particles' bar are columns at 0.5 and 9.5 mm, beside which heat flows as if
  // they were 0.07 spacings nearer (docs/theory/heat.md (H8)). The nearest particle has 2.2 K less.
  EXPECT_NEAR(run.last("probe.particles.temperature"), 300 + 100 * 3.2 / 9, 0.8);
  EXPECT_EQ(run.measures.at("particles"), run.last("probe.particles.temperature"));
}

TEST(Place, OutsideIsTold) {
  const auto reported = [](const std::string& at) {
    const auto loaded = load_deck_text(kText, "deck.yaml", {"probes.cells.at=" + at});
    std::vector<DeckProblem> warnings;
    warn_of_scene(loaded, *build_scene<2>(loaded), false, warnings);
    return warnings.empty() ? "" : warnings.front().text();
  };
  EXPECT_EQ(reported("[10 mm, 3 mm]"), "");
  const std::string text = reported("[14 mm, 3 mm]");
  EXPECT_NE(text.find("probes.cells.at: lies outside of 'cells'"), std::string::npos) << text;
  EXPECT_NE(text.find("4 mm away"), std::string::npos) << text;
}

}  // namespace
}  // namespace brunt::test
