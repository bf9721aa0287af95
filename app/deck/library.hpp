#pragma once
#include <string>

#include "io/deck/node.hpp"

namespace brunt::deck {

/// The library of materials as YAML: name: {summary, sources, low_confidence, values}.
const char* library_text();
/// The same as a tree; its places name the file "library".
Node library();

}  // namespace brunt::deck
