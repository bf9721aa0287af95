// The inside of closed surfaces. A ball of radius R is an octahedron split n times: it falls short
// of the ball's volume at second order; what fills it has the volume of the polyhedron, and its
// centre of mass is the centre. An L of three cubes has corners, edges and faces right above and
// below each other and above lattice points: a ray through an edge or a corner counts once or not
// at all. Expected windings are by construction: 1 inside, 0 outside.
#include "core/geometry/closed_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "core/geometry/mesh.hpp"

namespace brunt {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

struct Shell {
  std::vector<Vec3> nodes;
  Triangles triangles;
};

/// An octahedron whose triangles are split in four n times, with corners on a sphere.
Shell ball(const Vec3& center, Real radius, int n) {
  Shell shell;
  shell.nodes = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  shell.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4},
                     {1, 0, 5}, {2, 1, 5}, {3, 2, 5}, {0, 3, 5}};
  for (; n > 0; --n) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, fresh] =
          middles.try_emplace(std::minmax(a, b), static_cast<int>(shell.nodes.size()));
      if (fresh) {
        shell.nodes.push_back(
            (shell.nodes[static_cast<std::size_t>(a)] + shell.nodes[static_cast<std::size_t>(b)])
                .normalized());
      }
      return it->second;
    };
    Triangles finer;
    for (const auto& [a, b, c] : shell.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    shell.triangles = std::move(finer);
  }
  for (Vec3& x : shell.nodes) x = center + radius * x;
  return shell;
}

/// A prism of height 1 above a polygon that a fan from its first corner covers.
Shell prism(const std::vector<Vec<2>>& outline) {
  Shell shell;
  const int n = static_cast<int>(outline.size());
  for (const Real z : {0.0, 1.0}) {
    for (const auto& x : outline) shell.nodes.emplace_back(x[0], x[1], z);
  }
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    shell.triangles.push_back({i, j, n + j});
    shell.triangles.push_back({i, n + j, n + i});
    if (i == 0 || j == 0) continue;
    shell.triangles.push_back({0, j, i});
    shell.triangles.push_back({n, n + i, n + j});
  }
  return shell;
}

/// Three unit cubes: the corner that is cut away has its inner edge at (1, 1).
Shell letter() { return prism({{1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {2, 1}}); }

/// Joins another shell's triangles to one; turned: facing the other way, as walls of a hollow do.
void add(const Shell& other, bool turned, Shell& to) {
  const auto n = static_cast<int>(to.nodes.size());
  to.nodes.insert(to.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (const auto& [a, b, c] : other.triangles) {
    to.triangles.push_back(turned ? std::array{b + n, a + n, c + n}
                                  : std::array{a + n, b + n, c + n});
  }
}

ClosedSurface closed(const Shell& shell, Real cell = 0.1) {
  return {shell.nodes, shell.triangles, cell};
}

TEST(ClosedSurface, RaysThroughEdgesAndCornersCountOnce) {
  const auto surface = closed(letter());
  EXPECT_NEAR(surface.volume(), 3, 1e-14);
  // A grid that meets corners, edges and diagonals of triangles, half of it off them.
  for (int i = -2; i < 20; ++i) {
    for (int j = -2; j < 20; ++j) {
      for (int k = -2; k < 12; ++k) {
        const Vec3 x(0.125 * i + 0.0625, 0.125 * j + 0.0625, 0.125 * k + 0.0625);
        const Vec3 on(0.125 * i, 0.125 * j, 0.125 * k + 0.0625);
        const auto inside = [](const Vec3& p) {
          const bool slab = p[2] > 0 && p[2] < 1 && p[0] > 0 && p[1] > 0;
          return slab && p[0] < 2 && p[1] < 2 && (p[0] < 1 || p[1] < 1);
        };
        EXPECT_EQ(surface.winding(x), inside(x) ? 1 : 0) << x.transpose();
        // On a wall either answer is right; right beside it both are.
        const Vec3 beside = on + Vec3(1e-9, 2e-9, 0);
        EXPECT_EQ(surface.winding(beside), inside(beside) ? 1 : 0) << on.transpose();
        if (on[0] != 0 && on[0] != 1 && on[0] != 2 && on[1] != 0 && on[1] != 1 && on[1] != 2) {
          EXPECT_EQ(surface.winding(on), inside(on) ? 1 : 0) << on.transpose();
        }
      }
    }
  }
}

TEST(ClosedSurface, PointsAboveTheCornersOfABallAreInsideIt) {
  // Nodes of the octahedron lie on the axes, and edges above each other: the worst rays there are.
  const auto surface = closed(ball(Vec3::Zero(), 1, 3));
  for (const Real z : {-0.9, -0.5, 0.0, 0.3, 0.9}) EXPECT_EQ(surface.winding({0, 0, z}), 1);
  for (const Real z : {-1.1, 1.1, 5.0}) EXPECT_EQ(surface.winding({0, 0, z}), 0);
  for (const Real x : {-0.9, -0.5, 0.5, 0.9}) EXPECT_EQ(surface.winding({x, 0, 0.01}), 1);
  EXPECT_EQ(surface.winding({2, 0, 0}), 0);
}

TEST(ClosedSurface, ParticlesOfABallHaveItsMassAndCentre) {
  const Vec3 center(3, -1, 2);
  const auto shell = ball(center, 1, 4);
  const auto surface = closed(shell, 0.1);
  // Faces lie below the sphere by some (edge/R)^2/8 in the mean, and edges have 90/16 to 90/11
  // degrees: V falls short by three times that, 0.4 to 0.8 %.
  EXPECT_NEAR(surface.volume(), 4.0 / 3 * kPi, 0.008 * 4.0 / 3 * kPi);
  const auto filling = fill_surface(surface, {0.1}, LatticeKind::cubic);
  EXPECT_EQ(filling.volume, surface.volume());
  Vec3 mean = Vec3::Zero();
  Real farthest = 0;
  for (const auto& x : filling.points) {
    mean += x / static_cast<Real>(filling.points.size());
    farthest = std::max(farthest, (x - center).norm());
  }
  EXPECT_LT((mean - center).norm(), 1e-3);  // the lattice lies evenly about it, but for rounding
  EXPECT_LE(farthest, 1);
  // Counting cells is exact to the share of those at the rim, random over 6 dp/R of them.
  const auto count = static_cast<Real>(filling.points.size()) * 0.1 * 0.1 * 0.1;
  EXPECT_NEAR(count, surface.volume(), 0.03 * surface.volume());
}

TEST(ClosedSurface, AnLIsFilledCellByCell) {
  for (const auto lattice : {LatticeKind::cubic, LatticeKind::hexagonal}) {
    const auto filling = fill_surface(closed(letter(), 0.25), {0.25}, lattice);
    EXPECT_EQ(filling.volume, closed(letter()).volume());
    for (const auto& x : filling.points) EXPECT_FALSE(x[0] > 1 && x[1] > 1) << x.transpose();
    if (lattice == LatticeKind::cubic) {
      EXPECT_EQ(filling.points.size(), 3u * 64);
    }
  }
}

TEST(ClosedSurface, NormalsInwardAreTurnedAndCavitiesStayEmpty) {
  auto inward = ball(Vec3::Zero(), 1, 2);
  for (auto& triangle : inward.triangles) std::swap(triangle[0], triangle[1]);
  const auto surface = closed(inward);
  EXPECT_GT(surface.volume(), 0);
  EXPECT_EQ(surface.winding({0, 0, 0}), 1);

  auto hollow = ball(Vec3::Zero(), 2, 3);
  const auto n = static_cast<int>(hollow.nodes.size());
  hollow.nodes.insert(hollow.nodes.end(), inward.nodes.begin(), inward.nodes.end());
  for (const auto& [a, b, c] : inward.triangles) hollow.triangles.push_back({a + n, b + n, c + n});
  const auto shell = closed(hollow);
  EXPECT_EQ(shell.winding({0, 0, 0}), 0);
  EXPECT_EQ(shell.winding({1.5, 0, 0}), 1);
  EXPECT_NEAR(shell.volume(), closed(ball(Vec3::Zero(), 2, 3)).volume() - surface.volume(), 1e-12);
}

// A ball with a hollow in which another lies free, a third beside them, and a fourth so small that
// it lies between the places of particles: three rooms with particles, of which the first is the
// hollow one although its hollow comes last.
TEST(ClosedSurface, WhatIsApartIsARoomOfItsOwn) {
  auto shells = ball(Vec3::Zero(), 2, 3);
  add(ball(Vec3::Zero(), 0.7, 3), false, shells);
  add(ball({5, 0, 0}, 1, 3), false, shells);
  add(ball({2.5, 2.5, 0}, 0.01, 1), false, shells);
  add(ball(Vec3::Zero(), 1.2, 3), true, shells);
  const auto surface = closed(shells);
  ASSERT_EQ(surface.n_rooms(), 4u);
  EXPECT_EQ(surface.room_at({1.6, 0.1, 0.1}), 0u);
  EXPECT_EQ(surface.room_at({0.1, 0.2, 0.5}), 1u);
  EXPECT_EQ(surface.room_at({5.1, 0.2, -0.5}), 2u);
  const auto filling = fill_surface(surface, {0.2}, LatticeKind::cubic);
  EXPECT_EQ(filling.piece_names, (std::vector<std::string>{"1", "2", "3"}));
  EXPECT_EQ(filling.empty, 1u);
  ASSERT_EQ(filling.piece.size(), filling.points.size());
  for (std::size_t i = 0; i < filling.points.size(); ++i) {
    const Vec3& x = filling.points[i];
    EXPECT_EQ(filling.piece[i], x[0] > 3 ? 2u : x.norm() < 1 ? 1u : 0u) << x.transpose();
  }
  // What hangs together at a corner alone is one room, as of elements.
  auto joined = ball(Vec3::Zero(), 1, 0);
  const auto other = ball({2, 0, 0}, 1, 0);  // its corner 2 lies at corner 0 of the first
  const int place[] = {6, 7, 0, 8, 9, 10};
  for (const int corner : {0, 1, 3, 4, 5}) joined.nodes.push_back(other.nodes[corner]);
  for (const auto& [a, b, c] : other.triangles) {
    joined.triangles.push_back({place[a], place[b], place[c]});
  }
  EXPECT_EQ(closed(joined).n_rooms(), 1u);
  EXPECT_EQ(fill_surface(closed(joined), {0.2}, LatticeKind::cubic).piece_names,
            std::vector<std::string>{""});
}

std::string refusal(const Shell& shell) {
  try {
    fill_surface(closed(shell), {0.1}, LatticeKind::cubic);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(ClosedSurface, SaysWhyThereIsNoInside) {
  auto open = letter();
  open.triangles.pop_back();
  EXPECT_NE(refusal(open).find("3 of its edges have a triangle on one side alone"),
            std::string::npos);
  auto turned = letter();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_NE(refusal(turned).find("neighbouring triangles face opposite ways"), std::string::npos);
  auto overlapping = ball(Vec3::Zero(), 1, 2);
  const auto other = ball(Vec3(1, 0, 0), 1, 2);
  const auto n = static_cast<int>(overlapping.nodes.size());
  overlapping.nodes.insert(overlapping.nodes.end(), other.nodes.begin(), other.nodes.end());
  for (const auto& [a, b, c] : other.triangles) {
    overlapping.triangles.push_back({a + n, b + n, c + n});
  }
  EXPECT_NE(refusal(overlapping).find("shells of the surface overlap"), std::string::npos);
  Shell flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {1, 0, 2}}};
  EXPECT_NE(refusal(flat).find("no volume"), std::string::npos);
}

}  // namespace
}  // namespace brunt
