#pragma once
#include "app/loop/signals.hpp"
#include "core/parallel/communicator.hpp"
#include "core/step_limit.hpp"

namespace brunt {

/// All that ranks must agree on before a step.
struct StepHead {
  StepLimit step_limit;        ///< the smallest bound on the step, and whose
  Requests requests;           ///< what the run is asked for from outside
  Real heat_step = kInfinity;  ///< [s] that of heat alone

  /// Joins what another rank says; the order does not matter. True if its step limit is the smaller
  /// one, or no number, which ends the run.
  bool take(const StepHead& other);
};

/// The smallest step limit of all ranks, and what any of them is asked for. Collective: the one
/// reduction at the head of a step.
StepHead over_ranks(const StepHead& mine, const Communicator& ranks);

}  // namespace brunt
