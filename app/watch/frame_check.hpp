#pragma once
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/view.hpp"

namespace brunt {

/// Throws PhysicsError naming body and field where a frame would hold a value that is no finite
/// number, or is none in the single precision of its file. Collective: all ranks throw.
/// views, contact  what this rank is about to write
void refuse_no_numbers(const std::vector<BodyView>& views, const ContactView& contact,
                       const Communicator& ranks);

}  // namespace brunt
