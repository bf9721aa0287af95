// Depth, XSPH, checks and Hooke's law of the group of particles.
#include "sph/particles.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "core/errors.hpp"
#include "sample.hpp"

namespace brunt {
namespace {

using test::elastic_material;
using test::elastic_options;
using test::kDensity;
using test::kDp;
using test::lattice;
using test::particles;

// In 2D the depth is contained in the masses: twice the mass and the depth give twice the force and
// the same accelerations, whatever the channel. Factors of 2 are exact.
TEST(SphParticles, DepthScalesForcesAndNotMotion) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const auto run = [&](Real depth) {
    auto points = lattice<2>({8, 8}, kDp, kDensity * kDp * kDp * depth, 0.1);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.v[i] = Vec<2>(30 * std::sin(900 * points.x[i][1]), 2e4 * points.x[i][1]);
    }
    auto solid = particles<2>(std::move(points), kDp, *material, test::all_pair_sums(), depth);
    for (int k = 0; k < 10; ++k) test::step<2>(*solid, 2e-8);
    return solid;
  };
  const auto one = run(1), two = run(2);
  for (std::size_t i = 0; i < one->points().f.size(); ++i) {
    EXPECT_EQ(2 * one->points().f[i], two->points().f[i]);
    EXPECT_EQ(one->points().x[i], two->points().x[i]);
  }
}

// XSPH shifts positions by opposite amounts: the centre of mass moves with the momentum alone, to
// round-off of the positions (1e-13 of the size), and relative motion is damped, not fed: the
// lattice of alternating velocities spreads less than without.
TEST(SphParticles, XsphKeepsTheCenterOfMass) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const auto run = [&](Real xsph, Vec<2>& center) {
    SphOptions options = test::all_pair_sums();
    options.xsph = xsph;
    auto points = lattice<2>({10, 10}, kDp, kDensity * kDp * kDp, 0.1);
    for (std::size_t i = 0; i < points.x.size(); ++i) points.v[i][0] = i % 2 ? 50.0 : -50.0;
    const auto start = points.x;
    auto solid = particles<2>(std::move(points), kDp, *material, options);
    const Real dt = 1e-9;
    auto& p = solid->points();
    for (std::size_t i = 0; i < p.x.size(); ++i) p.x[i] += dt * p.v[i];
    solid->renew_lists();
    solid->update_state(dt);
    Real spread = 0;
    center.setZero();
    for (std::size_t i = 0; i < p.x.size(); ++i) {
      center += (p.x[i] - start[i]) / 100;
      spread += (p.x[i] - start[i]).norm();
    }
    return spread;
  };
  Vec<2> center, center_xsph;
  const Real spread = run(0, center), spread_xsph = run(0.5, center_xsph);
  EXPECT_LT((center - center_xsph).norm(), 1e-13 * 10 * kDp);
  EXPECT_LT(spread_xsph, 0.8 * spread);
}

// What breaks is named: time, body, particle and quantity.
TEST(SphParticles, CheckNamesTheBrokenParticle) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  auto solid = particles<2>(lattice<2>({4, 4}, kDp, kDensity * kDp * kDp), kDp, *material, {});
  solid->renew_lists();
  solid->update_state(1e-9);
  EXPECT_NO_THROW(solid->check(1.5, {"plate"}));
  solid->blocks()[0].state.pressure[5] = std::numeric_limits<Real>::quiet_NaN();
  try {
    solid->check(1.5, {"plate"});
    FAIL() << "a stress that is not a number went unseen";
  } catch (const PhysicsError& error) {
    EXPECT_EQ(error.failure().body, "plate");
    EXPECT_EQ(error.failure().entity, "particle 5");
    EXPECT_EQ(error.failure().time, 1.5);
  }
}

// Hooke: a corrected lattice under a uniform small strain gives the stress of the law and, inside,
// no force; the strain 1e-6 errs by its square. Also the fields that output reads.
TEST(SphParticles, UniformStrainGivesHookesStress) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  auto points = lattice<2>({9, 9}, kDp, kDensity * kDp * kDp * 0.02);
  const Real dt = 1e-9, strain = 1e-6;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i][0] = strain / dt * points.x[i][0];
    points.x[i][0] *= 1 + strain;
  }
  auto solid = particles<2>(std::move(points), kDp, *material, elastic_options(), 0.02);
  solid->renew_lists();
  solid->update_state(dt);
  solid->add_internal_forces(dt);
  const auto view = solid->view(0);
  const auto field = [&](const std::string& name) {
    for (const auto& f : view.point_fields) {
      if (f.name == name) return f.values;
    }
    return std::vector<Real>{};
  };
  const auto stress = field("stress");
  const Real lambda = material->bulk - 2.0 / 3 * material->shear;
  ASSERT_EQ(stress.size(), 6 * 81u);
  for (std::size_t k = 0; k < 81; ++k) {
    EXPECT_NEAR(stress[6 * k + xx], material->modulus() * strain,
                1e-5 * material->modulus() * strain);
    EXPECT_NEAR(stress[6 * k + yy], lambda * strain, 1e-5 * lambda * strain);
    EXPECT_NEAR(stress[6 * k + zz], lambda * strain, 1e-5 * lambda * strain);
  }
  // a face of n dp x depth carries sigma n dp depth: the force of a cut through a lattice row
  Real cut = 0;
  const auto& f = solid->points().f;
  for (std::size_t k = 0; k < 81; ++k) {
    if (k % 9 >= 5) cut += f[k][0];
  }
  EXPECT_LT(f[40].norm(), 1e-3 * stress[0] * kDp * 0.02);
  // Outward force on the right half: minus the tractions its left half would exert on a cut
  EXPECT_NEAR(cut / (-stress[0] * 9 * kDp * 0.02), 1, 0.2);
  EXPECT_NO_THROW(solid->check(0, {"block"}));
  EXPECT_EQ(view.point_radius.size(), 81u);
}

// Friction is shown the law at each particle's own state, and nothing where it does not ask.
TEST(SphParticles, ShowFrictionTheirMaterial) {
  const auto material = test::copper();
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025, law.m = 1.09, law.T_melt = 1356;
  auto solid = particles<2>(lattice<2>({5, 5}, kDp, 8960 * kDp * kDp), kDp, *material, {});
  solid->renew_lists();
  solid->update_state(1e-9);
  EXPECT_TRUE(solid->surface().particle_material.empty());
  solid->surface().needs_material = true;
  auto& state = solid->blocks()[0].state;
  state.eps_p[7] = 0.2, state.temperature[7] = 700;
  solid->renew_lists();
  solid->update_state(1e-9);
  const auto& shown = solid->surface().particle_material;
  ASSERT_EQ(shown.size(), 25u);
  EXPECT_EQ(shown[7].temperature, 700);
  EXPECT_EQ(shown[7].flow_stress, law.flow_stress(0.2, 0.0, 700.0));
  EXPECT_EQ(shown[8].temperature, 298);
  EXPECT_EQ(shown[8].flow_stress, law.flow_stress(0.0, 0.0, 298.0));
}

}  // namespace
}  // namespace brunt
