#pragma once
#include "contact/contacts/lost.hpp"

namespace brunt {

/// How a contact is noted that holds yet, though deeper than FirstTouch::kHeldFrom of what it holds
/// at all. A LostReport of it has no lost contacts.
inline constexpr std::uint32_t kDeep = 3;

}  // namespace brunt
// Tested by tests/unit/contact/lost_test.cpp.
