#pragma once
#include <algorithm>

#include "core/types.hpp"

namespace brunt {

/// Bounds that prove lists complete (docs/theory/contact.md (C2)): extremes, by component, of
/// displacement since they were built and of velocity.
template <int Dim>
struct MotionBounds {
  Vec<Dim> u_min = Vec<Dim>::Constant(kInfinity), u_max = Vec<Dim>::Constant(-kInfinity);
  Vec<Dim> v_min = Vec<Dim>::Constant(kInfinity), v_max = Vec<Dim>::Constant(-kInfinity);

  void take(const Vec<Dim>& u, const Vec<Dim>& v) {
    u_min = u_min.cwiseMin(u), u_max = u_max.cwiseMax(u);
    take_velocity(v);
  }
  void take_velocity(const Vec<Dim>& v) { v_min = v_min.cwiseMin(v), v_max = v_max.cwiseMax(v); }
  void take(const MotionBounds& other) {
    u_min = u_min.cwiseMin(other.u_min), u_max = u_max.cwiseMax(other.u_max);
    v_min = v_min.cwiseMin(other.v_min), v_max = v_max.cwiseMax(other.v_max);
  }
  /// Largest relative displacement [m] of any two nodes, any component; 0 where there are none.
  Real relative_displacement() const {
    Real widest = 0;
    for (int c = 0; c < Dim; ++c) widest = std::max(widest, u_max[c] - u_min[c]);
    return widest;
  }
  /// Largest relative speed [m/s] of any two nodes.
  Real relative_speed() const {
    const Vec<Dim> widest = v_max - v_min;
    return widest.norm();
  }
};

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
