#pragma once
#include <cstdint>
#include <vector>

#include "app/setup/groups.hpp"

namespace brunt {

/// Where a point or an element comes from: its body, and which one of it.
struct Origin {
  std::uint32_t body, index;
};

/// The points of chosen bodies along the curve; place_of[body][index] is the new local index.
template <int Dim>
struct Gathered {
  Points<Dim> points;
  std::vector<Origin> from;
  std::vector<std::vector<LocalIndex>> place_of;
};

/// Points of the chosen bodies along the curve at time 0, with ids, bodies, positions and
/// velocities; masses and pieces are left to their elements.
template <int Dim>
Gathered<Dim> gather(const LoadedDeck& loaded, const Scene<Dim>& scene,
                     const std::vector<BodyGeometry<Dim>>& bodies,
                     const std::vector<std::size_t>& chosen, NextIds& next);

}  // namespace brunt
// Tested by tests/verification/storage_order_test.cpp.
