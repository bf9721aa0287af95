#pragma once
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/view.hpp"

namespace brunt {

/// Throws PhysicsError naming body and field where a frame would hold a value that is no finite
/// number, or is none in the single precision of its file. Fields that wait are looked at when they
/// are written (NoNumberError). Collective: all ranks throw.
/// views, contact  what this rank is about to write
void refuse_no_numbers(const std::vector<BodyView>& views, const ContactView& contact,
                       const Communicator& ranks);
/// Throws that PhysicsError. field  empty: another rank knows which
[[noreturn]] void refuse_frame(const std::string& body, const std::string& field);

}  // namespace brunt
