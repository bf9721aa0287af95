#include "contact/geometry/plane_draft.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/bilinear_weights.hpp"
#include "contact/geometry/plane_parts.hpp"

namespace brunt {

bool PlaneDraft::find_overlap() {
  const Polygon overlap = intersect(below, above);
  const Real smaller = std::min(lower_->area, upper_->area);
  if (!(area(overlap) > kSliver * smaller)) return false;
  CommonPlane<3>& plane = *plane_;
  if (whole()) {
    plane.polygon = overlap;
  } else {
    clip(overlap, penetration, plane.polygon);
  }
  sum_ = integrate(plane.polygon, penetration);
  // What is left of an overlap where it penetrates may be a line: its area, of either sign, is
  // round-off.
  if (!(sum_.area > kSliver * smaller)) return false;
  if (!needs_->whole && !(sum_.total > kTouching * std::sqrt(smaller) * sum_.area)) return false;
  plane.deepest = -kInfinity;
  for (int i = 0; i < plane.polygon.size; ++i) {
    plane.deepest = std::max(plane.deepest, penetration.at(plane.polygon[i]));
  }
  return true;
}

void PlaneDraft::take_overlap(const FieldIntegrals& sum, Real deepest) {
  plane_->polygon = below;
  sum_ = sum;
  plane_->deepest = deepest;
}

bool PlaneDraft::find_pressure() {
  CommonPlane<3>& plane = *plane_;
  const FieldIntegrals& sum = sum_;
  if (!whole()) {
    deep_ =
        deep_area(plane.polygon, penetration, plane.half_cosine(), plane.deepest, plane.barrier);
  }
  if (pushes() && lower_->borders != 0 && upper_->borders != 0) {
    fade_ = fade_of(*lower_, *upper_, overlap(), plane);
  }
  if (fade_.factor == 0) return false;
  set_fade(fade_.factor, plane);
  plane.area = sum.area;
  Vec<2> p = whole() ? Vec<2>(sum.first / sum.area) : Vec<2>(sum.moment / sum.total);
  const Real of_barrier = set_spring(sum.total, penetration.at(p), deep_, whole(), plane);
  if (of_barrier > 0) p += of_barrier * (deep_.moment / deep_.squared - p);
  plane.penetration = penetration.at(p);
  plane.point = plane.origin + p[0] * plane.axis_1 + p[1] * plane.axis_2;
  point_ = p;
  middle_ = needs_->middle ? Vec<2>(sum.first / sum.area) : p;
  if (needs_->middle) {
    plane.middle = plane.origin + middle_[0] * plane.axis_1 + middle_[1] * plane.axis_2;
  }
  return true;
}

namespace {
std::array<Real, 4> weights(const Polygon& face, bool reverse, const Vec<2>& p) {
  std::array<Real, 4> in_order{};
  if (face.size == 4) {
    in_order = bilinear_weights({face[0], face[1], face[2], face[3]}, p);
  } else {
    const Vec<2> a = face[1] - face[0], b = face[2] - face[0], r = p - face[0];
    const Real twice = a[0] * b[1] - a[1] * b[0];
    in_order[1] = (r[0] * b[1] - r[1] * b[0]) / twice;
    in_order[2] = (a[0] * r[1] - a[1] * r[0]) / twice;
    in_order[0] = 1 - in_order[1] - in_order[2];
  }
  if (reverse) std::reverse(in_order.begin(), in_order.begin() + face.size);
  return in_order;
}
}  // namespace

/// Of both faces at two points: most faces are quads, whose weights are found together.
void PlaneDraft::set_weights() {
  CommonPlane<3>& plane = *plane_;
  if (below.size != 4 || above.size != 4) {
    plane.lower_weight = weights(below, false, point_);
    plane.upper_weight = weights(above, true, point_);
    plane.lower_at_middle = weights(below, false, middle_);
    plane.upper_at_middle = weights(above, true, middle_);
    return;
  }
  const auto found = bilinear_weights(below, above, point_, middle_);
  plane.lower_weight = found[0], plane.upper_weight = found[1];
  plane.lower_at_middle = found[2], plane.upper_at_middle = found[3];
}

void PlaneDraft::follow_potential() {
  if (!pushes()) return;
  const OverlapArea area = overlap();
  const PotentialShare share = potential_share(plane_->facing, area.change(*plane_), fade_);
  if (share.value > 0) add_potential(*lower_, *upper_, area, fade_, share, *plane_);
}

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
