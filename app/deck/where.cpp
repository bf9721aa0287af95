#include "app/deck/where.hpp"

#include <cmath>

#include "core/geometry/placement.hpp"

namespace brunt::deck {

bool WhereBox::holds(std::span<const Real> place, Real tolerance) const {
  bool inside = true;
  for (std::size_t c = 0; c < min.size() && c < place.size(); ++c) {
    inside = inside && place[c] >= min[c] - tolerance && place[c] <= max[c] + tolerance;
  }
  return inside;
}

bool WhereCylinder::holds(std::span<const Real> place, Real tolerance) const {
  Vec3 arm = Vec3::Zero(), axis = Vec3::UnitZ();
  for (std::size_t c = 0; c < place.size() && c < 3; ++c) {
    arm[static_cast<int>(c)] = place[c] - (c < cylinder.base.size() ? cylinder.base[c] : 0);
  }
  if (geometry == Geometry::plane_strain) return arm.norm() <= cylinder.radius + tolerance;
  if (geometry == Geometry::axisymmetric) axis = Vec3::UnitY();
  if (geometry == Geometry::three_d) axis = to_vector<3>(cylinder.axis).normalized();
  const Real along = axis.dot(arm);
  return along >= -tolerance && along <= cylinder.length + tolerance &&
         (arm - along * axis).norm() <= cylinder.radius + tolerance;
}

bool holds(const WhereInside& where, std::span<const Real> place, Real tolerance) {
  return std::visit(
      [&](const auto& part) {
        if constexpr (requires { part.holds(place, tolerance); }) {
          return part.holds(place, tolerance);
        } else {
          return true;
        }
      },
      where);
}

void describe(Schema&, WhereAll&) {}
void describe(Schema&, WhereSurface&) {}

void describe(Schema& s, WherePlane& where) {
  s.choice({"axis", "axis that the plane cuts", Need::required}, where.axis, s.axes());
  s.real({"at", "where it cuts the axis", Need::required}, where.at, {"m"});
}

void describe(Schema& s, WhereBox& where) {
  s.list({"min", "lowest corner", Need::required}, where.min, {"m"}, Schema::kVector);
  s.list({"max", "highest corner", Need::required}, where.max, {"m"}, Schema::kVector);
  bool ordered = true;  // a box without thickness may hold a plane of points
  for (std::size_t c = 0; c < where.min.size() && c < where.max.size(); ++c) {
    ordered = ordered && where.min[c] <= where.max[c];
  }
  s.require(ordered, "max", "must not be below min along any axis");
}

void describe(Schema& s, WhereCylinder& where) {
  where.geometry = s.geometry();
  describe(s, where.cylinder);
}

void describe(Schema& s, WhereSide& where) {
  static constexpr const char* kSides[] = {"min-x", "max-x", "min-y", "max-y", "min-z", "max-z"};
  const std::size_t count = s.geometry() == Geometry::three_d ? 6 : 4;
  s.value(where.side, std::span(kSides, count), "a side of the body");
}

void describe(Schema& s, WhereSet& where) {
  s.value(where.name, "name of a set of cells, faces or nodes");
}

}  // namespace brunt::deck
