// Friction of particles on faces. On a
// rigid surface a particle of radius r and modulus M has k = phi M (2 r)^(Dim - 2) along the normal
// and across it, here of phi = 1. Pressed by d it carries N = k d, and dragged by s a friction of
// min(k s, mu N).
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kRadius = 0.25, kSpring = 1e4;               // [m], [N/m]
constexpr Real kPressed = 1e-3, kCoefficient = 0.3;         // [m], [1]
constexpr Real kLimit = kCoefficient * kSpring * kPressed;  // [N]
constexpr Real kElastic = kLimit / kSpring;                 // [m] until it slips

Varying constant(Real value) {
  Varying varying;
  varying.constant = value;
  return varying;
}

template <int Dim>
void add_particle(ContactScene<Dim>& scene, const Vec<Dim>& x, Real mass = 1) {
  scene.add_particle(scene.add_group(), x, kRadius, kSpring / std::pow(2 * kRadius, Dim - 2), mass);
}

/// A rigid floor of faces of random shape, quads or triangles, that share their nodes.
void add_random_floor(ContactScene<3>& scene, bool quads, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> shift(-0.35, 0.35);
  constexpr LocalIndex n = 8;
  auto& group = scene.add_group();
  for (LocalIndex j = 0; j <= n; ++j) {
    for (LocalIndex i = 0; i <= n; ++i) {
      scene.add_point(group, {i - n / 2 + shift(random), j - n / 2 + shift(random), 0}, 0);
    }
  }
  const auto add = [&](const std::vector<LocalIndex>& corners) {
    auto& facet = group.surface.facets.emplace_back();
    facet.node.fill(-1);
    std::copy(corners.begin(), corners.end(), facet.node.begin());
    scene.name(group, facet, 0, 0);
  };
  for (LocalIndex j = 0; j < n; ++j) {
    for (LocalIndex i = 0; i < n; ++i) {
      const LocalIndex a = j * (n + 1) + i, b = a + n + 1;
      if (quads) {
        add({a, a + 1, b + 1, b});
      } else if (random() % 2) {
        add({a, a + 1, b + 1}), add({a, b + 1, b});
      } else {
        add({a, a + 1, b}), add({a + 1, b + 1, b});
      }
    }
  }
}
void add_random_floor(ContactScene<2>& scene, bool, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> shift(-0.35, 0.35);
  auto& group = scene.add_group();
  for (LocalIndex i = -4; i <= 4; ++i) scene.add_point(group, {i + shift(random), 0}, 0);
  for (LocalIndex i = 0; i < 8; ++i) {
    auto& facet = group.surface.facets.emplace_back();
    facet.node = {i + 1, i};
    scene.name(group, facet, 0, 0);
  }
}

/// A particle pressed on a floor by `depth`.
template <int Dim>
ContactScene<Dim> pressed(bool quads, std::uint64_t seed, Real zeta, Vec<Dim> x,
                          Real depth = kPressed) {
  ContactScene<Dim> scene;
  scene.options.fallback = {false, 1.0, zeta, constant(kCoefficient)};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  add_random_floor(scene, quads, seed);
  x[Dim - 1] = kRadius - depth;
  add_particle<Dim>(scene, x);
  scene.start();
  return scene;
}

/// Moves the particle by `way` in a step and returns the force on it [N].
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

// Dragged obliquely over six cells in steps of a tenth of the stretch mu N / k: k s up to mu N,
// then mu N, whatever faces it crosses; one that forgot would begin anew at each. Some roundings of
// places of size 1 against 1e-2 m of stretch.
template <int Dim>
void check_drag(bool quads, std::uint64_t seed) {
  Vec<Dim> along = Vec<Dim>::Zero(), start = Vec<Dim>::Zero();
  along[0] = Dim == 3 ? 0.8 : 1.0;
  start[0] = -3;
  if (Dim == 3) along[1] = 0.6, start[1] = -2.4;
  const Real depth = 0.04, normal = kSpring * depth, limit = kCoefficient * normal;
  auto scene = pressed<Dim>(quads, seed, 0, start, depth);
  const Real step = 0.1 * limit / kSpring;
  for (Real way = step; way < 6; way += step) {
    const Vec<Dim> force = drag<Dim>(scene, step * along);
    const Real wanted = std::min(kSpring * way, limit);
    ASSERT_NEAR(force.dot(along), -wanted, 1e-12 * limit) << way;
    ASSERT_NEAR(force[Dim - 1], normal, 1e-12 * normal) << way;
    ASSERT_NEAR(force.norm(), std::hypot(wanted, normal), 1e-12 * normal) << way;
    ASSERT_EQ(scene.contact->work().contacts, 1u) << way;
  }
}

TEST(ParticleFriction, DoesNotDipWhereFacesMeet) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    check_drag<2>(true, seed);
    check_drag<3>(true, seed);
    check_drag<3>(false, seed);
  }
}

// Dragged at v, once it slips: mu(v) N.
TEST(ParticleFriction, DecaysWithTheSpeedOfSlip) {
  auto scene = pressed<3>(true, 12, 0, Vec3::Zero());
  const DecayingFriction law{0.4, 0.1, 2};
  scene.options.fallback.coulomb.decaying = law;
  scene.start();
  for (const Real speed : {1.0, 0.1, 0.5, 2.0}) {
    Vec3 force;
    for (int i = 0; i < 10; ++i) force = drag<3>(scene, Vec3(0, speed * 1e-3, 0));
    const Real wanted = (0.1 + 0.3 * std::exp(-2 * speed)) * kSpring * kPressed;
    EXPECT_NEAR(force[1], -wanted, 1e-12 * wanted) << speed;
  }
}

// The mirrored drag has the mirrored force; turned back, friction falls by k s to -mu N, over
// 2 mu N / k.
template <int Dim>
void check_reversal() {
  const Vec<Dim> centre = Vec<Dim>::Constant(0.1);
  auto one = pressed<Dim>(false, 4, 0, centre), other = pressed<Dim>(false, 4, 0, centre);
  Vec<Dim> step = Vec<Dim>::Zero();
  step[0] = 0.11 * kElastic;
  if (Dim == 3) step[1] = -0.07 * kElastic;
  Real turned = 0;
  for (int i = 0; i < 600; ++i) {
    const Real sign = i / 200 % 2 == 0 ? 1 : -1;
    const Vec<Dim> force = drag<Dim>(one, sign * step), mirror = drag<Dim>(other, -sign * step);
    const Vec<Dim> sum = force + mirror - 2 * force[Dim - 1] * Vec<Dim>::Unit(Dim - 1);
    ASSERT_LT(sum.norm(), 1e-12 * kLimit) << i;
    turned = i % 200 == 0 ? step.norm() : turned + step.norm();
    if (i < 200) continue;
    const Real wanted = std::min(kSpring * turned - kLimit, kLimit);
    ASSERT_NEAR(-sign * force.dot(step.normalized()), wanted, 1e-12 * kLimit) << i;
  }
}

TEST(ParticleFriction, ReversalIsSymmetric) {
  check_reversal<2>();
  check_reversal<3>();
}

/// Steps a particle of mass m under the weight k kPressed and a pull [N].
template <int Dim>
void step_under(ContactScene<Dim>& scene, Real dt, const std::function<Real(Real x)>& pull) {
  scene.step(dt, [&] {
    auto& p = scene.groups[1].points;
    p.f[0][Dim - 1] -= kSpring * kPressed;
    p.f[0][0] += pull(p.x[0][0]);
  });
}

// What sticks under a pull F < mu N rests at F / k and is back where it was when the pull ends; no
// heat. m = 1, omega = 100 1/s: 10 s at zeta = 0.1 leave exp(-100) of its motion.
TEST(ParticleFriction, StickingParticleReturns) {
  auto scene = pressed<3>(true, 6, 0.1, Vec3(0.2, 0.1, 0));
  const Real pull = 0.6 * kLimit, start = scene.groups[1].points.x[0][0];
  const auto ramp = [&](int i, Real from, Real to) { return from + (to - from) * i / 500; };
  for (int i = 0; i < 10000; ++i) {
    step_under<3>(scene, 1e-3, [&](Real) { return ramp(std::min(i, 500), 0, pull); });
  }
  EXPECT_NEAR(scene.groups[1].points.x[0][0] - start, pull / kSpring, 1e-9 * kElastic);
  for (int i = 0; i < 10000; ++i) {
    step_under<3>(scene, 1e-3, [&](Real) { return ramp(std::min(i, 500), pull, 0); });
  }
  EXPECT_NEAR(scene.groups[1].points.x[0][0], start, 1e-9 * kElastic);
  EXPECT_EQ(scene.totals().value(Column::contact_friction), 0);
}

// A mass of 1 kg on a spring K = 100 N/m whose end is pulled at V. It slips when the spring
// carries mu N; from then on its mass swings by V sqrt(K m) = 0.0033 mu N about it.
template <int Dim>
void check_stick_slip() {
  auto scene = pressed<Dim>(true, 8, 0.1, Vec<Dim>::Constant(-1));
  const Real K = 100, V = 1e-3, dt = 2e-3, start = scene.groups[1].points.x[0][0];
  Real spring = 0, time = 0, onset = 0;
  for (; time < 60; time += dt) {
    step_under<Dim>(scene, dt, [&](Real x) {
      spring = K * (V * (time + dt) - (x - start));
      return spring;
    });
    if (onset == 0 && scene.totals().value(Column::contact_friction) > 0) onset = spring;
    ASSERT_LT(spring, 1.01 * kLimit) << time;
    ASSERT_GT(spring, onset > 0 ? 0.99 * kLimit : 0.0) << time;
  }
  EXPECT_NEAR(onset, kLimit, 0.01 * kLimit);
  // It slips once the end has gone mu N / K and the contact's own stretch.
  const Real way = scene.groups[1].points.x[0][0] - start;
  EXPECT_NEAR(way, V * time - kLimit / K, 0.01 * kLimit / K);
}

TEST(ParticleFriction, PulledMassSlipsAtTheCoulombForce) {
  check_stick_slip<2>();
  check_stick_slip<3>();
}

/// A rigid table and on it a block of 1 kg that keeps its shape: one face of 1 m.
template <int Dim>
ContactScene<Dim> block_on_table() {
  ContactScene<Dim> scene;
  scene.options.fallback = {false, 1.0, 0.01, constant(kCoefficient)};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  add_sheet(scene, 8, 0, 1.6, 0, true, 0, 0);
  add_sheet(scene, 1, 0.13, 1, -kPressed, false, kSpring, 1);
  auto& p = scene.groups[1].points;
  for (auto& m : p.mass) m = 1 / static_cast<Real>(p.mass.size());
  scene.start();
  return scene;
}

/// 1 kg at v0 = 1 m/s on a floor with g = k kPressed / m = 10 m/s^2 stops after v0^2 /
/// (2 mu g), to the stretch mu N / k of its spring. It comes to rest with the spring let go, so it
/// has slipped all of its way: heat mu N s, to what slips in the step in which it begins. All that
/// it lost is heat of friction or of the dampers, to 1e-10.
template <int Dim>
void check_stop(ContactScene<Dim> scene) {
  const Real v0 = 1, dt = 5e-4, g = kSpring * kPressed;
  auto& p = scene.groups[1].points;
  const auto n = static_cast<Real>(p.x.size());
  for (auto& v : p.v) v[0] = v0;
  const Real start = p.x[0][0], energy = scene.kinetic(dt);
  const Real pressed = 0.5 * kSpring * kPressed * kPressed;  // held from the first step on
  EXPECT_NEAR(energy, 0.5 * v0 * v0, 1e-14);
  for (int i = 0; i < 6000; ++i) {
    scene.step(dt, [&] {
      const Vec<Dim> mean = scene.force(1) / n - g / n * Vec<Dim>::Unit(Dim - 1);
      for (auto& f : p.f) f = mean;
    });
    const auto totals = scene.totals();
    const Real spring = totals.value(Column::contact_spring);
    const Real heat = totals.value(Column::contact_friction);
    const Real damped = totals.value(Column::contact_damping);
    const Real pairs = totals.value(Column::contact_pairs);
    ASSERT_NEAR(scene.kinetic(dt) + spring + heat + damped + pairs, energy, 1e-10 * energy) << i;
    ASSERT_NEAR(pairs, -pressed, 1e-10 * energy) << i;
  }
  const Real way = p.x[0][0] - start, stop = v0 * v0 / (2 * kCoefficient * g);
  EXPECT_NEAR(way, stop, kElastic);
  EXPECT_LT(p.v[0].norm(), 1e-6);
  const auto totals = scene.totals();
  const Real heat = totals.value(Column::contact_friction), slipped = kSpring * v0 * dt * v0 * dt;
  EXPECT_NEAR(heat, kLimit * way, slipped);
  EXPECT_NEAR(heat + totals.value(Column::contact_damping), energy, 1e-10 * energy);
}

TEST(ParticleFriction, SliderStopsAndHeatsByWhatItLost) {
  check_stop<2>(pressed<2>(true, 9, 0.1, Vec<2>::Zero()));
  check_stop<3>(pressed<3>(true, 9, 0.1, Vec3::Zero()));
  check_stop<3>(pressed<3>(false, 9, 0.1, Vec3::Zero()));
}

TEST(ParticleFriction, BlockStopsAndHeatsByWhatItLost) {
  check_stop<2>(block_on_table<2>());
  check_stop<3>(block_on_table<3>());
}

/// Corners of a face that looks up.
std::vector<Vec3> unit_face(const Vec3&) { return {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}; }
std::vector<Vec<2>> unit_face(const Vec<2>&) { return {{1, 0}, {0, 0}}; }

// A particle that rubs on a warped face of free nodes: neither a resultant nor a moment about the
// origin, so about no point. A few sums of forces of size F at arms of size 1.
template <int Dim>
void check_moment() {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> u(-1, 1);
  const auto anyhow = [&] {
    Vec<Dim> v;
    for (int c = 0; c < Dim; ++c) v[c] = u(random);
    return v;
  };
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    ContactScene<Dim> scene;
    scene.options.fallback.coulomb.friction = constant(0.3 + 0.3 * u(random));
    auto corners = unit_face(Vec<Dim>());
    for (auto& x : corners) x += 0.1 * anyhow();
    scene.add_face(scene.add_group(), corners, 1e6, 1, 1);
    Vec<Dim> x = Vec<Dim>::Constant(0.5) + 0.4 * anyhow();
    x[Dim - 1] = 0.6 * kRadius;
    add_particle<Dim>(scene, x);
    for (auto& group : scene.groups) {
      for (auto& v : group.points.v) v = anyhow();
    }
    scene.start();
    for (int n = 0; n < 2; ++n) {
      for (auto& group : scene.groups) {
        for (auto& f : group.points.f) f.setZero();
      }
      scene.contact->add_forces(1e-3);
    }
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    Real size = 0;
    for (const auto& group : scene.groups) {
      for (std::size_t k = 0; k < group.points.x.size(); ++k) {
        Vec3 at = Vec3::Zero(), f = Vec3::Zero();
        at.template head<Dim>() = group.points.x[k], f.template head<Dim>() = group.points.f[k];
        force += f;
        moment += at.cross(f);
        size += f.norm();
      }
    }
    touching += size > 0 ? 1 : 0;
    EXPECT_LE(force.norm(), 1e-14 * size) << i;
    EXPECT_LE(moment.norm(), 1e-14 * size) << i;
  }
  EXPECT_GT(touching, 1500);
}

TEST(ParticleFriction, HasNoMomentOnAFaceOfFreeNodes) {
  check_moment<2>();
  check_moment<3>();
}

// A ball of mass m that falls with speed v on the middle of a free face of mass M leaves with
// (m - M) / (m + M) v downwards and the face with 2 m / (m + M) v, to 1 % of v: entry and exit fall
// between two steps of 0.02 / omega.
template <int Dim>
void check_collision(Real face_mass) {
  ContactScene<Dim> scene;
  scene.options.fallback = {false, 1.0, 0, constant(kCoefficient)};
  scene.options.fallback.initial_overlap = InitialOverlap::press;
  const auto corners = unit_face(Vec<Dim>());
  scene.add_face(scene.add_group(), corners, 1e8, 1, face_mass / static_cast<Real>(corners.size()));
  const Real v = 0.01, k = kSpring * 1e8 * std::pow(2 * kRadius, Dim - 1) /
                           (kSpring + 1e8 * std::pow(2 * kRadius, Dim - 1));
  const Real omega = std::sqrt(k * (1 + 1 / face_mass)), dt = 0.02 / omega;
  Vec<Dim> x = Vec<Dim>::Constant(0.5);
  x[Dim - 1] = kRadius + 0.37 * v * dt;
  add_particle<Dim>(scene, x);
  auto& ball = scene.groups[1].points;
  ball.v[0][Dim - 1] = -v;
  scene.start();
  for (int i = 0; i < 200; ++i) {
    scene.step(dt);
    ASSERT_GE(scene.contact->stable_step().step, dt);
  }
  EXPECT_EQ(scene.force(1).norm(), 0);
  EXPECT_NEAR(ball.v[0][Dim - 1], -(1 - face_mass) / (1 + face_mass) * v, 0.01 * v) << face_mass;
  for (const auto& corner : scene.groups[0].points.v) {
    EXPECT_NEAR(corner[Dim - 1], -2 / (1 + face_mass) * v, 0.01 * v) << face_mass;
  }
}

TEST(ParticleFriction, BallOnAFreeFaceCollidesElastically) {
  for (const Real face_mass : {1e-6, 1.0, 1e6}) {
    check_collision<2>(face_mass);
    check_collision<3>(face_mass);
  }
}

}  // namespace
}  // namespace brunt
