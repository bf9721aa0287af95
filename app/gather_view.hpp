#pragma once
#include "core/parallel/communicator.hpp"
#include "core/view.hpp"

namespace brunt {

/// One view of a body out of those of all ranks, points and cells by ascending id, each as its
/// owner has it: the same bits as a lone rank shows. On the root; elsewhere it comes back empty.
/// Collective.
BodyView gather_view(const BodyView& mine, const Communicator& ranks);

/// The contacts of all ranks by their keys, the order of a lone rank, on the root. Collective.
ContactView gather_view(const ContactView& mine, const Communicator& ranks);

}  // namespace brunt
