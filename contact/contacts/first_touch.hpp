#pragma once
#include "contact/contacts/tie.hpp"

namespace brunt {

/// What two faces or particles, or a particle and a surface, remember of how they met
/// (docs/theory/contact.md (C36), (C37)): from time 0 an overlap of which contact takes no notice,
/// which only shrinks, by as much as they open, and a bond of cohesion and tension, which breaks
/// for good; and from when a particle came near an open surface the side from which it came, until
/// it leaves; and while it touches a thin plate of elements the face that was nearest. Faces whose
/// deepest corner nears the limit remember that they push: they have not come from behind when it
/// is beyond.
struct FirstTouch {
  ContactKey key;       ///< with ordinal 0; of a particle and a surface `second` is the surface
  Real overlap = 0;     ///< [m]
  bool bonded = false;  ///< in the last evaluation
  bool slips = false;   ///< it slid in the last evaluation: the bond is broken from the next one on
  int side = 0;         ///< of an open surface: 1 before it, -1 behind it; 0: none
  bool held =
      false;  ///< of faces: they pushed in the last evaluation, deeper than kHeldFrom limits
  GlobalId entry = kNoEntry;  ///< of a thin plate: the face that was nearest to the particle
  /// The entry by which the last evaluation chose: it is repeated by the same.
  GlobalId entry_before = kNoEntry;

  static constexpr GlobalId kNoEntry = ~GlobalId{0};
  static constexpr Real kHeldFrom = 0.75;
  static constexpr const char* kTable = "contact.first";

  /// False once nothing is left that would make the force unlike that of any other contact.
  bool matters() const { return overlap > 0 || bonded || side != 0 || entry != kNoEntry; }
  /// bonded, slips, side and held in one word.
  std::uint64_t flags() const {
    return static_cast<std::uint64_t>(bonded ? 1 : 0) + (slips ? 2 : 0) +
           4 * static_cast<std::uint64_t>(side + 1) + (held ? 16 : 0);
  }
  template <class Visitor, class Touch>
  static void visit(Visitor& visitor, Touch& touch) {
    visitor.carry(touch.overlap, touch.bonded, touch.slips, touch.side, touch.held, touch.entry,
                  touch.entry_before);
    visitor.hash(touch.overlap, touch.flags());
    if (touch.entry != kNoEntry) visitor.hash(touch.entry);
  }
};

/// Names the surface that the pieces of a body show to particles.
inline GlobalId surface_of(Label body, Label piece) {
  return (static_cast<GlobalId>(body) << 32) | piece;
}
/// The keys of first touches: of a particle and a surface, or of two faces or particles.
inline ContactKey touch_key(GlobalId particle, Label body, Label piece) {
  return {ContactKind::particle_face, 0, particle, surface_of(body, piece)};
}
inline ContactKey touch_key(ContactKind kind, GlobalId lower, GlobalId upper) {
  return {kind, 0, lower, upper};
}

/// Every first touch whose contact is evaluated here.
using FirstTouches = KeyedMemory<FirstTouch>;

/// How a step finds the touches of time 0, or makes them.
struct TouchStep {
  /// The face of entry by which this evaluation chooses; kNoEntry without one.
  GlobalId entry_of(const FirstTouch* touch) const {
    if (touch == nullptr) return FirstTouch::kNoEntry;
    return again ? touch->entry_before : touch->entry;
  }
  const FirstTouches* before = nullptr;  ///< those of the last evaluation
  bool time_zero = false;                ///< they begin now, and no force is evaluated
  bool again = false;  ///< the last evaluation is repeated: what slid in it has not broken yet
  const TiePoints* ties = nullptr;          ///< that held in the last evaluation
  const JointClosures* closures = nullptr;  ///< as it left them
};

}  // namespace brunt
