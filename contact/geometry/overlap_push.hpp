#pragma once
#include <algorithm>
#include <cmath>

#include "contact/geometry/common_plane.hpp"

namespace brunt {

/// How the pressure of an overlap fades where it came in over the borders of its faces, not through
/// them: sides of two bricks of which one rests on the other, seen by faces that are deep in each
/// other over the height of a penetration. For a border at an edge of the lower face and one of the
/// upper, between which the overlap lies,
///   rho = int_P G dA / int_P (D_l + D_u) dA
/// is the mean depth over the distance D_l + D_u of both, and kappa the cosine between their
/// directions into the faces, 1 where they are opposite. omega is the product over all such pairs
/// of 1 - K (1 - v(rho)), K = kappa^2, but 1 within 14 degrees, where v is 1 up to rho = 1 and
/// falls as 1/rho^2 beyond, to nothing before the overlap is so deep that its faces let go. Two
/// boxes that overlap by p > a at their edges have p/a on the sides that are p deep, a/p on the
/// others: these push. Borders on the same side, of faces that end flush, fade nothing.
template <int Dim>
struct BorderFade {
  struct Borders {
    int lower, upper;  ///< edges of both faces, as in their borders
    Real by_room;      ///< [1/m^Dim] derivative of ln omega by int (D_l + D_u)
    Real by_facing;    ///< [1] the same by kappa
  };
  static constexpr int kMost = Facet<Dim>::kNodes * Facet<Dim>::kNodes;
  std::array<Borders, kMost> pair;
  int n = 0;
  Real factor = 1;     ///< omega
  Real share = 0;      ///< what potential_share asks for, 0 .. 1
  Real by_volume = 0;  ///< [1/m^Dim] derivative of ln omega by int G
  Real by_area = 0;    ///< [1/m^(Dim-1)] the same by the area of the overlap

  /// An overlap between two borders.
  struct Room {
    Real volume = 0;         ///< [m^Dim] int G
    Real size = 0;           ///< [m^Dim] int (D_l + D_u)
    Real area = 1;           ///< [m^(Dim-1)]
    Real filled = 1;         ///< part of the distance from border to border that it takes up
    Real limit = kInfinity;  ///< [m] depth at which the faces let go
  };
  /// Takes in two borders by kappa.
  void add(int lower, int upper, Real facing, const Room& room);
};

/// How much of the force between two faces follows the potential of their overlap, 0 .. 1, and how
/// much of them is a layer, as far as the rest of that share goes.
struct PotentialShare {
  Real value = 0, layer = 0;
};

/// That of two faces.
///
/// The push k volume along the plane's normal leaves out what the rim of the overlap does. In a
/// layer between faces of two surfaces rims cancel; a rim that is left there only squeezes the
/// border of the surface by k g^2/2, the more the less uniform the stress should be. Where edges
/// and corners dig in, energy is kept by nothing else: at an angle (half of it at 2 degrees,
/// nothing below 0.1), in a wedge, whose depth changes by more than its mean (from 0.3 of it on,
/// all of it from 1), or between opposite borders, where it is not shallow against their distance
/// (from rho = 0.005 on, all of it from 0.05) and takes up all of it. What lies between such
/// borders beside other faces of its bodies has rims there that cancel with theirs, which may have
/// no share: a sliver between has none either, so that it does not matter whether it is there.
/// facing  cosine of the angle between the faces
/// change  of the depth over the overlap, of its mean
template <int Dim>
PotentialShare potential_share(Real facing, Real change, const BorderFade<Dim>& fade) {
  constexpr Real kNone = 1.523e-6, kHalf = 6.092e-4;  // 1 - cos of 0.1 and of 2 degrees
  constexpr Real kLayer = 0.3, kWedge = 1;
  const Real angle = (1 - facing - kNone) / (1 - facing + kHalf);
  const Real wedge = (change - kLayer) / (kWedge - kLayer);
  const Real digs = std::clamp(std::max(angle, wedge), 0.0, 1.0);
  return {std::max(digs, fade.share), 1 - digs};
}

/// The overlap under pressure of two faces in 3D, in the axes of their plane; plane.polygon is it.
struct OverlapArea {
  const Polygon& below;                   ///< corners of the lower face
  const Polygon& above;                   ///< of the upper, back
  const LinearField& penetration;         ///< [m]
  const FieldIntegrals& sum;              ///< of it
  unsigned lower_borders, upper_borders;  ///< as of Facet
  const DeepArea& deep;                   ///< where the barrier pushes
  Real opening;                           ///< [m] of it, which is no distance of the faces
  Real limit;                             ///< [m] depth at which the faces let go

  /// Largest less smallest penetration over the area, of the mean.
  Real change(const CommonPlane<3>& plane) const {
    Real least = kInfinity;
    for (int i = 0; i < plane.polygon.size; ++i) {
      least = std::min(least, penetration.at(plane.polygon[i]));
    }
    return (plane.deepest - least) * sum.area / sum.total;
  }
};

/// The same of two edges in 2D, by places s [m] along the line; areas are lengths times breadth.
struct OverlapLine {
  std::array<Real, 2> below, above;       ///< corners of both, in their order
  std::array<Real, 2> end;                ///< of the overlap, the smaller first
  std::array<Real, 2> penetration;        ///< [m] there
  Real area, first;                       ///< [m^2], [m^3] of s - middle
  Real total, moment;                     ///< [m^3], [m^4] the same, weighted by the penetration
  unsigned lower_borders, upper_borders;  ///< as of Facet
  const DeepLine& deep;                   ///< where the barrier pushes
  Real opening;                           ///< [m]
  Real limit;                             ///< [m]
  const Section& section;

  Real middle() const { return 0.5 * (end[0] + end[1]); }
  Real change() const { return std::fabs(penetration[1] - penetration[0]) * area / total; }
};

/// The fade of an overlap between the borders of both faces; whole where either has none.
BorderFade<3> fade_of(const FacePlane<3>& lower, const FacePlane<3>& upper,
                      const OverlapArea& overlap, const CommonPlane<3>& plane);
BorderFade<2> fade_of(const FacePlane<2>& lower, const FacePlane<2>& upper,
                      const OverlapLine& overlap, const CommonPlane<2>& plane);

/// Which part of what moves a side of the overlap at a border goes to the border of the other face
/// that runs the same way, d [m] behind it, instead of to its own: 1/2 where both are one, nothing
/// from d = e on. The area of an overlap of two equal faces is w - |s| times the breadth, s their
/// offset, and the side force of the potential, k g^2/2 a breadth, would jump from one side to the
/// other as they pass each other flush: bars end to end were pushed off each other from an offset
/// of a rounding. Here both have the same where they are flush, so that nothing is left between
/// them, and in all 1 - 2 part = x^2 (3 - 2x), x = d/e: an offset does not grow from nothing. What
/// this departs from the potential is e/2 k g^2/2 a breadth at most, of which w k g^2/2 is all. It
/// is so in a layer: where edges and corners dig in, energy is kept by the potential alone. same
/// cosine between both, nothing up to 1/2;  width  [m] of the narrower face; e  half of it
inline Real part_of_flush(Real d, Real same, Real width) {
  const Real x = 2 * std::fabs(d) / width;
  if (!(x < 1 && same > 0.5)) return 0;
  return 0.5 * (1 - x * x * (3 - 2 * x)) * (2 * same - 1);
}

/// Sets plane.share and the pushes beside k volume along the normal, per k, that make of a share of
/// the force minus the gradient of
///   U = ramp omega k int_P w(G) dA,  G(p) = n_l.(c_l - p) + n_u.(c_u - p) = cos(th/2) g,
/// w = G^2/2 and what the barrier has beside it, with the faces' mean planes (centre c, normal n),
/// the overlap P of their outlines along the plane's normal as far as G > 0, and th the angle
/// between them. Moving both faces as one changes nothing, so that the forces have no resultant and
/// no moment. Its parts: the push N = ramp k int w' dA along each face's own normal; what turns
/// that normal; w along the sides of P that are the faces' own, on the corners of that side (but
/// for part_of_flush); what turns the plane, which moves one outline over the other; and the same
/// of omega. plane.ramp holds omega; all but the pushes is set.
void add_potential(const FacePlane<3>& lower, const FacePlane<3>& upper, const OverlapArea& overlap,
                   const BorderFade<3>& fade, const PotentialShare& share, CommonPlane<3>& plane);
void add_potential(const FacePlane<2>& lower, const FacePlane<2>& upper, const OverlapLine& overlap,
                   const BorderFade<2>& fade, const PotentialShare& share, CommonPlane<2>& plane);

}  // namespace brunt
