// mu = kinetic + (static - kinetic) exp(-decay |v|): static at rest, the mean of both at ln 2 /
// decay, kinetic far beyond. A table is read at the argument that it names, an expression at all.
#include "contact/law/coulomb_friction.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(CoulombFriction, DecaysWithSpeed) {
  CoulombFriction law;
  EXPECT_FALSE(law.acts());
  EXPECT_EQ(law.coefficient({.pressure = 1, .speed = 1}), 0);
  law.decaying = DecayingFriction{0.5, 0.2, 3};
  EXPECT_TRUE(law.acts());
  for (const Real pressure : {0.0, 1e9}) {
    const auto at = [&](Real speed) {
      return law.coefficient({.pressure = pressure, .speed = speed});
    };
    EXPECT_DOUBLE_EQ(at(0), 0.5);
    EXPECT_DOUBLE_EQ(at(std::log(2.0) / 3), 0.35);
    EXPECT_DOUBLE_EQ(at(1e3), 0.2);
  }
}

TEST(CoulombFriction, DependsOnTheStateOfSliding) {
  const ContactState at{.temperature = 400, .flow_stress = 2e8, .pressure = 1e6, .speed = 3};
  CoulombFriction law;
  law.friction.emplace();
  law.friction->abscissa = {0, 800};
  law.friction->ordinate = {0.1, 0.3};
  law.friction->over = Varying::Over::temperature;
  EXPECT_DOUBLE_EQ(law.coefficient(at), 0.2);
  EXPECT_TRUE(law.depends_on_material());
  law.friction->over = Varying::Over::slip_speed;
  EXPECT_DOUBLE_EQ(law.coefficient(at), 0.1 + 0.2 * 3 / 800);
  EXPECT_FALSE(law.depends_on_material());
  law.friction->over = Varying::Over::pressure;
  EXPECT_EQ(law.coefficient(at), 0.3);
  EXPECT_FALSE(law.depends_on_material());
  law.friction->over = Varying::Over::sliding;
  law.friction->evaluate = [](const std::array<Real, 4>& s) {
    return s[0] + 10 * s[1] + 100 * s[2] + 1000 * s[3];
  };
  EXPECT_DOUBLE_EQ(law.coefficient(at), 400 + 2e9 + 1e8 + 3000);
  law.friction->depends = {false, false, true, true};
  EXPECT_FALSE(law.depends_on_material());
  law.friction->depends = {false, true, false, false};
  EXPECT_TRUE(law.depends_on_material());
}

TEST(CoulombFriction, WithoutACoefficientDoesNotAct) {
  CoulombFriction law;
  law.friction.emplace();
  EXPECT_FALSE(law.acts());
  law.friction->constant = 0.1;
  EXPECT_TRUE(law.acts());
  law.decaying = DecayingFriction{0, 0, 1};
  EXPECT_FALSE(law.acts());
}

// Y / sqrt(3) over the area, where the deck asks for it and that is less.
TEST(CoulombFriction, IsLimitedByTheShearStrength) {
  const ContactState at{.flow_stress = 3e8, .area = 1e-4};
  const Real strength = 3e8 / std::sqrt(3.0) * 1e-4;
  CoulombFriction law;
  EXPECT_EQ(law.limited(at, 2 * strength), 2 * strength);
  EXPECT_FALSE(law.needs_material());
  law.shear_limit = true;
  EXPECT_DOUBLE_EQ(law.limited(at, 2 * strength), strength);
  EXPECT_EQ(law.limited(at, 0.5 * strength), 0.5 * strength);
  EXPECT_TRUE(law.needs_material());
}

}  // namespace
}  // namespace brunt
