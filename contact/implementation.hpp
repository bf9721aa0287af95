#pragma once
#include "contact/evaluate.hpp"
#include "contact/manager.hpp"

namespace brunt {

/// What the manager holds.
template <int Dim>
struct ContactManager<Dim>::Implementation {
  Implementation(const ContactOptions& options, const Section& of_section,
                 std::vector<Surface<Dim>*> of_surfaces, const std::vector<std::string>& body_names)
      : section(of_section),
        surfaces(std::move(of_surfaces)),
        pairs(options, surfaces, body_names),
        entities(surfaces, pairs, section),
        candidates(options.search, options.skin) {}

  /// The longest step that may follow one of dt, 0 for the first: that of the springs, and four
  /// times dt where particles must look ahead.
  StepVote longest_after(Real dt) const;
  /// Records and votes of the lists at the present motion.
  void evaluate(Real dt, const StepVote& longest);

  Section section;
  std::vector<Surface<Dim>*> surfaces;
  PairTable pairs;
  Entities<Dim> entities;
  Candidates<Dim> candidates;
  Records<Dim> records;
  StepVote vote;
  Real dt_last = 0;       // [s] of the last evaluation
  Real longest_last = 0;  // [s] that the lists had to serve at the last evaluation
  bool started = false;   // forces have been evaluated
};

}  // namespace brunt
