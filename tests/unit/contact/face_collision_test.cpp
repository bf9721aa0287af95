// Faces on faces of unequal mass and stiffness: two free faces of 1 m^2 (of 1 m in
// the plane) meet flat, m1 and m2 behind them, on the spring k = phi S1 S2 / (S1 + S2) of their
// area. Nothing acts from outside, so that the centre of mass goes on, and their speed to each
// other comes back by e: 1 without damping. With zeta of critical of the reduced mass they part
// where spring and damper together would pull, at tan(p) = -2 zeta r / (1 - 2 zeta^2), r^2 = 1 -
// zeta^2, p = pi - atan(2 zeta r / (1 - 2 zeta^2)) of their swing, by e = exp(-zeta p / r), for all
// masses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "contact/law/springs.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

std::vector<Vec3> face(bool up, Real z, Vec3) {
  std::vector<Vec3> corners = {{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}};
  if (!up) std::reverse(corners.begin(), corners.end());
  return corners;
}
std::vector<Vec<2>> face(bool up, Real y, Vec<2>) {
  if (up) return {{1, y}, {0, y}};
  return {{0, y}, {1, y}};
}

template <int Dim>
void add(ContactScene<Dim>& scene, bool up, Real height, Real mass, Real stiffness) {
  const auto corners = face(up, height, Vec<Dim>());
  auto& facet = scene.add_face(scene.add_group(), corners, stiffness, 1,
                               mass / static_cast<Real>(corners.size()));
  facet.areal_mass = mass;
}

template <int Dim>
void check(Real mass, Real stiffness, Real zeta) {
  constexpr Real kPhi = 0.5, kSpeed = 0.01;
  ContactScene<Dim> scene;
  scene.options.fallback = {false, kPhi, zeta, {}};
  const Real reduced = mass / (1 + mass), k = kPhi * in_series(1.0, stiffness);
  const Real omega = std::sqrt(k / reduced);
  // A face allows what its own spring alone allows, sqrt(2 m''/S), whatever it touches.
  const Real own = std::sqrt(std::min(1.0, mass / stiffness)), dt = std::min(0.01 / omega, own);
  const Real v = kSpeed * omega;  // to a depth of 1 % of the elements
  add(scene, true, 0, 1, 1);
  add(scene, false, 0.37 * v * dt, mass, stiffness);
  for (auto& corner : scene.groups[1].points.v) corner[Dim - 1] = -v;
  scene.start();
  for (Real time = 0; time < 4 / omega; time += dt) {
    scene.step(dt);
    ASSERT_GE(scene.contact->stable_step().step, dt);
  }
  ASSERT_EQ(scene.force(1).norm(), 0);
  const Real root = std::sqrt(1 - zeta * zeta);
  const Real e =
      std::exp(-zeta / root * (kPi - std::atan(2 * zeta * root / (1 - 2 * zeta * zeta))));
  const Real center = -mass / (1 + mass) * v;
  // To 1 % of v: the contact begins and ends between two steps, and damps half a step late.
  for (const auto& corner : scene.groups[0].points.v) {
    EXPECT_NEAR(corner[Dim - 1], center - e * mass / (1 + mass) * v, 0.01 * v);
    EXPECT_LT(corner.head(Dim - 1).norm(), 1e-12 * v);
  }
  for (const auto& corner : scene.groups[1].points.v) {
    EXPECT_NEAR(corner[Dim - 1], center + e / (1 + mass) * v, 0.01 * v);
  }
}

TEST(FaceCollision, ReturnsWhatTheReducedMassSays) {
  for (const Real mass : {1e-6, 1.0, 1e6}) {
    for (const Real stiffness : {1e-6, 1.0, 1e6}) {
      for (const Real zeta : {0.0, 0.1}) {
        SCOPED_TRACE(std::to_string(mass) + " kg, " + std::to_string(stiffness) + " Pa/m, " +
                     std::to_string(zeta));
        check<2>(mass, stiffness, zeta);
        check<3>(mass, stiffness, zeta);
      }
    }
  }
}

}  // namespace
}  // namespace brunt
