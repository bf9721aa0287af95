#include "app/setup/rigid_symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace brunt {

namespace {
constexpr Real kRounding = 1e-6;  // of a body's size: of files in single precision

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
  state.momentum = left.cwiseProduct(state.momentum);
}
}  // namespace

template <int Dim>
std::string hold_on_plane(const Points<Dim>& points, std::span<const Facet<Dim>> facets, int axis,
                          Real at, FreeBody<Dim>& made) {
  const ExtentAlong range = extent_along(points, facets, axis);
  const Real below = at - range.least, above = range.most - at, reach = kRounding * range.size;
  if (below < -reach || above < -reach) return "";
  if (below > reach && above > reach) {
    return "lies on both sides of the plane and is free: take the half of it away, or give it "
           "`motion`";
  }
  const Vec3 spin = made.state.spin();
  Vec3 other_spins = spin;
  if (Dim == 3) other_spins[axis] = 0;
  // A spin that the deck gives about the normal has others by rounding.
  if (made.state.v[axis] != 0 || other_spins.norm() > 1e-9 * spin.norm()) {
    return std::string("ends at the plane and is free: it can slide along it") +
           (Dim == 3 ? " and turn about its normal" : "") + ", and not start with another motion";
  }
  made.free[slot_of(axis)] = false;
  leave_turns_about(axis, made);
  return "";
}

template <int Dim>
std::vector<char> facets_on_planes(const Points<Dim>& points, std::span<const Facet<Dim>> facets,
                                   const std::array<std::optional<Real>, 3>& at) {
  std::vector<char> on(facets.size(), 0);
  for (int axis = 0; axis < Dim; ++axis) {
    const auto& plane = at[slot_of(axis)];
    if (!plane) continue;
    const Real reach = kRounding * extent_along(points, facets, axis).size;
    for (std::size_t f = 0; f < facets.size(); ++f) {
      bool all = true;
      for (int k = 0; k < facets[f].n_nodes(); ++k) {
        const Real x = points.x_start[slot_of(facets[f].node[k])][axis];
        all = all && std::fabs(x - *plane) <= reach;
      }
      if (all) on[f] = 1;
    }
  }
  return on;
}

template std::vector<char> facets_on_planes(const Points<2>&, std::span<const Facet<2>>,
                                            const std::array<std::optional<Real>, 3>&);
template std::vector<char> facets_on_planes(const Points<3>&, std::span<const Facet<3>>,
                                            const std::array<std::optional<Real>, 3>&);
template std::string hold_on_plane(const Points<2>&, std::span<const Facet<2>>, int, Real,
                                   FreeBody<2>&);
template std::string hold_on_plane(const Points<3>&, std::span<const Facet<3>>, int, Real,
                                   FreeBody<3>&);

}  // namespace brunt
// Tested by tests/verification/rigid_symmetry_test.cpp.
