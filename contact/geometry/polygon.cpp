#include "contact/geometry/polygon.hpp"

#include "core/simd.hpp"

namespace brunt {

namespace {
Real plane_cross(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }
}  // namespace

namespace {
/// What clip() keeps, to `kept`; false where that is all of it, and nothing is written. The side
/// along the cut gets the name.
bool clip_to(const Polygon& polygon, const LinearField& keep, std::uint8_t name, Polygon& kept) {
  Real at[Polygon::kRoom];
  bool all = true;
  for (int i = 0; i < polygon.size; ++i) {
    at[i] = keep.at(polygon[i]);
    all = all && at[i] >= 0;
  }
  if (all) return false;
  kept.size = 0;
  int last = polygon.size - 1;
  for (int i = 0; i < polygon.size; last = i++) {
    const Real at_p = at[last], at_q = at[i];
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) {
      const Vec<2>& p = polygon[last];
      const std::uint8_t entered = polygon.side[slot_of(last)];
      kept.push(p + (at_p / (at_p - at_q)) * (polygon[i] - p), at_p > 0 ? name : entered);
    }
    if (!(at_q >= 0)) continue;
    const int next = i + 1 == polygon.size ? 0 : i + 1;
    const bool leaves = at_q == 0 && at[next] < 0;
    kept.push(polygon[i], leaves ? name : polygon.side[slot_of(i)]);
  }
  return true;
}
}  // namespace

void clip(const Polygon& polygon, const LinearField& keep, Polygon& kept) {
  if (!clip_to(polygon, keep, Polygon::kCut, kept)) kept = polygon;
}

namespace {
/// How many sides of a quad b, from the first on, cut nothing off a quad a: all corners of a
/// compared with four sides at once, by the numbers that clip_to finds.
int sides_that_keep(const Polygon& a, const Polygon& b) {
  const auto of = [&](int c) { return Pack{b[0][c], b[1][c], b[2][c], b[3][c]}; };
  const auto next = [](Pack p) { return __builtin_shufflevector(p, p, 1, 2, 3, 0); };
  const Pack x = of(0), y = of(1);
  const Pack slope_x = -(next(y) - y), slope_y = next(x) - x;
  const Pack value = -(slope_x * x + slope_y * y);
  PackMask keeps = broadcast<Pack>(0.0) < broadcast<Pack>(1.0);  // all
  for (int i = 0; i < 4; ++i) {
    const Pack at = value + slope_x * a[i][0] + slope_y * a[i][1];
    keeps = keeps & (at >= 0.0);
  }
  return __builtin_ctz(~mask_bits(keeps));
}
}  // namespace

Polygon intersect(const Polygon& a, const Polygon& b) {
  Polygon room[2];
  const Polygon* overlap = &a;
  int next = 0;
  const int first = a.size == 4 && b.size == 4 ? sides_that_keep(a, b) : 0;
  for (int i = first; i < b.size && overlap->size > 2; ++i) {
    const Vec<2>& p = b[i];
    const Vec<2> edge = b[i + 1 == b.size ? 0 : i + 1] - p;
    LinearField left;
    left.slope = Vec<2>(-edge[1], edge[0]);
    left.value = -left.slope.dot(p);
    const auto name = static_cast<std::uint8_t>(Polygon::kOfSecond + i);
    if (!clip_to(*overlap, left, name, room[next])) continue;
    overlap = &room[next];
    next = 1 - next;
  }
  return overlap->size < 3 ? Polygon{} : *overlap;
}

Real area(const Polygon& polygon) {
  Real twice = 0;
  for (int i = 1; i + 1 < polygon.size; ++i) {
    twice += plane_cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice;
}

FieldIntegrals integrate(const Polygon& polygon, const LinearField& g) {
  if (polygon.size < 3) return {};
  // On their own: sums that stand where they are returned to would wait for their own stores.
  Real area = 0, total = 0;
  Vec<2> moment = Vec<2>::Zero(), first = Vec<2>::Zero();
  const Vec<2> p = polygon[0];
  const Real at_p = g.at(p);
  for (int i = 1; i + 1 < polygon.size; ++i) {
    const Vec<2>& q = polygon[i];
    const Vec<2>& r = polygon[i + 1];
    const Real triangle = 0.5 * plane_cross(q - p, r - p);
    const Real at_q = g.at(q), at_r = g.at(r), at_all = at_p + at_q + at_r;
    area += triangle;
    total += triangle * at_all / 3;
    first += triangle / 3 * (p + q + r);
    moment += triangle / 12 * (at_all * (p + q + r) + at_p * p + at_q * q + at_r * r);
  }
  return {area, total, moment, first};
}

}  // namespace brunt
