// Nodes that are read four at a time arrive as they are, and bound their motion as node after node
// does, for runs of any length; what is no number bounds nothing.
#include "contact/surfaces/moved_nodes.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace brunt {
namespace {

template <int Dim>
struct Nodes {
  std::vector<Vec<Dim>> x, v, made;
  Nodes(std::size_t n, std::mt19937_64& random) {
    std::normal_distribution<Real> normal(0, 1);
    for (std::size_t i = 0; i < n; ++i) {
      for (auto* field : {&x, &v, &made}) {
        auto& at = field->emplace_back();
        for (int c = 0; c < Dim; ++c) at[c] = normal(random);
      }
      if (random() % 10 == 0) x[i][0] = std::numeric_limits<Real>::quiet_NaN();
      if (random() % 10 == 0) v[i][Dim - 1] = std::numeric_limits<Real>::quiet_NaN();
    }
  }
};

/// NaN is as good as NaN.
template <int Dim>
bool same(const Vec<Dim>& a, const Vec<Dim>& b) {
  bool all = true;
  for (int c = 0; c < Dim; ++c) all &= a[c] == b[c] || (std::isnan(a[c]) && std::isnan(b[c]));
  return all;
}

template <int Dim>
void expect_as_one_by_one() {
  std::mt19937_64 random(9);
  for (int trial = 0; trial < 300; ++trial) {
    MovedNodes<Dim> moved;
    MotionBounds<Dim> expected;
    for (std::size_t run = 0; run < 1 + random() % 4; ++run) {
      const std::size_t n = random() % 19;
      const Nodes<Dim> nodes(n, random);
      // One more behind, which stays as it is.
      const Vec<Dim> guard = Vec<Dim>::Constant(-7);
      std::vector<Vec<Dim>> x(n + 1, guard), v(n + 1, guard);
      moved.read(n, nodes.x.data(), nodes.v.data(), nodes.made.data(), x.data(), v.data());
      for (std::size_t i = 0; i < n; ++i) {
        expected.take(nodes.x[i] - nodes.made[i], nodes.v[i]);
        EXPECT_TRUE(same<Dim>(x[i], nodes.x[i]) && same<Dim>(v[i], nodes.v[i]));
      }
      EXPECT_TRUE(x[n] == guard && v[n] == guard);
    }
    const auto bounds = moved.bounds();
    EXPECT_EQ(bounds.u_min, expected.u_min);
    EXPECT_EQ(bounds.u_max, expected.u_max);
    EXPECT_EQ(bounds.v_min, expected.v_min);
    EXPECT_EQ(bounds.v_max, expected.v_max);
  }
}

TEST(MovedNodes, AreBoundedAsOneByOneInSpace) { expect_as_one_by_one<3>(); }
TEST(MovedNodes, AreBoundedAsOneByOneInThePlane) { expect_as_one_by_one<2>(); }

}  // namespace
}  // namespace brunt
