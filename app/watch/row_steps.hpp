#pragma once
#include "app/scene/scene.hpp"

namespace brunt {

/// What a row of history and a step take [ns], by counts alone: a function of the deck.
struct RowWork {
  Real row = 0, step = 0;
};
/// Collective.
template <int Dim>
RowWork row_work(const Scene<Dim>& scene);

/// The least number of steps between two rows with which rows take no more than kShareOfRows of the
/// time; a hundred at most.
inline constexpr Real kShareOfRows = 0.02;
std::int64_t steps_between_rows(const RowWork& work);

}  // namespace brunt
