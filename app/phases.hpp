#pragma once
#include <array>
#include <chrono>

#include "core/types.hpp"

namespace brunt {

/// The parts of a step whose wall seconds the summary names.
enum class Phase : int { step_bound, search, points, elements, particles, contact, ledger, output };
inline constexpr int kPhases = 8;
inline constexpr std::array<const char*, kPhases> kPhaseNames = {
    "step_bound", "search", "points", "elements", "particles", "contact", "ledger", "output"};

struct Phases {
  std::array<double, kPhases> seconds{};
};

/// Adds its life time to a phase.
class PhaseTimer {
 public:
  PhaseTimer(Phases& phases, Phase phase)
      : seconds_(phases.seconds[static_cast<std::size_t>(phase)]),
        start_(std::chrono::steady_clock::now()) {}
  ~PhaseTimer() {
    seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }
  PhaseTimer(const PhaseTimer&) = delete;
  PhaseTimer& operator=(const PhaseTimer&) = delete;

 private:
  double& seconds_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace brunt
