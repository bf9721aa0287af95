#pragma once
#include <vector>

#include "contact/surfaces/entities.hpp"

namespace brunt {

/// Nodes of all surfaces, numbered when first asked for.
template <int Dim>
class Numbering {
 public:
  Numbering(const std::vector<Surface<Dim>*>& surfaces, ContactNodes<Dim>& nodes)
      : surfaces_(surfaces), nodes_(nodes), known_(surfaces.size()) {
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      known_[s].assign(slot_of(surfaces[s]->points->size()), -1);
    }
  }
  /// Room for the nodes of these, and of what has gone.
  void reserve_for(const Entities<Dim>& entities) {
    constexpr LocalIndex kNone = -1, kWanted = -2;
    std::size_t n = 0;
    const auto want = [&](LocalIndex surface, LocalIndex point) {
      auto& number = known_[slot_of(surface)][slot_of(point)];
      n += number == kNone ? 1 : 0;
      number = kWanted;
    };
    for (const auto& face : entities.faces) {
      for (int c = 0; c < face.n_nodes; ++c) want(face.surface, face.node[slot_of(c)]);
    }
    for (const auto& particle : entities.particles) want(particle.surface, particle.node);
    for (const auto* surface : surfaces_) n += surface->gone.size();
    nodes_.reserve(n);
  }

  LocalIndex operator()(LocalIndex surface, LocalIndex point) {
    const auto s = slot_of(surface);
    auto& number = known_[s][slot_of(point)];
    if (number < 0) number = nodes_.add(surface, point, *surfaces_[s]->points);
    return number;
  }

  void name_corners(ContactFace<Dim>& face) {
    for (int c = 0; c < face.n_nodes; ++c) {
      auto& node = face.node[slot_of(c)];
      node = (*this)(face.surface, node);
    }
  }
  /// Points that have gone, for what is booked to them.
  void add_gone() {
    for (std::size_t s = 0; s < surfaces_.size(); ++s) {
      for (const LocalIndex point : surfaces_[s]->gone) (*this)(static_cast<LocalIndex>(s), point);
    }
  }

 private:
  const std::vector<Surface<Dim>*>& surfaces_;
  ContactNodes<Dim>& nodes_;
  std::vector<std::vector<LocalIndex>> known_;
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
