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
};

/// Steps the scene for a while, on one thread and with output into a folder that is removed again.
/// Nothing where its physics breaks at once, or the folder cannot be had. The scene is spent.
template <int Dim>
std::optional<Calibration> calibrate(const LoadedDeck& loaded, Scene<Dim>& scene);

/// Processor time [s] of this process, of all its threads.
Real processor_seconds();

}  // namespace brunt
