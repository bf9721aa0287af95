#pragma once
#include <array>
#include <vector>

#include "contact/contacts/key.hpp"

#include "core/search/search.hpp"
#include "core/surface.hpp"

namespace brunt {

/// A node of contact by its name, the same on all ranks.
struct ContactNodeName {
  LocalIndex surface = 0;
  GlobalId point = 0;
  auto operator<=>(const ContactNodeName&) const = default;
};

/// A face or a particle as other ranks see it.
template <int Dim>
struct ContactReach {
  SearchBox<Dim> box;  ///< [m] where it may touch before the lists are renewed
  GlobalId id = 0;     ///< facet id, or that of the particle
  bool rigid = false;  ///< a face of a rigid body, which every rank has
  int n_nodes = 0;     ///< corners; 1 of a particle
  std::array<ContactNodeName, Facet<Dim>::kNodes> node;
  std::size_t candidates = 0;  ///< that are evaluated with it
};

/// One contact that carries force: who evaluates it, and whom it moves.
template <int Dim>
struct ContactTouch {
  std::size_t evaluator = 0;  ///< among faces, or among particles
  ContactKind kind = ContactKind::face_face;
  std::vector<ContactNodeName> node;
};

/// What contact of a whole scene would ask of ranks if its points were partitioned: for tools that
/// say what a run on so many ranks would send.
template <int Dim>
struct ContactReaches {
  std::vector<ContactReach<Dim>> faces, particles;  ///< in the order of ids
  std::vector<ContactTouch<Dim>> touches;           ///< of the last evaluation
  std::size_t letter_bytes = 0;                     ///< [byte] of a force on its way to a node
};

}  // namespace brunt
