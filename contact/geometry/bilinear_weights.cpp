#include "contact/geometry/bilinear_weights.hpp"

#include "core/simd.hpp"

namespace brunt {

namespace {
/// Coordinates of one point, or of four.
template <class V>
struct InPlane {
  V x, y;
};
template <class V>
BRUNT_INLINE InPlane<V> operator+(const InPlane<V>& a, const InPlane<V>& b) {
  return {a.x + b.x, a.y + b.y};
}
template <class V>
BRUNT_INLINE InPlane<V> operator-(const InPlane<V>& a, const InPlane<V>& b) {
  return {a.x - b.x, a.y - b.y};
}
template <class V>
BRUNT_INLINE InPlane<V> operator*(V s, const InPlane<V>& a) {
  return {s * a.x, s * a.y};
}
template <class V>
BRUNT_INLINE V cross(const InPlane<V>& a, const InPlane<V>& b) {
  return a.x * b.y - a.y * b.x;
}
template <class V>
BRUNT_INLINE V within_one(V s) {
  const V one = broadcast<V>(1.0);
  return select(s < -one, -one, select(one < s, one, s));
}

/// Where p lies in the square [-1, 1]^2, by Newton's steps. A lane that has got there stays: after
/// a step of 1e-8 the error is of its square.
template <class V>
BRUNT_INLINE InPlane<V> inverse(const InPlane<V> (&corner)[4], const InPlane<V>& middle,
                                const InPlane<V>& p) {
  const V quarter = broadcast<V>(0.25);
  const auto along_1 = quarter * ((corner[1] - corner[0]) + (corner[2] - corner[3]));
  const auto along_2 = quarter * ((corner[3] - corner[0]) + (corner[2] - corner[1]));
  const auto twist = quarter * ((corner[0] - corner[1]) + (corner[2] - corner[3]));
  const V zero = broadcast<V>(0.0);
  V xi = zero, eta = zero;
  auto active = zero < broadcast<V>(1.0);  // all
  for (int iteration = 0; iteration < 12 && any(active); ++iteration) {
    const auto rest = p - middle - xi * along_1 - eta * along_2 - (xi * eta) * twist;
    const auto d_xi = along_1 + eta * twist, d_eta = along_2 + xi * twist;
    const V inverse_det = 1.0 / cross(d_xi, d_eta);
    const V step_xi = cross(rest, d_eta) * inverse_det, step_eta = cross(d_xi, rest) * inverse_det;
    xi = select(active, within_one(xi + step_xi), xi);
    eta = select(active, within_one(eta + step_eta), eta);
    active = active & !(vabs(step_xi) + vabs(step_eta) < 1e-8);
  }
  return {xi, eta};
}

template <class V>
BRUNT_INLINE void find_weights(const InPlane<V> (&corner)[4], const InPlane<V>& p, V (&weight)[4]) {
  const auto middle = broadcast<V>(0.25) * ((corner[0] + corner[1]) + (corner[2] + corner[3]));
  const auto [xi, eta] = inverse(corner, middle, p);
  weight[0] = 0.25 * (1.0 - xi) * (1.0 - eta);
  weight[1] = 0.25 * (1.0 + xi) * (1.0 - eta);
  weight[2] = 0.25 * (1.0 + xi) * (1.0 + eta);
  weight[3] = 0.25 * (1.0 - xi) * (1.0 + eta);
  // The couple that is left, carried by forces along the normal: w_a += b . (x_a - mean).
  InPlane<V> moment = p - middle;
  V j11 = broadcast<V>(0.0), j12 = j11, j22 = j11;
  for (int a = 0; a < 4; ++a) {
    const auto arm = corner[a] - middle;
    moment = moment - weight[a] * arm;
    j11 = j11 + arm.x * arm.x, j12 = j12 + arm.x * arm.y, j22 = j22 + arm.y * arm.y;
  }
  const V inverse_det = 1.0 / (j11 * j22 - j12 * j12);
  const V b_x = (j22 * moment.x - j12 * moment.y) * inverse_det;
  const V b_y = (j11 * moment.y - j12 * moment.x) * inverse_det;
  for (int a = 0; a < 4; ++a) {
    const auto arm = corner[a] - middle;
    weight[a] = weight[a] + (b_x * arm.x + b_y * arm.y);
  }
}
}  // namespace

std::array<Real, 4> bilinear_weights(const std::array<Vec<2>, 4>& corner, const Vec<2>& p) {
  InPlane<Real> place[4];
  for (std::size_t a = 0; a < 4; ++a) place[a] = {corner[a][0], corner[a][1]};
  Real weight[4];
  find_weights(place, {p[0], p[1]}, weight);
  return {weight[0], weight[1], weight[2], weight[3]};
}

std::array<std::array<Real, 4>, 4> bilinear_weights(const std::array<const Polygon*, 4>& face,
                                                    const std::array<Vec<2>, 4>& p) {
  InPlane<Pack> place[4], point{};
  for (int k = 0; k < kLanes; ++k) {
    const auto lane = slot_of(k);
    for (int a = 0; a < 4; ++a) {
      place[a].x[k] = (*face[lane])[a][0], place[a].y[k] = (*face[lane])[a][1];
    }
    point.x[k] = p[lane][0], point.y[k] = p[lane][1];
  }
  Pack weight[4];
  find_weights(place, point, weight);
  std::array<std::array<Real, 4>, 4> lanes{};
  for (int k = 0; k < kLanes; ++k) {
    for (std::size_t a = 0; a < 4; ++a) lanes[slot_of(k)][a] = weight[a][k];
  }
  return lanes;
}

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
