#pragma once
/// Listed pairs of faces, four at a time: what is looked up of each, and the planes of most, is
/// found before any of them is evaluated, side by side.
#include <array>
#include <span>

#include "contact/evaluate/evaluate.hpp"
#include "contact/evaluate/face_planes.hpp"

namespace brunt {

template <int Dim>
bool any_born(const Entities<Dim>& entities, const FaceCandidate& candidate) {
  if (!entities.any_born) return false;
  return entities.faces[slot_of(candidate.lower)].born ||
         entities.faces[slot_of(candidate.upper)].born;
}

template <int Dim>
ContactKey key_between(const Entities<Dim>& entities, const FaceCandidate& candidate) {
  return touch_key(ContactKind::face_face, entities.faces[slot_of(candidate.lower)].id,
                   entities.faces[slot_of(candidate.upper)].id);
}

/// What two faces keep of how they met, as the last evaluation left it; at time 0, and where one is
/// born, they meet.
template <int Dim>
FirstTouch touch_before(const Entities<Dim>& entities, const FaceCandidate& candidate,
                        const ContactKey& key, const Section& section, const TouchStep& step);

template <int Dim>
struct PairAhead {
  FaceCandidate candidate;
  bool in_reach = false;
  bool is_known = false;                          ///< so are `touch`, and `planes`
  FirstTouch touch{};                             ///< once planes are found, but for its key
  std::span<const CommonPlane<Dim>> planes = {};  ///< that carry pressure

  /// Sets `touch` and returns `planes`.  room  where they are put if they are not known
  std::span<const CommonPlane<Dim>> find_planes(const Entities<Dim>& entities,
                                                const Section& section, const EvaluationStep& step,
                                                Planes<Dim>& room);
};

template <int Dim>
class PairsAhead {
 public:
  /// All outlive it.
  PairsAhead(const Entities<Dim>& entities, const FacePairs<Dim>& pairs, const EvaluationStep& step)
      : entities_(entities), pairs_(pairs), step_(step) {}
  PairsAhead(const PairsAhead&) = delete;
  PairsAhead& operator=(const PairsAhead&) = delete;

  /// The next of them that anything is to be asked of, in their order; empty at the end. Holds
  /// until the next call.
  std::span<PairAhead<Dim>> next();

 private:
  static constexpr std::size_t kBlock = 4;
  void look_at(std::size_t k, bool in_reach);
  void find_planes();

  const Entities<Dim>& entities_;
  const FacePairs<Dim>& pairs_;
  const EvaluationStep& step_;
  std::size_t at_ = 0, n_ = 0;
  std::array<PairAhead<Dim>, kBlock> block_;
  std::array<CommonPlane<Dim>, kBlock> planes_;
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
