#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/scene/scene.hpp"

namespace brunt {

/// The columns of history.csv of a scene, patterns of app/deck/columns.hpp filled with its names.
struct ColumnNames {
  std::vector<std::string> names;
  std::vector<std::size_t> whole;  ///< indices of whole numbers: step, dt_body, planes
};
/// In the order in which HistoryColumns collects the values. Collective.
template <int Dim>
ColumnNames column_names(const Scene<Dim>& scene);

/// The first component of a torque: all three, or z alone in 2D, or none (3) of a whole ring.
template <int Dim>
int first_torque(const Scene<Dim>& scene) {
  if (scene.geometry == Geometry::axisymmetric) return 3;
  return Dim == 3 ? 0 : 2;
}

/// True of what a boundary reports whose moment is a column too.
inline bool is_reaction(std::string_view report) { return report == "reaction"; }

}  // namespace brunt
