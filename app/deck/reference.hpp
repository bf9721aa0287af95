#pragma once
#include "io/deck/key_tree.hpp"

namespace brunt::deck {

/// All keys of a deck in 3D, with those that are taken before it is read: include, parameters,
/// materials.NAME.library.
KeyInfo deck_keys();
/// The same for a schema of all geometries: only what each of them needs is required.
KeyInfo schema_keys();

}  // namespace brunt::deck
