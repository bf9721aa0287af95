#pragma once
/// How far the neighbours of a particle reach in every direction, which bounds the step of bodies
/// that are few particles thick.
#include <Eigen/Dense>
#include <span>

#include "sph/correction.hpp"
#include "sph/thin_moment.hpp"

namespace brunt {

/// Of the inverse G of a neighbourhood's spread C [m^2], the second moment of its mass; 0 where it
/// bounds nothing.
struct InverseSpread {
  Real trace = 0;    ///< [1/m^2]
  Real largest = 0;  ///< [1/m^2] eigenvalue

  /// [1/m^2] of omega^2 = (lambda tr G + 2 mu g_max)/rho over c^2. shear_share  [1] 2 mu/(rho c^2)
  Real stiffness(Real shear_share) const {
    return (1 - shear_share) * trace + shear_share * largest;
  }
};

/// Beyond this |B|^2 (Frobenius) gradients are steeper than at the face of a half-space, where B
/// has eigenvalues of 1 and 2.
inline constexpr Real kSteepCorrection = 9;

/// [1] A share of a gradient that bounds no step.
inline constexpr Real kNoShare = 1e-6;

/// excess(c)  [m^2] what an eigenvalue c [m^2] of the spread counts too much
/// thin  of a thin neighbourhood: its axes strain in part; null: in full
template <int Dim, class Excess>
InverseSpread inverse_of(const Eigen::Matrix<Real, Dim, Dim>& spread, const Excess& excess,
                         const ThinMoment<Dim>* thin) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, Dim, Dim>> solver;
  solver.computeDirect(spread, thin ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
  InverseSpread inverse;
  for (int d = 0; d < Dim; ++d) {
    const Real share = thin ? thin->share_along(solver.eigenvectors().col(d)) : 1;
    if (share < kNoShare) continue;
    const Real least = solver.eigenvalues()[d] - excess(solver.eigenvalues()[d]);
    if (!(least > 0)) return {kInfinity, kInfinity};
    inverse.trace += share * share / least;
    inverse.largest = std::max(inverse.largest, share * share / least);
  }
  return inverse;
}

/// The stiffest motion of a body a few particles thick is a linear one, v = A (x - x_c), whose
/// gradient corrected sums have exactly: the energy V (lambda (tr A)^2/2 + mu A:A) over the mass
/// moment tr(A C A) gives omega^2 <= (lambda tr C^-1 + 2 mu/c_min)/rho, c_min the least spread.
/// Where the neighbourhood is the whole thickness, C is about its centre. Where it goes on, as at
/// the corner of a thick body, that is too little: the spread about the particle itself hardly
/// falls towards faces. Of two layers that is dp^2/2, twice as much as C: dp^6/16 c^2 less is as
/// much, and more layers feel little of it. The longer step holds.
/// docs/theory/sph.md (S24), (S25).
/// row  neighbours; those whose gradient has no weight do not count
/// shear_share  [1] 2 mu/(rho c^2)
/// thin  its axes where it is thin; else null
template <int Dim, class Kernel>
InverseSpread inverse_spread(const MotionRecord<Dim>* motion, LocalIndex i,
                             std::span<const LocalIndex> row, Real shear_share,
                             const ThinMoment<Dim>* thin) {
  using Matrix = Eigen::Matrix<Real, Dim, Dim>;
  constexpr int volume = MotionRecord<Dim>::kVolume;
  const Real* own = motion[i].data;
  Real total = own[volume];
  Vec<Dim> first = Vec<Dim>::Zero();
  Matrix second = Matrix::Zero();
  PairPack<Dim> pairs;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k % kLanes == 0) {
      set_arms(motion, own, row.data() + k, pairs);
      pairs.weight = kernel_weight<Dim, Kernel>(pairs);
    }
    if (pairs.weight[k % kLanes] == 0) continue;
    const Real* other = motion[row[k]].data;
    Vec<Dim> arm;
    for (int d = 0; d < Dim; ++d) arm[d] = other[d] - own[d];
    total += other[volume];
    first += other[volume] * arm;
    second += other[volume] * arm * arm.transpose();
  }
  second /= total, first /= total;
  const Real cubed = std::pow(own[volume], 6.0 / Dim);  // [m^6] dp^6
  const auto of_two_layers = [&](Real c) { return cubed / (16 * c * c); };
  const InverseSpread about_own = inverse_of<Dim>(second, of_two_layers, thin);
  const InverseSpread about_centre = inverse_of<Dim>(
      second - first * first.transpose(), [](Real) { return 0.0; }, thin);
  const bool own_longer = about_own.stiffness(shear_share) < about_centre.stiffness(shear_share);
  return own_longer ? about_own : about_centre;
}

}  // namespace brunt
// Tested by tests/unit/sph/step_bound_test.cpp.
