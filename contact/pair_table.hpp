#pragma once
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "contact/options.hpp"
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
  /// The largest stiffness and damping with which anything may touch this body; 0: nothing may.
  PairOptions strongest(Label body) const;
  /// True if any of these pairs has friction.
  bool rubs() const { return rubs_; }
  /// Widest opening [m] through which heat passes to each body, by label; empty: none has any.
  const std::vector<Real>& gaps() const { return gaps_; }
  /// True if in any of these pairs an overlap at time 0 is felt at once.
  bool presses() const { return presses_; }
  /// Pairs of bodies that may touch, first <= second, with the names that history.csv uses.
  const std::vector<std::pair<Label, Label>>& pairs() const { return pairs_; }
  const std::vector<std::string>& names() const { return names_; }

 private:
  PairOptions fallback_;
  std::map<std::pair<Label, Label>, PairOptions> given_;
  std::map<Label, PairOptions> strongest_;
  std::vector<std::pair<Label, Label>> pairs_;
  std::vector<std::string> names_;
  bool rubs_ = false;
  std::vector<Real> gaps_;  // [m]
  bool presses_ = false;
};

}  // namespace brunt
