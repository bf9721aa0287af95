// Bounds on the step from the springs of all faces of a free rigid body, and the mass that it shows
// to a particle.
#include "contact/surfaces/own_springs.hpp"

#include <gtest/gtest.h>

#include "contact/law/springs.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr Real kStiffness = 4e9;    // [Pa/m]
constexpr Real kCompliance = 1e-3;  // [1/kg]

std::vector<Vec3> square(Real z, Real half, bool up) {
  if (up) return {{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  return {{-half, half, z}, {half, half, z}, {half, -half, z}, {-half, -half, z}};
}

/// A held floor, and a body of two faces of 4 m^2 that gives way by the same compliance everywhere.
ContactScene<3> two_faces(Real damping) {
  ContactScene<3> scene;
  scene.options.fallback.stiffness = 0.5;
  scene.options.fallback.damping = damping;
  scene.add_face(scene.add_group(), square(0, 4, true), 0, 0, 0);
  auto& body = scene.add_group();
  for (const Real z : {3.0, 5.0}) {
    auto& face = scene.add_face(body, square(z, 1, z > 4), kStiffness, 0.5, 0);
    face.compliance = kCompliance;
  }
  return scene;
}

// omega^2 = sum of phi k A c over both faces, though they cannot touch anything at once:
// 2 x 0.5 x 4e9 x 4 x 1e-3 = 1.6e7 1/s^2.
TEST(OwnSprings, BoundAFreeBodyByAllItsFaces) {
  auto scene = two_faces(0);
  EXPECT_NEAR(scene.start().stable_step().step, 2 / std::sqrt(1.6e7), 1e-15);
  EXPECT_EQ(scene.contact->stable_step().body, 1u);
}

// Dampers of 2 zeta sqrt(phi k m''), m'' = 1000 x 0.5/2 kg/m^2, on the same areas:
// sum c A/m = 2 x 2 x 0.1 sqrt(0.5 x 4e9 x 250) x 4 x 1e-3 = 2 zeta' omega.
TEST(OwnSprings, DampersShortenTheStep) {
  auto scene = two_faces(0.1);
  const Real omega = std::sqrt(1.6e7);
  const Real zeta = 0.4 * std::sqrt(0.5 * kStiffness * 250) * 4 * kCompliance / (2 * omega);
  EXPECT_NEAR(scene.start().stable_step().step, 2 / omega * lag_factor(zeta), 1e-15);
}

/// A plate of 4 m^2 that deforms, M/h = kPlate and m'' = 1000 x 0.5/2 kg/m^2, beside a body of two
/// faces of 4 m^2 and nothing else.
ContactScene<3> beside_a_plate(Real compliance) {
  constexpr Real kPlate = 1e9;  // [Pa/m]
  ContactScene<3> scene;
  scene.options.fallback.stiffness = 0.5;
  scene.options.fallback.damping = 0;
  scene.add_face(scene.add_group(), square(0, 1, true), kPlate, 0.5, 0);
  auto& body = scene.add_group();
  for (const Real z : {1.0, 3.0}) {
    scene.add_face(body, square(z, 1, z > 2), kStiffness, 0.5, 0).compliance = compliance;
  }
  return scene;
}

// Beside what deforms alone a rigid body has that spring, not its own 4e9: omega^2 = 2 faces x
// 0.5 x 1e9 x 4 c. In the plate's own step, h/c = sqrt(2 m''/k) = 0.707e-3 s, r = omega^2 dt^2/4,
// 5e-4 for c = 1e-6: the plate's spring is stiffer by 1/(1 - r), and its step limit is the shorter
// one.
TEST(OwnSprings, ARigidBodyTakesTheSpringOfItsNeighbour) {
  const Real light = 1e-6, step = std::sqrt(2 * 250.0 / 1e9);
  const Real r = 2 * 0.5 * 1e9 * 4 * light * step * step / 4;
  auto scene = beside_a_plate(light);
  EXPECT_NEAR(scene.start().stable_step().step, step * surface_step_ratio(0.5 / (1 - r), 0),
              1e-12 * step);
}

// A light one, r > 1/4, bounds the step itself, for sqrt(1/4) of 2/omega: then r is 1/4, and the
// highest frequency^2 of plate and body together at most that of the plate on a spring of 4/3 phi.
TEST(OwnSprings, ALightRigidBodyLeavesRoom) {
  const Real light = 1e-2;
  auto scene = beside_a_plate(light);
  const Real omega = std::sqrt(2 * 0.5 * 1e9 * 4 * light);
  EXPECT_NEAR(scene.start().stable_step().step, std::sqrt(kMostRecoil) * 2 / omega, 1e-12);
}

// A particle of 2 kg that presses on such a face: its damper is 2 zeta sqrt(k m) of the mass that
// both show, 1/(1/2 + c), and k = phi times its own M d = 1e6 N/m: the rigid side takes that.
TEST(OwnSprings, AParticleMeetsTheMassBehindTheFace) {
  constexpr Real kLight = 0.5;  // [1/kg]
  auto scene = two_faces(0.1);
  for (auto& face : scene.groups[1].surface.facets) face.compliance = kLight;
  auto& cloud = scene.add_group();
  scene.add_particle(cloud, Vec3(0.2, 0.1, 5.04), 0.05, 1e7, 2);
  cloud.points.v[0] = Vec3(0, 0, -3);
  scene.start();
  scene.evaluate();
  const Real k = 0.5 * 1e6;
  const Real damper = 2 * 0.1 * std::sqrt(k / (1.0 / 2 + kLight));
  EXPECT_NEAR(scene.force(2)[2], k * 0.01 + damper * 3, 1e-9 * k);
}

}  // namespace
}  // namespace brunt
