#pragma once
#include <array>

#include "contact/geometry/polygon.hpp"

namespace brunt {

/// Weights N_a of the corners of a convex quad with sum N_a x_a = p, p inside: bilinear, then
/// corrected in the least squares of their changes so that both sums are exact to round-off.
std::array<Real, 4> bilinear_weights(const std::array<Vec<2>, 4>& corner, const Vec<2>& p);

/// The same of four points in quads of their own side by side, with the bits of each alone.
/// face  corners of each quad
/// p     point of each
std::array<std::array<Real, 4>, 4> bilinear_weights(const std::array<const Polygon*, 4>& face,
                                                    const std::array<Vec<2>, 4>& p);

}  // namespace brunt
