#pragma once
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// One view of a body out of parts of it, points and cells by the ascending numbers of their fields
/// `id`, each point as its owner has it: the same bits as a lone rank shows. Copies of points that
/// nobody owns are left out.
BodyView merge_views(const std::vector<BodyView>& parts);

}  // namespace brunt
