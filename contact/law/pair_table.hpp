#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "contact/law/options.hpp"
#include "contact/law/resting_layer.hpp"
#include "core/surface.hpp"

namespace brunt {

/// Which bodies may touch, and by which options: those of the deck, for the bodies that are there.
class PairTable {
 public:
  PairTable() = default;
  template <int Dim>
  PairTable(const ContactOptions& options, const std::vector<Surface<Dim>*>& surfaces,
            std::vector<std::string> body_names);

  const PairOptions& of(Label a, Label b) const;
  /// Lets bodies rest on soft layers, as of their weights under gravity [m/s^2].
  void lay(const std::map<Label, RestingBody>& bodies, Real gravity);
  /// The layer between two bodies; none where `acts()` is false.
  const RestingLayer& resting(Label a, Label b) const;
  /// True where the faces of each piece of a body may touch each other too.
  bool touches_itself(Label body) const { return selves_.count(body) != 0; }
  /// Options by which particles of two bodies touch each other; none where they do not.
  const PairOptions* of_particles(Label a, Label b) const {
    const PairOptions& pair = of(a, b);
    return pair.ignore || pair.bonded ? nullptr : &pair;
  }
  /// True if particles of some two bodies, or of this one and another, may touch each other.
  bool particles_meet() const { return !meeting_.empty(); }
  bool particles_meet(Label body) const { return meeting_.count(body) != 0; }
  /// True if any of these pairs has friction.
  bool particles_have_friction() const { return particles_have_friction_; }
  /// The largest stiffness and damping with which anything may touch this body; 0: nothing may.
  PairOptions strongest(Label body) const;
  /// [1] the stiffness that bounds steps of this body even where nothing touches it: of watched
  /// pairs kFreeStiffness.
  Real always(Label body) const;
  /// [1] as large a part of the springs of both bodies as any spring between them may be.
  Real stiffness(Label a, Label b) const;
  /// True if any of these pairs is watched.
  bool watched() const { return watched_; }
  /// True if any of these pairs has friction.
  bool has_friction() const { return has_friction_; }
  /// True if any of these pairs is tied, or a joint.
  bool holds() const { return holds_; }
  /// True if in any of these pairs heat passes from one body to the other.
  bool passes_heat() const { return passes_heat_; }
  /// True if in any of these pairs friction depends on temperature or flow stress.
  bool needs_material() const { return needs_material_; }
  /// True if in any of these pairs an overlap at time 0 is felt at once.
  bool presses() const { return presses_; }
  /// Widest opening [m] through which heat passes to each body, by label; empty: none has any.
  const std::vector<Real>& gaps() const { return gaps_; }
  /// Pairs of bodies that may touch, first <= second, in ascending order.
  const std::vector<std::pair<Label, Label>>& pairs() const { return pairs_; }
  /// The place of a pair of bodies among them, in either order.
  std::optional<std::size_t> find(Label a, Label b) const;
  /// The name of a pair, as history.csv uses it: the deck's, or "a-b".
  std::string name(std::size_t pair) const;
  /// The body of a pair on which history.csv reports the force: the first that the deck names.
  Label reported_body(std::size_t pair) const;
  /// Places of the pairs with columns in history.csv: all, or where they are more than
  /// kMostReportedPairs those that the deck names.
  const std::vector<std::size_t>& reported() const { return reported_; }

 private:
  Real stiffness_of(const PairOptions& pair, Label a, Label b) const;

  PairOptions fallback_;
  std::map<std::pair<Label, Label>, PairOptions> given_;
  std::map<Label, PairOptions> strongest_;
  std::map<Label, Real> always_;
  std::map<Label, Real> softest_;  // [Pa/m] least M/h of each body's faces that deform
  std::map<std::pair<Label, Label>, RestingLayer> resting_;    // first <= second
  std::map<std::pair<Label, Label>, std::string> pair_names_;  // those of the deck
  std::set<std::pair<Label, Label>> turned_;                   // as of ContactOptions
  std::vector<std::string> body_names_;
  std::vector<std::pair<Label, Label>> pairs_;
  std::vector<std::size_t> reported_;
  bool has_friction_ = false;
  bool watched_ = false;
  bool presses_ = false;
  bool holds_ = false;
  bool passes_heat_ = false;
  bool needs_material_ = false;
  std::vector<Real> gaps_;   // [m]
  std::set<Label> selves_;   // bodies that the deck pairs with themselves
  std::set<Label> meeting_;  // bodies whose particles may touch those of others
  bool particles_have_friction_ = false;
};

/// Looks up the options of pairs one after another, mostly of the same two bodies.
class PairFinder {
 public:
  explicit PairFinder(const PairTable& pairs) : pairs_(pairs) {}
  const PairOptions& of(Label a, Label b) {
    find(a, b);
    return *options_;
  }
  const RestingLayer& resting(Label a, Label b) {
    find(a, b);
    return *resting_;
  }

 private:
  void find(Label a, Label b) {
    if (options_ != nullptr && a == a_ && b == b_) return;
    options_ = &pairs_.of(a, b);
    resting_ = &pairs_.resting(a, b);
    a_ = a, b_ = b;
  }

  const PairTable& pairs_;
  Label a_ = 0, b_ = 0;
  const PairOptions* options_ = nullptr;
  const RestingLayer* resting_ = nullptr;
};

}  // namespace brunt
