// Two equal parallel squares of size 1, all of whose edges are borders, lie g deep in each other
// with an offset s along x and t along y. The area of their overlap is (1 - |s|) (1 - |t|), and the
// potential k/2 int g^2 dA pushes the upper one along x by
//   -dU/ds = k g^2/2 (1 - |t|) sign(s),
// which jumps where the borders are flush. The border of the other face takes its part there
// (part_of_flush), so that x^2 (3 - 2x) of it is left, x = 2 |s| up to 1: none of what is flush
// along x depends on t, and the push along the normal k g (1 - |s|) (1 - |t|) is as it was. g is
// 0.1, from 0.05 of the distance of opposite borders on all of the potential counts, and less than
// that distance, so that nothing fades.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/geometry/overlap_push.hpp"

namespace brunt {
namespace {

constexpr Real kDepth = 0.1;

struct Pushed {
  Real beside, beside_lower;  ///< along x, on the upper and on the lower face
  Real volume, share;
};

template <int Dim>
Pushed pushed(FacePlane<Dim> lower, FacePlane<Dim> upper) {
  refresh(lower), refresh(upper);
  Planes<Dim> planes;
  const Section section{Dim == 3 ? Geometry::three_d : Geometry::plane_strain, 1};
  EXPECT_EQ(common_planes<Dim>(lower, upper, section, planes, {}), 1);
  const auto& plane = planes[0];
  Pushed sum{0, 0, plane.volume, plane.share};
  if (plane.share == 0) return sum;
  for (std::size_t c = 0; c < CommonPlane<Dim>::kCorners; ++c) {
    sum.beside += plane.upper_push[c][0];
    sum.beside_lower += plane.lower_push[c][0];
  }
  return sum;
}

/// A square from (0, 0) to (1, 1) and one s along x, t along y and down by kDepth.
Pushed squares(Real s, Real t, unsigned lower_borders = 15, unsigned upper_borders = 15) {
  FacePlane<3> lower, upper;
  lower.n_corners = upper.n_corners = 4;
  lower.corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  for (std::size_t c = 0; c < 4; ++c) {
    upper.corner[c] = lower.corner[(4 - c) % 4] + Vec3(s, t, -kDepth);
  }
  lower.borders = static_cast<std::uint8_t>(lower_borders);
  upper.borders = static_cast<std::uint8_t>(upper_borders);
  return pushed(lower, upper);
}

Pushed lines(Real s) {
  FacePlane<2> lower, upper;
  lower.n_corners = upper.n_corners = 2;
  lower.corner = {Vec<2>(1, 0), Vec<2>(0, 0)};
  upper.corner = {Vec<2>(s, -kDepth), Vec<2>(1 + s, -kDepth)};
  lower.borders = upper.borders = 3;
  return pushed(lower, upper);
}

/// What is left of the side force at an offset.
Real left(Real s) {
  const Real x = std::min(2 * std::fabs(s), 1.0);
  return std::copysign(x * x * (3 - 2 * x), s);
}

constexpr std::array<Real, 14> kOffsets = {0,    1e-16, -1e-16, 1e-12, 1e-9, 1e-6, -1e-6,
                                           1e-3, 0.1,   -0.1,   0.3,   0.5,  0.7,  -0.8};

TEST(FlushBorders, SideForceGrowsFromNoneInThreeDimensions) {
  for (const Real s : kOffsets) {
    for (const Real t : kOffsets) {
      const auto one = squares(s, t);
      const Real breadth = 1 - std::fabs(t);
      EXPECT_EQ(one.share, 1) << s << " " << t;
      EXPECT_NEAR(one.volume, kDepth * (1 - std::fabs(s)) * breadth, 1e-15) << s << " " << t;
      EXPECT_NEAR(one.beside, kDepth * kDepth / 2 * breadth * left(s), 1e-15) << s << " " << t;
      EXPECT_NEAR(one.beside + one.beside_lower, 0, 1e-17) << s << " " << t;
    }
  }
}

TEST(FlushBorders, SideForceGrowsFromNoneInTwoDimensions) {
  for (const Real s : kOffsets) {
    const auto one = lines(s);
    EXPECT_EQ(one.share, 1) << s;
    EXPECT_NEAR(one.volume, kDepth * (1 - std::fabs(s)), 1e-15) << s;
    EXPECT_NEAR(one.beside, kDepth * kDepth / 2 * left(s), 1e-15) << s;
    EXPECT_NEAR(one.beside + one.beside_lower, 0, 1e-17) << s;
  }
}

// Bodies two faces across: the right face of the lower, its border at x = 1, and the left one of
// the upper, which has moved to the right by s, its border at x = s - 1. Their overlap is s wide,
// between borders that are 1 - s/2 away on either side. The other faces of both follow no potential
// (no borders oppose each other there), and at the inner edges between all of them nothing may be
// left over: the sliver follows it by y^2 (3 - 2y), y = s/(2 - s), where 0.1/(2 - s) is 0.05 or
// more, less 0 to 1 e-10 of rounding in s.
TEST(FlushBorders, SliverBetweenInnerEdgesHasNoShare) {
  constexpr unsigned kRight = 1U << 1, kLeft = 1U << 0;
  for (const Real s : {1e-9, 1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0}) {
    const Real y = s / (2 - s);
    EXPECT_NEAR(squares(s - 1, 0, kRight, kLeft).share, y * y * (3 - 2 * y), 1e-10) << s;
  }
}

}  // namespace
}  // namespace brunt
