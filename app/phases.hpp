#pragma once
#include <array>
#include <chrono>

#include "core/parallel/communicator.hpp"

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
  std::array<double, kPhases> seconds{};
  std::array<double, kPhases> waiting{};  ///< of these: sending, receiving, waiting for others
  /// Seconds of this rank's own work in a phase.
  double work(Phase phase) const {
    const auto p = static_cast<std::size_t>(phase);
    return seconds[p] - waiting[p];
  }
};

/// Adds its life time to a phase.
class PhaseTimer {
 public:
  PhaseTimer(Phases& phases, Phase phase)
      : phases_(phases),
        phase_(static_cast<std::size_t>(phase)),
        waited_(phases.ranks->traffic().seconds),
        start_(std::chrono::steady_clock::now()) {}
  ~PhaseTimer() {
    phases_.seconds[phase_] +=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    phases_.waiting[phase_] += phases_.ranks->traffic().seconds - waited_;
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  Phases& phases_;
  std::size_t phase_;
  double waited_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace brunt
