#include "app/deck/flow_stress.hpp"

namespace brunt::deck {

Real slow_flow_stress(const StrengthLaw& law, Real strain) {
  constexpr Real kRoom = 293.15;
  return std::visit(
      [&](const auto& chosen) {
        if constexpr (FlowLaw<std::decay_t<decltype(chosen)>>) {
          return Real{chosen.flow_stress(strain, 0.0, kRoom)};
        } else if constexpr (PressureLaw<std::decay_t<decltype(chosen)>>) {
          auto law = chosen;
          law.prepare();
          return law.flow_stress(PressureState<Real>{{strain, 0.0, kRoom}, 0.0, 1.0});
        } else {
          return kInfinity;
        }
      },
      law);
}

}  // namespace brunt::deck
// Tested by tests/unit/app/forecast_test.cpp.
