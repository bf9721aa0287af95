// Forces against motions that strain nothing, of total-Lagrangian particles (docs/theory/sph.md,
// section 13). They are those of the energy
//   Psi = 1/2 sum_i c sum_j V_i V_j w_ij |x_ij - F_i X_ij|^2,   V_j grad_i W = -w_ij V_j X_ij ...
// with w = -W'(r)/r at time 0 and F_i = sum_j V_j w_ij x_ij (x) X_ij K_i^-1, found here pair by
// pair from the kernel. It is quadratic in the displacements u where c is constant: sum f . u = -2
// Psi. F_i being the least squares fit of its x_ij, the variation of F gives no force, and no
// moment.
#include "sph/total.hpp"

#include <gtest/gtest.h>

#include "tests/unit/sph/sample.hpp"

namespace brunt::test {
namespace {

constexpr Real kMass = kDensity * kDp * kDp * kDp, kStep = 1e-12;

SphOptions total_options(Real hourglass = 20) {
  SphOptions options = elastic_options();
  options.formulation = SphFormulation::total;
  options.smoothing = 1.5, options.hourglass = hourglass;
  return options;
}

/// A block of n^3 with 10 % of disorder, each particle displaced by u in one step.
std::unique_ptr<SphParticles<3>> displaced(int n, const Material& material,
                                           const SphOptions& options, Real noise,
                                           const std::vector<Vec3>& u) {
  auto points = lattice<3>({n, n, n}, kDp, kMass, noise);
  for (std::size_t i = 0; i < u.size(); ++i) points.v[i] = u[i] / kStep;
  auto solid = particles<3>(std::move(points), kDp, material, options);
  step<3>(*solid, kStep);
  return solid;
}

std::vector<Vec3> random_field(std::size_t n, Real size) {
  std::mt19937_64 random(7);
  std::vector<Vec3> field(n);
  for (auto& u : field) {
    for (int d = 0; d < 3; ++d) u[d] = size * (2 * static_cast<Real>(random() >> 11) * 0x1p-53 - 1);
  }
  return field;
}

/// w of the cubic kernel [1/m^5] at a distance r, h = 1.5 dp.
Real cubic_weight(Real r) {
  const Real h = 1.5 * kDp, q = r / h;
  const Real slope = q < 1 ? -3 * q + 2.25 * q * q : q < 2 ? -0.75 * (2 - q) * (2 - q) : 0;
  return -slope / (3.14159265358979324 * h * h * h * h) / r;
}

/// Psi [J], pair by pair.
Real energy(const std::vector<Vec3>& X, const std::vector<Vec3>& x, Real c) {
  const Real V = kDp * kDp * kDp;
  Real psi = 0;
  for (std::size_t i = 0; i < X.size(); ++i) {
    Eigen::Matrix3d K = Eigen::Matrix3d::Zero(), A = K;
    const auto pairs = [&](const auto& f) {
      for (std::size_t j = 0; j < X.size(); ++j) {
        const Vec3 arm = X[j] - X[i];
        if (j != i) f(V * cubic_weight(arm.norm()), arm, Vec3(x[j] - x[i]));
      }
    };
    pairs([&](Real w, const Vec3& arm, const Vec3& now) {
      K += w * arm * arm.transpose();
      A += w * now * arm.transpose();
    });
    const Eigen::Matrix3d F = A * K.inverse();
    pairs([&](Real w, const Vec3& arm, const Vec3& now) {
      psi += 0.5 * c * V * w * (now - F * arm).squaredNorm();
    });
  }
  return psi;
}

TEST(TotalParticles, HourglassForcesAreThoseOfTheirEnergyAndKeepBothMomenta) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  constexpr int n = 5;
  const auto X = lattice<3>({n, n, n}, kDp, kMass, 0.1).x;
  const auto u = random_field(X.size(), 0.1 * kDp);
  const auto solid = displaced(n, *material, total_options(), 0.1, u);
  const auto& points = solid->points();
  Real work = 0, size = 0;
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  for (std::size_t i = 0; i < u.size(); ++i) {
    const Vec3 f = solid->artificial_of(i).force;
    work += f.dot(u[i]), size += f.norm();
    force += f, moment += points.x[i].cross(f);
  }
  const Real psi = energy(X, points.x, 0.2 * material->shear);
  EXPECT_NEAR(-work / 2, psi, 1e-9 * psi);
  EXPECT_LT(force.norm(), 1e-12 * size);
  EXPECT_LT(moment.norm(), 1e-12 * size * n * kDp);
}

TEST(TotalParticles, AnAffineMotionHasNoHourglassForces) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const auto X = lattice<3>({5, 5, 5}, kDp, kMass, 0.1).x;
  Eigen::Matrix3d H;
  H << 0.5, 0.3, 0, -0.4, 0.1, 0.2, 0, 0.3, -0.3;
  std::vector<Vec3> u;
  for (const auto& x : X) u.push_back(H * x);
  const auto solid = displaced(5, *material, total_options(), 0.1, u);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto& state = solid->states()[i];
    EXPECT_LT(solid->artificial_of(i).force.norm(), 1e-9 * (1 + state.stress_force.norm()));
    EXPECT_NEAR(state.ratio, (Eigen::Matrix3d::Identity() + H).determinant(), 1e-9);
  }
}

/// omega^2 of the stiffest motion [1/s^2], by power iteration.
Real largest_omega2(int n, const Material& material, const SphOptions& options) {
  auto field = random_field(slot_of(n * n * n), 1);
  Real omega2 = 0;
  for (int k = 0; k < 60; ++k) {
    constexpr Real amplitude = 1e-9 * kDp;
    Real square = 0;
    for (const auto& u : field) square += u.squaredNorm();
    for (auto& u : field) u *= amplitude / std::sqrt(square);
    const auto solid = displaced(n, material, options, 0, field);
    Real growth = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      field[i] = solid->points().f[i] / kMass;
      growth += field[i].squaredNorm();
    }
    omega2 = std::sqrt(growth) / amplitude;
  }
  return omega2;
}

// The limit counts what the forces against such motions add: without them half of a lattice's
// (S23), with them a little less, and always less than the true limit 2/omega.
TEST(TotalParticles, TheStepLimitHoldsWithHourglassForces) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  Real before = kInfinity;
  for (const Real hourglass : {0.0, 20.0, 200.0}) {
    const auto options = total_options(hourglass);
    const Real omega2 = largest_omega2(6, *material, options);
    const auto rest = particles<3>(lattice<3>({6, 6, 6}, kDp, kMass), kDp, *material, options);
    const Real limit = rest->stable_step().step;
    EXPECT_LT(limit, 2 / std::sqrt(omega2)) << hourglass;
    EXPECT_GT(limit, 0.3 * 2 / std::sqrt(omega2)) << hourglass;
    EXPECT_LT(limit, before);
    before = limit;
  }
}

// A block that is pressed to half its height has half the step: a wave crosses it in half the
// time. Its volume is kept, so that the speed of sound is.
TEST(TotalParticles, TheStepLimitFollowsTheLeastStretch) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const auto X = lattice<3>({5, 5, 5}, kDp, kMass).x;
  const auto limit = [&](Real stretch) {
    std::vector<Vec3> u;
    for (const auto& x : X) {
      u.emplace_back((1 / std::sqrt(stretch) - 1) * x[0], (1 / std::sqrt(stretch) - 1) * x[1],
                     (stretch - 1) * x[2]);
    }
    auto solid = displaced(5, *material, total_options(0), 0, u);
    for (auto& v : solid->points().v) v.setZero();
    for (auto& a : solid->points().a) a.setZero();
    step<3>(*solid, kStep, [&](Points<3>& points) {
      for (auto& v : points.v) v.setZero();
    });
    for (auto& a : solid->points().a) a.setZero();
    return solid->stable_step().step;
  };
  EXPECT_NEAR(limit(0.5) / limit(0.9999), 0.5, 0.01);
}

}  // namespace
}  // namespace brunt::test
