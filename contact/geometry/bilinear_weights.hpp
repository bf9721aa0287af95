#pragma once
#include <array>

#include "contact/geometry/in_plane.hpp"
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

/// The same of two times four quads at four points p, of those that are there, with the bits of
/// each alone. of_a, of_b  of corner k of all, for k = 0 .. 3
void bilinear_weights(const FourQuadsInPlane& a, const FourQuadsInPlane& b, const InPlane<Pack>& p,
                      PackMask there, Pack (&of_a)[4], Pack (&of_b)[4]);

}  // namespace brunt
