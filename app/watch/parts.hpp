#pragma once
#include <vector>

#include "app/deck/where.hpp"
#include "core/view.hpp"

namespace brunt {

/// Which points, or cells by their centres, of a view at time 0 a part of the body holds; sizes
/// that follow from rounding alone, a millionth of the body's, count as inside.
std::vector<char> held_at_start(const deck::WhereInside& where, const BodyView& start, bool cells);

/// The same entities, found by their ids, among those that are left `now`.
std::vector<char> held_now(const deck::WhereInside& where, const BodyView& start,
                           const BodyView& now, bool cells);

}  // namespace brunt
