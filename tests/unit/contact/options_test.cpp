// mu = kinetic + (static - kinetic) exp(-decay |v|): static at rest, the mean of both at ln 2 /
// decay, kinetic far beyond.
#include "contact/law/options.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(PairOptions, FrictionDecaysWithSpeed) {
  PairOptions pair;
  EXPECT_FALSE(pair.has_friction());
  EXPECT_EQ(pair.coefficient({.pressure = 1, .speed = 1}), 0);
  pair.decaying = DecayingFriction{0.5, 0.2, 3};
  EXPECT_TRUE(pair.has_friction());
  for (const Real pressure : {0.0, 1e9}) {
    const auto at = [&](Real speed) {
      return pair.coefficient({.pressure = pressure, .speed = speed});
    };
    EXPECT_DOUBLE_EQ(at(0), 0.5);
    EXPECT_DOUBLE_EQ(at(std::log(2.0) / 3), 0.35);
    EXPECT_DOUBLE_EQ(at(1e3), 0.2);
  }
}

// A table is read at the argument that it names, an expression at all four; materials are asked for
// only where the temperature or the flow stress matters.
TEST(PairOptions, FrictionDependsOnTheStateOfSliding) {
  const Sliding at{.temperature = 400, .flow_stress = 2e8, .pressure = 1e6, .speed = 3};
  PairOptions pair;
  pair.friction.emplace();
  pair.friction->abscissa = {0, 800};
  pair.friction->ordinate = {0.1, 0.3};
  pair.friction->over = Varying::Over::temperature;
  EXPECT_DOUBLE_EQ(pair.coefficient(at), 0.2);
  EXPECT_TRUE(pair.needs_material());
  pair.friction->over = Varying::Over::slip_speed;
  EXPECT_DOUBLE_EQ(pair.coefficient(at), 0.1 + 0.2 * 3 / 800);
  EXPECT_FALSE(pair.needs_material());
  pair.friction->over = Varying::Over::pressure;
  EXPECT_EQ(pair.coefficient(at), 0.3);
  EXPECT_FALSE(pair.needs_material());
  pair.friction->over = Varying::Over::sliding;
  pair.friction->evaluate = [](const std::array<Real, 4>& s) {
    return s[0] + 10 * s[1] + 100 * s[2] + 1000 * s[3];
  };
  EXPECT_DOUBLE_EQ(pair.coefficient(at), 400 + 2e9 + 1e8 + 3000);
  pair.friction->depends = {false, false, true, true};
  EXPECT_FALSE(pair.needs_material());
  pair.friction->depends = {false, true, false, false};
  EXPECT_TRUE(pair.needs_material());
}

TEST(PairOptions, AShearLimitAsksForTheMaterialOfWhatRubs) {
  PairOptions pair;
  pair.shear_limit = true;
  EXPECT_FALSE(pair.needs_material());
  pair.friction.emplace().constant = 0.1;
  EXPECT_TRUE(pair.needs_material());
}

TEST(PairOptions, NoFrictionDoesNotRub) {
  PairOptions pair;
  pair.friction.emplace();
  EXPECT_FALSE(pair.has_friction());
  pair.friction->constant = 0.1;
  EXPECT_TRUE(pair.has_friction());
  pair.decaying = DecayingFriction{0, 0, 1};
  EXPECT_FALSE(pair.has_friction());
}

}  // namespace
}  // namespace brunt
