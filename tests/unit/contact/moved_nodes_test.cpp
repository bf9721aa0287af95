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
// Points in any order, which follow each other in the tables of contact: the last of either table
// stands before nothing, and is left.
TEST(MovedNodes, AreReadEachWithWhatStandsBehindIt) {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 100; ++trial) {
    const std::size_t n = 2 + random() % 9, n_points = n + random() % 3;
    const Nodes<3> points(n_points, random), nodes(n, random);
    std::vector<NodeRun> runs;
    for (std::size_t i = 0; i < n; ++i) {
      runs.push_back({LocalIndex(i), 0, LocalIndex((7 * i + trial) % n_points), 1});
    }
    std::vector<Vec3> x(n, Vec3::Zero()), v(n, Vec3::Zero());
    MovedNodes<3> moved;
    MotionBounds<3> expected;
    const NodeRun* const last = runs.data() + n;
    const NodeRun* end = runs.data();
    while (end != last) {
      const NodeRun* const next =
          moved.read_each(end, last, points.x.data(), points.v.data(), n_points, n,
                          nodes.made.data(), x.data(), v.data());
      for (; end != next; ++end) {
        const auto i = slot_of(end->node), p = slot_of(end->point);
        EXPECT_TRUE(p + 1 < n_points && i + 1 < n);
        EXPECT_TRUE(same<3>(x[i], points.x[p]) && same<3>(v[i], points.v[p]));
        expected.take(points.x[p] - nodes.made[i], points.v[p]);
      }
      if (end == last) break;
      EXPECT_TRUE(slot_of(end->point) + 1 == n_points || slot_of(end->node) + 1 == n);
      EXPECT_EQ(x[slot_of(end->node)], Vec3::Zero());
      ++end;
    }
    const auto bounds = moved.bounds();
    EXPECT_EQ(bounds.u_min, expected.u_min);
    EXPECT_EQ(bounds.u_max, expected.u_max);
    EXPECT_EQ(bounds.v_min, expected.v_min);
    EXPECT_EQ(bounds.v_max, expected.v_max);
  }
}
TEST(MovedNodes, AreBoundedAsOneByOneInThePlane) { expect_as_one_by_one<2>(); }

}  // namespace
}  // namespace brunt
