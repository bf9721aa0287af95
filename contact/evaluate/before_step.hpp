#pragma once
#include "contact/surfaces/start_warp.hpp"

namespace brunt {

/// A face as it was at the last evaluation.
template <int Dim>
FacePlane<Dim> before_step(const Entities<Dim>& entities, LocalIndex place, Real dt) {
  const auto& face = entities.faces[slot_of(place)];
  FacePlane<Dim> plane = entities.planes[slot_of(place)];
  for (std::size_t c = 0; c < slot_of(face.n_nodes); ++c) {
    plane.corner[c] -= dt * entities.nodes.v[slot_of(face.node[c])];
  }
  refresh(plane);
  compare_with_start(face, plane);
  return plane;
}

}  // namespace brunt
// Tested by tests/unit/contact/particle_returns_test.cpp.
