#include "contact/particle_face.hpp"

#include <cmath>

namespace brunt {

namespace {
/// Barycentric weights of the point of a triangle that is nearest to x.
std::array<Real, 3> nearest_weights(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
  const Real d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Real d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const Real vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
  const Real d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const Real vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
  const Real va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const Real w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const Real all = va + vb + vc;
  return {1 - vb / all - vc / all, vb / all, vc / all};
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

/// Takes a triangle with area as the nearest if it is nearer than what is known.
void offer(const Vec3& x, const std::array<Vec3, 3>& t, const std::array<int, 3>& corner,
           Candidate& best) {
  if (!((t[1] - t[0]).cross(t[2] - t[0]).squaredNorm() > 0)) return;
  const auto w = nearest_weights(x, t[0], t[1], t[2]);
  const Vec3 point = w[0] * t[0] + w[1] * t[1] + w[2] * t[2];
  const Real squared_distance = (x - point).squaredNorm();
  if (!(squared_distance < best.squared_distance)) return;
  best = {t, corner, w, point, squared_distance};
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
    Candidate best;
    const auto& corner = face.corner;
    if (face.n_corners == 3) {
      offer(x, {corner[0], corner[1], corner[2]}, {0, 1, 2}, best);
      return nearest_of(best);
    }
    for (int i = 0; i < 4; ++i) {
      const int j = (i + 1) % 4;
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      offer(x, {corner[a], corner[b], face.center}, {i, j, -1}, best);
    }
    return nearest_of(best);
  }
}

template NearestPoint<2> nearest_point<2>(const FacePlane<2>&, const Vec<2>&);
template NearestPoint<3> nearest_point<3>(const FacePlane<3>&, const Vec<3>&);

}  // namespace brunt
