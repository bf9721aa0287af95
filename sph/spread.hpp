#pragma once
/// How far the neighbours of a particle reach in every direction, which bounds the step of bodies
/// that are few particles thick.
#include <Eigen/Dense>
#include <bit>
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

/// Moments of the mass of a neighbourhood about its particle, over the volumes.
template <int Dim>
struct SpreadSums {
  Real total = 0;                        ///< [m^Dim]
  Vec<Dim> first;                        ///< [m^(Dim+1)]
  Eigen::Matrix<Real, Dim, Dim> second;  ///< [m^(Dim+2)]
};

/// Sums over the row in its order, each number of its own: lanes are components here, and those
/// that have none sum up what nobody reads. What fills the row up is i itself and no neighbour,
/// though most kernels have a weight there.
template <int Dim, class Kernel>
SpreadSums<Dim> spread_sums(const MotionRecord<Dim>* motion, LocalIndex i,
                            std::span<const LocalIndex> row) {
  constexpr int volume = MotionRecord<Dim>::kVolume;
  const Real* own = motion[i].data;
  const Pack place = load(own);
  Real total = own[volume];
  Pack first{}, square{}, mixed{};  // xx, yy, zz and yx, zy, zx
  PairPack<Dim> pairs;
  for (std::size_t k = 0; k < row.size(); k += kLanes) {
    set_arms(motion, own, row.data() + k, pairs);
    pairs.weight = kernel_weight<Dim, Kernel>(pairs);
    for (unsigned left = mask_bits(pairs.weight != 0.0); left != 0; left &= left - 1) {
      const LocalIndex j = row[k + slot_of(std::countr_zero(left))];
      if (j == i) continue;
      const Real* other = motion[j].data;
      const Pack arm = load(other) - place, weighed = other[volume] * arm;
      total += other[volume];
      first += weighed;
      square += weighed * arm;
      mixed += __builtin_shufflevector(weighed, weighed, 1, 2, 2, 3) *
               __builtin_shufflevector(arm, arm, 0, 1, 0, 3);
    }
  }
  SpreadSums<Dim> sums;
  sums.total = total;
  for (int d = 0; d < Dim; ++d) sums.first[d] = first[d], sums.second(d, d) = square[d];
  sums.second(0, 1) = sums.second(1, 0) = mixed[0];
  if constexpr (Dim == 3) {
    sums.second(1, 2) = sums.second(2, 1) = mixed[1];
    sums.second(0, 2) = sums.second(2, 0) = mixed[2];
  }
  return sums;
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
  constexpr int volume = MotionRecord<Dim>::kVolume;
  const SpreadSums<Dim> sums = spread_sums<Dim, Kernel>(motion, i, row);
  const Vec<Dim> first = sums.first / sums.total;
  const Eigen::Matrix<Real, Dim, Dim> second = sums.second / sums.total;
  const Real cubed = std::pow(motion[i].data[volume], 6.0 / Dim);  // [m^6] dp^6
  const auto of_two_layers = [&](Real c) { return cubed / (16 * c * c); };
  const InverseSpread about_own = inverse_of<Dim>(second, of_two_layers, thin);
  const InverseSpread about_centre = inverse_of<Dim>(
      second - first * first.transpose(), [](Real) { return 0.0; }, thin);
  const bool own_longer = about_own.stiffness(shear_share) < about_centre.stiffness(shear_share);
  return own_longer ? about_own : about_centre;
}

}  // namespace brunt
// Tested by tests/unit/sph/spread_test.cpp.
