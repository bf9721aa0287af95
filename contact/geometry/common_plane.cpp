#include "contact/geometry/common_plane.hpp"

#include <cmath>

#include "contact/geometry/plane_draft.hpp"
#include "contact/geometry/plane_parts.hpp"

namespace brunt {

namespace {
/// Mean plane of a face as a height along n over the common plane.
LinearField height(const FacePlane<3>& face, const CommonPlane<3>& plane) {
  const Real along = face.normal.dot(plane.normal);
  LinearField field;
  field.value = face.normal.dot(face.center - plane.origin) / along;
  field.slope =
      Vec<2>(-face.normal.dot(plane.axis_1) / along, -face.normal.dot(plane.axis_2) / along);
  return field;
}

void set_axes(CommonPlane<3>& plane) {
  // The smallest component decides; equal ones go to the first.
  Eigen::Index smallest = 0;
  plane.normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 unit = Vec3::Unit(smallest);
  plane.axis_1 = (unit - unit.dot(plane.normal) * plane.normal).normalized();
  plane.axis_2 = plane.normal.cross(plane.axis_1);
}

/// Corners in the plane, counter-clockwise about the normal: those of the upper face run back.
void project(const FacePlane<3>& face, const CommonPlane<3>& plane, bool reverse,
             Polygon& polygon) {
  for (int i = 0; i < face.n_corners; ++i) {
    const int k = reverse ? face.n_corners - 1 - i : i;
    const Vec3 arm = face.corner[slot_of(k)] - plane.origin;
    polygon.push(Vec<2>(arm.dot(plane.axis_1), arm.dot(plane.axis_2)),
                 static_cast<std::uint8_t>(i));
  }
}

/// The plane between two simple faces in 3D; false if it carries no pressure.
bool one_plane(const FacePlane<3>& lower, const FacePlane<3>& upper, const PlaneNeeds& needs,
               CommonPlane<3>& plane) {
  if (!orient(lower, upper, needs, plane)) return false;
  if (!needs.whole && apart(lower, upper, plane.normal, plane.origin, needs.opening)) return false;
  set_axes(plane);
  PlaneDraft draft;
  draft.begin(lower, upper, needs, plane);
  project(lower, plane, false, draft.below);
  project(upper, plane, true, draft.above);
  const LinearField top = height(lower, plane), bottom = height(upper, plane);
  draft.penetration.value = top.value - bottom.value + needs.opening;
  draft.penetration.slope = top.slope - bottom.slope;
  if (!draft.find_overlap() || !draft.find_pressure()) return false;
  draft.set_weights();
  draft.follow_potential();
  return true;
}

/// A face as itself, or as the four triangles of one that is split.
struct Parts {
  Parts(const FacePlane<3>& face, const FacePlane<3>& mate) : whole(face) {
    if (!is_split(face, mate)) return;
    parts = split(face);
    count = 4;
  }
  const FacePlane<3>& operator[](std::size_t i) const { return count == 1 ? whole : parts[i]; }
  /// Puts the weights of part i where the corners of the whole face are: of its centre each corner
  /// has a quarter.
  template <class Value>
  void spread(std::size_t i, std::array<Value, 4>& weight) const {
    if (count == 1) return;
    const std::array<Value, 4> of_part = weight;
    weight.fill(0.25 * of_part[2]);
    weight[i] += of_part[0];
    weight[(i + 1) % 4] += of_part[1];
  }
  const FacePlane<3>& whole;
  std::array<FacePlane<3>, 4> parts;
  std::size_t count = 1;
};

int split_planes(const FacePlane<3>& lower, const FacePlane<3>& upper, const PlaneNeeds& needs,
                 Planes<3>& plane) {
  const Parts below(lower, upper), above(upper, lower);
  std::size_t n = 0;
  for (std::size_t i = 0; i < below.count; ++i) {
    for (std::size_t j = 0; j < above.count; ++j) {
      if (!one_plane(below[i], above[j], needs, plane[n])) continue;
      plane[n].ordinal = static_cast<std::uint32_t>(4 * i + j);
      below.spread(i, plane[n].lower_weight);
      above.spread(j, plane[n].upper_weight);
      below.spread(i, plane[n].lower_at_middle);
      above.spread(j, plane[n].upper_at_middle);
      if (plane[n].share > 0) {
        below.spread(i, plane[n].lower_push);
        above.spread(j, plane[n].upper_push);
      }
      ++n;
    }
  }
  return static_cast<int>(n);
}
}  // namespace

template <int Dim>
int common_planes(const FacePlane<Dim>& lower, const FacePlane<Dim>& upper, const Section& section,
                  Planes<Dim>& plane, const PlaneNeeds& needs) {
  plane[0].ordinal = 0;
  if constexpr (Dim == 2) {
    return common_line(lower, upper, section, needs, plane[0]) ? 1 : 0;
  } else {
    if (is_split(lower, upper) || is_split(upper, lower)) {
      return split_planes(lower, upper, needs, plane);
    }
    return one_plane(lower, upper, needs, plane[0]) ? 1 : 0;
  }
}

template int common_planes<2>(const FacePlane<2>&, const FacePlane<2>&, const Section&, Planes<2>&,
                              const PlaneNeeds&);
template int common_planes<3>(const FacePlane<3>&, const FacePlane<3>&, const Section&, Planes<3>&,
                              const PlaneNeeds&);

}  // namespace brunt
