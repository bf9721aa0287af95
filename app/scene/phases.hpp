#pragma once
#include <array>

#include "core/wall_time.hpp"

namespace brunt {

/// The parts of a step whose wall seconds the summary names.
enum class Phase : int {
  step_bound,
  search,
  points,
  elements,
  particles,
  contact,
  ledger,
  output,
  balance
};
inline constexpr int kPhases = 9;
inline constexpr std::array<const char*, kPhases> kPhaseNames = {
    "step_bound", "search", "points", "elements", "particles",
    "contact",    "ledger", "output", "balance"};

struct Phases {
  const Communicator* ranks = &lone_rank();
  std::array<WallTime, kPhases> time{};

  WallTime& of(Phase phase) { return time[slot_of(phase)]; }
  const WallTime& of(Phase phase) const { return time[slot_of(phase)]; }
};

/// Adds its life time to a phase.
class PhaseTimer {
 public:
  PhaseTimer(Phases& phases, Phase phase) : timer_(phases.of(phase), *phases.ranks) {}

 private:
  WallTimer timer_;
};

}  // namespace brunt
