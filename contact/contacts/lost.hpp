#pragma once
/// Contacts that did not hold, for those who read the results: nothing here changes a force.
#include <array>
#include <vector>

#include "contact/contacts/keyed_memory.hpp"

namespace brunt {

/// How a contact was lost.
inline constexpr std::uint32_t kLetGo = 0, kFromBehind = 1, kCrossed = 2;

/// A contact that did not keep its bodies apart: it let go, since it was deeper than it is held;
/// its faces come back from beyond that, and are left alone until they have opened; or they go
/// through each other deeper than that where they do not oppose each other
/// (contact/geometry/crossing.hpp).
template <int Dim>
struct LostContact {
  ContactKey key;  ///< as of its record; its ordinal is one of these
  Label lower_body = 0, upper_body = 0;
  Real time = 0;                      ///< [s]
  Real depth = 0;                     ///< [m]
  Vec<Dim> point = Vec<Dim>::Zero();  ///< [m]
  static constexpr const char* kTable = "contact.lost";
  template <class Visitor, class Lost>
  static void visit(Visitor& visitor, Lost& lost) {
    visitor.carry(lost.lower_body, lost.upper_body, lost.time, lost.depth, lost.point);
  }
};

/// A particle that a face still holds, which the next step may bring farther behind it than that.
template <int Dim>
struct DeepParticle {
  ContactKey key;
  Label body = 0, body_of_particle = 0;  ///< of the face first
  Vec<Dim> outward;                      ///< unit, of the force on the particle
  Vec<Dim> point, velocity;              ///< of the face, nearest to it [m], [m/s]
  Real limit = 0;                        ///< [m]
};

/// Every lost contact that was evaluated here, each with its first time.
template <int Dim>
using LostContacts = KeyedMemory<LostContact<Dim>>;

/// Contacts of a pair of bodies that did not hold, since time 0, each counted once; of the first of
/// them where and when.
struct LostReport {
  std::int64_t let_go = 0;       ///< deeper in each other than contacts are held
  std::int64_t from_behind = 0;  ///< of faces that came back from beyond that
  std::int64_t crossed = 0;      ///< of faces that went through each other and did not push
  Real time = kInfinity;         ///< [s]
  Real depth = 0;                ///< [m]
  std::array<Real, 3> point{};   ///< [m]
  ContactKey key;                ///< its ordinal says how
  bool any() const { return let_go + from_behind + crossed > 0; }
};

}  // namespace brunt
// Tested by tests/unit/contact/lost_test.cpp.
