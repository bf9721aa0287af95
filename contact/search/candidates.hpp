#pragma once
#include <cmath>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "contact/exchange/imports.hpp"
#include "contact/search/clearance.hpp"
#include "contact/search/face_pairs.hpp"
#include "core/solid.hpp"

namespace brunt {

/// The box, or a point where it is not a number any more: that touches nothing.
template <int Dim>
SearchBox<Dim> finite_box(SearchBox<Dim> box) {
  for (std::size_t c = 0; c < slot_of(Dim); ++c) {
    if (!std::isfinite(box.lo[c]) || !std::isfinite(box.hi[c])) box.lo[c] = box.hi[c] = 0;
  }
  return box;
}

/// Rows of particles beside faces.
struct ParticleRows {
  const PairTable& pairs;
  const Clearances& clearances;               ///< of each candidate, with its face
  std::span<const std::size_t> starts;        ///< where each row begins, and their end
  std::span<const Clearance> row_clearances;  ///< of each row as a whole, with its particle
  ClearanceLoss loss;
  Real fastest = kInfinity;  ///< [m/s] no two nodes move faster relative to each other

  /// Rows first .. last of them.
  ParticleRows part(std::size_t first, std::size_t last) const {
    return {pairs,
            clearances,
            starts.subspan(first, last - first + 1),
            row_clearances.subspan(first, last - first),
            loss,
            fastest};
  }
  /// Where its candidates begin and end.
  std::pair<std::size_t, std::size_t> range(std::size_t row) const {
    return {starts[row], starts[row + 1]};
  }
};

/// The lists of what may touch, complete for as long as a bound on all motion holds
/// (docs/theory/contact.md (C1) to (C3)); no answer depends on when they are built or how wide
/// their skin is.
template <int Dim>
class Candidates {
 public:
  Candidates(SearchMode mode, std::optional<Real> skin) : mode_(mode), given_skin_(skin) {}

  /// Lists at nodes.x; pairs outlive them; longest [s] is the step whose speed limits they must
  /// serve. With other ranks it first brings in their faces that may touch what is evaluated here.
  /// Collective.
  void build(Entities<Dim>& entities, const PairTable& pairs, Real longest,
             ContactImports<Dim>& imports);
  /// True if they hold every contact and speed limit at nodes.x, nodes.v, planes; the same on all
  /// ranks. Collective: one reduction.
  bool complete(const Entities<Dim>& entities, Real longest, const Communicator& ranks);

  FacePairs<Dim> faces(const Entities<Dim>& entities) const {
    return {entities.faces, face_pairs_, face_options_};
  }
  std::size_t n_faces() const { return face_pairs_.size(); }
  /// Particles beside faces, as far as motion has brought them since the lists were built;
  /// longest [s] is the step that speed limits look ahead.
  ParticleRows particle_rows(const PairTable& pairs, Real longest) const;
  /// How many faces stand beside particles in all rows.
  std::size_t n_particles() const { return starts_.empty() ? 0 : starts_.back(); }
  /// Rows of owned particles beside particles of other bodies, in the order of ids.
  std::span<const PairCandidate> pairs() const { return pairs_; }
  /// Where each row begins in pairs(), and their end; empty where there are none.
  std::span<const std::size_t> pair_starts() const { return pair_starts_; }
  Real skin() const { return skin_; }
  /// Largest relative speed [m/s] of any two nodes, when last looked at.
  Real speed() const { return speed_; }
  /// How far faces may come in the longest step at the present speeds [m]; 0: no faces are fast
  /// enough to bound the step by their speed (contact/evaluate/face_step_limits.hpp).
  Real way_of_faces(const Entities<Dim>& entities) const;
  std::size_t builds() const { return builds_; }
  /// Where a face may touch another before the lists are renewed [m].
  SearchBox<Dim> box_of_face(const Entities<Dim>& entities, std::size_t face) const;
  /// Where a particle may touch a face, or bound the step by its speed, before the lists are
  /// renewed [m].
  SearchBox<Dim> box_of_particle(const Entities<Dim>& entities, std::size_t particle) const;
  /// The same for touching or nearing another particle, half of the way each [m].
  SearchBox<Dim> box_beside_particles(const Entities<Dim>& entities, std::size_t particle) const;

 private:
  void find_faces(const Entities<Dim>& entities, const PairTable& pairs);
  void find_particles(const Entities<Dim>& entities, const PairTable& pairs,
                      std::vector<LocalIndex>& particles, std::vector<LocalIndex>& faces);
  void find_pairs(const Entities<Dim>& entities, const PairTable& pairs);
  void choose_skin(const Entities<Dim>& entities);
  void find_clearances(const Entities<Dim>& entities, const std::vector<LocalIndex>& particles,
                       const std::vector<LocalIndex>& faces);

  SearchMode mode_;
  std::optional<Real> given_skin_;
  std::vector<ListedFaces> face_pairs_;
  std::vector<FaceOptions> face_options_;
  std::vector<std::size_t> starts_;  // of rows of particles beside faces
  Clearances clearances_;
  std::vector<Clearance> row_clearances_;
  std::vector<PairCandidate> pairs_;
  std::vector<std::size_t> pair_starts_;
  Real speed_reach_ = 0;   // [m] of motion that the particles' boxes predict
  Real face_reach_ = 0;    // [m] the same of faces, both sides together
  Real speed_ = 0;         // [m/s] largest relative speed now
  Real moved_ = 0;         // [m] largest relative displacement since
  Real warped_ = 0;        // [m] largest growth of a warp since
  Real turned_ = 0;        // largest change of a normal since
  Real skin_ = 0;          // [m]
  std::size_t steps_ = 0;  // since the lists were built
  std::size_t builds_ = 0;
};

}  // namespace brunt
// Tested by tests/unit/contact/rebuild_test.cpp.
