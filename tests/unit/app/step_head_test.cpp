// What ranks agree on before a step must not depend on the order in which they are heard, and one
// that is asked for something is enough. Runs on several ranks are in tests/parallel.
#include "app/loop/step_head.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace brunt {
namespace {

const StepHead kSlow{{2.0, "element", 3, 7}, {}};
const StepHead kFast{{1.0, "particle", 1, 9}, {}};
const StepHead kTied{{1.0, "contact speed", 2, 4}, {}};
const StepHead kBroken{{std::nan(""), "element", 5, 5}, {}};

StepHead joined(StepHead a, const StepHead& b) {
  const GlobalId before = a.step_limit.entity;
  const bool taken = a.take(b);
  EXPECT_EQ(taken, a.step_limit.entity != before);
  return a;
}

TEST(StepHead, TheSmallestLimitWinsWhoeverIsHeardFirst) {
  for (const auto& [a, b, winner] : {std::array{kSlow, kFast, kFast},
                                     {kFast, kTied, kTied},  // the smaller id
                                     {kBroken, kFast, kBroken},
                                     {kSlow, kBroken, kBroken}}) {
    for (const StepHead& head : {joined(a, b), joined(b, a)}) {
      EXPECT_EQ(head.step_limit.entity, winner.step_limit.entity);
      EXPECT_STREQ(head.step_limit.reason, winner.step_limit.reason);
      EXPECT_EQ(head.step_limit.body, winner.step_limit.body);
    }
  }
}

TEST(StepHead, OneThatIsAskedIsEnough) {
  StepHead asked = kSlow;
  asked.requests = {true, false};
  StepHead stopped = kBroken;
  stopped.requests = {false, true};
  for (const StepHead& head : {joined(asked, kFast), joined(kFast, asked)}) {
    EXPECT_TRUE(head.requests.checkpoint);
    EXPECT_FALSE(head.requests.stop);
  }
  const StepHead both = joined(asked, stopped);
  EXPECT_TRUE(both.requests.checkpoint && both.requests.stop);
}

TEST(StepHead, OfALoneRankIsItsOwn) {
  const StepHead head = over_ranks(kSlow, lone_rank());
  EXPECT_EQ(head.step_limit.step, 2.0);
  EXPECT_STREQ(head.step_limit.reason, "element");
}

}  // namespace
}  // namespace brunt
