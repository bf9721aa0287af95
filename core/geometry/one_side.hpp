#pragma once
#include <array>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Throws std::invalid_argument with the place where neighbouring triangles face opposite ways, as
/// where some of them are upside down. The surface may be open.
/// nodes  [m]
void require_one_side(const std::vector<Vec3>& nodes,
                      const std::vector<std::array<int, 3>>& triangles);

/// Closed shells of a surface, and how many of them have been turned.
struct TurnedShells {
  std::size_t turned = 0, closed = 0;
};

/// Turns closed shells that face inwards, and what lies in them with them: the walls of hollows
/// face the hollow. A shell inside another that faces outwards stays as it is, as does what is open
/// or encloses nothing. Neighbouring faces have to face one side (require_one_side).
/// nodes  [m];  faces  of three corners and -1, or of four
TurnedShells turn_outward(const std::vector<Vec3>& nodes, std::vector<std::array<int, 4>>& faces);

}  // namespace brunt
// Tested by tests/unit/core/turn_outward_test.cpp.
