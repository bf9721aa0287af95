#include "app/setup/rigid_symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
/// [m] From where to where a body lies along an axis, and its longest extent along any.
struct ExtentAlong {
  Real least = kInfinity, most = -kInfinity, size = 0;
};

template <int Dim>
ExtentAlong extent_along(const Points<Dim>& points, std::span<const Facet<Dim>> facets, int axis) {
  ExtentAlong range;
  for (int c = 0; c < Dim; ++c) {
    Real least = kInfinity, most = -kInfinity;
    for (const auto& facet : facets) {
      for (int k = 0; k < facet.n_nodes(); ++k) {
        const Real x = points.x_start[slot_of(facet.node[k])][c];
        least = std::min(least, x), most = std::max(most, x);
      }
    }
    range.size = std::max(range.size, most - least);
    if (c == axis) range.least = least, range.most = most;
  }
  return range;
}

/// Leaves of all turns those about one axis; none where another plane has left those about another,
/// nor in the plane, whose axis lies in all planes of symmetry.
template <int Dim>
void leave_turns_about(int axis, FreeBody<Dim>& made) {
  Vec3 left = Vec3::Zero();
  if (Dim == 3) left[axis] = made.turns_about[axis];
  made.turns_about = left;
  made.turns = made.turns && left[axis] != 0;
  auto& state = made.state;
  const Real about = state.inertia(axis, axis);
  state.inertia.setZero(), state.inverse_inertia.setZero();
  if (!made.turns) return;
  state.inertia(axis, axis) = about, state.inverse_inertia(axis, axis) = 1 / about;
}
}  // namespace

template <int Dim>
std::string hold_on_plane(const Points<Dim>& points, std::span<const Facet<Dim>> facets, int axis,
                          Real at, FreeBody<Dim>& made) {
  constexpr Real rounding = 1e-6;  // of its size: of files in single precision
  const ExtentAlong range = extent_along(points, facets, axis);
  const Real below = at - range.least, above = range.most - at, reach = rounding * range.size;
  if (below < -reach || above < -reach) return "";
  if (below > reach && above > reach) {
    return "lies on both sides of the plane and is free: take the half of it away, or give it "
           "`motion`";
  }
  Vec3 other_spins = made.state.spin();
  if (Dim == 3) other_spins[axis] = 0;
  if (made.state.v[axis] != 0 || other_spins != Vec3::Zero()) {
    return "ends at the plane and is free: it can slide along it and turn about its normal, and "
           "not start with another motion";
  }
  made.free[slot_of(axis)] = false;
  leave_turns_about(axis, made);
  return "";
}

template std::string hold_on_plane(const Points<2>&, std::span<const Facet<2>>, int, Real,
                                   FreeBody<2>&);
template std::string hold_on_plane(const Points<3>&, std::span<const Facet<3>>, int, Real,
                                   FreeBody<3>&);

}  // namespace brunt
// Tested by tests/verification/rigid_symmetry_test.cpp.
