#pragma once
/// Supports and loads as the deck gives them.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/deck/measures.hpp"
#include "core/schema.hpp"

namespace brunt::deck {

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
using Where = std::variant<WhereAll, WhereSurface, WherePlane, WhereBox, WhereSide, WhereSet>;

/// One component of a prescribed vector; absent: free.
using Components = std::vector<std::optional<Varying>>;

/// Heat h (T - T_surface) per area; constants, tables over time or expressions.
struct Convection {
  std::optional<Varying> h;  ///< [W/m^2/K]
  std::optional<Varying> T;  ///< [K]
};
/// Heat emissivity sigma (T^4 - T_surface^4) per area.
struct Radiation {
  Real emissivity = 1;       ///< [1]
  std::optional<Varying> T;  ///< [K]
};

/// What holds, moves, pushes or heats points of a body; points are chosen at time 0 and carried
/// along.
struct Boundary {
  std::string body;
  Where where;
  std::vector<std::string> fix;        ///< "x", "y", "z"; empty: none
  std::optional<Components> velocity;  ///< [m/s] constants, tables over time, expressions
  std::optional<Components> force;     ///< [N] in total on all chosen points, shared by mass
  std::optional<Varying> temperature;  ///< [K] of the chosen points
  std::optional<Varying> flux;         ///< [W/m^2] into the body
  std::optional<Convection> convection;
  std::optional<Radiation> radiation;
  Real from = 0;        ///< [s]
  Real to = kInfinity;  ///< [s]
};

/// Mass-proportional: f = -rate m v.
struct Damping {
  Real rate = 0;           ///< [1/s]
  Real until = kInfinity;  ///< [s]
};

void describe(Schema& s, WhereAll& where);
void describe(Schema& s, WhereSurface& where);
void describe(Schema& s, WherePlane& where);
void describe(Schema& s, WhereBox& where);
void describe(Schema& s, WhereSide& where);
void describe(Schema& s, WhereSet& where);
void describe(Schema& s, Convection& convection);
void describe(Schema& s, Radiation& radiation);
void describe(Schema& s, Boundary& boundary);
void describe(Schema& s, Damping& damping);

}  // namespace brunt::deck
