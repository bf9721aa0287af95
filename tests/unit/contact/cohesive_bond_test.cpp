// A bond of cohesion C and tension T (docs/theory/contact.md (C37)): it begins between faces that
// touch, slips at mu N + C A, a pull N < 0 counting against it, and tears beyond T.
#include "contact/law/cohesive_bond.hpp"

#include <gtest/gtest.h>

#include "contact/law/pair_laws.hpp"

namespace brunt {
namespace {

constexpr CohesiveBond kBond{3e3, 2e3};  // [Pa], [Pa]

TEST(CohesiveBond, ActsByCohesionOrTension) {
  EXPECT_FALSE((CohesiveBond{0, 0}.acts()));
  EXPECT_TRUE((CohesiveBond{1, 0}.acts()));
  EXPECT_TRUE((CohesiveBond{0, 1}.acts()));
}

TEST(CohesiveBond, BeginsWhereFacesTouchAndTearsBeyondItsTension) {
  EXPECT_TRUE(kBond.begins(-1e-3, 1e-6));
  EXPECT_TRUE(kBond.begins(1e-6, 1e-6));
  EXPECT_FALSE(kBond.begins(2e-6, 1e-6));
  EXPECT_FALSE(kBond.tears(1.99e3));
  EXPECT_TRUE(kBond.tears(2.01e3));
}

TEST(CohesiveBond, SlipsAtFrictionAndCohesion) {
  ContactState at{.push = 10, .area = 0.02};
  EXPECT_DOUBLE_EQ(kBond.slip_limit(at, 0.5), 0.5 * 10 + 3e3 * 0.02);
  at.push = -10;
  EXPECT_DOUBLE_EQ(kBond.slip_limit(at, 0.5), -0.5 * 10 + 3e3 * 0.02);
  at.push = -1e3;
  EXPECT_EQ(kBond.slip_limit(at, 0.5), 0);
  EXPECT_TRUE(kBond.breaks_by_slip());
  EXPECT_FALSE((CohesiveBond{0, 2e3}.breaks_by_slip()));
}

// As candidates of a pair have it: while it holds the bond, afterwards friction alone.
TEST(CohesiveBond, IsChosenForItsPair) {
  PairOptions options;
  EXPECT_EQ(PairLaws(options, true).friction, nullptr);
  EXPECT_FALSE(PairLaws(options, true).bond.any());
  std::get<CohesiveBond>(options.bonds) = kBond;
  options.coulomb.friction.emplace().constant = 0.5;
  const PairLaws laws(options, false);
  ASSERT_NE(laws.friction, nullptr);
  EXPECT_TRUE(laws.bond.any());
  EXPECT_TRUE(laws.bond.tears(2.01e3));
  ContactState at{.pressure = 0, .push = -10, .area = 0.02};
  Real coefficient = 0;
  EXPECT_EQ(laws.slip_limit(at, coefficient), 0);
  EXPECT_EQ(coefficient, 0);  // at no pressure it has none
  at.bonded = true;
  EXPECT_DOUBLE_EQ(laws.slip_limit(at, coefficient), -0.5 * 10 + 3e3 * 0.02);
  EXPECT_EQ(coefficient, 0.5);
}

TEST(CohesiveBond, HeatPassesWhereBothSidesTakeAny) {
  PairOptions options;
  EXPECT_EQ(PairLaws(options, true).heat, nullptr);
  options.heat.emplace<PerfectContactHeat>();
  EXPECT_EQ(PairLaws(options, true).heat, &options.heat);
  EXPECT_EQ(PairLaws(options, false).heat, nullptr);
}

}  // namespace
}  // namespace brunt
