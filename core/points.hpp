#pragma once
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// Material points of one group: FE nodes, SPH particles or the points of rigid surfaces.
/// Owned points come first, ghosts after them; along a space-filling curve, ids ascending.
/// Positions are relative to the scene's origin. An absent field is an empty array.
template <int Dim>
struct Points {
  LocalIndex n_owned = 0;
  std::vector<GlobalId> id;
  std::vector<Label> body;
  std::vector<Label> piece;
  std::vector<Real> mass;         ///< [kg]; 0 for points of a rigid surface
  std::vector<Vec<Dim>> x;        ///< [m] position
  std::vector<Vec<Dim>> v;        ///< [m/s] velocity; at the half step between predict and correct
  std::vector<Vec<Dim>> a;        ///< [m/s^2] acceleration at the last full step
  std::vector<Vec<Dim>> f;        ///< [N] force, accumulated
  std::vector<Vec<Dim>> x_start;  ///< [m] position at time 0
  std::vector<Real> integration;  ///< [J] what changes of the step left in the kinetic energy

  LocalIndex size() const { return static_cast<LocalIndex>(x.size()); }

  /// Makes room for n points, all owned; fields are zero.
  void resize(LocalIndex n) {
    n_owned = n;
    const auto count = static_cast<std::size_t>(n);
    id.resize(count);
    body.resize(count);
    piece.resize(count);
    mass.assign(count, 0.0);
    integration.assign(count, 0.0);
    for (auto* field : {&x, &v, &a, &f, &x_start}) field->assign(count, Vec<Dim>::Zero());
  }
};

}  // namespace brunt
