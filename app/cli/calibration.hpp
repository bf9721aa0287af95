#pragma once
#include <optional>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"

namespace brunt {

/// What steps of a scene cost, measured on its own first ones with all their output.
struct Calibration {
  std::int64_t steps = 0;     ///< that were measured
  Real seconds_per_step = 0;  ///< [s] of processor time
  Real start = 0;             ///< [s] of processor time before the first: building, first frame
  Real planned_step = 0;      ///< [s] the first step that a material bounds; 0: none did
  Real reached = 0;           ///< [s] the time of the scene that the steps reached
  bool ended = false;         ///< the scene came to its end
  bool stopped = false;       ///< it stopped before, as `stop` says
  /// Seconds of a step of the whole sample over one of its first part, SampleLimits::first_part.
  Real dearer = 1;
  Real points = 0;  ///< of the scene

  bool whole() const { return ended || stopped; }

  /// How many times the steps that the first of them promised were needed; 1 where none did.
  Real growth() const {
    return planned_step > 0 ? static_cast<Real>(steps) * planned_step / reached : 1;
  }
};

/// When a sample of steps is large enough.
struct SampleLimits {
  Real seconds = 0.7;          ///< processor time that a plan takes for it
  std::int64_t steps = 20000;  ///< more add nothing
  Real first_part = 0;         ///< [s] time of the scene up to which its first steps go
};

/// Steps the scene for a while, on one thread and with output into a folder that is removed again.
/// Nothing where its physics breaks at once, or the folder cannot be had. The scene is spent.
template <int Dim>
std::optional<Calibration> calibrate(const LoadedDeck& loaded, Scene<Dim>& scene,
                                     const SampleLimits& limits = {});

/// Processor time [s] of this process, of all its threads.
Real processor_seconds();

}  // namespace brunt
