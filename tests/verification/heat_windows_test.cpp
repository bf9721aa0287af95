// Windows of conduction (`time.heat_every`) change what conducts, and nothing else: mechanical
// heat, contacts and boundaries reach nodes, and elements follow these, in each step. Those that
// are chosen follow heat's longest step, and what begins or ends.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

std::string every(int n) { return "time.heat_every=" + std::to_string(n); }

std::string copper() {
  return "geometry: 3d\nambient: 300 K\nmaterials: {copper: {density: 8960, elastic: {E: 124 GPa, "
         "nu: 0.34}, strength: {johnson-cook: {A: 90 MPa, B: 292 MPa, n: 0.31, C: 0.025, rate_ref: "
         "1, m: 1.09, T_melt: 1356, T_ref: 298}}, eos: {mie-gruneisen: {c0: 3940, s: 1.49, gamma0: "
         "1.96}}, thermal: {cp: 383, k: 386, taylor_quinney: 0.9}}}\n";
}

// A bar is torn apart, and its elements go one after another: stored = plastic + compression +
// boundary to rounding in each row.
class TornBar : public ::testing::TestWithParam<const char*> {};

TEST_P(TornBar, LosesNoHeat) {
  const std::string deck =
      copper() +
      "heat: conduct\ntime: {end: 20 us}\noutput: {history: 100 ns}\nbodies: {bar: {material: "
      "copper, size: 1 mm, shape: {box: {min: [0, 0, 0], max: [6 mm, 2 mm, 2 mm]}}, erode: " +
      std::string(GetParam()) +
      "}}\nboundaries:\n  left: {body: bar, where: {side: min-x}, velocity: [-100 m/s, free, "
      "free]}\n  right: {body: bar, where: {side: max-x}, velocity: [100 m/s, free, free]}\n";
  for (const std::vector<std::string>& windows :
       {std::vector<std::string>{}, {every(1)}, {every(64)}}) {
    const auto torn = simulate_text(deck, windows);
    ASSERT_EQ(torn.failure, "");
    ASSERT_GT(torn.last("body.bar.eroded"), 0);
    ASSERT_GT(torn.last("heat.stored"), 0);
    for (const Real drift : torn.column("heat.drift")) EXPECT_LT(std::fabs(drift), 1e-12);
    const auto steps = torn.steps;
    for (const RunVariation& variation :
         {RunVariation{2, false, 0}, RunVariation{0, true, 0},
          RunVariation{0, false, steps / 2 + 1}, RunVariation{0, false, steps - 5}}) {
      EXPECT_EQ(simulate_text(deck, windows, variation).hashes, torn.hashes);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(All, TornBar,
                         ::testing::Values("{when: [strain: 0.4], to: nothing}",
                                           "{when: [strain: 0.4]}",
                                           "{when: [strain: 0.4], to: sph}"));

/// A copper bar of 2 x 0.4 x 0.4 mm of 0.1 mm, with what is at its hot end.
std::string heated(const std::string& end) {
  return copper() +
         "heat: conduct\ntime: {end: 17 us}\nbodies: {bar: {material: copper, size: 0.1 mm, shape: "
         "{box: {min: [0, 0, 0], max: [2 mm, 0.4 mm, 0.4 mm]}}}}\nboundaries: {end: {body: bar, "
         "where: {side: min-x}, " +
         end + "}}\n";
}

/// Aluminium that expands, in plane strain.
std::string aluminium() {
  return "geometry: plane-strain\nheat: conduct\nambient: 300 K\nmaterials: {alu: {density: 2700, "
         "elastic: {E: 70 GPa, nu: 0.33}, strength: {j2: {yield: 200 MPa, hardening: 300 MPa}}, "
         "thermal: {cp: 900, k: 200, taylor_quinney: 0.9, expansion: 2.3e-5}}}\n";
}

// What boundaries, contacts and conduction do to nodes reaches their elements in each step: a bar
// that is heated smoothly expands smoothly. Where elements followed only with the evaluations,
// stress came in stairs that made waves: 77,000 times the viscous work, and windows longer than the
// run left the bar as long as it was.
TEST(WindowsOfHeat, ElementsFollowTheirNodesInEachStep) {
  const std::string heated =
      aluminium() +
      "time: {end: 100 us}\noutput: {history: 5 us}\nbodies: {bar: {material: alu, size: 1 mm, "
      "shape: {box: {min: [0, 0], max: [20 mm, 2 mm]}}}}\nboundaries: {end: {body: bar, where: "
      "{side: min-x}, flux: 1e9}}\n";
  const auto once = simulate_text(heated, {every(1)});
  for (const auto& windows : {std::vector<std::string>{}, {every(16)}, {every(4000)}}) {
    const auto held = simulate_text(heated, windows);
    ASSERT_EQ(held.failure, "");
    // 4,000 steps are longer than the run: conduction is what it was at the first, nothing.
    const Real part = windows == std::vector<std::string>{every(4000)} ? 0.05 : 1e-3;
    for (const char* column : {"energy.expansion", "energy.viscosity", "energy.hourglass"}) {
      EXPECT_NEAR(held.last(column) / once.last(column), 1, part) << column;
    }
  }
}

// Two blocks that expand come into perfect contact after 300 steps, with friction: what they
// exchange and how they bounce is as with an evaluation in each step. It was 6 % of the motion off
// where elements followed their nodes late.
TEST(WindowsOfHeat, AContactThatComesLateIsFeltAtOnce) {
  const std::string thrown =
      aluminium() +
      "time: {end: 150 us}\nbodies:\n  a: {material: alu, temperature: 600 K, velocity: [0, -100], "
      "size: 1 mm, shape: {box: {min: [0, 5.03 mm], max: [4 mm, 13.03 mm]}}}\n  b: {material: alu, "
      "size: 1 mm, shape: {box: {min: [-2 mm, -4 mm], max: [6 mm, 0]}}}\nboundaries: {foot: {body: "
      "b, where: {side: min-y}, fix: [x, y]}}\ncontact: {default: {friction: 0.3, heat: "
      "perfect}}\n";
  const auto once = simulate_text(thrown, {every(1)}), chosen = simulate_text(thrown, {});
  ASSERT_EQ(chosen.failure, "");
  for (const char* column : {"body.b.heat", "heat.plastic", "energy.kinetic", "heat.friction"}) {
    EXPECT_NEAR(chosen.last(column) / once.last(column), 1, 3e-3) << column;
  }
}

// What passes a contact, and what a held temperature takes, is as smooth as with an evaluation in
// each step: a step that gives the mechanical heat of sixteen would show in both.
TEST(WindowsOfHeat, RatesOfHeatHaveNoSpikes) {
  const std::string pressed =
      aluminium() +
      "time: {end: 40 us}\noutput: {history: 0.5 us}\nbodies:\n  a: {material: alu, velocity: [0, "
      "-10], size: 0.5 mm, shape: {box: {min: [0, 0], max: [4 mm, 3 mm]}}}\n  b: {material: alu, "
      "temperature: 320 K, size: 0.5 mm, shape: {box: {min: [-1 mm, -2 mm], max: [5 mm, 0]}}}\n"
      "boundaries:\n  foot: {body: b, where: {side: min-y}, fix: [x, y]}\n  head: {body: a, where: "
      "{side: max-y}, velocity: [free, -10]}\n  cool: {body: a, where: {side: min-x}, temperature: "
      "300}\ncontact: {default: {heat: perfect}}\n";
  const auto once = simulate_text(pressed, {every(1)}), chosen = simulate_text(pressed, {});
  ASSERT_EQ(chosen.failure, "");
  ASSERT_GT(chosen.last("heat.plastic"), 0);
  for (const char* column : {"contact.a-b.heat_rate", "boundary.cool.heat_rate"}) {
    const auto expected = once.column(column), rate = chosen.column(column);
    ASSERT_EQ(rate.size(), expected.size());
    Real largest = 0;
    for (const Real one : expected) largest = std::max(largest, std::fabs(one));
    ASSERT_GT(largest, 0);
    for (std::size_t k = 0; k < rate.size(); ++k) {
      EXPECT_NEAR(rate[k], expected[k], 1e-2 * largest) << column << " row " << k;
    }
  }
}

// A temperature that is switched on late is conducted in time, as one of the start: 0.158/64 of the
// jump where windows err most, a tenth of that in heat. Without short windows it was 3e-3.
TEST(WindowsOfHeat, ABoundaryThatBeginsLateIsConductedInTime) {
  for (const char* from :
       {"temperature: 600 K, from: 14 us", "temperature: 600 K, from: 7 us, to: 8 us"}) {
    const auto once = simulate_text(heated(from), {every(1)});
    const auto chosen = simulate_text(heated(from), {});
    ASSERT_EQ(chosen.failure, "");
    EXPECT_NEAR(chosen.last("body.bar.heat") / once.last("body.bar.heat"), 1, 5e-4) << from;
  }
}

// A convection that jumps shortens heat's step, and ends the window with it: no step is lost.
TEST(WindowsOfHeat, AConvectionThatJumpsEndsTheWindow) {
  const std::string wild = "convection: {h: \"= t < 14e-6 ? 1e4 : 2e9\", T: 600 K}";
  const auto once = simulate_text(heated(wild), {every(1)});
  const auto chosen = simulate_text(heated(wild), {});
  ASSERT_EQ(chosen.failure, "");
  EXPECT_LE(chosen.steps, once.steps + 2);
  EXPECT_NEAR(chosen.last("body.bar.heat") / once.last("body.bar.heat"), 1, 2e-3);
}

}  // namespace
}  // namespace brunt::test
