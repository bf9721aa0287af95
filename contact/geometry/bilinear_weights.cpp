#include "contact/geometry/bilinear_weights.hpp"

#include "core/transpose.hpp"

namespace brunt {

namespace {
template <class V>
BRUNT_INLINE V within_one(V s) {
  return vmin(broadcast<V>(1.0), vmax(broadcast<V>(-1.0), s));  // what is no number stays so
}

/// A quad, and a point in it; or four of each.
template <class V>
struct QuadPoint {
  const InPlane<V>* corner;
  InPlane<V> p, middle;

  QuadPoint(const InPlane<V> (&corners)[4], const InPlane<V>& at)
      : corner(corners),
        p(at),
        middle(broadcast<V>(0.25) * ((corner[0] + corner[1]) + (corner[2] + corner[3]))) {}
};

/// Newton's steps to where the point lies in the square [-1, 1]^2.
template <class V>
struct Inverse {
  InPlane<V> along_1, along_2, twist, from_middle;
  V xi = broadcast<V>(0.0), eta = broadcast<V>(0.0);
  MaskOf<V> active;

  BRUNT_INLINE Inverse(const QuadPoint<V>& of, MaskOf<V> there)
      : from_middle(of.p - of.middle), active(there) {
    const auto* corner = of.corner;
    const V quarter = broadcast<V>(0.25);
    along_1 = quarter * ((corner[1] - corner[0]) + (corner[2] - corner[3]));
    along_2 = quarter * ((corner[3] - corner[0]) + (corner[2] - corner[1]));
    twist = quarter * ((corner[0] - corner[1]) + (corner[2] - corner[3]));
  }
  BRUNT_INLINE void step() {
    const auto rest = from_middle - xi * along_1 - eta * along_2 - (xi * eta) * twist;
    const auto d_xi = along_1 + eta * twist, d_eta = along_2 + xi * twist;
    const V inverse_det = 1.0 / cross(d_xi, d_eta);
    const V step_xi = cross(rest, d_eta) * inverse_det, step_eta = cross(d_xi, rest) * inverse_det;
    xi = select(active, within_one(xi + step_xi), xi);
    eta = select(active, within_one(eta + step_eta), eta);
    active = active & !(vabs(step_xi) + vabs(step_eta) < 1e-8);
  }
};

/// Steps of N side by side. A lane that has got there stays: after a step of 1e-8 the error is of
/// its square. Whether all have is asked after two steps, which a parallelogram takes, and from the
/// fourth on: others take four or five, and a guess that fails costs more than a step.
template <class V, std::size_t N>
BRUNT_INLINE void find_places(std::array<Inverse<V>, N>& of) {
  for (int iteration = 0; iteration < 12; ++iteration) {
    auto active = of[0].active;
    for (std::size_t k = 1; k < N; ++k) active = active | of[k].active;
    if ((iteration == 2 || iteration > 3) && !any(active)) break;
    for (auto& one : of) one.step();
  }
}

template <class V>
BRUNT_INLINE void weights_at(const QuadPoint<V>& of, V xi, V eta, V (&weight)[4]) {
  weight[0] = 0.25 * (1.0 - xi) * (1.0 - eta);
  weight[1] = 0.25 * (1.0 + xi) * (1.0 - eta);
  weight[2] = 0.25 * (1.0 + xi) * (1.0 + eta);
  weight[3] = 0.25 * (1.0 - xi) * (1.0 + eta);
  // The couple that is left, carried by forces along the normal: w_a += b . (x_a - mean).
  InPlane<V> moment = of.p - of.middle;
  V j11 = broadcast<V>(0.0), j12 = j11, j22 = j11;
  for (int a = 0; a < 4; ++a) {
    const auto arm = of.corner[a] - of.middle;
    moment = moment - weight[a] * arm;
    j11 = j11 + arm.x * arm.x, j12 = j12 + arm.x * arm.y, j22 = j22 + arm.y * arm.y;
  }
  const V inverse_det = 1.0 / (j11 * j22 - j12 * j12);
  const V b_x = (j22 * moment.x - j12 * moment.y) * inverse_det;
  const V b_y = (j11 * moment.y - j12 * moment.x) * inverse_det;
  for (int a = 0; a < 4; ++a) {
    const auto arm = of.corner[a] - of.middle;
    weight[a] = weight[a] + (b_x * arm.x + b_y * arm.y);
  }
}

template <class V>
BRUNT_INLINE void find_weights(const InPlane<V> (&corner)[4], const InPlane<V>& p, V (&weight)[4]) {
  const QuadPoint<V> of(corner, p);
  std::array<Inverse<V>, 1> place = {Inverse<V>(of, broadcast<V>(0.0) < broadcast<V>(1.0))};
  find_places(place);
  weights_at(of, place[0].xi, place[0].eta, weight);
}
}  // namespace

void bilinear_weights(const FourQuadsInPlane& a, const FourQuadsInPlane& b, const InPlane<Pack>& p,
                      PackMask there, Pack (&of_a)[4], Pack (&of_b)[4]) {
  const QuadPoint<Pack> first(a.corner, p), second(b.corner, p);
  std::array<Inverse<Pack>, 2> place = {Inverse<Pack>(first, there), Inverse<Pack>(second, there)};
  find_places(place);
  weights_at(first, place[0].xi, place[0].eta, of_a);
  weights_at(second, place[1].xi, place[1].eta, of_b);
}

std::array<Real, 4> bilinear_weights(const std::array<Vec<2>, 4>& corner, const Vec<2>& p) {
  InPlane<Real> place[4];
  for (std::size_t a = 0; a < 4; ++a) place[a] = {corner[a][0], corner[a][1]};
  Real weight[4];
  find_weights(place, {p[0], p[1]}, weight);
  return {weight[0], weight[1], weight[2], weight[3]};
}

namespace {
/// A corner of the lower face in the first and third lane, of the upper one in the others.
BRUNT_INLINE InPlane<Pack> in_turn(const Vec<2>& below, const Vec<2>& above) {
  return {Pack{below[0], above[0], below[0], above[0]},
          Pack{below[1], above[1], below[1], above[1]}};
}
}  // namespace

std::array<std::array<Real, 4>, 4> bilinear_weights(const Polygon& below, const Polygon& above,
                                                    const Vec<2>& p, const Vec<2>& middle) {
  const InPlane<Pack> corner[4] = {in_turn(below[0], above[0]), in_turn(below[1], above[1]),
                                   in_turn(below[2], above[2]), in_turn(below[3], above[3])};
  const InPlane<Pack> point = {Pack{p[0], p[0], middle[0], middle[0]},
                               Pack{p[1], p[1], middle[1], middle[1]}};
  Pack weight[4];
  find_weights(corner, point, weight);
  Pack forward[4], back[4];
  transpose(weight[0], weight[1], weight[2], weight[3], forward);
  transpose(weight[3], weight[2], weight[1], weight[0], back);
  std::array<std::array<Real, 4>, 4> weights;
  store(weights[0].data(), forward[0]), store(weights[1].data(), back[1]);
  store(weights[2].data(), forward[2]), store(weights[3].data(), back[3]);
  return weights;
}

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
