// All components at once are to give the bits that one after another give: boxes and points at
// random, many of them on a side or a corner, and some that are no numbers.
#include "contact/geometry/box_query.hpp"

#include <gtest/gtest.h>

#include <random>

namespace brunt {
namespace {

bool in_one_by_one(const SearchBox<3>& box, const Vec3& x, Real reach) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Real at = x[static_cast<Eigen::Index>(k)];
    if (at < box.lo[k] - reach || at > box.hi[k] + reach) return false;
  }
  return true;
}

Real square_one_by_one(const SearchBox<3>& box, const Vec3& x) {
  Real square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Real at = x[static_cast<Eigen::Index>(k)];
    const Real out = std::max({box.lo[k] - at, at - box.hi[k], 0.0});
    square += out * out;
  }
  return square;
}

TEST(BoxQuery, AllComponentsAtOnceGiveTheSameBits) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> coarse(-4, 4);
  std::uniform_real_distribution<Real> fine(-1, 1);
  int inside = 0, outside = 0;
  for (int i = 0; i < 20000; ++i) {
    const bool rough = i % 2 == 0;
    const auto number = [&] { return rough ? 0.25 * coarse(random) : fine(random); };
    SearchBox<3> box;
    Vec3 x;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real a = number(), b = number();
      box.lo[k] = std::min(a, b), box.hi[k] = std::max(a, b);
      x[static_cast<Eigen::Index>(k)] = number();
    }
    if (i % 100 == 0) x[i % 3] = std::numeric_limits<Real>::quiet_NaN();
    const Real reach = rough ? 0.25 : 0.1;
    const BoxQuery<3> query(x);
    EXPECT_EQ(query.in(box, reach), in_one_by_one(box, x, reach));
    const Real square = square_one_by_one(box, x);
    if (square == square) {
      EXPECT_EQ(query.squared_distance(box), square);
    } else {
      EXPECT_NE(query.squared_distance(box), query.squared_distance(box));
    }
    ++(square > 0 ? outside : inside);
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 1000);
}

TEST(BoxQuery, DistanceInAPlaneIsThatToTheNearestCorner) {
  const SearchBox<2> box{{0, 0}, {1, 2}};
  const BoxQuery<2> query(Vec<2>(4, 6));
  EXPECT_EQ(query.squared_distance(box), 25);
  EXPECT_FALSE(query.in(box, 3.5));
  EXPECT_TRUE(query.in(box, 4));
}

}  // namespace
}  // namespace brunt
