#pragma once
/// Faces beside faces: a list of little more than two indices a pair, since most are rejected; the
/// laws of a pair are found when it is not.
#include <span>

#include "contact/law/face_law.hpp"
#include "contact/surfaces/entities.hpp"

namespace brunt {

/// Two faces that may touch before the list is rebuilt, lower index first.
struct ListedFaces {
  LocalIndex lower = 0, upper = 0;
  std::uint32_t options = 0;  ///< place of the options of their bodies
};

/// What all faces of two bodies have in common; the table of pairs outlives it.
struct FaceOptions {
  const PairOptions* options;
  const RestingLayer* rests;
  bool acts_apart;  ///< they may bound the step, or hold each other, before they touch

  FaceOptions(const PairTable& pairs, Label a, Label b);
};

/// Two such faces with their laws.
struct FaceCandidate {
  LocalIndex lower = 0, upper = 0;
  FaceLaw normal{};
  PairLaws laws{};
  Real watched = 0;  ///< [1] stiffness of a pair that is watched; else 0
};

/// A part of the list, with what it takes to find laws.
template <int Dim>
class FacePairs {
 public:
  FacePairs(std::span<const ContactFace<Dim>> faces, std::span<const ListedFaces> listed,
            std::span<const FaceOptions> options)
      : faces_(faces), listed_(listed), options_(options) {}

  std::span<const ListedFaces> listed() const { return listed_; }
  const FaceOptions& options(std::size_t k) const { return options_[listed_[k].options]; }
  FaceCandidate candidate(std::size_t k) const;
  FacePairs part(std::size_t first, std::size_t last) const {
    return {faces_, listed_.subspan(first, last - first), options_};
  }

 private:
  std::span<const ContactFace<Dim>> faces_;
  std::span<const ListedFaces> listed_;
  std::span<const FaceOptions> options_;
};

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
