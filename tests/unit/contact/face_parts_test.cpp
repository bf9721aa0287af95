// A quad between flat and warped counts as its mean plane and as two triangles, by the part w of
// the first. With U the energies of all planes by their weights, the forces on the corners are
// minus its gradient, found here by central differences: of second order in the difference d, whose
// rounding is 1e-16 U/d. Moving all corners as one changes nothing: no resultant, no moment.
#include "contact/geometry/face_parts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/geometry/common_plane.hpp"

namespace brunt {
namespace {

FacePlane<3> square(Real size, Real warp, Real start = 0) {
  FacePlane<3> plane;
  plane.corner = {Vec3(0, 0, warp), {size, 0, -warp}, {size, size, warp}, {0, size, -warp}};
  if (start > 0) plane.area_start = start * start;
  refresh(plane);
  return plane;
}

// A face that is 2 m wide now and was `start` at time 0 is more split than not where its warp is
// beyond 5 % of the smaller width: of 0.5 m 25 mm, of 4 m the 100 mm that its width now allows.
TEST(FaceParts, WarpIsMeasuredByTheSmallerOfTheWidthsNowAndAtTimeZero) {
  EXPECT_TRUE(square(2, 0.024, 0.5).simple);
  EXPECT_FALSE(square(2, 0.026, 0.5).simple);
  EXPECT_TRUE(square(2, 0.09, 4).simple);
  EXPECT_FALSE(square(2, 0.11, 4).simple);
}

TEST(FaceParts, FadesFromOnePlaneToTwoTriangles) {
  EXPECT_FALSE(square(1, 0.0199).between);
  EXPECT_TRUE(square(1, 0.0199).simple);
  EXPECT_NEAR(whole_part(square(1, 0.0201)).value, 1, 1e-4);  // 3 (0.0001/0.06)^2
  EXPECT_NEAR(whole_part(square(1, 0.05)).value, 0.5, 1e-14);
  EXPECT_NEAR(whole_part(square(1, 0.0799)).value, 0, 1e-4);
  EXPECT_FALSE(square(1, 0.0801).between);
  EXPECT_FALSE(square(1, 0.0801).simple);
  FacePlane<3> dented = square(1, 0);
  dented.corner[2] = Vec3(1, 1, 0) / 1.94;  // of an area of 1/1.94 its corner turns by 0.06
  refresh(dented);
  EXPECT_TRUE(dented.simple && dented.between);
  EXPECT_NEAR(whole_part(dented).value, 0.5, 1e-12);
}

struct Pair {
  FacePlane<3> lower, upper;
  Planes<3> planes;
  int meet() {
    refresh(lower), refresh(upper);
    return common_planes<3>(lower, upper, {Geometry::three_d, 1}, planes, {.barrier = {0.1}});
  }
  Real energy() {
    const int n = meet();
    Real sum = 0;
    for (int i = 0; i < n; ++i) sum += planes[static_cast<std::size_t>(i)].energy;
    return sum;
  }
  Vec3& corner(std::size_t i) { return i < 4 ? lower.corner[i] : upper.corner[i - 4]; }
  /// On corner i, per k; false where a plane has a push that is no gradient.
  bool force(int n, std::size_t i, Vec3& sum) const {
    sum.setZero();
    for (int p = 0; p < n; ++p) {
      const auto& plane = planes[static_cast<std::size_t>(p)];
      if (plane.share != 1) return false;
      const Real weight = i < 4 ? -plane.lower_weight[i] : plane.upper_weight[i - 4];
      sum += weight * plane.volume * plane.normal;
      sum += i < 4 ? plane.lower_push[i] : plane.upper_push[i - 4];
    }
    return n > 0;
  }
};

/// Two squares of 1 m, warped by up to 0.1, of which one leans by 20 to 60 degrees into the other.
Pair random_pair(std::mt19937_64& generator) {
  const auto random = [&](Real least, Real most) {
    return std::uniform_real_distribution<Real>(least, most)(generator);
  };
  Pair pair;
  const Real turn = random(0, 2 * kPi), low = random(0, 0.1), high = random(0, 0.1);
  const Eigen::AngleAxis<Real> tilt(random(0.35, 1.05), Vec3(std::cos(turn), std::sin(turn), 0));
  const Vec3 at(random(-0.4, 0.4), random(-0.4, 0.4), random(-0.2, 0.2));
  const std::array<Vec3, 4> flat = {
      {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}}};
  for (std::size_t c = 0; c < 4; ++c) {
    const Real sign = c % 2 == 0 ? 1 : -1;
    const Vec3 moved(random(-0.05, 0.05), random(-0.05, 0.05), 0);
    pair.lower.corner[c] = flat[c] + moved + low * sign * Vec3::UnitZ();
    pair.upper.corner[c] = at + tilt * (flat[3 - c] + high * sign * Vec3::UnitZ());
  }
  return pair;
}

TEST(FaceParts, PushByTheGradientOfWhatAllOfThemHold) {
  std::mt19937_64 generator(20261124);
  const Real d = 1e-7;
  int found = 0;
  for (int k = 0; k < 400; ++k) {
    Pair pair = random_pair(generator);
    const int n = pair.meet();
    if (!pair.lower.between && !pair.upper.between) continue;
    std::array<Vec3, 8> force;
    bool all = true;
    Real largest = 0;
    Vec3 resultant = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t i = 0; i < 8; ++i) {
      all = all && pair.force(n, i, force[i]);
      if (!all) break;
      largest = std::max(largest, force[i].norm());
      resultant += force[i];
      moment += pair.corner(i).cross(force[i]);
    }
    if (!all) continue;
    ++found;
    // Some hundred sums of forces of this size.
    EXPECT_NEAR(resultant.norm(), 0, 1e-13 * largest);
    EXPECT_NEAR(moment.norm(), 0, 1e-13 * largest);
    for (std::size_t i = 0; i < 8; ++i) {
      for (int c = 0; c < 3; ++c) {
        const Real x = pair.corner(i)[c];
        pair.corner(i)[c] = x + d;
        const Real more = pair.energy();
        pair.corner(i)[c] = x - d;
        const Real less = pair.energy();
        pair.corner(i)[c] = x;
        // d/L of lengths L down to the band of warps of 0.06, where second derivatives jump.
        EXPECT_NEAR(-(more - less) / (2 * d), force[i][c], 1e-5 * largest) << k << ' ' << i << c;
      }
    }
  }
  EXPECT_GT(found, 50);
}

}  // namespace
}  // namespace brunt
