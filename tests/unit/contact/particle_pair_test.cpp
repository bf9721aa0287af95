// Particles on particles of another body. Two of radius r and
// modulus M have springs M (2 r)^(Dim - 2) in series, so k = phi M (2 r)^(Dim - 2) / 2 where they
// are alike, of phi = 1 here; nearer than r, 200 phi M (2 r)^(Dim - 2) (d - r)^3 / r^2 besides.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

constexpr Real kRadius = 0.25, kOwn = 2e4;  // [m], [N/m]
constexpr Real kSpring = kOwn / 2;          // [N/m]

Varying constant(Real value) {
  Varying varying;
  varying.constant = value;
  return varying;
}

/// Bodies of one particle each; ids are those of the bodies.
template <int Dim>
void add_body(ContactScene<Dim>& scene, const Vec<Dim>& x, Real radius = kRadius, Real own = kOwn,
              Real mass = 1) {
  auto& group = scene.add_group();
  scene.add_particle(group, x, radius, own / std::pow(2 * radius, Dim - 2), mass);
  group.points.id.back() = scene.groups.size();
}

template <int Dim>
ContactScene<Dim> two(const Vec<Dim>& apart, Real zeta = 0, Real mu = 0, Real mass = 1) {
  ContactScene<Dim> scene;
  scene.options.fallback = {false, 1.0, zeta, constant(mu)};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  add_body<Dim>(scene, Vec<Dim>::Zero());
  add_body<Dim>(scene, apart, kRadius, kOwn, mass);
  scene.start();
  return scene;
}

// F = k d along the line of centres, whatever its direction, opposite to the last bit.
template <int Dim>
void check_spring() {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<Real> part(-1, 1), depth(0, kRadius);
  for (int i = 0; i < 100; ++i) {
    Vec<Dim> n;
    for (int c = 0; c < Dim; ++c) n[c] = part(random);
    n.normalize();
    const Real d = depth(random);
    auto scene = two<Dim>((2 * kRadius - d) * n);
    scene.evaluate();
    EXPECT_LT((scene.force(1) - kSpring * d * n).norm(), 1e-12 * kSpring * kRadius);
    EXPECT_EQ(scene.force(0), -scene.force(1));
  }
}

TEST(ParticlePair, ForceOfTheSpringIsAlongTheCentres) {
  check_spring<2>();
  check_spring<3>();
}

TEST(ParticlePair, SpringsAreInSeries) {
  ContactScene<3> scene;
  scene.options.fallback = {false, 0.5, 0, {}};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  add_body<3>(scene, Vec3::Zero(), 0.25, 3e4);
  add_body<3>(scene, Vec3(0.3, 0, 0), 0.1, 1e4);
  scene.start();
  scene.evaluate();
  const Real k = 0.5 * 3e4 * 1e4 / 4e4;
  EXPECT_NEAR(scene.force(1)[0], k * 0.05, 1e-10 * k);
}

TEST(ParticlePair, NothingActsBetweenThoseApartOrIgnored) {
  auto apart = two<3>(Vec3(2 * kRadius + 1e-9, 0, 0));
  apart.evaluate();
  EXPECT_EQ(apart.force(1), Vec3(Vec3::Zero()));
  auto ignored = two<3>(Vec3(kRadius, 0, 0));
  ignored.options.fallback.ignore = true;
  ignored.start();
  ignored.evaluate();
  EXPECT_EQ(ignored.force(1), Vec3(Vec3::Zero()));
  auto bonded = two<3>(Vec3(kRadius, 0, 0));
  bonded.options.fallback.bonded = true;  // they share an SPH sum instead
  bonded.start();
  bonded.evaluate();
  EXPECT_EQ(bonded.force(1), Vec3(Vec3::Zero()));
}

// At 1e-9 h and in one place the force is that of the formula, k 2r + 200 own r, and finite.
TEST(ParticlePair, NearlyCoincidentOnesHaveAFiniteForce) {
  const Real wanted = kSpring * 2 * kRadius + 200 * kOwn * kRadius;
  for (const Real apart : {1e-9 * kRadius, 0.0}) {
    auto scene = two<3>(Vec3(0, apart, 0));
    scene.evaluate();
    EXPECT_NEAR(scene.force(1).norm(), wanted, 1e-6 * wanted) << apart;
    const Real step = scene.contact->stable_step().step;
    EXPECT_GT(step, 0) << apart;
  }
}

// Undamped impact of unequal masses: velocities of an elastic collision, to the error of velocity
// Verlet at a step of 0.02 / omega (its energy error over an impact is of third order).
TEST(ParticlePair, ImpactOfTwoMasses) {
  for (const Real mass : {1.0, 7.0, 1e6}) {
    auto scene = two<3>(Vec3(2 * kRadius, 0, 0), 0, 0, mass);
    scene.groups[0].points.v[0] = Vec3(1, 0, 0);
    const Real reduced = mass / (1 + mass), dt = 0.02 / std::sqrt(kSpring / reduced);
    for (int i = 0; i < 400; ++i) scene.step(dt);
    EXPECT_NEAR(scene.groups[0].points.v[0][0], (1 - mass) / (1 + mass), 1e-3) << mass;
    EXPECT_NEAR(scene.groups[1].points.v[0][0], 2 / (1 + mass), 1e-3 * 2 / (1 + mass)) << mass;
  }
}

// Steps as contact allows, 0.9 of them, at 0.01 to 5 sound speeds c = sqrt(own / m) 2r: no
// centres pass each other, and energy comes back to 1 % (the step follows the barrier).
TEST(ParticlePair, NothingPassesAtFiveSoundSpeeds) {
  const Real c = std::sqrt(kOwn) * 2 * kRadius;
  for (const Real mach : {0.01, 0.2, 1.0, 3.0, 5.0}) {
    auto scene = two<3>(Vec3(3 * kRadius, 1e-3 * kRadius, 0));
    scene.options.fallback.stiffness = 0.5;
    scene.start();
    scene.groups[0].points.v[0] = Vec3(mach * c, 0, 0);
    scene.contact->rearrange();
    Real dt = scene.contact->stable_step().step * 1e-3;
    Real nearest = 1;
    for (int i = 0; i < 20000; ++i) {
      scene.step(dt);
      dt = 0.9 * scene.contact->stable_step().step;
      const Vec3 apart = scene.groups[1].points.x[0] - scene.groups[0].points.x[0];
      nearest = std::min(nearest, apart[0]);
      if (apart[0] > 3 * kRadius) break;
    }
    EXPECT_GT(nearest, 0) << mach;
    EXPECT_GT(scene.groups[1].points.v[0][0], 0.95 * mach * c) << mach;
  }
}

/// Moves the second particle along `way` in one step, without other forces, and returns its force.
template <int Dim>
Vec<Dim> drag(ContactScene<Dim>& scene, const Vec<Dim>& way) {
  const Real dt = 1e-3;
  auto& p = scene.groups[1].points;
  p.v[0] = way / dt;
  p.x[0] += way;
  for (auto& group : scene.groups) {
    for (auto& f : group.points.f) f.setZero();
  }
  scene.contact->add_forces(dt);
  return p.f[0];
}

// Pressed by d and dragged by s across the line of centres: min(k s, mu N) across it, N = k d along
// it. The line turns by s / 2r = 0.04 in all, which the stretch and the length of s know to its
// square.
TEST(ParticlePair, FrictionSticksThenSlips) {
  const Real d = 0.02, mu = 0.3, limit = mu * kSpring * d;
  auto scene = two<3>(Vec3(0, 0, 2 * kRadius - d), 0, mu);
  const Real step = 0.05 * limit / kSpring;
  for (int i = 1; i <= 60; ++i) {
    const Vec3 force = drag<3>(scene, Vec3(step, 0, 0));
    const Vec3 n = scene.groups[1].points.x[0].normalized();
    const Real normal = force.dot(n), across = (force - normal * n).norm();
    EXPECT_NEAR(across, std::min(i * step * kSpring, mu * normal), 2e-3 * limit) << i;
    EXPECT_LT((force - normal * n)[0], 0);
    EXPECT_EQ(scene.force(0), -scene.force(1));
  }
}

// What is pulled away forgets its stretch, 10 N, by state: coming back along z on a line that leans
// by 1e-3 / 2r it slips by 0.03 m times that, 0.6 N.
TEST(ParticlePair, RecordsDieWhereTheyPart) {
  auto scene = two<3>(Vec3(0, 0, 2 * kRadius - 0.02), 0, 0.3);
  const auto across = [&](const Vec3& force) {
    const Vec3 n = scene.groups[1].points.x[0].normalized();
    return (force - force.dot(n) * n).norm();
  };
  EXPECT_NEAR(across(drag<3>(scene, Vec3(1e-3, 0, 0))), 10, 0.1);
  drag<3>(scene, Vec3(0, 0, 0.03));
  EXPECT_NEAR(across(drag<3>(scene, Vec3(0, 0, -0.03))), 0.6, 0.05);
}

// A gripped pair that turns as one with its material keeps its friction, in
// the frame of the bodies, and none appears where there was none.
template <int Dim>
void check_turning() {
  const Real d = 0.02, angle = 1e-2, dt = 1e-3;
  Vec<Dim> apart = Vec<Dim>::Zero(), way = Vec<Dim>::Zero();
  apart[1] = 2 * kRadius - d, way[0] = 1e-4;
  auto scene = two<Dim>(apart, 0, 0.3);
  Vec3 axis = Vec3::UnitZ();
  if (Dim == 3) axis = Vec3(0.6, 0, 0.8);
  drag<Dim>(scene, way);
  for (auto& group : scene.groups) group.points.v[0].setZero();
  scene.evaluate();
  const Vec<Dim> start = scene.force(1);
  Mat3 turned = Mat3::Identity();
  const Mat3 turn = Eigen::AngleAxis<Real>(angle, axis).toRotationMatrix();
  for (int i = 0; i < 100; ++i) {
    turned = turn * turned;
    for (auto& group : scene.groups) {
      auto& p = group.points;
      Vec3 x = Vec3::Zero();
      x.template head<Dim>() = p.x[0];
      const Vec<Dim> next = (turn * x).template head<Dim>();
      p.v[0] = (next - p.x[0]) / dt;
      p.x[0] = next;
      p.f[0].setZero();
      group.surface.spin.assign(1, std::sin(angle) / dt * axis);
    }
    scene.contact->add_forces(dt);
  }
  Vec3 wanted = Vec3::Zero();
  wanted.template head<Dim>() = start;
  wanted = turned * wanted;
  EXPECT_LT((scene.force(1) - wanted.template head<Dim>()).norm(), 1e-9 * start.norm());
  EXPECT_EQ(scene.totals().value(Column::contact_friction), 0);
}

TEST(ParticlePair, TurningTogetherIsNoSlip) {
  check_turning<2>();
  check_turning<3>();
}

// A cloud: momentum is kept to rounding, the frictionless one keeps angular momentum too, and the
// ledger of kinetic energy, spring, damping and friction closes to 1e-12.
TEST(ParticlePair, CloudKeepsMomentumAndEnergy) {
  for (const Real mu : {0.0, 0.4}) {
    ContactScene<3> scene;
    scene.options.fallback = {false, 0.5, 0.1, constant(mu)};
    scene.options.fallback.initial_overlap = InitialOverlap::press;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<Real> part(-1, 1), mass(0.5, 4);
    for (int i = 0; i < 40; ++i) {
      const Vec3 x(part(random), part(random), part(random));
      add_body<3>(scene, 1.2 * x, kRadius, kOwn, mass(random));
      scene.groups.back().points.v[0] = -5 * x + Vec3(part(random), part(random), part(random));
    }
    scene.start();
    const auto moments = [&](Real dt) {
      Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
      for (const auto& group : scene.groups) {
        const auto& p = group.points;
        const Vec3 v = p.v[0] - 0.5 * dt * p.a[0];  // of the middle of the step, at its start
        linear += p.mass[0] * p.v[0];
        angular += p.mass[0] * (p.x[0] - dt * v).cross(v);
      }
      return std::pair(linear, angular);
    };
    const Real dt = 2e-4;
    const auto [linear, angular] = moments(0);
    scene.step(dt);
    const Real energy = [&] {
      const auto totals = scene.totals();
      Real sum = scene.kinetic(dt);
      for (const Column c : {Column::contact_spring, Column::contact_damping,
                             Column::contact_friction, Column::contact_pairs}) {
        sum += totals.value(c);
      }
      return sum;
    }();
    for (int i = 0; i < 1500; ++i) scene.step(dt);
    const auto [linear_end, angular_end] = moments(dt);
    EXPECT_LT((linear_end - linear).norm(), 1e-11);
    const auto totals = scene.totals();
    Real sum = scene.kinetic(dt);
    for (const Column c : {Column::contact_spring, Column::contact_damping,
                           Column::contact_friction, Column::contact_pairs}) {
      sum += totals.value(c);
    }
    EXPECT_NEAR(sum, energy, 1e-12 * energy);
    EXPECT_GT(totals.value(Column::contact_damping), 0);
    if (mu > 0) {
      EXPECT_GT(totals.value(Column::contact_friction), 0);
    } else {
      EXPECT_LT((angular_end - angular).norm(), 1e-11 * (1 + angular.norm()));
    }
  }
}

// No answer depends on the lists: any skin, rebuilt every step, brute force.
TEST(ParticlePair, ListsMakeNoDifference) {
  const auto run = [](std::optional<Real> skin, SearchMode mode, bool rebuild) {
    ContactScene<3> scene;
    scene.options.fallback = {false, 0.5, 0.1, constant(0.3)};
    scene.options.fallback.initial_overlap = InitialOverlap::press;
    scene.options.skin = skin, scene.options.search = mode;
    std::mt19937_64 random(5);
    std::uniform_real_distribution<Real> part(-1, 1);
    for (int i = 0; i < 30; ++i) {
      const Vec3 x(part(random), part(random), part(random));
      add_body<3>(scene, 1.5 * x);
      scene.groups.back().points.v[0] = -10 * x;
    }
    scene.start();
    for (int i = 0; i < 400; ++i) {
      if (rebuild) scene.contact->rearrange();
      scene.step(3e-4);
    }
    return std::pair(scene.totals().state_hash, scene.groups[7].points.x[0]);
  };
  const auto wanted = run(std::nullopt, SearchMode::grid, false);
  EXPECT_EQ(run(0.0, SearchMode::grid, false), wanted);
  EXPECT_EQ(run(0.4, SearchMode::grid, false), wanted);
  EXPECT_EQ(run(0.1, SearchMode::brute, false), wanted);
  EXPECT_EQ(run(0.1, SearchMode::grid, true), wanted);
}

}  // namespace
}  // namespace brunt
