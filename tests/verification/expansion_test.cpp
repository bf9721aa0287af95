/// Thermal expansion: bodies that are heated slowly and evenly by 100 K.
///   Free: lengths grow by (1 + alpha dT), in plane strain by 1 + (1 + nu) alpha dT to first order.
/// Clamped along: sigma = -E alpha dT, lateral stress 0; the elongation (1 + nu) alpha dT across.
/// 0.5 %: strains are 1.2e-3, and the pressure K (1/J - 1) bends by as much; waves of the heating,
/// which takes 60 transits, are below that. Particles: 2 %, those of the surface lack neighbours.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

constexpr Real kHeatedYoung = 200e9, kHeatedNu = 0.3, kThermalStrain = 1.2e-5 * 100;

struct HeatedBar {
  const char* geometry = "3d";
  const char* method = "size: 1 mm, element: {integration: one-point}";
  bool clamped = false;
  const char* strength = "none";
};

Simulation heated(const HeatedBar& bar) {
  const std::string geometry = bar.geometry;
  const bool flat = geometry != "3d";
  const std::string along = geometry == "axisymmetric" ? "y" : "x";
  const std::string box = geometry == "3d" ? "min: [0, 0, 0], max: [8 mm, 3 mm, 3 mm]"
                          : along == "x"   ? "min: [0, 0], max: [8 mm, 3 mm]"
                                           : "min: [0, 0], max: [3 mm, 8 mm]";
  const std::string hold = "velocity: " + std::string(along == "y" ? "[free, 0]"
                                                      : flat       ? "[0, free]"
                                                                   : "[0, free, free]");
  std::string text = "title: A bar is heated\ngeometry: " + geometry + R"(
time: {end: 120 us}
ambient: 300 K
heat: conduct
materials:
  steel:
    density: 7800 kg/m^3
    elastic: {E: 200 GPa, nu: 0.3}
    strength: )" + bar.strength +
                     R"(
    thermal: {cp: 500 J/kg/K, k: 40 W/m/K, expansion: 1.2e-5 1/K}
bodies:
  bar: {material: steel, shape: {box: {)" +
                     box + "}}, " + bar.method + R"(}
boundaries:
  hot: {body: bar, where: all, temperature: {table: [[0, 300 K], [80 us, 400 K]], over: time}}
)";
  if (bar.clamped) {
    text += "  a: {body: bar, where: {side: min-" + along + "}, " + hold + "}\n";
    text += "  b: {body: bar, where: {side: max-" + along + "}, " + hold + "}\n";
  }
  const char* const across = along == "x" ? "y" : "x";
  text += "measures:\n  length: {extent: {body: bar, axis: " + along + "}}\n";
  text += std::string("  width: {extent: {body: bar, axis: ") + across + "}}\n";
  const std::string stress = along + along;
  text += "  stress: {mean: {body: bar, field: stress." + stress + "}}\n";
  text += "  across: {mean: {body: bar, field: stress.zz}}\n";
  text += "output: {every: 1 s, history: 2 us}\n";
  return simulate_text(text);
}

TEST(Expansion, FreeBodiesGrow) {
  for (const char* const element : {"one-point", "q1p0", "full"}) {
    for (const char* const geometry : {"3d", "plane-strain", "axisymmetric"}) {
      const std::string method = std::string("size: 1 mm, element: {integration: ") + element + "}";
      const auto run = heated({geometry, method.c_str()});
      EXPECT_EQ(run.failure, "");
      const bool flat = std::string(geometry) == "plane-strain";
      const Real strain = (flat ? 1 + kHeatedNu : 1) * kThermalStrain;
      EXPECT_NEAR((run.measures.at("length") / 0.008 - 1) / strain, 1, 0.005) << geometry;
      EXPECT_NEAR((run.measures.at("width") / 0.003 - 1) / strain, 1, 0.01) << geometry;
      const Real lateral = flat ? -kHeatedYoung * kThermalStrain : 0;
      EXPECT_NEAR(run.measures.at("across"), lateral, 0.005 * kHeatedYoung * kThermalStrain);
      EXPECT_LT(run.worst_drift, 1e-9) << geometry;
    }
  }
}

TEST(Expansion, ClampedBodiesArePressed) {
  for (const char* const geometry : {"3d", "axisymmetric"}) {
    const auto run = heated({geometry, "size: 1 mm", true});
    EXPECT_EQ(run.failure, "");
    EXPECT_NEAR(run.measures.at("stress") / (-kHeatedYoung * kThermalStrain), 1, 0.005) << geometry;
    EXPECT_NEAR((run.measures.at("width") / 0.003 - 1) / ((1 + kHeatedNu) * kThermalStrain), 1,
                0.01);
  }
  // A plate that is held along and in its plane: E alpha dT/(1 - nu).
  const auto plate = heated({"plane-strain", "size: 1 mm", true});
  EXPECT_NEAR(plate.measures.at("stress") / (-kHeatedYoung * kThermalStrain / 0.7), 1, 0.005);
}

TEST(Expansion, TetrahedraAndMetalsToo) {
  const auto tets = heated({"3d", "size: 1 mm, element: {type: tet4}"});
  EXPECT_NEAR((tets.measures.at("length") / 0.008 - 1) / kThermalStrain, 1, 0.01);
  const auto metal = heated({"3d", "size: 1 mm", true, "{j2: {yield: 100 MPa}}"});
  EXPECT_NEAR(metal.measures.at("stress") / -100e6, 1, 0.005);
}

TEST(Expansion, ParticlesGrow) {
  for (const char* const geometry : {"3d", "plane-strain"}) {
    const auto run = heated({geometry, "method: sph, size: 0.5 mm"});
    EXPECT_EQ(run.failure, "");
    const Real strain = (std::string(geometry) == "3d" ? 1 : 1 + kHeatedNu) * kThermalStrain;
    EXPECT_NEAR((run.measures.at("length") / 0.008 - 1) / strain, 1, 0.1) << geometry;
  }
}

}  // namespace
}  // namespace brunt::test
