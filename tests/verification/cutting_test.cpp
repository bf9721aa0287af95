// Orthogonal cutting, the shipped deck at twice its spacing. No force is known; what must hold is
// what is asked for: F_t/F_c = tan(atan mu - rake) (Merchant), ratio 0.0929 within 0.1;
// a specific cutting energy of 600 to 1100 N/mm^2; a steady force, halves of the last third within
// 10 %. Heat softens: where it may leave the shear zone the force is higher, and without any no
// shear zone forms, and the tool shoves the workpiece at twice the force.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

Simulation cut(const std::string& heat) {
  return simulate_shipped(
      "cutting-2d", {"parameters.spacing=0.05 mm", "parameters.travel=1.2 mm", "heat=" + heat});
}

/// Mean of a column over the rows from `first` to `last`, as shares of the run.
Real mean(const Simulation& run, const std::string& column, Real first, Real last) {
  const auto values = run.column(column);
  const auto n = static_cast<Real>(values.size());
  Real sum = 0;
  int count = 0;
  for (auto i = static_cast<std::size_t>(first * n); i < static_cast<std::size_t>(last * n); ++i) {
    sum += values[i], ++count;
  }
  return sum / count;
}

TEST(Cutting, AChipFlowsOffAtASteadyForce) {
  const auto run = cut("adiabatic");
  ASSERT_EQ(run.failure, "");
  const Real force = -run.measures.at("cutting");
  EXPECT_NEAR(run.measures.at("ratio"), std::tan(std::atan(0.2) - 6 * kPi / 180), 0.1);
  const Real energy = force / (0.3e-3 * 1e-3);  // [Pa] N/m^2 of the cut that is taken off
  EXPECT_GT(energy, 600e6);
  EXPECT_LT(energy, 1100e6);
  EXPECT_NEAR(mean(run, "contact.rake.force.x", 2.0 / 3, 5.0 / 6),
              mean(run, "contact.rake.force.x", 5.0 / 6, 1), 0.1 * force);
  EXPECT_LT(run.worst_drift, 1e-10);
  EXPECT_LT(std::fabs(run.last("energy.contact.pairs")), 1e-3 * run.largest_energy());
}

TEST(Cutting, HeatSoftensAndFlowsIntoTheTool) {
  const auto conducting = cut("conduct"), adiabatic = cut("adiabatic"), cold = cut("off");
  ASSERT_EQ(conducting.failure, "");
  EXPECT_GT(-cold.measures.at("cutting"), -conducting.measures.at("cutting"));
  EXPECT_GT(-conducting.measures.at("cutting"), -adiabatic.measures.at("cutting"));
  EXPECT_GT(conducting.last("body.tool.heat"), 0);
  // All heat comes from plastic work and from friction, and nothing leaves.
  for (const Real drift : conducting.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
  EXPECT_NEAR(conducting.last("heat.friction"), conducting.last("energy.contact.friction"),
              1e-10 * conducting.last("energy.contact.friction"));
}

}  // namespace
}  // namespace brunt::test
