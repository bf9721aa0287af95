#pragma once
#include "core/parallel/communicator.hpp"
#include "core/view.hpp"

namespace brunt {

/// One view of a body out of those of all ranks, by ids: the same bits as a lone rank shows. On the
/// root; elsewhere it comes back empty. Collective.
BodyView gather_view(BodyView mine, const Communicator& ranks);

}  // namespace brunt
