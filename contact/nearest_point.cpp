#include "contact/particle_face.hpp"

#include <cmath>

#include "contact/place.hpp"

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
  const V all = va + vb + vc, of_b = vb / all, of_c = vc / all;
  Place<V> weight{one - of_b - of_c, of_b, of_c};
  // The first that holds counts: it is asked last.
  const auto set = [&](auto where, V on_a, V on_b, V on_c) {
    weight.x = select(where, on_a, weight.x);
    weight.y = select(where, on_b, weight.y);
    weight.z = select(where, on_c, weight.z);
  };
  const V along_bc = (d4 - d3) / ((d4 - d3) + (d5 - d6));
  set((va <= zero) & (d4 - d3 >= zero) & (d5 - d6 >= zero), zero, one - along_bc, along_bc);
  const V along_ac = d2 / (d2 - d6);
  set((vb <= zero) & (d2 >= zero) & (d6 <= zero), one - along_ac, zero, along_ac);
  set((d6 >= zero) & (d5 <= d6), zero, zero, one);
  const V along_ab = d1 / (d1 - d3);
  set((vc <= zero) & (d1 >= zero) & (d3 <= zero), one - along_ab, along_ab, zero);
  set((d3 >= zero) & (d4 <= d3), zero, one, zero);
  set((d1 <= zero) & (d2 <= zero), one, zero, zero);
  return weight;
}

void set_vertex(NearestPoint<3>& nearest, int corner) {
  nearest.feature = Feature::vertex;
  nearest.corner = {corner, corner};
}

/// What of the face the weights of a triangle name. Corner 2 is the quad's centre if is_quad.
void name_feature(const std::array<Real, 3>& w, const std::array<int, 3>& corner, bool is_quad,
                  NearestPoint<3>& nearest) {
  const int zeros = (w[0] == 0) + (w[1] == 0) + (w[2] == 0);
  nearest.smooth = zeros == 0;
  nearest.feature = Feature::face;
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
NearestPoint<3> nowhere() {
  NearestPoint<3> nearest;
  nearest.point.setZero(), nearest.normal.setZero();
  nearest.smooth = false;
  return nearest;
}

Vec3 vector(const Place<Real>& p) { return {p.x, p.y, p.z}; }

NearestPoint<3> nearest_on_triangle(const FacePlane<3>& face, const Vec3& x) {
  const auto& at = face.corner;
  const Place<Real> t[3] = {place(at[0]), place(at[1]), place(at[2])};
  const auto found = nearest_on(t, place(x));
  if (!(found.squared_distance < kInfinity)) return nowhere();
  NearestPoint<3> nearest;
  nearest.distance = std::sqrt(found.squared_distance);
  nearest.point = vector(found.point);
  nearest.normal = vector(found.normal).normalized();
  nearest.weight = {found.weight.x, found.weight.y, found.weight.z, 0};
  name_feature({found.weight.x, found.weight.y, found.weight.z}, {0, 1, 2}, false, nearest);
  return nearest;
}

/// The four triangles of a quad about its centre side by side; of equals the first.
NearestPoint<3> nearest_on_quad(const FacePlane<3>& face, const Vec3& x) {
  const Place<Pack> from = corners(face.corner);
  const Place<Pack> t[3] = {from, next(from), everywhere(face.center)};
  const auto found = nearest_on(t, everywhere(x));
  Real least = kInfinity;
  int k = -1;
  for (int i = 0; i < kLanes; ++i) {
    if (!(found.squared_distance[i] < least)) continue;
    least = found.squared_distance[i];
    k = i;
  }
  if (k < 0) return nowhere();
  NearestPoint<3> nearest;
  const auto lane = [k](const Place<Pack>& p) { return Place<Real>{p.x[k], p.y[k], p.z[k]}; };
  const Place<Real> weight = lane(found.weight);
  const int j = (k + 1) % kLanes;
  nearest.distance = std::sqrt(least);
  nearest.point = vector(lane(found.point));
  nearest.normal = vector(lane(found.normal)).normalized();
  nearest.weight.fill(0.25 * weight.z);
  nearest.weight[static_cast<std::size_t>(k)] += weight.x;
  nearest.weight[static_cast<std::size_t>(j)] += weight.y;
  name_feature({weight.x, weight.y, weight.z}, {k, j, -1}, true, nearest);
  return nearest;
}

NearestPoint<2> nearest_on_edge(const FacePlane<2>& face, const Vec<2>& x) {
  NearestPoint<2> nearest;
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
  return nearest;
}
}  // namespace

template <int Dim>
NearestPoint<Dim> nearest_point(const FacePlane<Dim>& face, const Vec<Dim>& x) {
  if constexpr (Dim == 2) {
    return nearest_on_edge(face, x);
  } else {
    return face.n_corners == 3 ? nearest_on_triangle(face, x) : nearest_on_quad(face, x);
  }
}

template NearestPoint<2> nearest_point<2>(const FacePlane<2>&, const Vec<2>&);
template NearestPoint<3> nearest_point<3>(const FacePlane<3>&, const Vec<3>&);

}  // namespace brunt
