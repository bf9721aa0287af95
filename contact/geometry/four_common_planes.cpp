#include "contact/geometry/four_common_planes.hpp"

#include <algorithm>

#include "contact/geometry/bilinear_weights.hpp"
#include "contact/geometry/place.hpp"
#include "contact/geometry/plane_draft.hpp"
#include "contact/geometry/plane_parts.hpp"
#include "contact/geometry/side_by_side.hpp"

namespace brunt {

namespace {
/// What a plane is found from, of one side of four pairs.
struct FourSides {
  std::array<Place<Pack>, 4> corner;
  Place<Pack> center, normal;
  Pack area, warp, sharpness;

  template <class Of>
  explicit FourSides(const Of& of) {
    const auto rows = [&](int lane) { return CornerRows(of(lane).corner); };
    corner = side_by_side(rows(0), rows(1), rows(2), rows(3));
    Pack first[4], last[4];
    // Numbers in a row: centre, normal, area and warp.
    const auto row = [&](int lane) { return of(lane).center.data(); };
    transpose(load(row(0)), load(row(1)), load(row(2)), load(row(3)), first);
    transpose(load(row(0) + kLanes), load(row(1) + kLanes), load(row(2) + kLanes),
              load(row(3) + kLanes), last);
    center = {first[0], first[1], first[2]}, normal = {first[3], last[0], last[1]};
    area = last[2], warp = last[3];
    sharpness = Pack{of(0).sharpness, of(1).sharpness, of(2).sharpness, of(3).sharpness};
  }
};

/// A linear function over each of four planes.
struct FourFields {
  Pack value;
  InPlane<Pack> slope;
  BRUNT_INLINE Pack at(const InPlane<Pack>& p) const {
    return value + slope.x * p.x + slope.y * p.y;
  }
};

/// Up to the outlines of both faces and the penetration between them: step by step what one_plane
/// does, in its order. All of the planes are found, and `there` says which are looked for.
struct FourOutlines {
  PackMask there;
  Pack facing, ramp, growth;
  Place<Pack> normal, origin, axis_1, axis_2;
  FourQuadsInPlane below, above;
  FourFields penetration;
  Pack smaller;  // area of the smaller face

  FourOutlines(const FourSides& lower, const FourSides& upper, Pack opening) {
    smaller = select(upper.area < lower.area, upper.area, lower.area);
    facing = -dot(lower.normal, upper.normal);
    set_ramp(vmin(lower.sharpness, upper.sharpness));
    if (!any(there)) return;
    normal = unit(lower.normal - upper.normal);
    origin = broadcast<Pack>(0.5) * (lower.center + upper.center);
    const auto height = [&](const Place<Pack>& x) { return dot(normal, x - origin); };
    Pack top = height(lower.corner[0]), bottom = height(upper.corner[0]);
    for (std::size_t c = 1; c < 4; ++c) {
      top = vmax(height(lower.corner[c]), top);
      bottom = vmin(height(upper.corner[c]), bottom);
    }
    there = there & !(bottom - top >= 1.42 * (lower.warp + upper.warp) + opening);
    if (!any(there)) return;
    set_axes();
    for (std::size_t c = 0; c < 4; ++c) {
      below.corner[c] = in_plane(lower.corner[c] - origin);
      above.corner[c] = in_plane(upper.corner[3 - c] - origin);
    }
    const FourFields to_top = height_of(lower), to_bottom = height_of(upper);
    penetration.value = to_top.value - to_bottom.value + opening;
    penetration.slope = to_top.slope - to_bottom.slope;
  }

 private:
  static BRUNT_INLINE Place<Pack> unit(const Place<Pack>& a) {
    const Pack length = vsqrt(dot(a, a));
    return {a.x / length, a.y / length, a.z / length};
  }
  BRUNT_INLINE InPlane<Pack> in_plane(const Place<Pack>& arm) const {
    return {dot(arm, axis_1), dot(arm, axis_2)};
  }
  /// As FacingRamp.
  void set_ramp(Pack sharpness) {
    const Pack none = 0.18 * kBoxSharpness * sharpness, whole = 0.34 * kBoxSharpness * sharpness;
    there = facing > none;
    const Pack one = broadcast<Pack>(1.0), zero = broadcast<Pack>(0.0);
    const Pack part = (facing - none) / (whole - none), s = select(one < part, one, part);
    ramp = s * s * (3.0 - 2.0 * s);
    growth = zero;
    if (!any(s < one)) return;
    const Pack steep = 6.0 * (1.0 - s) / (s * (3.0 - 2.0 * s) * (whole - none));
    growth = select(s < one, steep, zero);
  }
  void set_axes() {
    const Pack one = broadcast<Pack>(1.0), zero = broadcast<Pack>(0.0);
    const Pack x = vabs(normal.x), y = vabs(normal.y), z = vabs(normal.z);
    // The smallest component decides; equal ones go to the first.
    const PackMask is_z = (z < x) & (z < y), is_y = (y < x) & !is_z;
    const PackMask is_x = !(is_z | is_y);
    const Pack along = select(is_z, normal.z, select(is_y, normal.y, normal.x));
    const Place<Pack> axis = {select(is_x, one, zero), select(is_y, one, zero),
                              select(is_z, one, zero)};
    axis_1 = unit(axis - along * normal);
    axis_2 = cross(normal, axis_1);
  }
  BRUNT_INLINE FourFields height_of(const FourSides& face) const {
    const Pack along = dot(face.normal, normal);
    return {dot(face.normal, face.center - origin) / along,
            {-dot(face.normal, axis_1) / along, -dot(face.normal, axis_2) / along}};
  }
};

/// The overlaps that are all of the lower face, within the upper, and penetrate at each corner:
/// their integrals as of integrate().
struct FourWholeOverlaps {
  PackMask decided;  ///< that lie within the upper face and penetrate everywhere or nowhere
  PackMask presses;  ///< those of them that carry pressure
  Pack area, total, deepest;
  InPlane<Pack> moment, first;

  explicit FourWholeOverlaps(const FourOutlines& of) {
    const InPlane<Pack>* const x = of.below.corner;
    decided = presses = of.there & are_within(of);
    if (!any(decided)) return;
    Pack g[4];
    for (int c = 0; c < 4; ++c) g[c] = of.penetration.at(x[c]);
    const Pack zero = broadcast<Pack>(0.0);
    const PackMask all = (g[0] >= zero) & (g[1] >= zero) & (g[2] >= zero) & (g[3] >= zero);
    const PackMask none = (g[0] < zero) & (g[1] < zero) & (g[2] < zero) & (g[3] < zero);
    decided = decided & (all | none);
    deepest = vmax(vmax(g[0], g[1]), vmax(g[2], g[3]));
    area = total = moment.x = moment.y = first.x = first.y = zero;
    for (int i = 1; i < 3; ++i) add(x[0], x[i], x[i + 1], g[0], g[i], g[i + 1]);
    presses = decided & all & (area > kSliver * of.smaller) &
              (total > kTouching * vsqrt(of.smaller) * area);
  }

 private:
  /// As intersect() asks of each side of the upper face, and what is left of area.
  static PackMask are_within(const FourOutlines& of) {
    const InPlane<Pack>*const x = of.below.corner, *const y = of.above.corner;
    const Pack twice = cross(x[1] - x[0], x[2] - x[0]) + cross(x[2] - x[0], x[3] - x[0]);
    PackMask within = 0.5 * twice > kSliver * of.smaller;
    for (int i = 0; i < 4; ++i) {
      const InPlane<Pack> edge = y[(i + 1) % 4] - y[i];
      FourFields left;
      left.slope = {-edge.y, edge.x};
      left.value = -(left.slope.x * y[i].x + left.slope.y * y[i].y);
      for (int c = 0; c < 4; ++c) within = within & (left.at(x[c]) >= broadcast<Pack>(0.0));
    }
    return within;
  }
  BRUNT_INLINE void add(const InPlane<Pack>& p, const InPlane<Pack>& q, const InPlane<Pack>& r,
                        Pack at_p, Pack at_q, Pack at_r) {
    const Pack triangle = 0.5 * cross(q - p, r - p), at_all = at_p + at_q + at_r;
    const Pack third = triangle / 3.0, twelfth = triangle / 12.0;
    area = area + triangle;
    total = total + triangle * at_all / 3.0;
    const auto add_along = [&](Pack InPlane<Pack>::*c) {
      const Pack sum = p.*c + q.*c + r.*c;
      first.*c = first.*c + third * sum;
      const Pack weighted = at_all * sum + at_p * p.*c + at_q * q.*c + at_r * r.*c;
      moment.*c = moment.*c + twelfth * weighted;
    };
    add_along(&InPlane<Pack>::x), add_along(&InPlane<Pack>::y);
  }
};

/// Hands what is known of a plane over to it, and outlines and penetration to its draft.
class HandOver {
 public:
  explicit HandOver(const FourOutlines& of) : of_(of) {
    transpose(of.normal.x, of.normal.y, of.normal.z, of.facing, normal_);
    transpose(of.origin.x, of.origin.y, of.origin.z, of.ramp, origin_);
    transpose(of.axis_1.x, of.axis_1.y, of.axis_1.z, of.growth, axis_1_);
    transpose(of.axis_2.x, of.axis_2.y, of.axis_2.z, of.penetration.value, axis_2_);
    outlines(of.below, below_), outlines(of.above, above_);
  }
  void give(int lane, const PlaneNeeds& needs, CommonPlane<3>& plane) const {
    begin(of_.facing[lane], needs, plane);
    plane.ramp = of_.ramp[lane], plane.ramp_growth = of_.growth[lane];
    const auto vector = [&](Pack of) { return Vec3(of[0], of[1], of[2]); };
    plane.normal = vector(normal_[lane]), plane.origin = vector(origin_[lane]);
    plane.axis_1 = vector(axis_1_[lane]), plane.axis_2 = vector(axis_2_[lane]);
    plane.ordinal = 0;
  }
  void give(int lane, PlaneDraft& draft) const {
    const auto& field = of_.penetration;
    give(below_, lane, draft.below), give(above_, lane, draft.above);
    draft.penetration.value = field.value[lane];
    draft.penetration.slope = Vec<2>(field.slope.x[lane], field.slope.y[lane]);
  }

 private:
  using Rows = std::array<std::array<Pack, 4>, 2>;  // two corners of each lane in a row
  static void outlines(const FourQuadsInPlane& quad, Rows& rows) {
    const auto* x = quad.corner;
    transpose(x[0].x, x[0].y, x[1].x, x[1].y, rows[0].data());
    transpose(x[2].x, x[2].y, x[3].x, x[3].y, rows[1].data());
  }
  static void give(const Rows& rows, int lane, Polygon& polygon) {
    polygon.size = 4;
    for (std::size_t k = 0; k < 4; ++k) polygon.side[k] = static_cast<std::uint8_t>(k);
    store(polygon.corner[0].data(), rows[0][slot_of(lane)]);
    store(polygon.corner[2].data(), rows[1][slot_of(lane)]);
  }

  const FourOutlines& of_;
  Pack normal_[4], origin_[4], axis_1_[4], axis_2_[4];
  Rows below_, above_;
};

/// The weights of both faces at four points, for those that are there.
struct FourWeights {
  Pack lower[4], upper[4];
  FourWeights(const FourOutlines& of, const InPlane<Pack>& p, PackMask there) {
    Pack below[4], above[4];
    bilinear_weights(of.below, of.above, p, there, below, above);
    transpose(below[0], below[1], below[2], below[3], lower);
    transpose(above[3], above[2], above[1], above[0], upper);
  }
  void give(int lane, std::array<Real, 4>& to_lower, std::array<Real, 4>& to_upper) const {
    store(to_lower.data(), lower[lane]), store(to_upper.data(), upper[lane]);
  }
};

using FourDrafts = std::array<PlaneDraft, 4>;

/// In one go, or what is made lane by lane is waited for.
template <class Of>
BRUNT_INLINE InPlane<Pack> four(const FourDrafts& draft, const Of& of) {
  const auto along = [&](int c) {
    return Pack{of(draft[0])[c], of(draft[1])[c], of(draft[2])[c], of(draft[3])[c]};
  };
  return {along(0), along(1)};
}

void set_weights(const FourOutlines& of, const FourDrafts& draft, std::array<QuadPair, 4>& pair) {
  const auto presses = [&](std::size_t lane) { return pair[lane].presses ? -1L : 0L; };
  const PackMask there = {presses(0), presses(1), presses(2), presses(3)};
  bool any_middle = false;
  const FourWeights found(of, four(draft, [](auto& one) { return one.point(); }), there);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!pair[lane].presses) continue;
    CommonPlane<3>& plane = *pair[lane].plane;
    found.give(static_cast<int>(lane), plane.lower_weight, plane.upper_weight);
    any_middle = any_middle || pair[lane].needs.middle;
    if (pair[lane].needs.middle) continue;
    found.give(static_cast<int>(lane), plane.lower_at_middle, plane.upper_at_middle);
  }
  if (!any_middle) return;
  const FourWeights middle(of, four(draft, [](auto& one) { return one.middle(); }), there);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if (!pair[lane].presses || !pair[lane].needs.middle) continue;
    CommonPlane<3>& plane = *pair[lane].plane;
    middle.give(static_cast<int>(lane), plane.lower_at_middle, plane.upper_at_middle);
  }
}
}  // namespace

void four_common_planes(std::array<QuadPair, 4>& pair, int n) {
  const auto last = [&](int lane) -> const QuadPair& {
    return pair[slot_of(std::min(lane, n - 1))];
  };
  const FourSides lower([&](int lane) -> const FacePlane<3>& { return *last(lane).lower; });
  const FourSides upper([&](int lane) -> const FacePlane<3>& { return *last(lane).upper; });
  const FourOutlines of(lower, upper,
                        Pack{last(0).needs.opening, last(1).needs.opening, last(2).needs.opening,
                             last(3).needs.opening});
  for (auto& one : pair) one.presses = false;
  const unsigned asked = mask_bits(of.there) & ((1U << n) - 1);
  if (asked == 0) return;
  const FourWholeOverlaps whole(of);
  const unsigned decided = mask_bits(whole.decided), pressed = mask_bits(whole.presses);
  if ((asked & (~decided | pressed)) == 0) return;
  const HandOver known(of);
  FourDrafts draft;
  bool any_presses = false;
  for (int lane = 0; lane < n; ++lane) {
    const unsigned bit = 1U << lane;
    if ((asked & (~decided | pressed) & bit) == 0) continue;
    auto& one = pair[slot_of(lane)];
    known.give(lane, one.needs, *one.plane);
    auto& its = draft[slot_of(lane)];
    its.begin(*one.lower, *one.upper, one.needs, *one.plane);
    known.give(lane, its);
    if ((decided & bit) != 0) {
      its.take_overlap(
          {whole.area[lane], whole.total[lane], Vec<2>(whole.moment.x[lane], whole.moment.y[lane]),
           Vec<2>(whole.first.x[lane], whole.first.y[lane])},
          whole.deepest[lane]);
    } else if (!its.find_overlap()) {
      continue;
    }
    one.presses = its.find_pressure();
    any_presses = any_presses || one.presses;
  }
  if (!any_presses) return;
  set_weights(of, draft, pair);
  for (int lane = 0; lane < n; ++lane) {
    if (pair[slot_of(lane)].presses) draft[slot_of(lane)].follow_potential();
  }
}

}  // namespace brunt
// Tested by tests/unit/contact/four_common_planes_test.cpp.
