// Blades that cross push each other along e_l x e_u. Two upright sheets stand for the sides of
// blades: the lower with its edge along z at y = 0, the upper with its edge along x at y = -d, in
// the lower by d. Their weight is a quarter, of the four pairs of sides of two blades.
//
// The force is minus the gradient of U, which a motion of both faces as one does not change: so it
// has no resultant and no moment, and keeps energy. Central differences of a step h err by h^2.
#include "contact/geometry/edge_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/evaluate/edges.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using Corners = std::vector<Vec3>;
constexpr std::uint8_t kTopBlade = 0b00010001, kTopBorder = 0b1;
constexpr Real kStiffening = 0.02;  // [m] g

/// 1 m x 1 m, edge 0 along z through the origin, the face below it; normal x.
Corners lower_corners() { return {{0, 0, 0.5}, {0, 0, -0.5}, {0, -1, -0.5}, {0, -1, 0.5}}; }
/// Edge 0 along x, the face above it; normal z.
Corners upper_corners(Real deep) {
  return {{-0.5, -deep, 0}, {0.5, -deep, 0}, {0.5, 1 - deep, 0}, {-0.5, 1 - deep, 0}};
}

FacePlane<3> face_of(const Corners& corners, std::uint8_t borders = kTopBlade) {
  FacePlane<3> face;
  std::copy(corners.begin(), corners.end(), face.corner.begin());
  face.borders = borders;
  refresh(face);
  return face;
}

bool find(const Corners& lower, const Corners& upper, EdgeContact& contact,
          std::uint8_t borders = kTopBlade) {
  Real overlap = 0;
  return find_edge_contact(face_of(lower, borders), 0, face_of(upper, borders), 0, {kStiffening},
                           overlap, contact);
}

Corners turned(Corners corners, const Vec3& axis, Real angle) {
  for (auto& x : corners) x = Eigen::AngleAxis<Real>(angle, axis.normalized()) * x;
  return corners;
}

TEST(EdgeContact, IsASpringAlongTheNormalOfBothEdges) {
  constexpr Real d = 0.01;
  EdgeContact contact;
  ASSERT_TRUE(find(lower_corners(), upper_corners(d), contact));
  EXPECT_NEAR((contact.normal - Vec3::UnitY()).norm(), 0, 1e-15);
  EXPECT_NEAR(contact.penetration, d, 1e-17);
  EXPECT_NEAR((contact.point - Vec3(0, -0.5 * d, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR(contact.share, 0.25, 1e-15);
  const Real ratio = d * d / (kStiffening * kStiffening);
  EXPECT_NEAR(contact.force, 0.25 * d * (1 + ratio), 1e-17);
  EXPECT_NEAR(contact.energy, 0.25 * d * d * (0.5 + 0.25 * ratio), 1e-19);
  for (const std::size_t k : {0, 1}) EXPECT_NEAR(contact.weight[k], -0.5, 1e-15);
  for (const std::size_t k : {4, 5}) EXPECT_NEAR(contact.weight[k], 0.5, 1e-15);
  for (const auto& push : contact.push) EXPECT_NEAR(push.norm(), 0, 1e-17);
}

// Blades that cross when they begin: only what they close again counts.
TEST(EdgeContact, TakesNoNoticeOfAnOverlapUntilItOpens) {
  EdgeContact contact;
  Real overlap = kInfinity;
  const auto at = [&](Real deep) {
    return find_edge_contact(face_of(lower_corners()), 0, face_of(upper_corners(deep)), 0,
                             {kStiffening}, overlap, contact);
  };
  EXPECT_FALSE(at(0.01));
  EXPECT_NEAR(overlap, 0.01, 1e-17);
  ASSERT_TRUE(at(0.015));
  EXPECT_NEAR(contact.penetration, 0.005, 1e-17);
  EXPECT_NEAR(contact.energy, 0.25 * 2.5e-5 * (0.5 + 6.25e-6 / (kStiffening * kStiffening)), 1e-17);
  EXPECT_FALSE(at(0.004));
  EXPECT_NEAR(overlap, 0.004, 1e-17);
  ASSERT_TRUE(at(0.015));
  EXPECT_NEAR(contact.penetration, 0.011, 1e-17);
  EXPECT_FALSE(at(-0.001));
  EXPECT_EQ(overlap, 0);
}

// Blades that have passed each other are seen from behind: they push no sooner than they have come
// back and meet again.
TEST(EdgeContact, TakesNoNoticeOfBladesThatHavePassed) {
  EdgeContact contact;
  Real overlap = 0;
  const auto at = [&](Real deep) {
    return find_edge_contact(face_of(lower_corners()), 0, face_of(upper_corners(deep)), 0,
                             {kStiffening, 0.02}, overlap, contact);
  };
  EXPECT_TRUE(at(0.0199));
  EXPECT_FALSE(at(0.0201));
  EXPECT_FALSE(at(0.015));
  EXPECT_NEAR(overlap, 0.015, 1e-17);
  ASSERT_TRUE(at(0.016));
  EXPECT_NEAR(contact.penetration, 0.001, 1e-17);
}

TEST(EdgeContact, IsNoneWhereTheyPartOrFacesOpposeEachOther) {
  EdgeContact contact;
  EXPECT_FALSE(find(lower_corners(), upper_corners(-0.01), contact)) << "apart";
  auto beside = upper_corners(0.01);
  for (auto& x : beside) x[0] += 0.6;
  EXPECT_FALSE(find(lower_corners(), beside, contact)) << "beside the end of the edge";
  const auto leaning = turned(lower_corners(), Vec3::UnitZ(), 0.25);  // sine 0.247
  EXPECT_FALSE(find(leaning, upper_corners(0.01), contact)) << "faces carry it";
  const auto along = turned(upper_corners(0.01), Vec3::UnitY(), 0.5 * kPi - 0.09);
  EXPECT_FALSE(find(lower_corners(), along, contact)) << "along each other";
  // Both bodies below their edges: neither is in the other's way, on whichever side it is ahead.
  for (const Real ahead : {-0.3, -0.01, 0.01, 0.3}) {
    const auto same = turned(upper_corners(ahead), Vec3::UnitX(), kPi);
    EXPECT_FALSE(find(lower_corners(), same, contact)) << "the same way " << ahead;
    EXPECT_FALSE(find(same, lower_corners(), contact)) << "the same way " << ahead;
  }
}

// A blade of two edges that meet at their corner, dented there by d/2, and another across: the
// lines of each edge pass the other's beyond the corner. They push all the same, at d as one
// straight edge would: each of the four pairs by E = 1/4, at s L = x = z = s d/(1 + 2 s^2) beyond
// its ends, which is next to nothing against the fade of g (first order: 3/2 x/g of E).
TEST(EdgeContact, HoldsDentedBladesAtTheirCorners) {
  constexpr Real d = 0.001, slope = 0.02;
  Real force = 0;
  for (const Real side : {-1.0, 1.0}) {
    auto lower = lower_corners();
    for (auto& x : lower) x[2] += 0.5 * side;
    for (auto& x : lower) x[1] += slope * std::fabs(x[2]);
    for (const Real other : {-1.0, 1.0}) {
      auto upper = upper_corners(d);
      for (auto& x : upper) x[0] += 0.5 * other;
      for (auto& x : upper) x[1] -= slope * std::fabs(x[0]);
      EdgeContact contact;
      ASSERT_TRUE(find(lower, upper, contact));
      force += contact.force * contact.normal[1];
    }
  }
  const Real beyond = 1.5 * slope * d / kStiffening;  // of E, at each of two edges
  EXPECT_NEAR(force, 0.25 * d, 0.25 * d * (2 * beyond + 2 * slope * slope + 0.003));
}

/// U by place of one corner's coordinate.
Real energy_at(Corners lower, Corners upper, std::size_t k, int c, Real by, std::uint8_t borders) {
  (k < 4 ? lower[k] : upper[k - 4])[c] += by;
  EdgeContact contact;
  return find(lower, upper, contact, borders) ? contact.energy : 0.0;
}

TEST(EdgeContact, KeepsEnergyAndBothMomenta) {
  constexpr Real h = 1e-6, d = 0.01;
  std::mt19937_64 random(1);
  const auto number = [&](Real by) {
    return by * (2 * static_cast<Real>(random() >> 11) * 0x1p-53 - 1);
  };
  int blended = 0;
  for (int n = 0; n < 200; ++n) {
    // Leaning and turned so that each factor of the weight fades now and then; ends that fade too.
    const bool ends = n % 2 == 1;
    const auto borders = static_cast<std::uint8_t>(ends ? 0b00011111 : kTopBlade);
    auto lower = turned(lower_corners(), Vec3::UnitZ(), number(0.22));
    auto upper = turned(upper_corners(d), Vec3::UnitX(), number(0.22));
    upper = turned(upper, Vec3::UnitY(), number(1.45));
    const Vec3 shift(ends ? 0.49 : number(0.3), 0, number(0.2));
    for (auto& x : upper) x += shift;
    for (auto* face : {&lower, &upper}) {
      for (auto& x : *face) x += Vec3(number(0.003), number(0.003), number(0.003));
    }
    EdgeContact contact;
    if (!find(lower, upper, contact, borders)) continue;
    blended += contact.share < 0.2499 ? 1 : 0;
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t k = 0; k < 8; ++k) {
      const Vec3 force = contact.weight[k] * contact.force * contact.normal + contact.push[k];
      sum += force;
      moment += (k < 4 ? lower[k] : upper[k - 4]).cross(force);
      for (int c = 0; c < 3; ++c) {
        const Real slope = (energy_at(lower, upper, k, c, h, borders) -
                            energy_at(lower, upper, k, c, -h, borders)) /
                           (2 * h);
        EXPECT_NEAR(force[c], -slope, 1e-6 * d) << n << ' ' << k << ' ' << c;
      }
    }
    EXPECT_LT(sum.norm(), 1e-15) << n;
    EXPECT_LT(moment.norm(), 1e-15) << n;
  }
  EXPECT_GT(blended, 20);
}

// A face that turns about its edge by u/height, its far corners moved by u, changes w alone, not
// the depth: U'' = U/w w''. That is at most what fade_curvature says with the largest w, 1/4, and
// comes near to it, as the curvature of a smooth step is largest at its ends. Central differences
// over 1e-4 m of 1 m, where w changes over 0.113: to 1 % and the rounding of U.
TEST(EdgeContact, FadesBendTheEnergyNoMoreThanTheirBound) {
  constexpr Real d = 0.015, h = 1e-4;
  Real closest = 0;
  for (int step = 0; step <= 80; ++step) {
    const Real angle = 0.1 + 0.002 * step;  // [rad] sines of 0.1 to 0.26
    const Corners lower = turned(lower_corners(), Vec3::UnitZ(), angle);
    const Vec3 across(std::cos(angle), std::sin(angle), 0);
    EdgeContact contact;
    const auto energy = [&](Real u) {
      Corners moved = lower;
      moved[2] += u * across, moved[3] += u * across;
      return find(moved, upper_corners(d), contact) ? contact.energy : 0.0;
    };
    const Real bent = (energy(h) - 2 * energy(0) + energy(-h)) / (h * h);
    const Real ratio = d * d / (kStiffening * kStiffening);
    if (!find(lower, upper_corners(d), contact)) continue;
    const Real bound = 0.25 * d * d * (0.5 + 0.25 * ratio) * contact.fade_curvature;
    const Real near_ends = 0.25 * d * d * (0.5 + 0.25 * ratio) * 6 / (0.113 * 0.113);
    EXPECT_LE(bent, 1.01 * std::max(bound, contact.fade_curvature > 0 ? 0 : near_ends) + 1e-9);
    if (bound > 0) closest = std::max(closest, bent / bound);
  }
  EXPECT_GT(closest, 0.7);
}

// Of blades of which only one side is there the manager makes one record: k l^2, with l = 0.1 m and
// k = phi M/h of both in series, acts on both edges.
TEST(EdgeContact, IsARecordOfItsPairOfFaces) {
  constexpr Real kLimit = 0.1, kModulus = 1e5, d = 0.002;
  for (const auto borders : {kTopBlade, kTopBorder}) {
    testing::ContactScene<3> scene;
    auto& low = scene.add_face(scene.add_group(), lower_corners(), kModulus, kLimit, 1);
    low.borders = borders;
    auto& high = scene.add_face(scene.add_group(), upper_corners(d), kModulus, kLimit, 1);
    high.borders = borders;
    scene.start();
    scene.evaluate();
    const auto report = scene.contact->reports().at(0);
    if (borders == kTopBorder) {
      EXPECT_EQ(report.planes, 0) << "no blades";
      continue;
    }
    EXPECT_EQ(report.planes, 1);
    const Real k = scene.options.fallback.stiffness * 0.5 * kModulus * kLimit * kLimit;
    const Real g = 0.5 * kLimit, force = 0.25 * k * d * (1 + d * d / (g * g));
    EXPECT_NEAR(scene.force(1)[1], force, 1e-12 * force);
    EXPECT_NEAR((scene.force(0) + scene.force(1)).norm(), 0, 1e-12 * force);
    EXPECT_NEAR(scene.totals().value(Column::contact_spring),
                0.25 * k * d * d * (0.5 + 0.25 * d * d / (g * g)), 1e-12 * force);
  }
}

}  // namespace
}  // namespace brunt
