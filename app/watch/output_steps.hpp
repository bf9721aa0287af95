#pragma once
#include "app/scene/scene.hpp"

namespace brunt {

/// What a row of history, a frame and a step take [ns], by counts alone: a function of the deck.
struct OutputWork {
  Real row = 0, frame = 0, step = 0;
};
/// Collective.  columns  of a row
template <int Dim>
OutputWork output_work(const Scene<Dim>& scene, std::size_t columns);

/// Shares of the time that rows and frames take where the deck does not say how often they come.
inline constexpr Real kShareOfRows = 0.01, kShareOfFrames = 0.015;
/// What rows take in all whatever their share: nobody waits for it [ns].
inline constexpr Real kTimeOfSureRows = 3e7;

/// The least number of steps between two rows with which rows take no more than kShareOfRows of the
/// time; a hundred at most.
std::int64_t steps_between_rows(const OutputWork& work);
/// Rows that take kTimeOfSureRows in all: so many come however few steps there are. 0: none.
Real sure_rows(const OutputWork& work);
/// The same as of rows, of frames and kShareOfFrames, without a bound: FrameTimes has one.
std::int64_t steps_between_frames(const OutputWork& work);

}  // namespace brunt
