// Faces that go through each other where they do not oppose each other are reported. Two sheets at
// right angles, one upright through the other: it reaches `deep` behind the other's plane, the
// other half its width behind the upright one's, and both share a line as long as the narrower is
// wide. The least of the three is the depth.
#include "contact/geometry/crossing.hpp"

#include <gtest/gtest.h>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr Real kDepth = 0.1;  // [m] at which faces let go

std::vector<Vec<2>> lying(Real width, Vec<2>) { return {{width, 0}, {-width, 0}}; }
std::vector<Vec<3>> lying(Real width, Vec<3>) {
  return {{-width, -width, 0}, {width, -width, 0}, {width, width, 0}, {-width, width, 0}};
}
/// Normal along x, 0.4 m high (and wide), `deep` below the other.
std::vector<Vec<2>> upright(Real deep, Vec<2>) { return {{0, -deep}, {0, 0.4 - deep}}; }
std::vector<Vec<3>> upright(Real deep, Vec<3>) {
  return {{0, -0.2, -deep}, {0, 0.2, -deep}, {0, 0.2, 0.4 - deep}, {0, -0.2, 0.4 - deep}};
}

template <int Dim>
FacePlane<Dim> plane_of(const std::vector<Vec<Dim>>& corners) {
  FacePlane<Dim> plane;
  std::copy(corners.begin(), corners.end(), plane.corner.begin());
  refresh(plane);
  return plane;
}

template <int Dim>
void expect_crossings() {
  const auto below = plane_of<Dim>(lying(1, Vec<Dim>()));
  Crossing<Dim> found;
  const auto crosses = [&](Real deep) {
    const auto above = plane_of<Dim>(upright(deep, Vec<Dim>()));
    return find_crossing<Dim>(below, above, kDepth, found) &&
           find_crossing<Dim>(above, below, kDepth, found);
  };
  EXPECT_FALSE(crosses(-0.01)) << "above it";
  EXPECT_FALSE(crosses(0.09)) << "no deeper than contacts are held";
  ASSERT_TRUE(crosses(0.15));
  EXPECT_NEAR(found.depth, 0.15, 1e-15);
  EXPECT_NEAR(found.point.norm(), 0, 1e-15);
  ASSERT_TRUE(crosses(0.25));
  EXPECT_NEAR(found.depth, 0.25, 1e-15);
  EXPECT_FALSE(crosses(0.41)) << "wholly behind it";
  const auto beside = plane_of<Dim>(upright(0.2, Vec<Dim>()));
  EXPECT_FALSE(find_crossing<Dim>(plane_of<Dim>(lying(0.09, Vec<Dim>())), beside, kDepth, found))
      << "as deep, but near a border of the other";
}

TEST(Crossing, IsAsDeepAsBothFacesReachBehindEachOther) {
  expect_crossings<2>();
  expect_crossings<3>();
}

TEST(Crossing, SharesALine) {
  // Beside the other face, whose plane it goes through: no line in common.
  auto corners = upright(0.2, Vec<3>());
  for (auto& x : corners) x[1] += 1.3;
  Crossing<3> found;
  const auto below = plane_of<3>(lying(1, Vec<3>()));
  EXPECT_FALSE(find_crossing<3>(below, plane_of<3>(corners), kDepth, found));
  for (auto& x : corners) x[1] -= 0.25;  // 0.15 m of it over the border: y = 0.85 to 1
  ASSERT_TRUE(find_crossing<3>(below, plane_of<3>(corners), kDepth, found));
  EXPECT_NEAR(found.depth, 0.15, 1e-15);
  EXPECT_NEAR(found.point[1], 0.925, 1e-15);
}

/// The upright sheet, held beside nothing, goes down by 7 mm a step; its faces see no other.
template <int Dim>
void expect_told() {
  constexpr Real kStep = 1e-3, kDown = 0.007;
  ContactScene<Dim> scene;
  scene.add_face(scene.add_group(), lying(1, Vec<Dim>()), 1e5, kDepth, 1);
  scene.add_face(scene.add_group(), upright(0, Vec<Dim>()), 1e5, kDepth, 1);
  scene.start();
  auto& p = scene.groups[1].points;
  for (int step = 1; step <= 20; ++step) {
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      p.v[i] = Vec<Dim>::Unit(Dim - 1) * (-kDown / kStep);
      p.x[i][Dim - 1] -= kDown;
    }
    scene.contact->add_forces(kStep, step * kStep);
    EXPECT_EQ(scene.contact->reports().at(0).planes, 0);
    const auto pairs = scene.contact->lost_pairs();
    // 14 steps, 98 mm: not yet.
    ASSERT_EQ(pairs.size(), step < 15 ? 0u : 1u) << step;
    if (step < 15) continue;
    const LostReport& lost = pairs.at(0).lost;
    EXPECT_EQ(lost.crossed, 1);
    EXPECT_EQ(lost.key.ordinal, kCrossed);
    EXPECT_EQ(lost.time, 15 * kStep) << "the first";
    EXPECT_NEAR(lost.depth, 15 * kDown, 1e-14);
  }
}

TEST(Crossing, IsToldOnceWithItsPlaceAndTime) {
  expect_told<2>();
  expect_told<3>();
}

}  // namespace
}  // namespace brunt
