#pragma once
/// Gradients of particles whose neighbours lie in a plane, on a line, or are few.
#include <Eigen/Dense>
#include <algorithm>

#include "sph/correction.hpp"

namespace brunt {

/// Eigenvalues of a moment K below this share of the largest count in part. Those of rods and
/// sheets two particles thick come to 0.24 of it with the widest kernel.
inline constexpr Real kThinShare = 0.15;

/// But for those along which neighbours lie: (S9a) of over this share of the most. Two layers on a
/// cubic lattice have 0.36 however close they are; a sheet over a radius of two spacings has 0.11.
inline constexpr Real kThinDirections = 0.25;

/// [1] So do those below this, of particles with hardly a neighbour. Cubes of two particles a side
/// have 0.06.
inline constexpr Real kLeastMoment = 0.02;

/// What a neighbourhood knows of each of its axes.
template <int Dim>
struct ThinMoment {
  using Matrix = Eigen::Matrix<Real, Dim, Dim>;
  Matrix axes = Matrix::Identity();     ///< eigenvectors of K, by columns
  Vec<Dim> share = Vec<Dim>::Zero();    ///< [1] w, 1 where gradients are complete
  Vec<Dim> inverse = Vec<Dim>::Zero();  ///< [1] w/lambda, eigenvalues of B

  /// [1] of the gradient along a unit vector
  Real share_along(const Vec<Dim>& unit) const {
    return (axes.transpose() * unit).cwiseAbs2().dot(share);
  }
};

/// All components of a symmetric tensor.
template <int Dim>
typename ThinMoment<Dim>::Matrix full_matrix(const Real (&symmetric)[kSymmetric<Dim>]) {
  typename ThinMoment<Dim>::Matrix full;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) full(a, b) = symmetric[symmetric_place<Dim>(a, b)];
  }
  return full;
}

/// Axes of a moment K with eigenvalues lambda, and their shares w = min(1, r^8, (lambda/0.02)^8),
/// r the larger of lambda/(0.15 lambda_max) and nu/(0.25 nu_max); nu = e.N e of each axis, where
/// the moment N of directions is given. Layers that are pressed together keep their nu, a sheet
/// that bends has none.
/// docs/theory/sph.md (S9a).
/// near  [1/m^2] N = sum_j w_ij e e^T, e along the pair, or null
template <int Dim>
ThinMoment<Dim> thin_moment(const Real (&moment)[kSymmetric<Dim>],
                            const Real (*near)[kSymmetric<Dim>] = nullptr) {
  const Eigen::SelfAdjointEigenSolver<typename ThinMoment<Dim>::Matrix> solver(
      full_matrix<Dim>(moment));
  ThinMoment<Dim> thin;
  thin.axes = solver.eigenvectors();
  Vec<Dim> ratio =
      solver.eigenvalues() / (kThinShare * std::max(solver.eigenvalues()[Dim - 1], kLeastMoment));
  if (near != nullptr) {
    const Vec<Dim> along = (thin.axes.transpose() * full_matrix<Dim>(*near) * thin.axes).diagonal();
    const Real most = along.maxCoeff();
    if (most > 0) ratio = ratio.cwiseMax(along / (kThinDirections * most));
  }
  for (int d = 0; d < Dim; ++d) {
    const Real value = std::max(solver.eigenvalues()[d], 0.0);
    const Real least = std::max(std::min({ratio[d], value / kLeastMoment, 1.0}), 0.0);
    const Real square = least * least, fourth = square * square;
    thin.share[d] = fourth * fourth;
    thin.inverse[d] = value > 0 ? thin.share[d] / value : 0.0;
  }
  return thin;
}

/// correction <- B of the axes and their inverse.
template <int Dim>
void thin_correction(const ThinMoment<Dim>& thin, Real (&correction)[kSymmetric<Dim>]) {
  const typename ThinMoment<Dim>::Matrix full =
      thin.axes * thin.inverse.asDiagonal() * thin.axes.transpose();
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) correction[symmetric_place<Dim>(a, b)] = full(a, b);
  }
}

/// inverse <- moment^-1, or B of (S9a) where the neighbourhood is thin; of a particle without
/// neighbours 0.
template <int Dim>
BRUNT_INLINE void invert_moment(const Real (&moment)[kSymmetric<Dim>],
                                Real (&inverse)[kSymmetric<Dim>]) {
  if (!invert_thick<Dim>(moment, inverse)) thin_correction(thin_moment<Dim>(moment), inverse);
}

/// velocity_gradient <- of A = R B, in the axes: S_ab + W_ab, S_ab = (w_a A_ab + w_b A_ba)/(w_a +
/// w_b), W_ab = (A_ab - A_ba)/max(w_a + w_b, 1). A turn strains nothing, and where w is 0 the
/// normal turns with the sheet.
/// docs/theory/sph.md (S9b).
/// rate  [1/s] R, by rows
template <int Dim>
void thin_gradient(const Real (&rate)[Dim * Dim], const ThinMoment<Dim>& thin,
                   Real (&velocity_gradient)[Dim * Dim]) {
  using Matrix = typename ThinMoment<Dim>::Matrix;
  const Eigen::Map<const Eigen::Matrix<Real, Dim, Dim, Eigen::RowMajor>> plain(rate);
  const Matrix along = thin.axes.transpose() * plain * thin.axes * thin.inverse.asDiagonal();
  Matrix gradient = along;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < a; ++b) {
      const Real shares = thin.share[a] + thin.share[b];
      const Real strain =
          shares > 0 ? (thin.share[a] * along(a, b) + thin.share[b] * along(b, a)) / shares : 0;
      const Real turn = (along(a, b) - along(b, a)) / std::max(shares, 1.0);
      gradient(a, b) = strain + turn;
      gradient(b, a) = strain - turn;
    }
  }
  Eigen::Map<Eigen::Matrix<Real, Dim, Dim, Eigen::RowMajor>>{velocity_gradient} =
      thin.axes * gradient * thin.axes.transpose();
}

/// [1] What the gradient dt L of (S9b) misses of the second order of a turn: at the end of a step
/// that turns by theta, arms strain by theta^2/2 along each axis across, which (S11) takes back.
/// docs/theory/sph.md (S9d).
/// gradient  [1] dt L
template <int Dim>
typename ThinMoment<Dim>::Matrix missed_turn(const typename ThinMoment<Dim>::Matrix& gradient,
                                             const ThinMoment<Dim>& thin) {
  using Matrix = typename ThinMoment<Dim>::Matrix;
  const Matrix spin = 0.5 * (gradient - gradient.transpose());
  Matrix along = thin.axes.transpose() * (0.5 * spin.transpose() * spin) * thin.axes;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      const Real shares = thin.share[a] + thin.share[b];
      along(a, b) *= shares > 0 ? 1 - 2 * thin.share[a] * thin.share[b] / shares : 1;
    }
  }
  return thin.axes * along * thin.axes.transpose();
}

/// T B with the power sigma : L on R of (S9b): in the axes T_ab = 2 sigma_ab w_a/(w_a + w_b).
/// docs/theory/sph.md (S9c).
/// sigma  [Pa]
template <int Dim>
typename ThinMoment<Dim>::Matrix thin_stress(const typename ThinMoment<Dim>::Matrix& sigma,
                                             const ThinMoment<Dim>& thin) {
  typename ThinMoment<Dim>::Matrix along = thin.axes.transpose() * sigma * thin.axes;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      const Real shares = thin.share[a] + thin.share[b];
      if (a != b) along(a, b) *= shares > 0 ? 2 * thin.share[a] / shares : 0;
    }
  }
  return thin.axes * along * thin.inverse.asDiagonal() * thin.axes.transpose();
}

}  // namespace brunt
// Tested by tests/unit/sph/thin_moment_test.cpp.
