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

}  // namespace brunt
