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

  /// Records and votes of the lists at the present motion.
  void evaluate(Real dt);

  Section section;
  std::vector<Surface<Dim>*> surfaces;
  PairTable pairs;
  Entities<Dim> entities;
  Candidates<Dim> candidates;
  Records<Dim> records;
  StepVote vote;
  Real dt_last = 0;      // [s] of the last evaluation
  bool started = false;  // forces have been evaluated
};

}  // namespace brunt
