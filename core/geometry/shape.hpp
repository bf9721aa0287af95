#pragma once
/// Shapes of bodies as the deck gives them: plain parameters, SI. Vectors have two components in a
/// 2D deck and three in a 3D one; an empty vector means the origin.
#include <optional>
#include <variant>
#include <vector>

#include "core/schema.hpp"

namespace brunt {

struct Box {
  static constexpr const char* deck_name = "box";
  static constexpr const char* deck_help = "a box along the axes; a rectangle in 2D";
  std::vector<Real> min, max;  ///< [m] opposite corners
};

/// In plane strain a disc, and then length may be absent (0).
struct Cylinder {
  static constexpr const char* deck_name = "cylinder";
  static constexpr const char* deck_help = "a cylinder from the centre of its base along its axis";
  Real radius = 0;                  ///< [m]
  Real length = 0;                  ///< [m]
  std::vector<Real> base;           ///< [m] centre of the base
  std::vector<Real> axis{0, 0, 1};  ///< unit vector, 3 components unless given with 2
};

struct Tube {
  static constexpr const char* deck_name = "tube";
  static constexpr const char* deck_help = "a hollow cylinder";
  Real inner = 0, outer = 0;        ///< [m] radii
  Real length = 0;                  ///< [m]
  std::vector<Real> base;           ///< [m] centre of the base
  std::vector<Real> axis{0, 0, 1};  ///< unit vector, 3 components unless given with 2
};

struct Sphere {
  static constexpr const char* deck_name = "sphere";
  static constexpr const char* deck_help = "a ball; a disc in plane strain";
  Real radius = 0;           ///< [m]
  std::vector<Real> center;  ///< [m]
};

struct PolygonShape {
  static constexpr const char* deck_name = "polygon";
  static constexpr const char* deck_help = "a simple polygon in x and y, with a thickness in 3D";
  std::vector<std::vector<Real>> points;    ///< [m] n x 2
  Real thickness = 0;                       ///< [m] along z from z = 0; 0 in 2D
  std::optional<std::vector<int>> corners;  ///< four of the points, from 0; an FE body that deforms
  Real base = 0;                            ///< [m] z from which the thickness goes; of a deck 0
};

/// A cutting tool that moves along -x over the work: core/geometry/wedge.hpp.
struct Wedge {
  static constexpr const char* deck_name = "wedge";
  static constexpr const char* deck_help = "a cutting tool that moves along -x, in x and y";
  std::vector<Real> tip;  ///< [m] where its faces would meet if its edge were sharp
  Real rake = 0;          ///< [rad] of the front face to y: leaning back, along +x, is positive
  Real clearance = 0;     ///< [rad] of the lower face to x
  Real edge_radius = 0;   ///< [m] 0: sharp
  Real height = 0;        ///< [m] along y from the tip
  Real length = 0;        ///< [m] along x from the tip
  Real thickness = 0;     ///< [m] along z from the tip; 0 in 2D
};

struct Plane {
  static constexpr const char* deck_name = "plane";
  static constexpr const char* deck_help = "a flat rigid surface; the normal points to free space";
  std::vector<Real> origin;  ///< [m] its centre
  std::vector<Real> normal;  ///< unit vector
  Real extent = 0;           ///< [m] edge length of the square
};

enum class Bond : int { running, stack };

/// Courses run along `course` and are stacked along the last other axis; every brick is a piece.
struct BrickWall {
  static constexpr const char* deck_name = "brick-wall";
  static constexpr const char* deck_help = "bricks in courses, each a piece of its own in contact";
  std::optional<std::vector<int>> bricks;  ///< number along each axis (always there)
  std::vector<Real> brick;                 ///< [m] size of one brick along each axis
  std::vector<Real> origin;                ///< [m] lowest corner of the wall
  std::vector<Real> course{1, 0, 0};       ///< unit vector along which courses run
  Bond bond = Bond::running;
  Real gap = 0;  ///< [m] between neighbouring bricks
};

/// A shank of length - nose, and a tangent ogive of length nose that ends in a point.
struct Ogive {
  static constexpr const char* deck_name = "ogive";
  static constexpr const char* deck_help = "a cylinder with a pointed, tangent ogive nose";
  Real radius = 0;                  ///< [m] of the shank
  Real length = 0;                  ///< [m] from base to tip
  Real nose = 0;                    ///< [m] length of the nose, part of length
  std::vector<Real> base;           ///< [m] centre of the flat end
  std::vector<Real> axis{0, 0, 1};  ///< unit vector from base to tip
};

/// Turns by the right-hand rule; in 2D about z, and the axis is not given.
struct BodyRotation {
  std::vector<Real> axis{0, 0, 1};  ///< unit vector
  Real angle = 0;                   ///< [rad]
  std::vector<Real> about;          ///< [m] a point that stays where it is
};

using ShapeKind =
    std::variant<Box, Cylinder, Tube, Sphere, PolygonShape, Wedge, Plane, BrickWall, Ogive>;

/// A shape, then turned, then moved.
struct BodyShape {
  ShapeKind kind;
  std::optional<BodyRotation> rotate;
  std::vector<Real> translate;  ///< [m]; empty: none
};

void describe(Schema& s, Box& shape);
void describe(Schema& s, Cylinder& shape);
void describe(Schema& s, Tube& shape);
void describe(Schema& s, Sphere& shape);
void describe(Schema& s, PolygonShape& shape);
void describe(Schema& s, Wedge& shape);
void describe(Schema& s, Plane& shape);
void describe(Schema& s, BrickWall& shape);
void describe(Schema& s, Ogive& shape);
void describe(Schema& s, BodyRotation& rotation);
void describe(Schema& s, BodyShape& shape);

}  // namespace brunt
