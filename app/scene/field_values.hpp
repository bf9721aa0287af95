#pragma once
#include <string>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// Index of the point, or of the cell by its centre, nearest to a place [m] in a view at time 0;
/// the first of those that are equally near.
std::size_t nearest_entity(const BodyView& start, const std::vector<Real>& at, bool cells);

/// Values of a field such as "stress.xx", "velocity.magnitude" or "temperature", one an entity;
/// `weights` receives masses or volumes.
std::vector<Real> field_values(const BodyView& view, const std::string& field,
                               std::vector<Real>* weights = nullptr);

}  // namespace brunt
