#pragma once
/// Nearest points of triangles, as many side by side as V has lanes. Closest point on a triangle
/// after Ericson (2005), 5.1.5.
#include "contact/geometry/place.hpp"

namespace brunt {

/// Barycentric weights of the point of a triangle that is nearest to x.
template <class V>
BRUNT_INLINE Place<V> nearest_weights(const Place<V>& x, const Place<V>& a, const Place<V>& b,
                                      const Place<V>& c) {
  const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
  const auto ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const V d1 = dot(ab, ax), d2 = dot(ac, ax), d3 = dot(ab, bx), d4 = dot(ac, bx);
  const V d5 = dot(ab, cx), d6 = dot(ac, cx);
  const V vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  const V to_b = d5 - d6, to_c = d4 - d3, all = va + vb + vc;
  const auto on_bc = (va <= zero) & (to_c >= zero) & (to_b >= zero);
  const auto on_ac = (vb <= zero) & (d2 >= zero) & (d6 <= zero);
  const auto on_ab = (vc <= zero) & (d1 >= zero) & (d3 <= zero);
  // One division for the inside and all edges: divisions are what takes longest here.
  const auto choose = [&](V inside, V bc, V ac, V ab) {
    return select(on_ab, ab, select(on_ac, ac, select(on_bc, bc, inside)));
  };
  const V along = choose(vb, to_c, d2, d1) / choose(all, to_c + to_b, d2 - d6, d1 - d3);
  const V of_c = vc / all;
  Place<V> weight{one - along - of_c, along, of_c};
  // The first that holds counts: it is asked last.
  const auto set = [&](auto where, V on_a, V on_b, V on_c) {
    weight.x = select(where, on_a, weight.x);
    weight.y = select(where, on_b, weight.y);
    weight.z = select(where, on_c, weight.z);
  };
  const V rest = one - along;
  set(on_bc, zero, rest, along);
  set(on_ac, rest, zero, along);
  set((d6 >= zero) & (d5 <= d6), zero, zero, one);
  set(on_ab, rest, along, zero);
  set((d3 >= zero) & (d4 <= d3), zero, one, zero);
  set((d1 <= zero) & (d2 <= zero), one, zero, zero);
  return weight;
}

/// Of one triangle, or of four: weights and place of the nearest point, its squared distance [m^2],
/// and the normal, as long as twice the area.
template <class V>
struct OfTriangles {
  Place<V> weight, point, normal;
  V square;            // of the normal
  V squared_distance;  // infinite without area
};
template <class V>
BRUNT_INLINE OfTriangles<V> nearest_on(const Place<V> (&t)[3], const Place<V>& x) {
  OfTriangles<V> found;
  found.weight = nearest_weights(x, t[0], t[1], t[2]);
  found.point = found.weight.x * t[0] + found.weight.y * t[1] + found.weight.z * t[2];
  const auto arm = x - found.point;
  found.normal = cross(t[1] - t[0], t[2] - t[0]);
  found.square = dot(found.normal, found.normal);
  found.squared_distance =
      select(found.square > broadcast<V>(0.0), dot(arm, arm), broadcast<V>(kInfinity));
  return found;
}

}  // namespace brunt
// Tested by tests/unit/contact/nearest_quads_test.cpp.
