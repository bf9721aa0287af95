#include "app/setup/planes.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/deck/findings.hpp"

namespace brunt {

namespace {
std::string path_of(int axis) { return std::string("symmetry.") + static_cast<char>('x' + axis); }

/// A body that deforms or is free, as it stands to a plane.
struct Standing {
  Real gap = 0;    ///< [m] from its outer nodes or particles to the plane
  Real size = 0;   ///< [m] of its elements, its spacing, or of the body where it is rigid
  Real reach = 0;  ///< [1] of the size: it ends at the plane
  bool above = false;
  bool ends_there() const { return gap <= reach * size; }
};

/// Nothing of bodies that are held or have a prescribed motion, or `motion` of their own.
template <int Dim>
std::optional<Standing> standing_of(const deck::Body& body, const BodyBox<Dim>& box, int axis,
                                    Real at, Real size) {
  if (box.empty() || (body.rigid && (!deck::follows_forces(body) || body.motion))) return {};
  const Real low = box.low[axis] - at, high = box.high[axis] - at;
  Standing one{std::min(std::fabs(low), std::fabs(high)), size, 0.1, low + high > 0};
  if (body.method == deck::Method::sph) one.reach = 0.75;
  if (body.rigid) one.size = box.lengths().maxCoeff(), one.reach = 1e-6;
  return one;
}

/// Of particles that end at a plane: lattices go on beyond it where they stand half a spacing from
/// it.
void warn_of_spacing(int axis, const std::string& name, const Standing& one, const Warn& warn) {
  constexpr Real kHalf = 0.5, kOff = 0.15;
  const Real spacings = one.gap / one.size;
  if (std::fabs(spacings - kHalf) <= kOff) return;
  warn(path_of(axis), "the outer particles of '" + name + "' stand " + deck::short_text(spacings) +
                          " spacings from the plane, not half of one: the shape does not end at "
                          "it, or the lattice (hexagonal, rotated) does not go on beyond it");
}

template <int Dim>
void warn_of_plane(const LoadedDeck& loaded, const Scene<Dim>& scene, int axis, Real at,
                   const std::vector<BodyBox<Dim>>& boxes, const Warn& warn) {
  bool any = false;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const auto& [name, body] = loaded.deck.bodies[b];
    const auto one = standing_of(body, boxes[b], axis, at, scene.body_size[b]);
    if (!one) continue;
    any = any || one->ends_there();
    if (!one->ends_there() && one->gap <= (body.rigid ? 1e-3 : 1.0) * one->size) {
      warn(path_of(axis), "'" + name + "' ends " + deck::length_text(one->gap) +
                              " from the plane and is not held by it");
    } else if (one->ends_there() && body.method == deck::Method::sph) {
      warn_of_spacing(axis, name, *one, warn);
    }
  }
  if (any) return;
  warn(path_of(axis),
       "holds nothing: no body ends at this plane at time 0, and what comes to it goes through");
}
}  // namespace

template <int Dim>
void check_planes(const LoadedDeck& loaded, const Scene<Dim>& scene,
                  std::vector<DeckProblem>& problems) {
  if (!loaded.deck.symmetry) return;
  const auto boxes = boxes_of_bodies(scene);
  const auto wrong = [&](int axis, const std::string& what) {
    problems.push_back(loaded.places.problem(path_of(axis), what));
  };
  for (int axis = 0; axis < Dim; ++axis) {
    const auto& at = loaded.deck.symmetry->across(axis);
    if (!at) continue;
    if (scene.geometry == Geometry::axisymmetric && axis == 0 && *at != 0) {
      wrong(axis, "x is the radius, and no plane stands across it: leave it out");
    }
    const std::string* on[2] = {nullptr, nullptr};  // below and above
    for (std::size_t b = 0; b < boxes.size(); ++b) {
      const auto& [name, body] = loaded.deck.bodies[b];
      const auto one = standing_of(body, boxes[b], axis, *at, scene.body_size[b]);
      if (one && one->ends_there()) on[one->above ? 1 : 0] = &name;
    }
    if (!on[0] || !on[1]) continue;
    wrong(axis, "'" + *on[0] + "' lies below the plane and '" + *on[1] +
                    "' above: of what is symmetric one side stands in the deck");
  }
}

template <int Dim>
void warn_of_planes(const LoadedDeck& loaded, const Scene<Dim>& scene,
                    const std::vector<BodyBox<Dim>>& boxes, const Warn& warn) {
  const Deck& deck = loaded.deck;
  for (int axis = 0; deck.symmetry && axis < Dim; ++axis) {
    const auto& at = deck.symmetry->across(axis);
    if (!at) continue;
    warn_of_plane(loaded, scene, axis, *at, boxes, warn);
    if (deck.has_gravity() && deck::largest_gravity(deck.gravity, deck.time.end)[axis] != 0) {
      warn("gravity", std::string("acts across the plane of symmetry, symmetry.") +
                          static_cast<char>('x' + axis) +
                          ": the mirror image would fall the other "
                          "way");
    }
  }
}

template void check_planes(const LoadedDeck&, const Scene<2>&, std::vector<DeckProblem>&);
template void check_planes(const LoadedDeck&, const Scene<3>&, std::vector<DeckProblem>&);
template void warn_of_planes(const LoadedDeck&, const Scene<2>&, const std::vector<BodyBox<2>>&,
                             const Warn&);
template void warn_of_planes(const LoadedDeck&, const Scene<3>&, const std::vector<BodyBox<3>>&,
                             const Warn&);

}  // namespace brunt
// Tested by tests/unit/app/mirrors_test.cpp.
