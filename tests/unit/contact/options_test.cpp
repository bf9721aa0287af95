// mu = kinetic + (static - kinetic) exp(-decay |v|): static at rest, the mean of both at ln 2 /
// decay, kinetic far beyond.
#include "contact/options.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(PairOptions, FrictionDecaysWithSpeed) {
  PairOptions pair;
  EXPECT_FALSE(pair.rubs());
  EXPECT_EQ(pair.coefficient(1, 1), 0);
  pair.decaying = DecayingFriction{0.5, 0.2, 3};
  EXPECT_TRUE(pair.rubs());
  for (const Real pressure : {0.0, 1e9}) {
    EXPECT_DOUBLE_EQ(pair.coefficient(0, pressure), 0.5);
    EXPECT_DOUBLE_EQ(pair.coefficient(std::log(2.0) / 3, pressure), 0.35);
    EXPECT_DOUBLE_EQ(pair.coefficient(1e3, pressure), 0.2);
  }
}

TEST(PairOptions, NoFrictionDoesNotRub) {
  PairOptions pair;
  pair.friction.emplace();
  EXPECT_FALSE(pair.rubs());
  pair.friction->constant = 0.1;
  EXPECT_TRUE(pair.rubs());
  pair.decaying = DecayingFriction{0, 0, 1};
  EXPECT_FALSE(pair.rubs());
}

}  // namespace
}  // namespace brunt
