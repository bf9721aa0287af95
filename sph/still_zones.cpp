#include "sph/still_zones.hpp"

#include <algorithm>

#include "sph/parallel.hpp"

namespace brunt {

template <int Dim>
void StillZones<Dim>::start(const ListWatch<Dim>& watch, std::size_t n_owned) {
  zone_of_.resize(watch.x().size());
  for (std::size_t z = 0; z < watch.n_zones(); ++z) {
    for (const LocalIndex i : watch.members(z)) zone_of_[i] = static_cast<LocalIndex>(z);
  }
  stirred_.assign(watch.n_zones(), 0);
  near_.assign(watch.n_zones(), 0);
  left_out_.assign(n_owned, 0);
  n_stirred_ = count_ = 0;
  computed_ = found_ = false;
}

template <int Dim>
void StillZones<Dim>::look(const ListWatch<Dim>& watch, const Points<Dim>& points,
                           std::span<const MirrorImage> images) {
  if (all_stirred()) return;
  const auto moves = [&](LocalIndex i) {
    const std::size_t n = points.x.size();
    const std::size_t k = slot_of(i) < n ? slot_of(i) : slot_of(images[slot_of(i) - n].of);
    bool any = false;
    for (int d = 0; d < Dim; ++d) {
      any = any || points.v[k][d] != 0 || points.x[k][d] != watch.x()[k][d];
    }
    return any;
  };
  for_each(stirred_.size(), [&](std::size_t z) {
    const auto members = watch.members(z);
    if (!stirred_[z] && std::any_of(members.begin(), members.end(), moves)) stirred_[z] = 1;
  });
  const bool changed = settle(watch);
  if (computed_ && (changed || !found_)) find_left_out();
}

template <int Dim>
void StillZones<Dim>::look_again(const ListWatch<Dim>& watch) {
  if (settle(watch) && computed_) find_left_out();
  computed_ = true;
}

/// Finds the zones beside those that are stirred. True where there are more of them than before.
template <int Dim>
bool StillZones<Dim>::settle(const ListWatch<Dim>& watch) {
  const auto n = slot_of(std::count(stirred_.begin(), stirred_.end(), 1));
  if (n == n_stirred_) return false;
  n_stirred_ = n;
  for (const auto [a, b] : watch.touching()) {
    if (stirred_[a] || stirred_[b]) near_[a] = near_[b] = 1;
  }
  return true;
}

template <int Dim>
void StillZones<Dim>::find_left_out() {
  for_each(left_out_.size(), [&](std::size_t i) { left_out_[i] = near_[zone_of_[i]] ? 0 : 1; });
  count_ = slot_of(std::count(left_out_.begin(), left_out_.end(), 1));
  found_ = true;
}

template class StillZones<2>;
template class StillZones<3>;

}  // namespace brunt
// Tested by tests/unit/sph/still_zones_test.cpp.
