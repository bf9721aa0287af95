// What the options of a pair say of it as a whole.
#include "contact/law/options.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(PairOptions, AShearLimitNeedsTheMaterial) {
  PairOptions pair;
  pair.coulomb.shear_limit = true;
  EXPECT_FALSE(pair.needs_material());
  pair.coulomb.friction.emplace().constant = 0.1;
  EXPECT_TRUE(pair.needs_material());
}

TEST(PairOptions, ABondResistsSlidingToo) {
  PairOptions pair;
  EXPECT_FALSE(pair.has_friction());
  std::get<CohesiveBond>(pair.bonds) = {0, 1e6};
  EXPECT_TRUE(pair.has_friction());
}

}  // namespace
}  // namespace brunt
