#pragma once
/// Tiles of elements that lie still are left out of a step: it would change no bit of them and put
/// no force on their nodes. docs/theory/elements.md, section 11
#include "fe/element_step.hpp"

namespace brunt {

/// True where a step of an element block need not compute tile `tile`: its nodes do not move, and
/// the last step that did compute it found it free of stress, at the places of time 0. Else the
/// tile is to be computed, and then shown to `keep_rest`.
template <int Dim>
bool rests(const ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step);

/// After a tile has been computed: notes whether it may be left out of the next steps. One that has
/// been moved or strained is never looked at again.
template <int Dim>
void keep_rest(ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step);

}  // namespace brunt
// Tested by tests/unit/fe/rest_test.cpp.
