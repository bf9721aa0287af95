// A chain of elements (h = c = rho = 1: springs 1, masses 1, 1/2 at the ends) whose last node sits
// on a spring phi: the limit of central differences is 2/omega_max. It equals 0.998, 0.972, 0.910,
// 0.786, 0.625 h/c for phi = 0.1, 0.5, 1, 2, 4, and is the same for two
// equal chains joined by a spring phi/2.
#include "contact/law/springs.hpp"

#include <gtest/gtest.h>

#include "tests/support/eigenvalues.hpp"

namespace brunt {
namespace {

using Matrix = Eigen::MatrixXd;

struct Chain {
  Matrix stiffness, mass;
  explicit Chain(int n) : stiffness(Matrix::Zero(n, n)), mass(Matrix::Zero(n, n)) {}
  void add_bar(int first, int last) {
    for (int i = first; i < last; ++i) {
      join(i, i + 1, 1);
      mass(i, i) += 0.5, mass(i + 1, i + 1) += 0.5;
    }
  }
  void join(int i, int j, Real k) {
    stiffness(i, i) += k, stiffness(j, j) += k;
    stiffness(i, j) -= k, stiffness(j, i) -= k;
  }
  Real limit() const {
    const Matrix motion = mass.diagonal().cwiseInverse().asDiagonal() * stiffness;
    return 2 / std::sqrt(test::largest_eigenvalue_of(motion));
  }
};

TEST(ContactLaw, SurfaceStepRatioIsTheLimitOfTheChain) {
  const std::array<std::pair<Real, Real>, 5> table = {
      {{0.1, 0.998}, {0.5, 0.972}, {1, 0.910}, {2, 0.786}, {4, 0.625}}};
  for (const auto& [phi, printed] : table) {
    Chain wall(41);
    wall.add_bar(0, 40);
    wall.stiffness(40, 40) += phi;
    Chain bars(82);
    bars.add_bar(0, 40), bars.add_bar(41, 81);
    bars.join(40, 41, phi * in_series(1, 1));
    EXPECT_NEAR(surface_step_ratio(phi, 0), printed, 1e-3);  // printed figures are cut
    // 40 elements leave q^80 of the mode at the far end: phi = 0.1 gives q = 0.905, 3e-4.
    EXPECT_NEAR(surface_step_ratio(phi, 0), wall.limit(), 1e-4);
    EXPECT_NEAR(wall.limit(), bars.limit(), 1e-4);
  }
}

TEST(ContactLaw, DampedSurfaceIsStableAtItsRatioAndGainsNothing) {
  // v' = v - dt M^-1 (K x' + C v), x' = x + dt v: no eigenvalue of the step may leave the unit
  // circle.
  for (const Real phi : {0.1, 0.5, 1.0, 2.0, 4.0}) {
    for (const Real zeta : {0.05, 0.1, 0.3, 1.0}) {
      constexpr int n = 16;
      Chain wall(n);
      wall.add_bar(0, n - 1);
      wall.stiffness(n - 1, n - 1) += phi;
      Matrix damping = Matrix::Zero(n, n);
      damping(n - 1, n - 1) = damping_coefficient(zeta, phi, 0.5);
      const Real dt = surface_step_ratio(phi, zeta);
      const Matrix inverse = wall.mass.diagonal().cwiseInverse().asDiagonal();
      const Matrix unit = Matrix::Identity(n, n);
      Matrix step(2 * n, 2 * n);
      step << unit, dt * unit, -dt * inverse * wall.stiffness,
          unit - dt * inverse * (damping + dt * wall.stiffness);
      // Undamped modes lie on the circle; double roots there split by sqrt(eps).
      EXPECT_LT(test::spectral_radius_of(step), 1 + 1e-7) << phi << " " << zeta;
    }
  }
}

// Four at once have the bits of each.
TEST(ContactLaw, RecoilOfFourIsThatOfEach) {
  const Pack recoil = {0, 0.1, 0.25, 0.7}, zeta = {0, 0.05, 0.3, 1};
  const Pack factor = recoil_factor(recoil), damping = recoil_damping(zeta, recoil);
  for (int k = 0; k < kLanes; ++k) {
    EXPECT_EQ(factor[k], 1 / (1 - std::min(recoil[k], kMostRecoil)));
    EXPECT_EQ(factor[k], recoil_factor(recoil[k]));
    EXPECT_EQ(damping[k], recoil_damping(zeta[k], recoil[k]));
    EXPECT_EQ(damping[k], k == 0 ? zeta[k] : zeta[k] * factor[k] * std::sqrt(factor[k]));
  }
}

TEST(ContactLaw, SpringsInSeriesAndRigidSides) {
  EXPECT_EQ(in_series(2, 2), 1);
  EXPECT_EQ(in_series(0, 3), 3);
  EXPECT_EQ(in_series(3, 0), 3);
  EXPECT_EQ(damping_coefficient(0.5, 4, 9), 6);
}

}  // namespace
}  // namespace brunt
