#pragma once
/// Supports and loads as the deck gives them.
#include <string>
#include <tuple>
#include <vector>

#include "app/deck/where.hpp"
#include "core/boundaries/catalog.hpp"
#include "core/schema.hpp"

namespace brunt::deck {

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

void describe(Schema& s, Boundary& boundary);
void describe(Schema& s, Damping& damping);

}  // namespace brunt::deck
