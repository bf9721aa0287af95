// The barrier of faces: per k, beside g, the pressure b (g - g0)^2/g0 beyond g0 (FaceBarrier). Its
// integrals over overlaps are those of polynomials: exact, here by
//   int over a simplex x^i y^j dA = i! j!/(i + j + 2)!  (triangle (0,0), (1,0), (0,1)),
// and, where a face leans, by integrals along the wedge: u from 0 to u1 over a length l has
//   int u = l u1/2, int u^2 = l u1^2/3, int u^3 = l u1^3/4, int u^2 s = l^2 u1^2/4.
// Tolerances are those of sums of ten numbers.
#include "contact/geometry/face_barrier.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/geometry/common_plane.hpp"

namespace brunt {
namespace {

Polygon polygon_of(const std::vector<Vec<2>>& corners) {
  Polygon polygon;
  std::uint8_t side = 0;
  for (const auto& p : corners) polygon.push(p, side++);
  return polygon;
}

TEST(FaceBarrier, BeginsWithoutAKinkAndIsTheSlopeOfItsEnergy) {
  const FaceBarrier barrier = FaceBarrier::before(0.8);
  const Real g0 = barrier.onset, b = FaceBarrier::kStrength;
  EXPECT_EQ(g0, 0.1);
  for (const Real g : {-1.0, 0.0, 0.05, 0.1}) {
    EXPECT_EQ(barrier.pressure(g), 0) << g;
    EXPECT_EQ(barrier.energy(g), 0) << g;
    EXPECT_EQ(barrier.tangent(g), 1) << g;
  }
  EXPECT_NEAR(barrier.pressure(0.4), b * 0.09 / g0, 1e-14);
  const Real d = 1e-6;  // cubic at most: differences of second order are exact but for rounding
  for (const Real g : {0.1001, 0.3, 0.8}) {
    EXPECT_NEAR((barrier.energy(g + d) - barrier.energy(g - d)) / (2 * d), barrier.pressure(g),
                1e-8);
    EXPECT_NEAR(1 + (barrier.pressure(g + d) - barrier.pressure(g - d)) / (2 * d),
                barrier.tangent(g), 1e-7);
  }
  const FaceBarrier none;
  EXPECT_EQ(none.pressure(5) + none.energy(5), 0);
  EXPECT_EQ(none.tangent(5), 1);
}

TEST(FaceBarrier, FadesInWithTheAngle) {
  const FaceBarrier barrier = FaceBarrier::before(0.8);
  EXPECT_EQ(barrier.at(1).strength, FaceBarrier::kStrength);
  EXPECT_EQ(barrier.at(1).growth, 0);
  EXPECT_EQ(barrier.at(0.2).pressure(0.8), 0);
  const Real d = 1e-6;
  for (const Real facing : {0.25, 0.4, 0.58}) {
    const Real growth =
        (barrier.at(facing + d).energy(0.5) - barrier.at(facing - d).energy(0.5)) / (2 * d);
    EXPECT_NEAR(growth / barrier.at(facing).energy(0.5), barrier.at(facing).growth, 1e-7) << facing;
  }
}

TEST(FaceBarrier, IntegratesOverATriangle) {
  // u = x: what is less deep than g0 = 0.2, x < 0, is cut off.
  const Polygon overlap = polygon_of({{0, 0}, {1, 0}, {0, 1}, {-1, 1}, {-1, 0}});
  const LinearField g{0.2, {1, 0}};
  const DeepArea deep = deep_area(overlap, g, 1, 1.2, {0.2});
  EXPECT_NEAR(deep.linear, 1.0 / 6, 1e-16);
  EXPECT_NEAR(deep.squared, 1.0 / 12, 1e-16);
  EXPECT_NEAR(deep.cubed, 1.0 / 20, 1e-16);
  EXPECT_NEAR(deep.moment[0], 1.0 / 20, 1e-16);
  EXPECT_NEAR(deep.moment[1], 1.0 / 60, 1e-16);
  EXPECT_EQ(deep_area(overlap, g, 1, 0.2, {0.2}).squared, 0);
  EXPECT_EQ(deep_area(overlap, g, 1, 1.2, {}).squared, 0);
}

TEST(FaceBarrier, MeansAlongASide) {
  // u = a + (b - a) t: int u^3 = (b^4 - a^4)/(4 (b - a)); with t, by parts.
  const Real a = 0.3, b = 0.7;
  const auto fourth = [](Real x) { return x * x * x * x; };
  const Real all = (fourth(b) - fourth(a)) / (4 * (b - a));
  const Real fifth = (fourth(b) * b - fourth(a) * a) / (20 * (b - a) * (b - a));
  const SideMeans means = cubic_means(a, b);
  EXPECT_NEAR(means.all, all, 1e-15);
  EXPECT_NEAR(means.late, fourth(b) / (4 * (b - a)) - fifth, 1e-15);
}

TEST(FaceBarrier, IntegratesAlongALine) {
  // G = 0.1 + s over 0 .. 1, g0 = 0.3: u = s - 0.2 from 0 to 0.8; breadths 1 and s.
  const auto deep = deep_line({0, 1}, {0.1, 1.1}, {0.3}, [](Real) { return 1.0; });
  EXPECT_NEAR(deep.linear, 0.64 / 2, 1e-16);
  EXPECT_NEAR(deep.squared, 0.8 * 0.64 / 3, 1e-16);
  EXPECT_NEAR(deep.cubed, 0.8 * 0.512 / 4, 1e-16);
  EXPECT_NEAR(deep.moment, 0.64 * 0.64 / 4 + 0.2 * deep.squared, 1e-16);
  const auto ring = deep_line({0, 1}, {0.1, 1.1}, {0.3}, [](Real s) { return s; });
  EXPECT_NEAR(ring.squared, deep.moment, 1e-16);
  EXPECT_NEAR(ring.cubed_by_length, deep.cubed, 1e-16);
  EXPECT_NEAR(ring.cubed, deep.cubed_moment, 1e-16);
  // It runs the other way.
  const auto back = deep_line({0, 1}, {1.1, 0.1}, {0.3}, [](Real) { return 1.0; });
  EXPECT_NEAR(back.squared, deep.squared, 1e-16);
  EXPECT_NEAR(back.moment, deep.squared - deep.moment, 1e-16);
}

/// Two unit squares, or edges 1 long, of which the upper lies `depth` in the lower.
template <int Dim>
CommonPlane<Dim> flush(Real depth, const PlaneNeeds& needs) {
  FacePlane<Dim> lower, upper;
  if constexpr (Dim == 3) {
    lower.corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    upper.corner = {Vec3(0, 0, -depth), Vec3(0, 1, -depth), Vec3(1, 1, -depth), Vec3(1, 0, -depth)};
  } else {
    lower.corner = {Vec<2>(1, 0), Vec<2>(0, 0)};
    upper.corner = {Vec<2>(0, -depth), Vec<2>(1, -depth)};
  }
  lower.n_corners = upper.n_corners = FacePlane<Dim>::kCorners;
  refresh(lower), refresh(upper);
  Planes<Dim> planes;
  const Section section{Dim == 3 ? Geometry::three_d : Geometry::plane_strain, 1};
  EXPECT_EQ(common_planes<Dim>(lower, upper, section, planes, needs), 1);
  return planes[0];
}

template <int Dim>
void expect_flush() {
  const FaceBarrier barrier = FaceBarrier::before(0.8);
  for (const bool whole : {false, true}) {
    for (const Real depth : {0.05, 0.3, 0.7}) {
      const auto plane = flush<Dim>(depth, {.whole = whole, .barrier = barrier});
      const Real u = std::max(depth - barrier.onset, 0.0), b = FaceBarrier::kStrength;
      EXPECT_NEAR(plane.volume, depth + b * u * u / barrier.onset, 1e-13) << depth;
      EXPECT_NEAR(plane.energy, 0.5 * depth * depth + b * u * u * u / (3 * barrier.onset), 1e-13);
      EXPECT_NEAR(plane.penetration, depth, 1e-15);
      EXPECT_NEAR(plane.mean_slope, barrier.tangent(depth), 1e-13);
    }
  }
}
TEST(FaceBarrier, PushesFlushFacesInTheirMiddle) {
  expect_flush<2>();
  expect_flush<3>();
}

}  // namespace
}  // namespace brunt
