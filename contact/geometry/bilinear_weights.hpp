#pragma once
#include <array>

#include "contact/geometry/polygon.hpp"

namespace brunt {

/// Weights N_a of the corners of a convex quad with sum N_a x_a = p, p inside: bilinear, then
/// corrected in the least squares of their changes so that both sums are exact to round-off.
std::array<Real, 4> bilinear_weights(const std::array<Vec<2>, 4>& corner, const Vec<2>& p);

/// The same of two quads at two points side by side, with the bits of each alone: of the lower and
/// the upper face at p, then at `middle`. Corners of the upper face run back in its polygon, and
/// not in its weights.
std::array<std::array<Real, 4>, 4> bilinear_weights(const Polygon& below, const Polygon& above,
                                                    const Vec<2>& p, const Vec<2>& middle);

}  // namespace brunt
