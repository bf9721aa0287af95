#pragma once
/// Parts of a body, by place at time 0.
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/shape.hpp"
#include "core/schema.hpp"

namespace brunt::deck {

enum class Axis : int { x, y, z };

struct WhereAll {
  static constexpr const char* deck_name = "all";
  static constexpr const char* deck_help = "all points of the body";
};
struct WhereSurface {
  static constexpr const char* deck_name = "surface";
  static constexpr const char* deck_help = "the points on the surface of the body";
};
/// Points within a tenth of `size` of the plane.
struct WherePlane {
  static constexpr const char* deck_name = "plane";
  static constexpr const char* deck_help = "points within a tenth of `size` of a plane";
  Axis axis = Axis::x;
  Real at = 0;  ///< [m]
};
struct WhereBox {
  static constexpr const char* deck_name = "box";
  static constexpr const char* deck_help = "points inside a box";
  std::vector<Real> min, max;  ///< [m]

  /// place [m]: x, y, and z in 3D;  tolerance [m] beyond its faces
  bool holds(std::span<const Real> place, Real tolerance) const;
};
/// In plane strain a disc; axisymmetric it stands on its base about the axis of symmetry.
struct WhereCylinder {
  static constexpr const char* deck_name = "cylinder";
  static constexpr const char* deck_help = "points inside a cylinder; a disc in plane strain";
  Cylinder cylinder;
  Geometry geometry = Geometry::three_d;

  bool holds(std::span<const Real> place, Real tolerance) const;  ///< as WhereBox
};
enum class Side : int { min_x, max_x, min_y, max_y, min_z, max_z };
struct WhereSide {
  static constexpr const char* deck_name = "side";
  static constexpr const char* deck_help = "points on one side of the body: min-x, max-x, ...";
  Side side = Side::min_x;
};
/// Points of a named set of the body's mesh file.
struct WhereSet {
  static constexpr const char* deck_name = "set";
  static constexpr const char* deck_help = "the points of a named set of the body's mesh file";
  std::string name;
};
using Where =
    std::variant<WhereAll, WhereSurface, WherePlane, WhereBox, WhereCylinder, WhereSide, WhereSet>;
/// What has a volume: points in it, and elements whose centres are.
using WhereInside = std::variant<WhereAll, WhereBox, WhereCylinder>;

/// True where it holds a place at time 0 [m]: x, y, and z in 3D.
bool holds(const WhereInside& where, std::span<const Real> place, Real tolerance);

void describe(Schema& s, WhereAll& where);
void describe(Schema& s, WhereSurface& where);
void describe(Schema& s, WherePlane& where);
void describe(Schema& s, WhereBox& where);
void describe(Schema& s, WhereCylinder& where);
void describe(Schema& s, WhereSide& where);
void describe(Schema& s, WhereSet& where);

}  // namespace brunt::deck
// Tested by tests/verification/parts_test.cpp.
