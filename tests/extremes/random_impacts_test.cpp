// Needles, knives, chisels, wedges and boxes, thrown at each other at 2 to 20 m/s without friction
// (tests/support/random_impacts.hpp). What keeps two convex bodies apart keeps some plane between
// them, but for a penetration: bodies shrunk by 15 % about their middles never have a point in
// common, or the run has reported contacts that did not hold. Springs hold what they were given:
// contact.pairs, what forces did besides, stays below 1 % of the largest energy.
//
// Of the first 500 seeds 130 are of rigid bodies alone. Three of them miss the 1 % as measured:
// 318, 455 and 499 (10, 1.1 and 1.1 %), of which 499 reports lost contacts: knives, wedges and
// boxes thrown on needles of 0.9 to 2 degrees, whose sides slide over a border
// (docs/decisions/201). Elements and particles bend, and the hulls of slender ones meet where the
// bodies do not (seeds 99 and 116): there an element or a particle must be in the other body.
#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <sstream>

#include "core/errors.hpp"
#include "tests/support/random_impacts.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

struct Count {
  int pairs = 0, silent = 0, off = 0;
};

/// Throws the pairs of seeds first .. last - 1 that are wanted; prints each that is not as it
/// should.
template <class Wanted>
Count throw_pairs(std::uint64_t first, std::uint64_t last, const Wanted& wanted) {
  Count count;
  for (auto seed = first; seed < last; ++seed) {
    const Impact impact = random_impact(seed);
    if (!wanted(impact)) continue;
    const Outcome outcome = outcome_of(impact);
    const bool reported = outcome.lost > 0 || !outcome.failure.empty() || outcome.created > 0.05;
    const bool silent = outcome.crossed && !reported, off = outcome.pairs > 0.01;
    ++count.pairs;
    count.silent += silent ? 1 : 0;
    count.off += off ? 1 : 0;
    if (!silent && !off) continue;
    std::cout << "seed " << seed << ": " << impact.what << ": contact.pairs " << outcome.pairs
              << ", created " << outcome.created << (outcome.crossed ? ", crossed" : "")
              << (reported ? ", reported" : "") << '\n';
  }
  return count;
}

TEST(RandomImpacts, OfRigidBodiesPassNoneInSilence) {
  const Count count =
      throw_pairs(1, 501, [](const Impact& impact) { return impact.n_deforming == 0; });
  EXPECT_EQ(count.pairs, 130);
  EXPECT_EQ(count.silent, 0);
  EXPECT_LE(count.off, 3);
}

TEST(RandomImpacts, LongOfElementsAndParticlesPassNoneInSilence) {
  const Count count =
      throw_pairs(1, 61, [](const Impact& impact) { return impact.n_deforming > 0; });
  EXPECT_GT(count.pairs, 40);
  EXPECT_EQ(count.silent, 0);
  EXPECT_LE(count.off, 3);
}

// The coarse tip of a chisel on a rigid one: its sides turn to and fro across the angle at which
// they begin to push. With a force that jumped there they made 21 % of the energy (seed 155).
TEST(RandomImpacts, SidesThatTurnToAndFroMakeNoEnergy) {
  const Outcome outcome = outcome_of(random_impact(155));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.pairs, 0.001);
}

// A side of an element half an element deep in a chisel, nearly perpendicular to it, turned through
// the whole range in which its pressure fades within a step, 78 times, and made 5.6 % of the energy
// (seed 4): the step is bounded by what the pair would hold, docs/theory/contact.md (C55).
TEST(RandomImpacts, SidesThatTurnWithinAStepMakeLittleEnergy) {
  const Outcome outcome = outcome_of(random_impact(4));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.pairs, 0.005);
  EXPECT_LT(outcome.created, 0.005);
}

// Particles beside the edge of a wedge, thin for them: behind its far side, and outside. Taken for
// inside at time 0 they were thrown with a million times the energy (seed 222).
TEST(RandomImpacts, ParticlesBesideAThinWedgeAreOutside) {
  const Outcome outcome = outcome_of(random_impact(222));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.created, 0.001);
}

// A corner of a box of elements on a rigid edge: faces warp and are two triangles, along diagonals
// that must not change with every rounding. They made 252 % of the energy (seed 153); what is left
// is where a quad becomes two triangles.
TEST(RandomImpacts, FacesThatWarpKeepTheirDiagonal) {
  const Outcome outcome = outcome_of(random_impact(153));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.created, 0.05);
}

// A knife and a needle whose edges point the same way, 40 mm apart: they pushed each other with
// 1600 J, and the run ended (seed 318). It loses 4 % yet, which is not made: docs/decisions/209.
TEST(RandomImpacts, BladesThatPointTheSameWayDoNotPush) {
  const Outcome outcome = outcome_of(random_impact(318));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.created, 0.005);
}

// The flank of a needle and the end of another, at right angles and deeper inside than either
// is wide, turned into the range where their pressure fades in, a fifth of a degree, and back: in
// one step of many they made 1.4 % (seed 477). 30 s.
TEST(RandomImpacts, LongFlanksThatTurnInsideANeedleDoNotPush) {
  const Outcome outcome = outcome_of(random_impact(477));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.created, 0.001);
}

// What was lost or made before contact's energy was continuous (docs/decisions/209): overlaps over
// borders that were let go (11: 1.6 %), a needle that dug in deeper than it is wide (265: 25 %),
// faces that turned within a step (44: 1.4 %), and blades 60 mm behind each other that gave needles
// spins of 1e10 rad/s (351, 354: stopped).
TEST(RandomImpacts, WhatTwoFacesHoldIsContinuous) {
  for (const std::uint64_t seed : {11, 44, 265, 351, 354}) {
    const Outcome outcome = outcome_of(random_impact(seed));
    EXPECT_EQ(outcome.failure, "") << seed;
    EXPECT_LT(outcome.pairs, 0.003) << seed;
    EXPECT_LT(outcome.created, 0.003) << seed;
  }
}

// Needles of 0.7 and 1.6 degrees that lie in each other at time 0. Two of their faces lean into
// each other: their deepest corner is beyond the limit, their centre of pressure is not. So they
// pushed at once, and made 32 % of the energy in the first step (seed 142).
TEST(RandomImpacts, FacesThatLeanIntoEachOtherAtTimeZeroDoNotPush) {
  const Outcome outcome = outcome_of(random_impact(142));
  EXPECT_EQ(outcome.failure, "");
  EXPECT_LT(outcome.created, 1e-4);
}

/// The bodies of an impact, nearer to each other by a part of their distance and without velocity,
/// for a 300th of its time.
std::string still_and_nearer(std::string text, Real part) {
  const auto list_at = [&](std::size_t at) {
    std::istringstream stream(text.substr(at));
    std::vector<Real> values(1);
    for (char comma = 0; stream >> values.back() >> comma && comma == ',';) values.push_back(0);
    return values;
  };
  const std::string moves = "translate: [", velocity = "velocity: [", end = "end: ";
  const auto first = text.find(moves) + moves.size();
  auto place = list_at(first);
  const auto other = list_at(text.find(moves, first) + moves.size());
  std::string list;
  for (std::size_t i = 0; i < place.size(); ++i) {
    list += (i > 0 ? ", " : "") + std::to_string(place[i] + part * (other[i] - place[i]));
  }
  text.replace(first, text.find(']', first) - first, list);
  for (auto at = text.find(velocity); at != text.npos; at = text.find(velocity, at + 1)) {
    const auto from = at + velocity.size();
    text.replace(from, text.find(']', from) - from, place.size() == 3 ? "0, 0, 0" : "0, 0");
  }
  const auto from = text.find(end) + end.size();
  const auto seconds = std::to_string(1e6 * std::stod(text.substr(from)) / 300);
  return text.replace(from, text.find(',', from) - from, seconds + " us");
}

// Bodies that overlap at time 0, by next to nothing or by most of their size, of elements, of
// particles or rigid, with sharp edges in each other: nothing moves, to the last bit.
TEST(RandomImpacts, WhatOverlapsAtRestStaysAtRest) {
  int ran = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const std::string text = random_impact(seed).text;
    for (const Real part : {0.3, 0.6, 0.9}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", nearer by " + std::to_string(part));
      Simulation run;
      try {
        run = simulate_text(still_and_nearer(text, part));
      } catch (const DeckError&) {
        continue;  // refused: a body that is inside another
      }
      ++ran;
      EXPECT_EQ(run.failure, "");
      EXPECT_EQ(run.last("energy.kinetic"), 0);
      EXPECT_EQ(run.last("energy.contact.spring"), 0);
    }
  }
  EXPECT_GT(ran, 60);
}

// A corner of one box in another, deeper than faces are held, as a sliver of the face beside it:
// what that pair remembers, that it pushes, goes over a restart.
TEST(RandomImpacts, AreTheSameOverARestartInTheMiddle) {
  const Impact impact = random_impact(226);
  const Simulation whole = simulate_text(impact.text);
  const auto planes = whole.column("contact.a-b.planes");
  const auto depth = whole.column("contact.a-b.max_penetration");
  const auto deepest = std::max_element(depth.begin(), depth.end()) - depth.begin();
  ASSERT_GT(planes[static_cast<std::size_t>(deepest)], 0);
  const auto middle =
      static_cast<std::int64_t>(whole.column("step")[static_cast<std::size_t>(deepest)]);
  for (const std::int64_t at : {middle - 4, middle, middle + 4}) {
    const Simulation split = simulate_text(impact.text, {}, {.split_at = at});
    EXPECT_EQ(split.hashes, whole.hashes) << at;
  }
}

}  // namespace
}  // namespace brunt::test
