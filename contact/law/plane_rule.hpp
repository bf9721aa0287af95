#pragma once
#include "core/schema.hpp"

namespace brunt {

/// How the pressure between two faces is found (docs/theory/contact.md, section 2): as an exact
/// integral over where they penetrate, or as that at the middle of their overlap, times its area.
enum class PlaneRule : int { integrated, point };

inline void describe(Schema& s, PlaneRule& rule) {
  static constexpr const char* kWords[] = {"integrated", "point"};
  s.choice({"plane",
            "pressure of two faces: integrated over where they penetrate, or that at the middle of "
            "their overlap (point), which makes energy where edges and corners dig in"},
           rule, kWords);
}

}  // namespace brunt
// Tested by tests/unit/contact/common_plane_test.cpp.
