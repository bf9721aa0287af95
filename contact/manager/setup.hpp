#pragma once
#include <vector>

#include "contact/surfaces/entities.hpp"

namespace brunt {

/// What contact is given, and keeps as it is.
template <int Dim>
struct ContactSetup {
  ContactOptions options;
  Section section;
  ContactRanks ranks;
  std::vector<Surface<Dim>*> surfaces;
  PairTable pairs;
  RigidSprings rigid{};  ///< of all ranks
};

}  // namespace brunt
