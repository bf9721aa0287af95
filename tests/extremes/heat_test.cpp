// Extremes of heat: conductivities a factor of a million apart. Two rods of 50 mm
// between 100 and 0 degC, k2 = k1/1e6: q = 100 K/(L/k1 + 1/h + L/k2), 0.474 W/m^2. The poor
// conductor has a heat capacity as small, so that it settles as fast: exp(-2.4 alpha t/L^2) is
// 1e-12 after 300 s. On the way no temperature may leave what the ends are held at (maximum
// principle), and a poor conductor that is not light, of which only a skin heats up, is watched for
// 20 s as well. Held particles have their temperature half a spacing inside, and the rods are as
// much shorter. A rod of few particles across conducts all but 1 % of what its material does
// (SphConduction.RodsConductWhatTheirMaterialDoes has the lattice sums; docs/theory/heat.md (H8)).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kRods = R"(
title: rods with conductivities a million apart
geometry: 3d
time: {end: END}
ambient: 0 degC
materials:
  good: {density: 2700, elastic: {E: 70 GPa, nu: 0.33}, thermal: {cp: 900, k: 237}}
  poor: {density: 2700, elastic: {E: 70 GPa, nu: 0.33}, thermal: {cp: CAPACITY, k: 2.37e-4}}
bodies:
  left: {material: good, METHOD, temperature: 0 degC,
         shape: {box: {min: [-50 mm, 0, 0], max: [0, 5 mm, 5 mm]}}}
  right: {material: poor, METHOD, temperature: 0 degC,
          shape: {box: {min: [0, 0, 0], max: [50 mm, 5 mm, 5 mm]}}}
boundaries:
  left_still: {body: left, where: all, fix: [x, y, z]}
  right_still: {body: right, where: all, fix: [x, y, z]}
  hot: {body: HOT, where: {side: HOT_SIDE}, temperature: 100 degC}
  cold: {body: COLD, where: {side: COLD_SIDE}, temperature: 0 degC}
contact: {default: {heat: CONTACT}}
)";

struct Rods {
  std::string method, contact, capacity, end;
  bool poor_is_hot;
  Real resistance;  // [m^2 K/W] of the contact
  Real tolerance;   // of the flux; 0: it is not steady at the end
};
const char* const kElements = "method: fe, size: 2.5 mm";
const char* const kParticles = "method: sph, size: 1.25 mm";
const char* const kResistive = "{conductance: 1e4 W/m^2/K}";

std::string deck(const Rods& rods) {
  std::string text = kRods;
  const auto put = [&](const std::string& word, const std::string& by) {
    for (std::size_t at; (at = text.find(word)) != std::string::npos;) {
      text.replace(at, word.size(), by);
    }
  };
  put("HOT_SIDE", rods.poor_is_hot ? "max-x" : "min-x");
  put("COLD_SIDE", rods.poor_is_hot ? "min-x" : "max-x");
  put("HOT", rods.poor_is_hot ? "right" : "left");
  put("COLD", rods.poor_is_hot ? "left" : "right");
  put("METHOD", rods.method), put("CONTACT", rods.contact);
  put("CAPACITY", rods.capacity), put("END", rods.end);
  return text;
}

/// Lowest and highest temperature [K] of all steps: between what the ends are held at.
struct Temperatures {
  Real lowest = kInfinity, highest = -kInfinity;
  SceneHooks hooks() {
    SceneHooks hooks;
    hooks.step_done = [this](Scene<3>& scene, const Clock&) {
      for (const auto& solid : scene.solids) {
        for (const Real T : solid->points().temperature) {
          lowest = std::min(lowest, T), highest = std::max(highest, T);
        }
      }
    };
    return hooks;
  }
  void expect_between_the_ends() const {
    constexpr Real kZero = 273.15, kRounding = 1e-10;  // [K]
    EXPECT_GE(lowest, kZero - kRounding);
    EXPECT_LE(highest, kZero + 100 + kRounding);
    EXPECT_GT(highest, lowest + 99);
  }
};

void PrintTo(const Rods& rods, std::ostream* out) {
  *out << rods.method << ' ' << rods.contact << " capacity " << rods.capacity;
}
class HeatExtremes : public testing::TestWithParam<Rods> {};

TEST_P(HeatExtremes, ConductivitiesAMillionApart) {
  const Rods& rods = GetParam();
  Temperatures temperatures;
  const auto run = simulate_text(deck(rods), {}, {}, temperatures.hooks());
  ASSERT_EQ(run.failure, "");
  temperatures.expect_between_the_ends();
  if (rods.tolerance == 0) return;
  const Real length = rods.method == kElements ? 50e-3 : 50e-3 - 0.5 * 1.25e-3;
  const Real flux = 100 / (length / 237 + rods.resistance + length / 2.37e-4);
  const Real area = 25e-6, rate = run.last("contact.left-right.heat_rate");
  EXPECT_NEAR(std::fabs(rate), flux * area, rods.tolerance * flux * area);
  EXPECT_EQ(rate > 0, rods.poor_is_hot);  // into the first
}

// The page's own 1 % of the material with 20 particles across. The poor rod is the hot one and
// settles as exp(-pi^2 alpha t/L^2), 1e-5 after 30 s. Held particles have their temperature half a
// spacing inside: rods of 49.5 mm.
const Rods kTwentyAcross{"method: sph, size: 1 mm", kResistive, "900e-6", "30 s", true, 1e-4, 0.01};

void expect_flux_of_material(const Simulation& run, Real area) {
  ASSERT_EQ(run.failure, "");
  const Real rate = run.last("contact.left-right.heat_rate") / area;
  const auto flux = [&](Real length) { return 100 / (length / 237 + 1e-4 + length / 2.37e-4); };
  EXPECT_NEAR(rate, flux(49.5e-3), 0.01 * flux(49.5e-3));
  std::printf("20 particles across: %.4f of the material\n", rate / flux(49.5e-3));
  EXPECT_LT(std::fabs(run.last("heat.drift")), 1e-12);
}

TEST(HeatExtremesOfWideStrips, FluxOfParticlesWithinAPercentOfTheMaterial) {
  const auto run = simulate_text(deck(kTwentyAcross),
                                 {"geometry=plane-strain", "boundaries.left_still.fix=[x, y]",
                                  "bodies.left.shape={box: {min: [-50 mm, 0], max: [0, 20 mm]}}",
                                  "bodies.right.shape={box: {min: [0, 0], max: [50 mm, 20 mm]}}",
                                  "boundaries.right_still.fix=[x, y]"});
  expect_flux_of_material(run, 20e-3);  // of a depth of 1 m
}

// The same in space: 40,000 particles.
TEST(HeatExtremesOfWideRodsLong, FluxOfParticlesWithinAPercentOfTheMaterial) {
  Temperatures temperatures;
  const auto run =
      simulate_text(deck(kTwentyAcross),
                    {"bodies.left.shape={box: {min: [-50 mm, 0, 0], max: [0, 20 mm, 20 mm]}}",
                     "bodies.right.shape={box: {min: [0, 0, 0], max: [50 mm, 20 mm, 20 mm]}}"},
                    {}, temperatures.hooks());
  temperatures.expect_between_the_ends();
  expect_flux_of_material(run, 400e-6);
}

INSTANTIATE_TEST_SUITE_P(
    , HeatExtremes,
    testing::Values(Rods{kElements, kResistive, "900e-6", "300 s", false, 1e-4, 0.01},
                    Rods{kElements, "perfect", "900e-6", "300 s", true, 0, 0.01},
                    Rods{kElements, "perfect", "900", "20 s", false, 0, 0},
                    Rods{kParticles, kResistive, "900e-6", "120 s", true, 1e-4, 0.01},
                    Rods{kParticles, "perfect", "900", "20 s", true, 0, 0}));

}  // namespace
}  // namespace brunt::test
