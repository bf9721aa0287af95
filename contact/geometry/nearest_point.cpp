#include "contact/geometry/particle_face.hpp"

#include <bit>
#include <cmath>

#include "contact/geometry/place.hpp"

namespace brunt {

namespace {
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

void set_vertex(NearestPoint<3>& nearest, int corner) {
  nearest.feature = Feature::vertex;
  nearest.corner = {corner, corner};
}

BRUNT_INLINE bool inside(const Place<Real>& weight) {
  return (weight.x != 0) & (weight.y != 0) & (weight.z != 0);
}

/// What of the face the weights of a triangle name that are not inside it. Corner 2 is the quad's
/// centre if is_quad. nearest  fresh: of the inside
void name_feature(const Place<Real>& weight, const std::array<int, 3>& corner, bool is_quad,
                  NearestPoint<3>& nearest) {
  nearest.smooth = false;
  const std::array<Real, 3> w = {weight.x, weight.y, weight.z};
  const int zeros = (w[0] == 0) + (w[1] == 0) + (w[2] == 0);
  if (zeros == 2) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (w[i] != 0 && corner[i] >= 0) set_vertex(nearest, corner[i]);
    }
  } else if (zeros == 1 && (!is_quad || w[2] == 0)) {
    const std::size_t out = w[0] == 0 ? 0 : (w[1] == 0 ? 1 : 2);
    nearest.feature = Feature::edge;
    nearest.corner = {corner[(out + 1) % 3], corner[(out + 2) % 3]};
  }
}

/// Of one triangle, or of four: weights and place of the nearest point, its squared distance [m^2],
/// and the normal, as long as twice the area.
template <class V>
struct OfTriangles {
  Place<V> weight, point, normal;
  V squared_distance;  // infinite without area
};
template <class V>
BRUNT_INLINE OfTriangles<V> nearest_on(const Place<V> (&t)[3], const Place<V>& x) {
  OfTriangles<V> found;
  found.weight = nearest_weights(x, t[0], t[1], t[2]);
  found.point = found.weight.x * t[0] + found.weight.y * t[1] + found.weight.z * t[2];
  const auto arm = x - found.point;
  found.normal = cross(t[1] - t[0], t[2] - t[0]);
  found.squared_distance = select(dot(found.normal, found.normal) > broadcast<V>(0.0),
                                  dot(arm, arm), broadcast<V>(kInfinity));
  return found;
}

/// Of a face without area: infinitely far.
void set_nowhere(NearestPoint<3>& nearest) {
  nearest.point.setZero(), nearest.normal.setZero();
  nearest.smooth = false;
}

Vec3 vector(const Place<Real>& p) { return {p.x, p.y, p.z}; }

/// nearest  out; fresh, as with all below
void find_on_triangle(const FacePlane<3>& face, const Vec3& x, NearestPoint<3>& nearest) {
  const auto& at = face.corner;
  const Place<Real> t[3] = {place(at[0]), place(at[1]), place(at[2])};
  const auto found = nearest_on(t, place(x));
  if (!(found.squared_distance < kInfinity)) return set_nowhere(nearest);
  nearest.distance = std::sqrt(found.squared_distance);
  nearest.point = vector(found.point);
  nearest.normal = vector(found.normal).normalized();
  nearest.weight = {found.weight.x, found.weight.y, found.weight.z, 0};
  if (!inside(found.weight)) name_feature(found.weight, {0, 1, 2}, false, nearest);
}

/// The first lane of the smallest of four numbers; one that is none is not smaller than any.
BRUNT_INLINE int least_lane(Pack v) {
  const Pack infinite = broadcast<Pack>(kInfinity);
  v = select(v < infinite, v, infinite);
  const Pack pairs = vmin(v, Pack{v[1], v[0], v[3], v[2]});
  const Pack least = vmin(pairs, Pack{pairs[2], pairs[3], pairs[0], pairs[1]});
  return std::countr_zero(mask_bits(v == least));
}

/// The four triangles of a quad about its centre side by side; of equals the first.
void find_on_quad(const FacePlane<3>& face, const Vec3& x, NearestPoint<3>& nearest) {
  const Place<Pack> from = corners(face.corner);
  const Place<Pack> t[3] = {from, next(from), everywhere(face.center)};
  const auto found = nearest_on(t, everywhere(x));
  const int k = least_lane(found.squared_distance);
  const Real least = found.squared_distance[k];
  if (!(least < kInfinity)) return set_nowhere(nearest);
  const auto lane = [k](const Place<Pack>& p) { return Place<Real>{p.x[k], p.y[k], p.z[k]}; };
  const Place<Real> weight = lane(found.weight);
  const int j = (k + 1) % kLanes;
  nearest.distance = std::sqrt(least);
  nearest.point = vector(lane(found.point));
  nearest.normal = vector(lane(found.normal)).normalized();
  const Real of_center = 0.25 * weight.z;
  nearest.weight.fill(of_center);
  nearest.weight[slot_of(k)] = of_center + weight.x;
  nearest.weight[slot_of(j)] = of_center + weight.y;
  if (!inside(weight)) name_feature(weight, {k, j, -1}, true, nearest);
}

void find_on_edge(const FacePlane<2>& face, const Vec<2>& x, NearestPoint<2>& nearest) {
  const Vec<2> edge = face.corner[1] - face.corner[0];
  const Real along = edge.dot(x - face.corner[0]) / edge.squaredNorm();
  const Real w = along <= 0 ? 0.0 : (along >= 1 ? 1.0 : along);
  nearest.weight = {1 - w, w};
  nearest.point = w == 1 ? face.corner[1] : Vec<2>(face.corner[0] + w * edge);
  nearest.distance = (x - nearest.point).norm();
  nearest.normal = face.normal;
  nearest.smooth = w != 0 && w != 1;
  if (!nearest.smooth) {
    nearest.feature = Feature::vertex;
    nearest.corner = {w == 0 ? 0 : 1, w == 0 ? 0 : 1};
  }
}
}  // namespace

template <int Dim>
NearestPoint<Dim> nearest_point(const FacePlane<Dim>& face, const Vec<Dim>& x) {
  NearestPoint<Dim> nearest;  // filled where the caller wants it
  if constexpr (Dim == 2) {
    find_on_edge(face, x, nearest);
  } else if (face.n_corners == 3) {
    find_on_triangle(face, x, nearest);
  } else {
    find_on_quad(face, x, nearest);
  }
  return nearest;
}

template NearestPoint<2> nearest_point<2>(const FacePlane<2>&, const Vec<2>&);
template NearestPoint<3> nearest_point<3>(const FacePlane<3>&, const Vec<3>&);

}  // namespace brunt
// Tested by tests/unit/contact/particle_face_test.cpp.
