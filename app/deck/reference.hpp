#pragma once
#include "io/deck/key_tree.hpp"

namespace brunt::deck {

/// All keys of a deck in 3D, with those that are taken before it is read: include, parameters,
/// materials.NAME.library.
KeyInfo deck_keys();

}  // namespace brunt::deck
