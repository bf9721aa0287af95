/// sigma_y = yield + R(eps_p) by hand: R = H eps_p, or a table, linear between and held outside.
#include "core/materials/j2.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

static_assert(FlowLaw<J2>);

TEST(J2, IsPerfectlyPlasticWithoutHardening) {
  const J2 law{400e6, {}};
  EXPECT_EQ(law.flow_stress(0.7, 1e6, 2000.0), 400e6);
  EXPECT_EQ(law.near(0.7, 0.0).at(0.1, 0.0, 0.0).d_eps_p, 0.0);
  EXPECT_FALSE(law.needs_temperature());
}

TEST(J2, HardensByAModulus) {
  J2 law{400e6, Varying{}};
  law.hardening->constant = 1e9;
  EXPECT_DOUBLE_EQ(law.flow_stress(0.25, 0.0, 0.0), 650e6);
  const auto flow = law.near(0.25, 0.0).at(0.25, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(flow.value, 900e6);
  EXPECT_EQ(flow.d_eps_p, 1e9);
}

TEST(J2, HardensByATable) {
  J2 law{200e6, Varying{}};
  law.hardening->over = Varying::Over::eps_p;
  law.hardening->abscissa = {0.0, 0.1, 0.5};
  law.hardening->ordinate = {0.0, 50e6, 90e6};
  EXPECT_DOUBLE_EQ(law.flow_stress(0.0, 0.0, 0.0), 200e6);
  EXPECT_DOUBLE_EQ(law.flow_stress(0.05, 0.0, 0.0), 225e6);
  EXPECT_DOUBLE_EQ(law.flow_stress(0.1, 0.0, 0.0), 250e6);
  EXPECT_DOUBLE_EQ(law.flow_stress(0.3, 0.0, 0.0), 270e6);
  EXPECT_DOUBLE_EQ(law.flow_stress(9.0, 0.0, 0.0), 290e6);
  EXPECT_DOUBLE_EQ(law.hardened(0.05).d_eps_p, 500e6);
  EXPECT_DOUBLE_EQ(law.hardened(0.1).d_eps_p, 100e6);  // the side to the right
  EXPECT_DOUBLE_EQ(law.hardened(0.6).d_eps_p, 0.0);
  const Pack lanes = law.flow_stress(Pack{0.0, 0.05, 0.3, 9.0}, Pack{}, Pack{});
  EXPECT_EQ(lanes[1], law.flow_stress(0.05, 0.0, 0.0));
  EXPECT_EQ(lanes[2], law.flow_stress(0.3, 0.0, 0.0));
}

}  // namespace
}  // namespace brunt
