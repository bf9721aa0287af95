#pragma once
#include "contact/contacts/keyed_memory.hpp"

namespace brunt {

/// A place of two faces, or of a particle and a face, that is held from time 0 on: by the same
/// weights of their corners for good, so that nothing drifts however they turn.
struct TiePoint {
  static constexpr std::size_t kCorners = 4;
  ContactKey key;                               ///< its ordinal counts the points of a pair
  std::array<Real, kCorners> lower{}, upper{};  ///< [1] of the corners; a particle has one
  Real gap = 0;                                 ///< [m] between both, along the normal, at time 0
  Real area = 0;                                ///< [m^2] for which it stands
  Real closed = 0;                              ///< [m] largest closure since time 0

  static constexpr const char* kTable = "contact.tie";
  template <class Visitor, class Point>
  static void visit(Visitor& visitor, Point& point) {
    for (auto& weight : point.lower) visitor.carry(weight);
    for (auto& weight : point.upper) visitor.carry(weight);
    visitor.carry(point.gap, point.area, point.closed);
    visitor.hash(point.gap, point.area, point.closed);
  }
};
/// Those that hold, of all contacts that are evaluated here.
using TiePoints = KeyedMemory<TiePoint>;

/// How far two faces of a joint have been closed. It outlives that they open, or slide off each
/// other: they may come back.
struct JointClosure {
  ContactKey key;   ///< as of their common plane
  Real closed = 0;  ///< [m] largest closure since time 0

  static constexpr const char* kTable = "contact.joint";
  template <class Visitor, class Closure>
  static void visit(Visitor& visitor, Closure& closure) {
    visitor.carry(closure.closed);
    visitor.hash(closure.closed);
  }
};
using JointClosures = KeyedMemory<JointClosure>;

/// What a joint has used up in a step: by closing, or by breaking.
struct JointLoss {
  ContactKey key;
  Real energy = 0;  ///< [J]
};

}  // namespace brunt
// Tested by tests/unit/contact/ties_test.cpp.
