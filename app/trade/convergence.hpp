#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// One value of a series of runs that differ in size alone.
struct SizedValue {
  Real size = 0;  ///< of elements or particles, in any unit
  Real value = 0;
};

/// How a value goes to its limit when sizes go to zero.
struct Convergence {
  bool asymptotic = false;
  std::optional<Real> order;  ///< observed, where the differences have one
  std::optional<Real> limit;  ///< Richardson's estimate of the value of size 0
  Real bound = 0;             ///< uncertainty of the value of the finest size
  std::string words;          ///< "order 1.9", or why it is not asymptotic
};

/// The order p with which three values converge, of
///   f = f_0 + C h^p:   (h_3^p - h_2^p) / (h_2^p - h_1^p) = (f_3 - f_2) / (f_2 - f_1)
/// Nothing where the differences do not shrink towards the finest, h_1.
/// finest, middle, coarsest  with sizes that increase
std::optional<Real> observed_order(const SizedValue& finest, const SizedValue& middle,
                                   const SizedValue& coarsest);

/// Fits f_0 + C h^p and bounds the error of the finest value as a grid convergence index does
/// (Roache 1994, J. Fluids Eng. 116, 405; several sizes by least squares as Eca & Hoekstra 2014,
/// J. Comput. Phys. 262, 104):
///   bound = F |f_2 - f_1| / (r^p - 1), r = h_2/h_1
///   F = 1.25 where three sizes give an order of 0.5 to 2.5, with p held at 1: coarse sizes show
///   more than what has shocks or contact keeps; where four sizes or more follow one order to 2.5,
///   F = 1.25 times the distance to its limit
///   F = 3 elsewhere; two sizes give no order, and p = 2 is assumed
/// A value that oscillates, or whose differences grow, is bounded by three times its spread.
/// values  two or more, of different sizes in any order
Convergence fit_convergence(std::vector<SizedValue> values);

/// The size that counts of runs of these nominal sizes and numbers of cells: sizes are rounded to
/// whole cells, so the numbers say more. In d directions, the nearest to what both say,
///   h = h_1 (n_1 / n)^(1/d)
/// Nominal sizes where the numbers do not follow them.
/// nominal, cells  of each run
std::vector<Real> effective_sizes(const std::vector<Real>& nominal, const std::vector<Real>& cells);

}  // namespace brunt
