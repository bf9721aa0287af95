#pragma once
#include <vector>

#include "contact/evaluate/evaluate.hpp"
#include "contact/manager/search.hpp"

namespace brunt {

/// The contacts of one instant: records of those that carry force, and the step that they allow.
template <int Dim>
class Evaluation {
 public:
  const Records<Dim>& records() const { return records_; }
  Records<Dim>& records() { return records_; }
  const StepLimit& step_limit() const { return step_limit_; }

  /// Evaluates the lists at the present motion, after a step of dt [s]. Friction goes on from its
  /// past, or is left out where there is none: at time 0, and where the last evaluation is
  /// repeated.
  void run(const ContactSetup<Dim>& setup, ContactSearch<Dim>& search, Real dt,
           const LookAhead& ahead, const TouchStep& touches, FrictionHistory<Dim>* past);
  /// Puts together what both sides of each contact of particles leave for heat. Collective among
  /// neighbours.
  void complete_pair_heat(const ContactSetup<Dim>& setup, const ContactSearch<Dim>& search);

 private:
  void run_particles(const ContactSetup<Dim>& setup, const ContactSearch<Dim>& search,
                     const EvaluationStep& step, FrictionHistory<Dim>* past);

  Records<Dim> records_;
  std::vector<ParticleLoad> loads_;  // by particle; empty where no row of pairs is there
  std::vector<PairSide> sides_;      // by candidate of pairs; empty where nothing conducts
  StepLimit step_limit_;
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
