#include "contact/evaluate/pairs_ahead.hpp"

#include <new>
#include <type_traits>

#include "contact/geometry/four_common_planes.hpp"

namespace brunt {

template <int Dim>
FirstTouch touch_before(const Entities<Dim>& entities, const FaceCandidate& candidate,
                        const ContactKey& key, const Section& section, const TouchStep& step) {
  if (step.time_zero) {
    return first_touch(entities.planes[slot_of(candidate.lower)],
                       entities.planes[slot_of(candidate.upper)], section, candidate);
  }
  if (any_born(entities, candidate)) {
    return born_touch(entities.planes[slot_of(candidate.lower)],
                      entities.planes[slot_of(candidate.upper)], section);
  }
  const auto* before = step.before->find(key);
  return before == nullptr ? FirstTouch{} : *before;
}

namespace {
/// Asks for what is read soon: a face, with its plane and its reach, is read in one step after the
/// other only here, and has left the cache in between. Pairs of one face follow each other.
template <int Dim>
BRUNT_INLINE void fetch_ahead(const Entities<Dim>& entities, std::span<const ListedFaces> listed,
                              std::size_t k) {
  constexpr std::size_t kAhead = 8, kLine = 64;
  if (k + kAhead >= listed.size()) return;
  const LocalIndex lower = listed[k + kAhead].lower;
  if (lower == listed[k + kAhead - 1].lower) return;
  const auto f = slot_of(lower);
  const auto fetch = [](const auto& what) {
    const auto* from = reinterpret_cast<const char*>(&what);
    for (std::size_t at = 0; at < sizeof what; at += kLine) __builtin_prefetch(from + at);
  };
  fetch(entities.faces[f]), fetch(entities.planes[f]), fetch(entities.reaches[f]);
}

/// Whether one plane between two faces can be found before it is known what else they do.
bool has_one_plane(const FacePlane<3>& lower, const FacePlane<3>& upper,
                   const FaceCandidate& candidate) {
  return lower.n_corners == 4 && upper.n_corners == 4 && candidate.laws.holds == nullptr &&
         !candidate.normal.at_point && !candidate.normal.layer.acts() && !is_split(lower, upper) &&
         !is_split(upper, lower);
}
}  // namespace

template <int Dim>
std::span<const CommonPlane<Dim>> PairAhead<Dim>::find_planes(const Entities<Dim>& entities,
                                                              const Section& section,
                                                              const EvaluationStep& step,
                                                              Planes<Dim>& room) {
  if (is_known) return planes;
  const ContactKey key = key_between(entities, candidate);
  touch = touch_before(entities, candidate, key, section, step.touches);
  if (!step.touches.time_zero || candidate.laws.presses_at_once()) {
    const int n = planes_of(entities.planes[slot_of(candidate.lower)],
                            entities.planes[slot_of(candidate.upper)], section, candidate,
                            step.touches, touch, room);
    planes = {room.data(), slot_of(n)};
  }
  return planes;
}

template <int Dim>
std::span<PairAhead<Dim>> PairsAhead<Dim>::next() {
  n_ = 0;
  const auto listed = pairs_.listed();
  const SearchBox<Dim>* const reaches = entities_.reaches.data();
  std::size_t k = at_;  // most are not in reach: nothing is written for them
  for (; n_ < kBlock && k < listed.size(); ++k) {
    fetch_ahead(entities_, listed, k);
    const bool in_reach =
        reaches[slot_of(listed[k].lower)].meets(reaches[slot_of(listed[k].upper)]);
    if (in_reach || step_.fast || pairs_.options(k).acts_apart) look_at(k, in_reach);
  }
  at_ = k;
  if constexpr (Dim == 3) find_planes();
  return {block_.data(), n_};
}

template <int Dim>
void PairsAhead<Dim>::look_at(std::size_t k, bool in_reach) {
  const auto& lower = entities_.faces[slot_of(pairs_.listed()[k].lower)];
  for (std::size_t c = 0; c < slot_of(lower.n_nodes); ++c) {
    __builtin_prefetch(&entities_.nodes.v[slot_of(lower.node[c])]);
  }
  // Made where it stands: a copy would wait for what has just been written.
  static_assert(std::is_trivially_destructible_v<PairAhead<Dim>>);
  ::new (static_cast<void*>(&block_[n_++])) PairAhead<Dim>{pairs_.candidate(k), in_reach};
}

template <int Dim>
void PairsAhead<Dim>::find_planes() {
  if constexpr (Dim == 3) {
    if (step_.touches.time_zero) return;
    std::array<QuadPair, kBlock> quads;
    std::array<PairAhead<3>*, kBlock> of{};
    std::size_t n = 0;
    for (auto& pair : std::span(block_.data(), n_)) {
      const FaceCandidate& candidate = pair.candidate;
      const auto &lower = entities_.planes[slot_of(candidate.lower)],
                 &upper = entities_.planes[slot_of(candidate.upper)];
      if (!pair.in_reach || !has_one_plane(lower, upper, candidate)) continue;
      if (any_born(entities_, candidate)) continue;
      const auto* before = step_.touches.before->find(key_between(entities_, candidate));
      if (before != nullptr && before->matters()) continue;
      if (before != nullptr) pair.touch = *before;
      quads[n] = {&lower, &upper, needs_of(candidate, 0), &planes_[n]};
      of[n++] = &pair;
    }
    if (n < 2) return;  // by itself it is found faster
    four_common_planes(quads, static_cast<int>(n));
    for (std::size_t i = 0; i < n; ++i) {
      of[i]->is_known = true;
      of[i]->planes = {&planes_[i], quads[i].presses ? std::size_t{1} : 0};
    }
  }
}

template struct PairAhead<2>;
template struct PairAhead<3>;
template class PairsAhead<2>;
template class PairsAhead<3>;
template FirstTouch touch_before<2>(const Entities<2>&, const FaceCandidate&, const ContactKey&,
                                    const Section&, const TouchStep&);
template FirstTouch touch_before<3>(const Entities<3>&, const FaceCandidate&, const ContactKey&,
                                    const Section&, const TouchStep&);

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
