// Fronts of points written down by hand.
#include "app/trade/front.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

CostError point_at(Real cost, Real error) { return {repeated({cost}), error}; }

TEST(Front, RepeatsHaveAMedianAndASpread) {
  const Repeated odd = repeated({3, 1, 2});
  EXPECT_EQ(odd.median, 2);
  EXPECT_EQ(odd.low, 1);
  EXPECT_EQ(odd.high, 3);
  EXPECT_EQ(odd.count, 3);
  EXPECT_EQ(repeated({4, 1}).median, 2.5);
}

TEST(Front, KeepsWhatNothingBeats) {
  // Cheaper is worse from 0 to 2; 3 costs more than 1 and is no better; 4 is 2 at twice the cost.
  const auto found = dominated(
      {point_at(1, 0.3), point_at(2, 0.2), point_at(4, 0.1), point_at(3, 0.2), point_at(8, 0.1)});
  EXPECT_FALSE(found[0].by || found[1].by || found[2].by);
  ASSERT_TRUE(found[3].by && found[4].by);
  EXPECT_EQ(*found[3].by, 1u);
  EXPECT_EQ(*found[4].by, 2u);
  EXPECT_TRUE(found[3].clear && found[4].clear);
}

TEST(Front, AHundredthOfAnErrorIsNotWorthItsCost) {
  const auto found = dominated({point_at(1, 0.3), point_at(2, 0.298), point_at(3, 0.29)});
  EXPECT_FALSE(found[0].by);
  EXPECT_EQ(found[1].by, 0);
  EXPECT_FALSE(found[2].by);
  EXPECT_EQ(dominated({point_at(1, 1e-14), point_at(2, 0)})[1].by, 0);
}

TEST(Front, TwinsDoNotDominateEachOther) {
  const auto found = dominated({point_at(1, 0.3), point_at(1, 0.3)});
  EXPECT_FALSE(found[0].by || found[1].by);
}

TEST(Front, NamesTheLeastWrongOfThoseThatDominate) {
  const auto found = dominated({point_at(1, 0.3), point_at(2, 0.1), point_at(3, 0.5)});
  ASSERT_TRUE(found[2].by);
  EXPECT_EQ(*found[2].by, 1u);
}

TEST(Front, ANoisyMachineDoesNotDecide) {
  // Medians 2 and 2.1, whose spreads overlap: dominated, but not clearly.
  const CostError better{repeated({1.9, 2, 2.5}), 0.1}, worse{repeated({1.8, 2.1, 2.2}), 0.2};
  const auto close = dominated({better, worse});
  ASSERT_TRUE(close[1].by);
  EXPECT_FALSE(close[1].clear);
  const CostError dear{repeated({2.6, 2.7, 3}), 0.2};
  const auto apart = dominated({better, dear});
  ASSERT_TRUE(apart[1].by);
  EXPECT_TRUE(apart[1].clear);
}

}  // namespace
}  // namespace brunt
