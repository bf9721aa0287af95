// Runs that go wrong by themselves and used to end with status 0 or in "nan" (tests/cases): energy
// that nobody put in stops them, a step that collapses slowly is reported and stops them, and no
// row holds what is no finite number.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/simulate.hpp"
#include "tests/support/source_path.hpp"

namespace brunt::test {
namespace {

Simulation simulate_case(const std::string& name, const std::vector<std::string>& overrides = {},
                         const RunVariation& variation = {.threads = 1}) {
  return simulate(load_deck(source_path("tests/cases/" + name + ".yaml"), overrides), variation);
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool was_told(const Simulation& run, const std::string& id) {
  return std::any_of(run.reported.begin(), run.reported.end(),
                     [&](const RunWarning& one) { return one.id == id; });
}

void expect_numbers(const Simulation& run) {
  for (const auto& row : run.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      ASSERT_TRUE(std::isfinite(row[c])) << run.columns[c];
    }
  }
}

// A free spin keeps m L^2/12 w^2 = 7.85e-3 kg x (10 mm)^2/6 x 1e6/2 s^-2 = 0.0654 J (0.0648 of the
// particles), and nobody gives it more. Artificial stress does, from a spin's own tension, until
// 4.8 J: the run stops once it gave 5 % of the largest energy, well before that.
TEST(WatchCases, ArtificialStressThatDrivesASpinStopsTheRun) {
  const auto run = simulate_case("spin-artificial-stress",
                                 {"bodies.b.artificial_stress=0.3", "bodies.b.smoothing=1.2"});
  EXPECT_TRUE(holds(run.failure, "energy that nobody put in")) << run.failure;
  EXPECT_TRUE(holds(run.failure, "artificial_stress gave")) << run.failure;
  EXPECT_TRUE(holds(run.failure, "to b; set `artificial_stress: 0`")) << run.failure;
  EXPECT_TRUE(was_told(run, "energy"));
  // Looked at every 100 steps, it is reported below twice the 5 % (it doubles in some 300).
  EXPECT_GT(run.created, 0.05);
  EXPECT_LT(run.created, 0.10);
}

// The remedy helps: the spin is kept within 1 %, as a free spin must be.
TEST(WatchCases, WithoutArtificialStressTheSpinIsKept) {
  const auto run = simulate_case("spin-artificial-stress", {"parameters.end=250 us"});
  EXPECT_EQ(run.failure, "");
  EXPECT_FALSE(was_told(run, "energy"));
  EXPECT_NEAR(run.last("energy.kinetic"), run.first("energy.kinetic"),
              0.01 * run.first("energy.kinetic"));
}

// Nor does it strain where gradients are not corrected: a rigid turn v = W x has the plain sum W K,
// from which the gradient is R + W - W K = W (docs/theory/sph.md, S8a). Taken for a gradient, W K
// strained faces by half of what they turned: 40 % of the energy, 98 % at its worst. What is left
// is the stretch by its own centrifugal force, rho w^2 L^2/E = 4e-6, felt too softly at faces.
TEST(WatchCases, WithoutCorrectionTheSpinIsKeptToo) {
  const std::vector<std::string> in_space{"bodies.b.correction=false", "bodies.b.size=2 mm",
                                          "parameters.end=300 us"};
  auto in_plane = in_space;
  in_plane.insert(in_plane.end(), {"geometry=plane-strain", "bodies.b.spin={rate: $w}",
                                   "bodies.b.shape={box: {min: [-5 mm, -5 mm], max: [5 mm, 5 mm]}}",
                                   "bodies.b.smoothing=1.2"});
  for (const auto& overrides : {in_space, in_plane}) {
    const auto run = simulate_case("spin-artificial-stress", overrides);
    EXPECT_EQ(run.failure, "");
    EXPECT_LT(run.created, 1e-6);
    for (const Real kinetic : run.column("energy.kinetic")) {
      ASSERT_NEAR(kinetic, run.first("energy.kinetic"), 1e-3 * run.first("energy.kinetic"));
    }
  }
}

// Where rows are written, on how many threads it runs and whether it went on from a checkpoint does
// not move the step at which it stops, nor what it says.
TEST(WatchCases, TheStopIsAFunctionOfTheDeckAlone) {
  const std::vector<std::string> strict = {"time.max_created=1 %"};
  const auto one = simulate_case("tube-nan-volume", strict);
  ASSERT_TRUE(holds(one.failure, "nobody put in")) << one.failure;
  auto rarely = strict;
  rarely.push_back("output.history=1 us");
  EXPECT_EQ(simulate_case("tube-nan-volume", rarely, {.threads = 2}).failure, one.failure);
  const auto split = simulate_case("tube-nan-volume", strict, {.threads = 1, .split_at = 3});
  EXPECT_EQ(split.failure, one.failure);
  EXPECT_EQ(split.created, one.created);
}

// Simple shear by gamma flattens a square to a height of 1/sqrt(1 + gamma^2) of its edge; the plan
// is end over the first step, 3,460. In 150,000 steps the run is over: what guards shapes keeps the
// elements at the corners from being crushed to nothing.
TEST(WatchCases, AShearedBlockComesToItsEnd) {
  const auto run = simulate_case("shear-collapse");
  EXPECT_EQ(run.failure, "");
  EXPECT_LT(run.steps, 150000);
  EXPECT_LT(run.created, 0.01);
  expect_numbers(run);
}

// Steps of a tenth are reported, and those below what the deck calls the least, a thirtieth, stop
// it.
TEST(WatchCases, AStepThatCollapsesSlowlyIsToldAndStops) {
  const auto run = simulate_case("shear-collapse", {"parameters.gamma=20", "time.min_step=19 ns"});
  EXPECT_LT(run.steps, 150000);
  EXPECT_TRUE(was_told(run, "step"));
  EXPECT_TRUE(holds(run.failure, "body b, element ")) << run.failure;
  EXPECT_TRUE(holds(run.failure, "time.min_step")) << run.failure;
  EXPECT_TRUE(holds(run.failure, "method: sph")) << run.failure;
  EXPECT_FALSE(holds(run.failure, "q1p0")) << run.failure;  // it is on
  expect_numbers(run);
}

TEST(WatchCases, NoRowHoldsWhatIsNoNumber) {
  for (const char* name : {"nan-in-history", "tube-nan-volume"}) {
    const auto run = simulate_case(name, {"output.history=10 ns"});
    EXPECT_FALSE(run.rows.empty());
    EXPECT_FALSE(holds(run.failure, "nan")) << run.failure;
    EXPECT_FALSE(holds(run.failure, "= inf")) << run.failure;
    expect_numbers(run);
  }
}

// Contacts of one layer of elements, each as thick as the particles, make more energy than there
// is. The stop names where; the finer elements that it asks for run to the end.
TEST(WatchCases, ATubeThatContactsDriveIsStoppedAndItsRemedyHelps) {
  const auto run = simulate_case("tube-nan-volume");
  if (!run.failure.empty()) {
    EXPECT_TRUE(holds(run.failure, "contact.pairs gave")) << run.failure;
    EXPECT_TRUE(holds(run.failure, "b1, element ")) << run.failure;
    EXPECT_TRUE(holds(run.failure, "finer elements")) << run.failure;
  }
  const auto finer = simulate_case("tube-nan-volume", {"bodies.b1.size=3.7 mm"});
  EXPECT_EQ(finer.failure, "");
  EXPECT_LT(finer.created, 0.05);
}

}  // namespace
}  // namespace brunt::test
