#include "core/geometry/shape.hpp"

#include <algorithm>
#include <cmath>

#include "core/geometry/wedge.hpp"

namespace brunt {

namespace {

constexpr Quantity kLength{"m", positive(), between(1e-6, 1e3)};
constexpr Quantity kPlace{"m", {}, between(-1e4, 1e4)};

/// A length along an axis counts in 3D and where the axis lies in the plane.
Need need_of_length(const Schema& s) {
  return s.geometry() == Geometry::plane_strain ? Need::optional : Need::required;
}

/// What is echoed for a disc, whose length is not given, must be read again.
Quantity length_quantity(const Schema& s) {
  const Quantity none_or_more{"m", at_least(0), between(0, 1e3)};
  return s.geometry() == Geometry::plane_strain ? none_or_more : kLength;
}

void describe_axis(Schema& s, std::vector<Real>& axis) {
  s.direction({"axis", "direction of the axis: x, y, z or a vector"}, axis);
}

bool ordered(const std::vector<Real>& min, const std::vector<Real>& max) {
  for (std::size_t i = 0; i < min.size() && i < max.size(); ++i) {
    if (!(min[i] < max[i])) return false;
  }
  return true;
}

}  // namespace

void describe(Schema& s, Box& shape) {
  s.list({"min", "lowest corner", Need::required}, shape.min, kPlace, Schema::kVector);
  s.list({"max", "highest corner", Need::required}, shape.max, kPlace, Schema::kVector);
  s.require(ordered(shape.min, shape.max), "max", "must be above min along every axis");
}

void describe(Schema& s, Cylinder& shape) {
  s.real({"radius", "radius", Need::required}, shape.radius, kLength);
  s.real({"length", "length along the axis", need_of_length(s)}, shape.length, length_quantity(s));
  s.list({"base", "centre of the base; default: the origin"}, shape.base, kPlace, Schema::kVector);
  describe_axis(s, shape.axis);
}

void describe(Schema& s, Tube& shape) {
  s.real({"inner", "inner radius", Need::required}, shape.inner, kLength);
  s.real({"outer", "outer radius", Need::required}, shape.outer, kLength);
  s.real({"length", "length along the axis", need_of_length(s)}, shape.length, length_quantity(s));
  s.list({"base", "centre of the base; default: the origin"}, shape.base, kPlace, Schema::kVector);
  describe_axis(s, shape.axis);
  s.require(shape.inner < shape.outer, "outer", "must be above the inner radius");
}

void describe(Schema& s, Sphere& shape) {
  s.real({"radius", "radius", Need::required}, shape.radius, kLength);
  s.list({"center", "centre; default: the origin"}, shape.center, kPlace, Schema::kVector);
}

void describe(Schema& s, PolygonShape& shape) {
  s.points({"points", "corners in x and y, in order; not closed", Need::required}, shape.points,
           kPlace);
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    in3d.real({"thickness", "thickness along z, from z = 0", Need::required}, shape.thickness,
              kLength);
  });
  s.integers({"corners", "four of the points, from 0, between which a body that deforms is meshed"},
             shape.corners, 4, at_least(0));
  bool there = true;
  for (const int corner : shape.corners.value_or(std::vector<int>{})) {
    if (corner >= static_cast<int>(shape.points.size())) there = false;
  }
  s.require(there, "corners",
            "there are " + std::to_string(shape.points.size()) + " points, counted from 0");
}

void describe(Schema& s, Wedge& shape) {
  constexpr Range kSharp{-kPi / 2, kPi / 2, true, true}, kOpen{0, kPi / 2, false, true};
  constexpr Real kLeast = kPi / 180;  // between its faces
  s.list({"tip", "where its two faces would meet if the edge were sharp", Need::required},
         shape.tip, kPlace, Schema::kVector);
  s.real({"rake", "of the front face to y; positive: it leans back from the chip", Need::required},
         shape.rake, {"rad", kSharp, between(-kPi / 3, kPi / 3)});
  s.real({"clearance", "of the lower face to x, over which the tool goes", Need::required},
         shape.clearance, {"rad", kOpen, between(0, kPi / 4)});
  s.real({"edge_radius",
          "of the rounded edge between the faces; 0: sharp. A tool of elements, one that conducts, "
          "has "
          "edges as fine as its size"},
         shape.edge_radius, {"m", at_least(0), between(0, 0.01)});
  s.real({"height", "along y from the tip", Need::required}, shape.height, kLength);
  s.real({"length", "along x from the tip", Need::required}, shape.length, kLength);
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    in3d.real({"thickness", "along z from the tip", Need::required}, shape.thickness, kLength);
  });
  const bool opens = shape.rake + shape.clearance < kPi / 2 - kLeast;
  s.require(opens, "rake", "rake and clearance must leave an angle between them: below 90 deg");
  if (!opens) return;
  s.require(shape.length > shape.height * std::tan(shape.rake), "length",
            "must reach beyond the upper end of the rake face, height tan(rake)");
  s.require(shape.height > shape.length * std::tan(shape.clearance), "height",
            "must reach beyond the far end of the clearance face, length tan(clearance)");
  const Real face =
      std::min(shape.height / std::cos(shape.rake), shape.length / std::cos(shape.clearance));
  s.require(length_of_edge(shape) < face, "edge_radius",
            "rounds more than the faces: it must be smaller, or the tool larger");
}

void describe(Schema& s, Plane& shape) {
  s.list({"origin", "its centre", Need::required}, shape.origin, kPlace, Schema::kVector);
  s.direction({"normal", "points to the side where bodies are", Need::required}, shape.normal);
  s.real({"extent", "edge length", Need::required}, shape.extent, kLength);
}

void describe(Schema& s, BrickWall& shape) {
  static constexpr const char* kBonds[] = {"running", "stack"};
  s.integers({"bricks", "number of bricks along each axis", Need::required}, shape.bricks,
             Schema::kVector, between(1, 100000));
  s.list({"brick", "size of a brick along each axis", Need::required}, shape.brick, kLength,
         Schema::kVector);
  s.list({"origin", "lowest corner of the wall; default: the origin"}, shape.origin, kPlace,
         Schema::kVector);
  s.direction({"course", "direction of the courses; they are stacked along the last other axis"},
              shape.course);
  s.choice({"bond", "running: every second course is shifted by half a brick"}, shape.bond, kBonds);
  s.real({"gap", "between neighbouring bricks"}, shape.gap, {"m", at_least(0), between(0, 1)});
  s.require(std::all_of(shape.brick.begin(), shape.brick.end(),
                        [&](Real edge) { return edge > shape.gap; }),
            "gap", "must be smaller than each edge of a brick");
}

void describe(Schema& s, Ogive& shape) {
  s.real({"radius", "radius of the shank", Need::required}, shape.radius, kLength);
  s.real({"length", "from base to tip", Need::required}, shape.length, kLength);
  s.real({"nose", "length of the nose, a part of length", Need::required}, shape.nose, kLength);
  s.list({"base", "centre of the flat end; default: the origin"}, shape.base, kPlace,
         Schema::kVector);
  describe_axis(s, shape.axis);
  s.require(shape.nose <= shape.length, "nose", "cannot be longer than the whole");
}

void describe(Schema& s, BodyRotation& rotation) {
  s.section(s.geometry() == Geometry::three_d, "only for geometry: 3d", [&](Schema& in3d) {
    in3d.direction({"axis", "axis of the turn", Need::required}, rotation.axis);
  });
  s.real({"angle", "angle by the right-hand rule", Need::required}, rotation.angle,
         {"rad", {}, between(-2 * kPi, 2 * kPi)});
  s.list({"about", "a point that stays where it is; default: the origin"}, rotation.about, kPlace,
         Schema::kVector);
}

void describe(Schema& s, BodyShape& shape) {
  s.one_of({"", "the shape", Need::required}, shape.kind);
  s.object({"rotate", "turns the shape"}, shape.rotate);
  s.list({"translate", "moves the shape, after it was turned"}, shape.translate, kPlace,
         Schema::kVector);
}

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
