// Friction heats, and never cools: over any history of pressure and slip the heat of each step is
// at least 0, and what the forces of contact take from the motion, -(F(n) + F(n+1))/2 . dx, is what
// the columns of contact say together.
//
// The mean of both forces times the slip of a step is below 0 where the old force was above the
// limit that there is now and the slip turns back: a spring of k that holds 10, then moves by 16/k
// under a limit of 5, slips by 1/k against the mean of 10 and -5. So may the last force of a
// contact that opens while it turns back.
#include <gtest/gtest.h>

#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

constexpr Real kSide = 1e6, kDeep = 0.01, kStep = 1e-3;  // [Pa/m], [m], [s]

enum class Kind { two_faces, particle_on_face, two_particles };

template <int Dim>
ContactScene<Dim> scene_of(Kind kind) {
  ContactScene<Dim> scene;
  scene.options.fallback.coulomb.friction.emplace().constant = 0.5;
  scene.options.fallback.damping = 0;
  const auto add_ball = [&](Real height) {
    Vec<Dim> x = Vec<Dim>::Constant(0.5);
    x[Dim - 1] = height;
    scene.add_particle(scene.add_group(), x, 0.1, kSide, 1);
  };
  if (kind == Kind::two_particles) {
    add_ball(0);
  } else {
    add_sheet(scene, 3, -1, 3, 0, true, kSide, 1);
  }
  if (kind == Kind::two_faces) {
    add_sheet(scene, 1, 0, 1, -kDeep, false, kSide, 1);
  } else {
    add_ball((kind == Kind::two_particles ? 0.2 : 0.1) - kDeep);
  }
  scene.start();
  return scene;
}

/// [J] of all columns of contact.
template <int Dim>
Real booked(const Totals<Dim>& totals) {
  Real sum = 0;
  for (const Column column : {Column::contact_spring, Column::contact_damping,
                              Column::contact_friction, Column::contact_pairs}) {
    sum += totals.value(column);
  }
  return sum;
}

/// The second body moves at random: its depth over -0.4 to 1 times kDeep, so that it opens in some
/// steps, its place aside by as much either way.
template <int Dim>
void check_history(Kind kind) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<Real> u(-1, 1);
  auto scene = scene_of<Dim>(kind);
  scene.evaluate();
  Vec<Dim> force = scene.force(1), place = Vec<Dim>::Zero();
  Real taken = 0, turnover = 0, heat = 0;
  const Real at_start = booked(scene.totals());
  for (int i = 0; i < 3000; ++i) {
    Vec<Dim> next;
    for (int c = 0; c < Dim; ++c) next[c] = kDeep * u(random);
    next[Dim - 1] = 0.7 * (kDeep + next[Dim - 1]);
    const Vec<Dim> way = next - place;
    auto& p = scene.groups[1].points;
    for (std::size_t k = 0; k < p.x.size(); ++k) p.v[k] = way / kStep, p.x[k] += way;
    for (auto& group : scene.groups) {
      for (auto& f : group.points.f) f.setZero();
    }
    scene.contact->add_forces(kStep);
    taken -= 0.5 * (force + scene.force(1)).dot(way);
    turnover += 0.5 * (force + scene.force(1)).norm() * way.norm();
    force = scene.force(1), place = next;
    const auto totals = scene.totals();
    const Real now = totals.value(Column::contact_friction);
    ASSERT_GE(now, heat) << i;
    heat = now;
    // A rounding or two of each step, of places of size 1 in ways of 0.01 too.
    ASSERT_NEAR(booked(totals) - at_start, taken, 1e-13 * turnover) << i;
  }
  EXPECT_GT(heat, 0.01 * turnover);
}

TEST(FrictionHeat, OfFacesIsNeverNegative) {
  check_history<2>(Kind::two_faces);
  check_history<3>(Kind::two_faces);
}

TEST(FrictionHeat, OfAParticleOnAFaceIsNeverNegative) {
  check_history<2>(Kind::particle_on_face);
  check_history<3>(Kind::particle_on_face);
}

TEST(FrictionHeat, OfTwoParticlesIsNeverNegative) {
  check_history<2>(Kind::two_particles);
  check_history<3>(Kind::two_particles);
}

}  // namespace
}  // namespace brunt
