#include "core/boundaries/heat_step.hpp"

namespace brunt {

template <int Dim>
StepLimit heat_step(const Points<Dim>& points, int steps) {
  StepLimit step_limit;
  if (!points.conducts) return step_limit;
  for (std::size_t i = 0; i < points.owned(); ++i) {
    // Infinite where nothing flows.
    const Real step = points.least_capacity(i) / (steps * points.conductance[i]);
    step_limit.take({step >= 0 ? step : 0.0, "heat of point", points.body[i], points.id[i]});
  }
  return step_limit;
}

template StepLimit heat_step(const Points<2>&, int);
template StepLimit heat_step(const Points<3>&, int);

}  // namespace brunt
// Tested by tests/verification/heat_every_test.cpp.
