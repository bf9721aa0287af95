#pragma once
#include <algorithm>

#include "contact/geometry/polygon.hpp"

namespace brunt {

/// What the pressure of two faces has beside k g where they are deep in each other, per k:
///   b (g - g0)^2 / g0
/// for g beyond g0, an eighth of the penetration at which they let go. Two bodies alike that close
/// at v press by rho c v/2: at the speed of sound they come 0.27 of an element deep, instead of 2,
/// and at the limit, where k g = M/4, faces push 62 times as hard, and have taken in the energy of
/// their elements at 5 c.
struct FaceBarrier {
  static constexpr Real kOnset = 0.125;  ///< g0 of the limit
  static constexpr Real kStrength = 10;  ///< b
  /// Cosines of the angle between the faces from which it fades in, up to the whole of it. Faces
  /// that meet at an angle may reach far behind each other, and begin to do so where a barrier is
  /// highest.
  static constexpr Real kFadesIn = 0.2, kIsWhole = 0.6;
  Real onset = 0;             ///< [m] g0; 0: there is none
  Real strength = kStrength;  ///< b
  Real growth = 0;            ///< derivative of ln b by the cosine

  /// Which part of it faces have that meet by this cosine.
  static Real part_at(Real facing) {
    const Real s = std::clamp((facing - kFadesIn) / (kIsWhole - kFadesIn), 0.0, 1.0);
    return s * s * (3 - 2 * s);
  }
  static FaceBarrier before(Real limit) { return {kOnset * limit}; }
  /// The same between faces at an angle, by its cosine.
  FaceBarrier at(Real facing) const {
    const Real s = std::clamp((facing - kFadesIn) / (kIsWhole - kFadesIn), 0.0, 1.0);
    if (s == 0) return {};
    const Real slope = 6 * s * (1 - s) / (kIsWhole - kFadesIn), part = s * s * (3 - 2 * s);
    return {onset, part * strength, slope / part};
  }
  /// The way of a step where faces are deep [m]: slower ones bound no step by their speed.
  Real least_way() const { return 0.5 * onset; }
  Real beyond(Real g) const { return onset > 0 ? std::max(g - onset, 0.0) : 0.0; }
  /// b/g0 [1/m]; there is a barrier.
  Real steepness() const { return strength / onset; }
  /// Its pressure and energy by area at a penetration g [m]: [m], [m^2].
  Real pressure(Real g) const {
    const Real u = beyond(g);
    return u > 0 ? steepness() * u * u : 0.0;
  }
  Real energy(Real g) const { return pressure(g) * beyond(g) / 3; }
  /// Slope of the whole pressure, k g too, over k: 1 up to g0.
  Real tangent(Real g) const {
    const Real u = beyond(g);
    return u > 0 ? 1 + 2 * steepness() * u : 1.0;
  }
};

/// The part of an overlap in 3D where a barrier pushes, with u = G - g0, G = cos(th/2) g.
struct DeepArea {
  Polygon polygon;                 ///< its sides keep their names; u is 0 on those named kCut
  LinearField u;                   ///< [m]
  Real linear = 0;                 ///< [m^3] integral of u
  Real squared = 0;                ///< [m^4] of u^2; 0: nothing is deep
  Real cubed = 0;                  ///< [m^5] of u^3
  Vec<2> moment = Vec<2>::Zero();  ///< [m^5] of u^2 p
};
/// penetration  g [m];  cosine  cos(th/2);  deepest  [m] largest g of the overlap
DeepArea deep_area(const Polygon& overlap, const LinearField& penetration, Real cosine,
                   Real deepest, const FaceBarrier& barrier);

/// Of u^3 along a side on which it goes from a to b: the mean, and that weighted by 0 .. 1.
struct SideMeans {
  Real all, late;
};
SideMeans cubic_means(Real a, Real b);

/// The same in 2D, between two places [m] along a line; areas are lengths times breadth.
struct DeepLine {
  std::array<Real, 2> end{}, u{};  ///< [m]
  Real linear = 0;                 ///< [m^3] integral of u
  Real squared = 0;                ///< [m^4] of u^2; 0: nothing is deep
  Real cubed = 0;                  ///< [m^5] of u^3
  Real moment = 0;                 ///< [m^5] of u^2 s
  Real cubed_by_length = 0;        ///< [m^4] of u^3, without the breadth
  Real cubed_moment = 0;           ///< [m^5] of u^3 s, without it
};
/// end, depth  the overlap and G [m] there;  breadth(s)  linear at most
template <class Breadth>
DeepLine deep_line(const std::array<Real, 2>& end, const std::array<Real, 2>& depth,
                   const FaceBarrier& barrier, const Breadth& breadth) {
  DeepLine deep;
  if (!(barrier.onset > 0) || std::max(depth[0], depth[1]) <= barrier.onset) return deep;
  deep.end = end;
  deep.u = {depth[0] - barrier.onset, depth[1] - barrier.onset};
  const Real crossing = end[0] + (end[1] - end[0]) * deep.u[0] / (deep.u[0] - deep.u[1]);
  for (const std::size_t e : {0, 1}) {
    if (deep.u[e] < 0) deep.end[e] = crossing, deep.u[e] = 0;
  }
  // Gauss's rule of three points, exact up to the 5th degree.
  constexpr std::array<Real, 3> kAt = {-0.7745966692414834, 0, 0.7745966692414834};
  constexpr std::array<Real, 3> kShare = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const Real length = deep.end[1] - deep.end[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const Real share = 0.5 * (1 + kAt[i]);
    const Real s = deep.end[0] + share * length;
    const Real u = deep.u[0] + share * (deep.u[1] - deep.u[0]);
    const Real squared = kShare[i] * length * u * u;
    deep.linear += kShare[i] * length * u * breadth(s);
    deep.squared += squared * breadth(s);
    deep.moment += squared * breadth(s) * s;
    deep.cubed += squared * u * breadth(s);
    deep.cubed_by_length += squared * u;
    deep.cubed_moment += squared * u * s;
  }
  return deep;
}

}  // namespace brunt
