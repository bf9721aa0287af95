#include "app/watch/parts.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <span>

namespace brunt {

namespace {
/// Of the points [m]; 0 of none.
Real largest_extent(const BodyView& view) {
  Real largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    Real low = kInfinity, high = -kInfinity;
    for (std::size_t i = c; i < view.position.size(); i += 3) {
      low = std::min(low, view.position[i]), high = std::max(high, view.position[i]);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

/// Of a point, or the centre of a cell [m].
std::array<Real, 3> place_of(const BodyView& view, std::size_t entity, bool cells) {
  const std::size_t corners = cells ? slot_of(view.corners) : 1;
  std::array<Real, 3> place{};
  for (std::size_t k = 0; k < corners; ++k) {
    const std::size_t i = cells ? slot_of(view.connectivity[entity * corners + k]) : entity;
    for (std::size_t c = 0; c < 3; ++c) {
      place[c] += view.position[3 * i + c] / static_cast<Real>(corners);
    }
  }
  return place;
}

const Field* ids_of(const BodyView& view, bool cells) {
  return field_named(cells ? view.cell_fields : view.point_fields, "id");
}
}  // namespace

std::vector<char> held_at_start(const deck::WhereInside& where, const BodyView& start, bool cells) {
  const Real tolerance = 1e-6 * largest_extent(start);
  std::vector<char> held(cells ? start.n_cells() : start.position.size() / 3);
  for (std::size_t e = 0; e < held.size(); ++e) {
    const auto place = place_of(start, e, cells);
    held[e] = deck::holds(where, place, tolerance) ? 1 : 0;
  }
  return held;
}

std::vector<char> held_now(const deck::WhereInside& where, const BodyView& start,
                           const BodyView& now, bool cells) {
  auto held = held_at_start(where, start, cells);
  const Field *before = ids_of(start, cells), *after = ids_of(now, cells);
  if (before == nullptr || after == nullptr) return held;
  std::set<Real> ids;
  for (std::size_t e = 0; e < held.size(); ++e) {
    if (held[e] != 0) ids.insert(before->values[e]);
  }
  held.assign(after->values.size(), 0);
  for (std::size_t e = 0; e < held.size(); ++e) held[e] = ids.contains(after->values[e]) ? 1 : 0;
  return held;
}

}  // namespace brunt
