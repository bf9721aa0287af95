#pragma once
#include "core/parallel/partition.hpp"
#include "core/view.hpp"

namespace brunt {

/// What a rank writes of a body: its own points and cells, and of other ranks' points those that
/// its cells touch, with the values of their owners (forces on copies are not whole). All ranks
/// with points of it get the same cell fields. The view needs the point field `id` where it has
/// points. Collective.
BodyView frame_piece(BodyView view, const Partition& partition, const Communicator& ranks);

/// Adds the field `rank` to all points and cells of a view: this one has them, or it is told so of
/// copies by frame_piece. A view without points has no fields, and gets none.
void add_owner(BodyView& view, int rank);

}  // namespace brunt
