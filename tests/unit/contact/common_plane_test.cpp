// Wedge of side angle th against a flat face, tip at depth d: the common plane of one side bisects
// face and side, and the penetration grows linearly from 0 where they cross. Both sides together
// push with F = k d^2 / (2 sin(th/2)) per unit depth: 5.7369, 1.9319,
// 1.3066, 1.0000, 0.8213 for 10, 30, 45, 60, 75 degrees.
//
// Hinge: two squares of side 1 share an edge and overlap by the angle th. On the bisecting plane
// the penetration is 2 u tan(th/2) for 0 < u < cos(th/2) = L: volume tan(th/2) L^2, centre of
// pressure at u = 2/3 L.
#include "contact/geometry/common_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "contact/geometry/bilinear_weights.hpp"

namespace brunt {
namespace {

FacePlane<3> face(const std::vector<Vec3>& corners) {
  FacePlane<3> plane;
  plane.n_corners = static_cast<int>(corners.size());
  plane.corner[3].setZero();
  for (std::size_t c = 0; c < corners.size(); ++c) plane.corner[c] = corners[c];
  refresh(plane);
  return plane;
}

FacePlane<2> edge(const Vec<2>& a, const Vec<2>& b) {
  FacePlane<2> plane;
  plane.corner = {a, b};
  refresh(plane);
  return plane;
}

const Section k3d{Geometry::three_d, 1};
const Section kPlane{Geometry::plane_strain, 1};
constexpr std::array<std::pair<Real, Real>, 5> kWedge = {
    {{10, 5.7369}, {30, 1.9319}, {45, 1.3066}, {60, 1.0000}, {75, 0.8213}}};

TEST(CommonPlane, WedgeInTwoDimensions) {
  const Real d = 0.01;
  for (const auto& [degrees, printed] : kWedge) {
    const Real th = degrees * kPi / 180;
    const Vec<2> tip(0, -d), side(std::cos(th), std::sin(th)), other(-side[0], side[1]);
    const auto floor = edge(Vec<2>(10, 0), Vec<2>(-10, 0));
    Planes<2> plane;
    Real up = 0;
    ASSERT_EQ(common_planes<2>(floor, edge(tip, tip + side), kPlane, plane), 1);
    up += plane[0].volume * plane[0].normal[1];
    ASSERT_EQ(common_planes<2>(floor, edge(tip + other, tip), kPlane, plane), 1);
    up += plane[0].volume * plane[0].normal[1];
    const Real exact = 1 / (2 * std::sin(th / 2));
    EXPECT_NEAR(up / (d * d) / exact, 1, 1e-12) << degrees;
    EXPECT_NEAR(up / (d * d), printed, 5e-5) << degrees;  // four printed decimals
  }
}

TEST(CommonPlane, WedgeInThreeDimensions) {
  const Real d = 0.01;
  for (const auto& [degrees, printed] : kWedge) {
    const Real th = degrees * kPi / 180;
    const Vec3 tip(0, 0, -d), side(std::cos(th), 0, std::sin(th)), along(0, 1, 0);
    const auto floor = face({{-10, -1, 0}, {10, -1, 0}, {10, 2, 0}, {-10, 2, 0}});
    const auto right = face({tip, tip + along, tip + side + along, tip + side});
    Planes<3> plane;
    ASSERT_EQ(common_planes<3>(floor, right, k3d, plane), 1);
    const Real up = 2 * plane[0].volume * plane[0].normal[2];
    EXPECT_NEAR(up / (d * d) * (2 * std::sin(th / 2)), 1, 1e-12) << degrees << " " << printed;
  }
}

TEST(CommonPlane, LinearPressureHasItsCentreAtTwoThirds) {
  const Real th = 0.1, length = std::cos(th / 2);
  const Vec3 turned(std::cos(th), 0, -std::sin(th)), along(0, 1, 0), zero = Vec3::Zero();
  const auto lower = face({zero, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  const auto upper = face({zero, along, turned + along, turned});
  Planes<3> plane;
  ASSERT_EQ(common_planes<3>(lower, upper, k3d, plane), 1);
  EXPECT_NEAR(plane[0].volume, std::tan(th / 2) * length * length, 1e-13);
  const Vec3 bisector(std::cos(th / 2), 0, -std::sin(th / 2));
  EXPECT_NEAR(plane[0].point.dot(bisector), 2.0 / 3 * length, 1e-12);
  EXPECT_NEAR(plane[0].point[1], 0.5, 1e-12);

  const Vec<2> end(std::cos(th), -std::sin(th)), corner = Vec<2>::Zero();
  Planes<2> line;
  ASSERT_EQ(common_planes<2>(edge(Vec<2>(1, 0), corner), edge(corner, end), kPlane, line), 1);
  EXPECT_NEAR(line[0].volume, std::tan(th / 2) * length * length, 1e-13);
  EXPECT_NEAR(line[0].point.dot(Vec<2>(bisector[0], bisector[2])), 2.0 / 3 * length, 1e-12);
}

TEST(CommonPlane, RingOfAnAxisymmetricDeckIsWeightedByItsRadius) {
  // Constant penetration d over 1 < r < 3: volume 2 pi d (9 - 1)/2, centre at (27 - 1)/3 / 4.
  const Section ring{Geometry::axisymmetric, 1};
  Planes<2> line;
  const Real d = 0.01;
  ASSERT_EQ(common_planes<2>(edge(Vec<2>(3, d), Vec<2>(1, d)), edge(Vec<2>(1, 0), Vec<2>(3, 0)),
                             ring, line),
            1);
  EXPECT_NEAR(line[0].volume, 8 * kPi * d, 1e-13);
  EXPECT_NEAR(line[0].area, 8 * kPi, 1e-13);
  EXPECT_NEAR(line[0].point[0], 26.0 / 12, 1e-13);
}

TEST(CommonPlane, SubdivisionChangesNothing) {
  // The same planes, cut in n x n faces each way: force and moment are the same integrals.
  const Real th = 0.05;
  const auto lower_at = [](Real u, Real v) { return Vec3(u, v, 0); };
  const auto upper_at = [&](Real u, Real v) {
    return Vec3(0.3 + (u - 0.1) * std::cos(th), v + 0.2, (u - 0.1) * std::sin(th) - 0.01);
  };
  const auto total = [&](int n, int m, Vec3& force, Vec3& moment) {
    force.setZero(), moment.setZero();
    Planes<3> plane;
    for (int i = 0; i < n * n; ++i) {
      const Real u = i % n, v = i / n, h = 1.0 / n;
      const auto a = face({lower_at(u * h, v * h), lower_at((u + 1) * h, v * h),
                           lower_at((u + 1) * h, (v + 1) * h), lower_at(u * h, (v + 1) * h)});
      for (int j = 0; j < m * m; ++j) {
        const Real s = j % m, t = j / m, g = 1.0 / m;
        const auto b = face({upper_at(s * g, t * g), upper_at(s * g, (t + 1) * g),
                             upper_at((s + 1) * g, (t + 1) * g), upper_at((s + 1) * g, t * g)});
        if (!common_planes<3>(a, b, k3d, plane)) continue;
        const Vec3 f = plane[0].volume * plane[0].normal;
        force += f;
        moment += plane[0].point.cross(f);
      }
    }
  };
  Vec3 force, moment, force_n, moment_n;
  total(1, 1, force, moment);
  ASSERT_GT(force[2], 1e-4);
  for (const auto& [n, m] : {std::pair(2, 1), {1, 3}, {4, 3}, {7, 5}}) {
    total(n, m, force_n, moment_n);
    EXPECT_LT((force_n - force).norm(), 1e-12 * force.norm());
    EXPECT_LT((moment_n - moment).norm(), 1e-12 * force.norm());
  }
}

TEST(CommonPlane, MomentumOfRandomWarpedPairs) {
  // Shares of the force at the corners: sum 0 and moment 0, to the round-off of eight products.
  std::mt19937_64 random(1);
  std::normal_distribution<Real> noise(0, 0.08), off_plane(0, 0.16);
  const std::array<Vec3, 4> base = {Vec3(-.5, -.5, 0), {.5, -.5, 0}, {.5, .5, 0}, {-.5, .5, 0}};
  int carried = 0, split_faces = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<Vec3> a, b;
    for (std::size_t c = 0; c < 4; ++c) {
      a.push_back(base[c] + Vec3(noise(random), noise(random), off_plane(random)));
      b.push_back(base[3 - c] + Vec3(noise(random), noise(random), off_plane(random)) +
                  Vec3(.2, .1, -.05));
    }
    if (trial % 3 == 0) a.pop_back();
    const auto lower = face(a), upper = face(b);
    split_faces += upper.simple ? 0 : 1;
    Planes<3> plane;
    const int n = common_planes<3>(lower, upper, k3d, plane);
    for (int i = 0; i < n; ++i) {
      const auto& one = plane[static_cast<std::size_t>(i)];
      Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
      for (std::size_t c = 0; c < 4; ++c) {
        force += (one.upper_weight[c] - one.lower_weight[c]) * one.normal;
        moment += one.upper_weight[c] * upper.corner[c].cross(one.normal);
        if (c < a.size()) moment -= one.lower_weight[c] * lower.corner[c].cross(one.normal);
      }
      EXPECT_LT(force.norm(), 1e-14);
      EXPECT_LT(moment.norm(), 1e-14);
      ++carried;
    }
  }
  EXPECT_GT(carried, 2000);
  EXPECT_GT(split_faces, 200);
}

TEST(CommonPlane, MomentumOfRandomEdges) {
  std::mt19937_64 random(2);
  std::normal_distribution<Real> noise(0, 0.15);
  int carried = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const auto jitter = [&] { return Vec<2>(noise(random), noise(random)); };
    const auto lower = edge(Vec<2>(.5, 0) + jitter(), Vec<2>(-.5, 0) + jitter());
    const auto upper = edge(Vec<2>(-.3, -.05) + jitter(), Vec<2>(.7, -.05) + jitter());
    Planes<2> plane;
    if (!common_planes<2>(lower, upper, kPlane, plane)) continue;
    Vec<2> force = Vec<2>::Zero();
    Real moment = 0;
    const auto add = [&](const FacePlane<2>& on, const std::array<Real, 2>& weight, Real sign) {
      for (std::size_t c = 0; c < 2; ++c) {
        const Vec<2> f = sign * weight[c] * plane[0].normal;
        force += f;
        moment += on.corner[c][0] * f[1] - on.corner[c][1] * f[0];
      }
    };
    add(upper, plane[0].upper_weight, 1);
    add(lower, plane[0].lower_weight, -1);
    EXPECT_LT(force.norm(), 1e-14);
    EXPECT_LT(std::fabs(moment), 1e-14);
    ++carried;
  }
  EXPECT_GT(carried, 1000);
}

// A face 1 m wide that leans by 0.1, its middle 0.02 deep: over the whole overlap k A g of the
// middle, though a part of it is open, where the integral has more: (0.07^2/2)/0.1 of a metre.
TEST(CommonPlane, AtAPointThePressureIsThatOfTheMiddle) {
  const Real lean = std::atan(0.1), half = 0.5 * std::cos(lean), rise = 0.5 * std::sin(lean);
  const auto lower = face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  const auto upper = face({{-half, -.5, -rise - .02},
                           {-half, .5, -rise - .02},
                           {half, .5, rise - .02},
                           {half, -.5, rise - .02}});
  Planes<3> plane;
  ASSERT_EQ(common_planes<3>(lower, upper, k3d, plane), 1);
  const Real integral = plane[0].volume;
  ASSERT_EQ(common_planes<3>(lower, upper, k3d, plane, {.at_point = true}), 1);
  const Real c = std::cos(0.5 * lean);
  EXPECT_NEAR(plane[0].penetration, 0.02 / c, 1e-3 * 0.02);
  EXPECT_NEAR(plane[0].volume, plane[0].area * plane[0].penetration, 1e-15);
  EXPECT_NEAR(plane[0].area, c, 1e-12);
  EXPECT_EQ(plane[0].share, 0);
  EXPECT_NEAR(integral / plane[0].volume, 0.07 * 0.07 / 2 / 0.1 / 0.02, 0.01);
  auto open = upper;
  for (auto& x : open.corner) x[2] += 0.03;
  refresh(open);
  EXPECT_EQ(common_planes<3>(lower, open, k3d, plane), 1);
  EXPECT_EQ(common_planes<3>(lower, open, k3d, plane, {.at_point = true}), 0);
  // In the plane the same.
  Planes<2> line;
  const auto below = edge(Vec<2>(2, 0), Vec<2>(-2, 0));
  const auto above = edge(Vec<2>(-half, -rise - .02), Vec<2>(half, rise - .02));
  ASSERT_EQ(common_planes<2>(below, above, kPlane, line, {.at_point = true}), 1);
  EXPECT_NEAR(line[0].volume / kPlane.depth, line[0].penetration * c, 1e-12);
}

// A plate's face whose corner is drawn out before a point, and the flank of the point beside it:
// with two triangles along a diagonal the flank was 0.04 mm deep, and 0.55 mm once the other
// diagonal was the shorter by enough (decks/perforation with elements of 2 mm and facets of 1 mm).
TEST(CommonPlane, AWarpedFaceIsContinuousInItsCorners) {
  const auto flank = face({{6.536, 1.132, -1.559},
                           {6.536, 1.559, -1.132},
                           {7.479, 1.248, -0.907},
                           {7.479, 0.907, -1.248}});
  constexpr int kSteps = 600;
  std::vector<Real> volume;
  for (int i = 0; i <= kSteps; ++i) {
    const auto drawn = face({{4.061, 2.638, -2.639},
                             {4.627, -0.270, -3.178},
                             {9.6 + 0.001 * i, 0, 0},
                             {4.626, 3.183, 0.274}});
    ASSERT_FALSE(drawn.simple);
    Planes<3> planes;
    const int n = common_planes<3>(drawn, flank, k3d, planes);
    volume.push_back(0);
    for (int k = 0; k < n; ++k) volume.back() += planes[static_cast<std::size_t>(k)].volume;
  }
  const auto [least, most] = std::minmax_element(volume.begin(), volume.end());
  ASSERT_GT(*most, 0.01);
  for (std::size_t i = 1; i < volume.size(); ++i) {
    EXPECT_LT(std::fabs(volume[i] - volume[i - 1]), 5 * (*most - *least) / kSteps) << i;
  }
}

/// The largest change of the energy that a face 1 m wide holds on a plate, its mean plane 2 mm
/// deep, in a thousandth of a warp of 0 to 0.2 m, over what it holds in the end.
Real largest_jump(bool rigid) {
  auto plate = face({{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}});
  plate.rigid = rigid;
  Real last = 0, jump = 0;
  for (int i = 0; i <= 1000; ++i) {
    const Real w = 2e-4 * i, z = -2e-3;
    const auto warped =
        face({{-.5, -.5, z + w}, {-.5, .5, z - w}, {.5, .5, z + w}, {.5, -.5, z - w}});
    Planes<3> planes;
    const int n = common_planes<3>(plate, warped, k3d, planes);
    Real energy = 0;
    for (int k = 0; k < n; ++k) energy += planes[static_cast<std::size_t>(k)].energy;
    if (i > 0) jump = std::max(jump, std::fabs(energy - last));
    last = energy;
  }
  return jump / last;
}

// Four triangles hold more than their mean plane, by the square of the warp. Where what they lie on
// deforms, a face is split at a warp of 12 %; on what is rigid where there is no difference yet.
TEST(CommonPlane, AFaceThatWarpsOnARigidOneHoldsNoMoreAtOnce) {
  EXPECT_LT(largest_jump(true), 3e-3);
  EXPECT_GT(largest_jump(false), 0.1);
}

TEST(CommonPlane, TouchingOrAlikeFacesCarryNothing) {
  Planes<3> plane;
  const Real z = 0.1 + 0.2;
  const auto lower = face({{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}});
  const auto upper = face({{0, 0, 0.3}, {0, 1, 0.3}, {1, 1, 0.3}, {1, 0, 0.3}});
  EXPECT_EQ(common_planes<3>(lower, upper, k3d, plane), 0);  // apart by one rounding
  EXPECT_EQ(common_planes<3>(upper, lower, k3d, plane), 0);
  EXPECT_EQ(common_planes<3>(lower, lower, k3d, plane), 0);
}

TEST(CommonPlane, RampFadesWhereFacesStopOpposing) {
  // -n1.n2 = cos(angle): half way between 0.09 and 0.17 the ramp is one half.
  Planes<2> plane;
  const auto ramp = [&](Real cosine) {
    const Real angle = std::acos(cosine);
    const Vec<2> tip(0, -0.1), side(std::cos(angle), std::sin(angle));
    const int n =
        common_planes<2>(edge(Vec<2>(5, 0), Vec<2>(-5, 0)), edge(tip, tip + side), kPlane, plane);
    return n ? plane[0].ramp : 0.0;
  };
  EXPECT_EQ(ramp(0.0899), 0);
  EXPECT_NEAR(ramp(0.13), 0.5, 1e-12);
  EXPECT_EQ(ramp(0.1701), 1);
}

// Two quads at two points side by side: the bits of each alone.
TEST(CommonPlane, BilinearWeightsSideBySideAreThoseOfEach) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> u(-0.2, 0.2);
  for (int i = 0; i < 1000; ++i) {
    std::array<Polygon, 2> quad;
    std::array<Vec<2>, 2> p;
    for (std::size_t k = 0; k < 2; ++k) {
      for (const auto& x : {Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(1, 1), Vec<2>(0, 1)}) {
        quad[k].push(x + Vec<2>(u(random), u(random)));
      }
      p[k] = Vec<2>(0.5 + 2 * u(random), 0.5 + 2 * u(random));
    }
    const auto together = bilinear_weights(quad[0], quad[1], p[0], p[1]);
    for (std::size_t k = 0; k < 4; ++k) {
      const Polygon& of = quad[k % 2];
      auto alone = bilinear_weights({of[0], of[1], of[2], of[3]}, p[k / 2]);
      if (k % 2 == 1) std::reverse(alone.begin(), alone.end());
      EXPECT_EQ(together[k], alone);
    }
  }
}

TEST(CommonPlane, BilinearWeightsAreExactAndNotNegative) {
  const std::array<Vec<2>, 4> quad = {Vec<2>(0, 0), {2, 0.1}, {1.4, 1}, {-0.3, 1.2}};
  for (const auto& [xi, eta] : {std::pair(0.3, -0.7), {-1.0, 1.0}, {0.999, 0.1}, {0.0, 0.0}}) {
    const std::array<Real, 4> exact = {.25 * (1 - xi) * (1 - eta), .25 * (1 + xi) * (1 - eta),
                                       .25 * (1 + xi) * (1 + eta), .25 * (1 - xi) * (1 + eta)};
    Vec<2> p = Vec<2>::Zero();
    for (std::size_t a = 0; a < 4; ++a) p += exact[a] * quad[a];
    const auto weight = bilinear_weights(quad, p);
    for (std::size_t a = 0; a < 4; ++a) {
      EXPECT_NEAR(weight[a], exact[a], 1e-14);
      EXPECT_GE(weight[a], -1e-15);
    }
  }
}

}  // namespace
}  // namespace brunt
