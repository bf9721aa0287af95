#pragma once
/// Shapes of bodies: core's own structs, which carry their descriptions.
#include "core/geometry/shape.hpp"

namespace brunt::deck {

using Shape = brunt::BodyShape;

}  // namespace brunt::deck
