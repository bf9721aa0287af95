// A number with its derivatives, against those of x y / (x - y) + sqrt(x):
//   d/dx = -y^2/(x - y)^2 + 1/(2 sqrt(x)),   d/dy = x^2/(x - y)^2.
#include "contact/geometry/gradient_number.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(GradientNumber, DerivesWhatIsComputedWithIt) {
  const auto x = variable<GradientNumber<2>>(3, 0), y = variable<GradientNumber<2>>(2, 1);
  const auto f = x * y / (x - y) + root_of(x);
  EXPECT_NEAR(f.value, 6 + std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(f.slope[0], -4 + 0.5 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(f.slope[1], 9, 1e-14);
  EXPECT_EQ(variable<Real>(3, 0), 3);
}

}  // namespace
}  // namespace brunt
