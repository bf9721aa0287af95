#pragma once
/// Supports and loads as the deck gives them.
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "app/deck/measures.hpp"
#include "core/boundaries/catalog.hpp"
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

/// What holds, moves, pushes or heats points of a body; points are chosen at time 0 and carried
/// along. One boundary may do several of these things.
struct Boundary {
  std::string body;
  Where where;
  BoundaryKinds kinds;
  Real from = 0;        ///< [s]
  Real to = kInfinity;  ///< [s]

  template <class Kind>
  const Kind& of() const {
    return std::get<Kind>(kinds);
  }
};
/// Calls f(kind) of what the deck gives of a boundary.
template <class F>
void visit_given(const Boundary& boundary, const F& f) {
  const auto look = [&](const auto& kind) {
    if (kind.given()) f(kind);
  };
  std::apply([&](const auto&... kind) { (look(kind), ...); }, boundary.kinds);
}

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
void describe(Schema& s, Boundary& boundary);
void describe(Schema& s, Damping& damping);

}  // namespace brunt::deck
