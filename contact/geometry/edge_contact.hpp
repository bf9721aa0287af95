#pragma once
#include "contact/geometry/face_plane.hpp"

namespace brunt {

/// Edges as sharp as a blade: bit 4 + c of a facet's borders marks its edge c (3D).
inline constexpr unsigned kBladeBits = 4;

/// Where blades cross, none of their faces oppose each other: the edges push each other themselves.
///
/// For an edge of the lower face and one of the upper, with the directions e_l and e_u,
///   n = +- e_l x e_u / |e_l x e_u|, out of the lower body,   d = (x_l - x_u) . n
/// at the points of both lines that are nearest to each other, d less an overlap of which contact
/// takes no notice. The spring holds
///   U = w k (d^2/2 + d^4/(4 g^2)),   w = 1/4 Z(n . n_l) Z(n . n_u) E(s_l) E(s_u) P(e_l, e_u),
/// and its force is minus the gradient of U, which has no resultant and no moment. A quarter, since
/// an edge belongs to two faces on each side. Z is 1 where n lies in a face, up to a sine of 0.127,
/// and 0 from 0.24 on, where that face opposes those of the other blade (FacingRamp); E fades over
/// g towards the end of a blade, and from an edge to the next, as much before their corner as
/// beyond it, so that blades that are dented between elements do not fall through it; P fades where
/// edges are parallel (sines of 0.1 to 0.3).
struct EdgeContact {
  static constexpr int kMost = 2 * Facet<3>::kNodes;
  Vec3 normal;           ///< unit, from the lower to the upper body
  Vec3 point;            ///< [m] half way between both edges
  Real penetration = 0;  ///< [m] d, above 0
  Real share = 0;        ///< w
  Real force = 0;        ///< [m] of it along the normal, per k
  Real energy = 0;       ///< [m^2] U per k
  /// [1/m^2] Bound of the second derivative of w by the place of a corner, over the largest w:
  /// where the fades change, those of the sines with the turn of their face.
  Real fade_curvature = 0;
  std::array<Real, kMost> weight{};  ///< of the corners, lower face first; lower ones negative
  std::array<Vec3, kMost> push;      ///< [m] what corners get besides weight force normal, per k
};

/// Depths of two edges.
struct BladeDepths {
  Real stiffening;            ///< [m] g
  Real farthest = kInfinity;  ///< [m] those that are deeper have passed each other
};

/// True where edge i of the lower face and edge j of the upper push each other.
/// overlap  [m] that does not count; in and out: no more than there is, and all of it where they
/// have passed each other
bool find_edge_contact(const FacePlane<3>& lower, int i, const FacePlane<3>& upper, int j,
                       const BladeDepths& depths, Real& overlap, EdgeContact& contact);

}  // namespace brunt
