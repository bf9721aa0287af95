#pragma once
#include "contact/common_plane.hpp"

namespace brunt {

/// How much of the force between two faces follows the potential of their overlap, 0 .. 1.
///
/// The push k volume along the plane's normal leaves out what the rim of the overlap does. Beside
/// parallel faces of one surface rims cancel; a rim that is left there would only squeeze the
/// border of the surface by k g^2/2, the more the less uniform the stress should be. Where edges
/// and corners dig in, at an angle, energy is kept by nothing else (docs/decisions.md,
/// contact.md 2.5). Half of it at 2 degrees, nothing below 0.1. facing  cosine of the angle between
/// the faces
inline Real lean_share(Real facing) {
  constexpr Real kNone = 1.523e-6, kHalf = 6.092e-4;  // 1 - cos of 0.1 and of 2 degrees
  const Real lean = 1 - facing;
  return lean > kNone ? (lean - kNone) / (lean + kHalf) : 0.0;
}

/// The overlap under pressure of two faces in 3D, in the axes of their plane; plane.polygon is it.
struct OverlapArea {
  const Polygon& below;            ///< corners of the lower face
  const Polygon& above;            ///< of the upper, back
  const LinearField& penetration;  ///< [m]
  Real opening;                    ///< [m] of it, which is no distance of the faces
  Real total;                      ///< [m^3] integral of the penetration
};

/// The same of two edges in 2D, by places s [m] along the line.
struct OverlapLine {
  std::array<Real, 2> below, above;  ///< corners of both, in their order
  std::array<Real, 2> end;           ///< of the overlap, the smaller first
  std::array<Real, 2> penetration;   ///< [m] there
  Real opening;                      ///< [m]
  Real total;                        ///< [m^3] integral of the penetration times breadth
};

/// Sets plane.leans and the pushes beside k volume along the normal, per k, that make the force of
/// faces at an angle, as far as lean_share says, minus the gradient of
///   U = ramp k/2 int_P G^2 dA,  G(p) = n_l.(c_l - p) + n_u.(c_u - p) = cos(th/2) g,
/// with the faces' mean planes (centre c, normal n), the overlap P of their outlines along the
/// plane's normal as far as G > 0, and th the angle between them. Moving both faces as one changes
/// nothing, so that the forces have no resultant and no moment. It has four parts: the push
/// N = ramp k int G dA along each face's own normal; what turns that normal; G^2/2 along the sides
/// of P that are the faces' own, on the corners of that side; what turns the plane, which moves one
/// outline over the other. Everything else of the plane is there already.
void push_leaning(const FacePlane<3>& lower, const FacePlane<3>& upper, const OverlapArea& overlap,
                  CommonPlane<3>& plane);
void push_leaning(const FacePlane<2>& lower, const FacePlane<2>& upper, const OverlapLine& overlap,
                  const Section& section, CommonPlane<2>& plane);

}  // namespace brunt
