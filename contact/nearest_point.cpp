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

/// A triangle of a face, its corners there (-1: the centre), and its point that is nearest to x.
struct Candidate {
  std::array<Vec3, 3> at = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::array<int, 3> corner{};
  std::array<Real, 3> weight{};
  Vec3 point = Vec3::Zero();
  Real squared_distance = kInfinity;
};

/// Of one triangle, or of four: weights and place of the nearest point, its squared distance [m^2].
template <class V>
struct OfTriangles {
  Place<V> weight, point;
  V squared_distance;  // infinite without area
};
template <class V>
BRUNT_INLINE OfTriangles<V> nearest_on(const Place<V> (&t)[3], const Place<V>& x) {
  OfTriangles<V> found;
  found.weight = nearest_weights(x, t[0], t[1], t[2]);
  found.point = found.weight.x * t[0] + found.weight.y * t[1] + found.weight.z * t[2];
  const auto arm = x - found.point, twice = cross(t[1] - t[0], t[2] - t[0]);
  found.squared_distance =
      select(dot(twice, twice) > broadcast<V>(0.0), dot(arm, arm), broadcast<V>(kInfinity));
  return found;
}

Candidate nearest_on_triangle(const FacePlane<3>& face, const Vec3& x) {
  const auto& at = face.corner;
  const Place<Real> t[3] = {place(at[0]), place(at[1]), place(at[2])};
  const auto found = nearest_on(t, place(x));
  if (!(found.squared_distance < kInfinity)) return {};
  return {{at[0], at[1], at[2]},
          {0, 1, 2},
          {found.weight.x, found.weight.y, found.weight.z},
          Vec3(found.point.x, found.point.y, found.point.z),
          found.squared_distance};
}

/// The four triangles of a quad about its centre side by side; of equals the first.
Candidate nearest_on_quad(const FacePlane<3>& face, const Vec3& x) {
  const auto& at = face.corner;
  const Place<Pack> from = corners(at);
  const Place<Pack> t[3] = {from, next(from), everywhere(face.center)};
  const auto found = nearest_on(t, everywhere(x));
  Candidate best;
  int nearest = -1;
  for (int k = 0; k < kLanes; ++k) {
    if (!(found.squared_distance[k] < best.squared_distance)) continue;
    best.squared_distance = found.squared_distance[k];
    nearest = k;
  }
  if (nearest < 0) return best;
  const int k = nearest, j = (k + 1) % kLanes;
  best.at = {at[static_cast<std::size_t>(k)], at[static_cast<std::size_t>(j)], face.center};
  best.corner = {k, j, -1};
  best.weight = {found.weight.x[k], found.weight.y[k], found.weight.z[k]};
  best.point = Vec3(found.point.x[k], found.point.y[k], found.point.z[k]);
  return best;
}

NearestPoint<3> nearest_of(const Candidate& best) {
  NearestPoint<3> nearest;
  const auto& t = best.at;
  nearest.distance = std::sqrt(best.squared_distance);
  nearest.point = best.point;
  nearest.normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  const bool is_quad = best.corner[2] < 0;
  nearest.weight.fill(is_quad ? 0.25 * best.weight[2] : 0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    if (best.corner[i] >= 0)
      nearest.weight[static_cast<std::size_t>(best.corner[i])] += best.weight[i];
  }
  name_feature(best.weight, best.corner, is_quad, nearest);
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
    return nearest_of(face.n_corners == 3 ? nearest_on_triangle(face, x)
                                          : nearest_on_quad(face, x));
  }
}

template NearestPoint<2> nearest_point<2>(const FacePlane<2>&, const Vec<2>&);
template NearestPoint<3> nearest_point<3>(const FacePlane<3>&, const Vec<3>&);

}  // namespace brunt
