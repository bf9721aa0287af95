#include "core/materials/wide_return.hpp"

namespace brunt {

std::unique_ptr<Strength> make_wide_strength(const StrengthLaw& law, const StrengthInputs& inputs) {
  return std::visit(
      [&](const auto& chosen) -> std::unique_ptr<Strength> {
        using Law = std::decay_t<decltype(chosen)>;
        if constexpr (FlowLaw<Law>) {
          return std::make_unique<RadialReturn<Law, Wide>>(chosen, inputs);
        } else {
          return nullptr;
        }
      },
      law);
}

}  // namespace brunt
