#include <algorithm>

#include "core/geometry/grid.hpp"

namespace brunt {

const Grading* Sizing::along(int axis) const {
  const auto found = std::find_if(gradings.begin(), gradings.end(),
                                  [axis](const Grading& grading) { return grading.axis == axis; });
  return found == gradings.end() ? nullptr : &*found;
}

Layers layers_along(const Sizing& sizing, std::size_t c, Real length,
                    const std::optional<Grading>& grading) {
  if (!grading || !(sizing.size || sizing.cells)) return {sizing.count(c, length), {}};
  const auto& sizes = sizing.size;
  const int n = sizing.cells
                    ? sizing.count(c, length)
                    : graded_count(*grading, length, (*sizes)[std::min(c, sizes->size() - 1)]);
  return {n, graded_layers(*grading, n)};
}
Layers layers_along(const Sizing& sizing, int axis, Real length) {
  return layers_along(sizing, slot_of(axis), length, turned(sizing.along(axis), false));
}

}  // namespace brunt
// Tested by tests/unit/core/grading_test.cpp.
