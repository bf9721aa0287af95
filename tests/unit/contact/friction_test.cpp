// Friction of common planes. Two faces whose springs S = M/h are
// equal have k = phi S / 2 per area, along the normal and across it.
#include "contact/contacts/friction.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSide = 1e6;  // [Pa/m] S of each face
constexpr Real kSpring = 0.5 * kSide / 2;

Varying constant(Real value) {
  Varying varying;
  varying.constant = value;
  return varying;
}

/// Prescribes the motion of all points of a group and evaluates contact at the end of the step.
template <int Dim>
void drive(ContactScene<Dim>& scene, Real dt,
           const std::function<Vec<Dim>(std::size_t group, const Vec<Dim>& now)>& move) {
  for (std::size_t g = 0; g < scene.groups.size(); ++g) {
    auto& p = scene.groups[g].points;
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      const Vec<Dim> next = move(g, p.x[i]);
      p.v[i] = (next - p.x[i]) / dt;
      p.x[i] = next;
      p.f[i].setZero();
    }
  }
  scene.contact->add_forces(dt);
}

// Forces of a pair with friction have no resultant and no moment. A few hundred sums of
// forces of size F at arms of size 1 leave some 1e-15.
TEST(Friction, RandomWarpedPairsHaveNoMoment) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> u(-1, 1);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    ContactScene<3> scene;
    scene.options.fallback.coulomb.friction = constant(0.3 + 0.3 * u(random));
    for (const bool up : {true, false}) {
      std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
      if (!up) std::swap(corners[1], corners[3]);
      const Vec3 shift(0.3 * u(random), 0.3 * u(random), up ? 0.15 : 0);
      for (auto& x : corners) x += shift + 0.1 * Vec3(u(random), u(random), u(random));
      scene.add_face(scene.add_group(), corners, kSide, 1, 1);
      for (auto& v : scene.groups.back().points.v) v = Vec3(u(random), u(random), u(random));
    }
    scene.start();
    scene.contact->add_forces(1e-2);
    for (auto& group : scene.groups) {
      for (auto& f : group.points.f) f.setZero();
    }
    scene.contact->add_forces(1e-2);
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    Real size = 0;
    for (const auto& group : scene.groups) {
      for (std::size_t k = 0; k < 4; ++k) {
        force += group.points.f[k];
        moment += group.points.x[k].cross(group.points.f[k]);
        size += group.points.f[k].norm();
      }
    }
    if (size == 0) continue;
    ++touching;
    EXPECT_LT(force.norm(), 1e-14 * size);
    EXPECT_LT(moment.norm(), 1e-14 * size);
  }
  EXPECT_GT(touching, 1500);
}

TEST(Friction, RandomEdgesHaveNoMoment) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<Real> u(-1, 1);
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    ContactScene<2> scene;
    scene.options.fallback.coulomb.friction = constant(0.4);
    for (const bool up : {true, false}) {
      std::vector<Vec<2>> corners = {{up ? 1 : 0, up ? 0.1 : 0}, {up ? 0 : 1, up ? 0.1 : 0}};
      for (auto& x : corners) x += 0.1 * Vec<2>(u(random), u(random));
      scene.add_face(scene.add_group(), corners, kSide, 1, 1);
      for (auto& v : scene.groups.back().points.v) v = Vec<2>(u(random), u(random));
    }
    scene.start();
    scene.contact->add_forces(1e-2);
    Real moment = 0, size = 0;
    for (const auto& group : scene.groups) {
      for (std::size_t k = 0; k < 2; ++k) {
        const auto &x = group.points.x[k], &f = group.points.f[k];
        moment += x[0] * f[1] - x[1] * f[0];
        size += f.norm();
      }
    }
    if (size == 0) continue;
    ++touching;
    EXPECT_LT((scene.force(0) + scene.force(1)).norm(), 1e-14 * size);
    EXPECT_LT(std::fabs(moment), 1e-14 * size);
  }
  EXPECT_GT(touching, 1500);
}

/// Two sheets that press on each other by 0.01 over 1 m^2: N = k 0.01.
template <int Dim>
ContactScene<Dim> gripped(Real mu) {
  ContactScene<Dim> scene;
  scene.options.fallback.coulomb.friction = constant(mu);
  scene.options.fallback.damping = 0;
  add_sheet(scene, 2, 0, 1, 0.01, true, kSide, 1);
  add_sheet(scene, 3, 0, 1, 0, false, kSide, 1);
  scene.start();
  return scene;
}

// A pair that is sheared by 0.002 and then turned as one rigid body about an oblique axis,
// or flown at 1e4 m/s, keeps its forces in the frame of the bodies. Turns are exact but for
// rounding; at 1e4 m/s and 1e-3 s a displacement of 10 m has an error of 2e-15 m, against 2e-3 m of
// shear.
TEST(Friction, GrippedPairTurnsWithItsBodies) {
  auto scene = gripped<3>(0.5);
  drive<3>(scene, 1e-3, [](std::size_t group, const Vec3& x) {
    return Vec3(x + (group == 1 ? Vec3(0.002, 0.001, 0) : Vec3::Zero()));
  });
  const Vec3 before = scene.force(1);
  EXPECT_NEAR(before[0], -kSpring * 0.002 * 0.998 * 0.999, 1e-9 * kSpring);
  const Vec3 axis = Vec3(1, -2, 0.7).normalized();
  const Mat3 step = Eigen::AngleAxis<Real>(2 * kPi / 360, axis).toRotationMatrix();
  Mat3 total = Mat3::Identity();
  for (int i = 0; i < 360; ++i) {
    drive<3>(scene, 1e-3, [&](std::size_t, const Vec3& x) { return Vec3(step * x); });
    total = step * total;
    EXPECT_LT((total.transpose() * scene.force(1) - before).norm(), 1e-9 * before.norm()) << i;
  }
}

TEST(Friction, GrippedPairFliesUnchanged) {
  auto scene = gripped<3>(0.5);
  drive<3>(scene, 1e-3, [](std::size_t group, const Vec3& x) {
    return Vec3(x + (group == 1 ? Vec3(0.002, 0.001, 0) : Vec3::Zero()));
  });
  const Vec3 before = scene.force(1);
  for (int i = 0; i < 100; ++i) {
    drive<3>(scene, 1e-3, [&](std::size_t, const Vec3& x) { return Vec3(x + Vec3(10, -3, 2)); });
    EXPECT_LT((scene.force(1) - before).norm(), 1e-9 * before.norm()) << i;
  }
}

TEST(Friction, GrippedEdgesTurnWithTheirBodies) {
  auto scene = gripped<2>(0.5);
  drive<2>(scene, 1e-3, [](std::size_t group, const Vec<2>& x) {
    return Vec<2>(x + (group == 1 ? Vec<2>(0.002, 0) : Vec<2>::Zero()));
  });
  const Vec<2> before = scene.force(1);
  const Eigen::Rotation2D<Real> step(2 * kPi / 360);
  for (int i = 1; i <= 360; ++i) {
    drive<2>(scene, 1e-3, [&](std::size_t, const Vec<2>& x) { return Vec<2>(step * x); });
    const Vec<2> back = Eigen::Rotation2D<Real>(-2 * kPi / 360 * i) * scene.force(1);
    EXPECT_LT((back - before).norm(), 1e-9 * before.norm()) << i;
  }
}

// A slider one face long crosses 20 faces. With mu sigma / k = 0.1 h its friction is mu N
// from 0.1 h on; without inheritance it would dip by 2.5 % at each crossing.
template <int Dim>
void check_slider(bool slider_first) {
  const Real h = 0.05, depth = 0.01;
  ContactScene<Dim> scene;
  scene.options.fallback.coulomb.friction = constant(0.1 * h / depth);
  scene.options.fallback.damping = 0;
  const auto slider = [&] { add_sheet(scene, 1, 0.2 * h, h, 0, false, kSide, 1); };
  const auto table = [&] { add_sheet(scene, 22, 0, 22 * h, depth, true, kSide, 1); };
  const std::size_t moving = slider_first ? 0 : 1;
  if (slider_first) {
    slider();
    table();
  } else {
    table();
    slider();
  }
  scene.start();
  const Real area = Dim == 3 ? h * h : h, limit = 0.1 * h * kSpring * area;
  const Real step = 0.013 * h;
  for (Real way = 0; way < 20 * h; way += step) {
    drive<Dim>(scene, 1e-3, [&](std::size_t group, const Vec<Dim>& x) {
      return Vec<Dim>(x + (group == moving ? step : 0.0) * Vec<Dim>::Unit(0));
    });
    if (way < 0.11 * h) continue;
    EXPECT_NEAR(scene.force(moving)[0], -limit, 1e-10 * limit) << way / h;
  }
}

TEST(Friction, SliderDoesNotDipWhereFacesMeet) {
  for (const bool first : {true, false}) {
    check_slider<2>(first);
    check_slider<3>(first);
  }
}

// Shear to and fro by an amplitude a beyond the slip: each cycle dissipates 4 mu N (a -
// mu N / k), to the part of a step in which slip begins: k du^2 / 2 of each of four corners. All
// that motion loses is heat and store: what faces hand on to each other cancels, to rounding.
template <int Dim>
void check_cycle() {
  const Real mu = 0.3, normal = kSpring * 0.01, a = 0.01;
  ContactScene<Dim> scene;
  scene.options.fallback.coulomb.friction = constant(mu);
  scene.options.fallback.damping = 0;
  add_sheet(scene, 5, -0.5, 2, 0.01, true, kSide, 1);
  add_sheet(scene, 3, 0, 1, 0, false, kSide, 1);
  scene.start();
  // pressed: what the spring along the normal holds from the first step on, nobody's work.
  Real lost = 0, place = 0, pressed = 0;
  std::vector<Real> heat;
  const int steps = 4000;
  Vec<Dim> last = Vec<Dim>::Zero();
  for (int i = 1; i <= 2 * steps; ++i) {
    const Real next = a * std::sin(2 * kPi * i / steps);
    drive<Dim>(scene, 1e-3, [&](std::size_t group, const Vec<Dim>& x) {
      return Vec<Dim>(x + (group == 1 ? next - place : 0.0) * Vec<Dim>::Unit(0));
    });
    lost -= 0.5 * (last + scene.force(1))[0] * (next - place);
    last = scene.force(1);
    place = next;
    if (i == 1) pressed = scene.totals().value(Column::contact_pairs);
    if (i % steps == 0) heat.push_back(scene.totals().value(Column::contact_friction));
  }
  const Real cycle = heat[1] - heat[0], du = 2 * kPi * a / steps;
  EXPECT_NEAR(cycle, 4 * mu * normal * (a - mu * normal / kSpring), 2 * kSpring * du * du);
  const auto totals = scene.totals();
  const Real pairs = totals.value(Column::contact_pairs) - pressed;
  const Real stored = last.squaredNorm() > 0 ? 0.5 * last[0] * last[0] / kSpring : 0.0;
  EXPECT_LT(std::fabs(pairs), 1e-10 * cycle);
  EXPECT_NEAR(lost, heat[1] + stored, 1e-10 * cycle);
}

TEST(Friction, CyclicShearDissipatesItsLoop) {
  check_cycle<2>();
  check_cycle<3>();
}

}  // namespace
}  // namespace brunt
