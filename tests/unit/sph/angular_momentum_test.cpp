// docs/theory/sph.md (S14).
// Moments of the forces that particles have on each other: sum x (x) f less its transpose.
// - Stress: f_i = sum V_i V_j (sigma_i B_i + sigma_j B_j) grad W, not along x_i - x_j, has
//     sum x (x) f = -sum_i V_i K_i B_i sigma_i = -sum_i V_i sigma_i,  K_i = B_i^-1
//   by pairs: none beside its own transpose, on any particles (Bonet & Lok 1999). Uncorrected, the
//   pair stress T_i = sigma_i - skew(sigma_i K_i) K_i^-1 takes the place of sigma_i B_i, and
//     sum x (x) f = -sum_i V_i K_i T_i^T,  skew(T_i K_i) = skew(sigma_i K_i) - skew(sigma_i K_i) =
//     0.
// - Monaghan's viscosity acts along x_i - x_j.
// - Artificial stress: f_ij = V_i V_j w f^4 (S_i + S_j) a with a = x_j - x_i, w = -W'/r, has
//     sum x (x) f = -sum_i V_i N_i S_i,  N_i = sum_j V_j w f^4 a (x) a
//   and so a moment where N_i and S_i have other axes: not inside a lattice (N_i is isotropic), but
//   at its faces, where N_i misses a side.
// Rounding: 60 pairs of a particle, 1e-13 of sum |x| |f|.
#include <gtest/gtest.h>

#include <cmath>

#include "sample.hpp"
#include "tests/support/eigenvalues.hpp"

namespace brunt {
namespace {

template <int Dim>
using Square = Eigen::Matrix<Real, Dim, Dim>;

/// sum x (x) f of one of the forces [N m], and the sum of its sizes.
template <int Dim>
struct Moment {
  Square<Dim> sum = Square<Dim>::Zero();
  Real size = 0;
  void add(const Vec<Dim>& x, const Vec<Dim>& f) {
    sum += x * f.transpose(), size += x.norm() * f.norm();
  }
  Square<Dim> turning() const { return sum - sum.transpose(); }
};

/// -epsilon times the tensile part of the stress of a particle [Pa].
template <int Dim>
Square<Dim> artificial_stress(const MaterialState& state, std::size_t k, Real epsilon) {
  Mat3 full;
  const auto s = [&](std::size_t c) { return state.deviator[c][k]; };
  full << s(xx), s(xy), s(zx), s(xy), s(yy), s(yz), s(zx), s(yz), s(zz);
  full.diagonal().array() -= state.pressure[k];
  return -epsilon * test::tensile_part_of(full.template topLeftCorner<Dim, Dim>());
}

template <int Dim>
struct Cloud {
  std::unique_ptr<Material> material = test::elastic_material(test::kDensity, 200e9, 0.3);
  SphOptions options = test::all_pair_sums();
  std::unique_ptr<SphParticles<Dim>> solid;
  Real volume = std::pow(test::kDp, Dim);  // [m^Dim] of each at time 0
  Moment<Dim> stress, viscosity, artificial;

  /// One step from rest under a velocity that strains by 2e-3, all ways.
  Cloud(bool correction, Real noise) {
    options.correction = correction;
    std::array<int, Dim> n;
    n.fill(Dim == 2 ? 10 : 6);
    auto points = test::lattice<Dim>(n, test::kDp, test::kDensity * volume, noise);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.v[i].setConstant(3.0);
      points.v[i][0] += 40 * std::sin(500 * points.x[i][1]) + 20 * std::cos(700 * points.x[i][0]);
      points.v[i][1] += 30 * std::cos(800 * points.x[i][0]);
    }
    solid = test::particles<Dim>(std::move(points), test::kDp, *material, options);
    test::step<Dim>(*solid, 1e-7);
    for (std::size_t i = 0; i < solid->states().size(); ++i) {
      const auto& state = solid->states()[i];
      const auto& x = solid->points().x[i];
      stress.add(x, state.stress_force), viscosity.add(x, state.viscous_force);
      artificial.add(x, solid->artificial_of(i).force);
    }
  }

  /// -sum V_i N_i S_i of the printed formula, all pairs. Weights are those of the step's start,
  /// and so are h and V_j; V_i is that of the stress.
  Square<Dim> artificial_moment() const {
    const auto& x = solid->points().x;
    const Real h = 1.2 * test::kDp;
    const Real peak = (Dim == 2 ? 10 / (7 * kPi) : 1 / kPi) / std::pow(h, Dim);
    const auto value = [](Real q) {
      return q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * std::pow(2 - q, 3);
    };
    const auto slope = [](Real q) {
      return q < 1 ? -3 * q + 2.25 * q * q : -0.75 * (2 - q) * (2 - q);
    };
    Square<Dim> moment = Square<Dim>::Zero();
    for (std::size_t i = 0; i < x.size(); ++i) {
      Square<Dim> N = Square<Dim>::Zero();
      for (std::size_t j = 0; j < x.size(); ++j) {
        const Vec<Dim> arm = x[j] - x[i];
        const Real r = arm.norm(), q = r / h;
        if (i == j || q >= 2) continue;
        const Real push = std::pow(value(q) / value(1 / 1.2), 4);
        N += volume * (-slope(q) * peak / (h * r)) * push * arm * arm.transpose();
      }
      const auto& state = solid->blocks()[0].state;
      const Square<Dim> S = artificial_stress<Dim>(state, i, options.artificial_stress);
      moment -= solid->states()[i].volume * N * S;
    }
    return moment;
  }
};

template <int Dim>
void expect_moments() {
  const Cloud<Dim> cloud(true, 0.2);
  EXPECT_LT(cloud.stress.turning().norm(), 1e-13 * cloud.stress.size);
  EXPECT_GT(cloud.stress.size, 0);
  EXPECT_LT(cloud.viscosity.turning().norm(), 1e-13 * cloud.viscosity.size);
  EXPECT_GT(cloud.viscosity.size, 0);
  // Beside the sums, the principal axes of two methods: 1e-12.
  const Square<Dim> moment = cloud.artificial_moment();
  EXPECT_LT((cloud.artificial.sum - moment).norm(), 1e-12 * cloud.artificial.size);
  EXPECT_GT(cloud.artificial.turning().norm(), 1e-3 * cloud.artificial.size);

  const Cloud<Dim> uncorrected(false, 0.2);
  EXPECT_GT(uncorrected.stress.size, 0);
  EXPECT_LT(uncorrected.stress.turning().norm(), 1e-13 * uncorrected.stress.size);
}
TEST(AngularMomentum, IsChangedByTheArtificialStressAlone) {
  expect_moments<2>();
  expect_moments<3>();
}

}  // namespace
}  // namespace brunt
