#include "core/materials/catalog.hpp"

#include <type_traits>

#include "core/materials/softening.hpp"
#include "core/materials/wide_return.hpp"
#include "core/wide_lanes.hpp"

namespace brunt {

namespace {
std::unique_ptr<Strength> make(const NoStrength&, const StrengthInputs& inputs) {
  return std::make_unique<ElasticStrength>(inputs.shear);
}
template <FlowLaw Law>
std::unique_ptr<Strength> make(const Law& law, const StrengthInputs& inputs) {
  return std::make_unique<RadialReturn<Law>>(law, inputs);
}
template <PressureLaw Law>
std::unique_ptr<Strength> make(const Law& law, const StrengthInputs& inputs) {
  return std::make_unique<PressureReturn<Law>>(law, inputs);
}
template <PorousLaw Law>
std::unique_ptr<Strength> make(const Law& law, const StrengthInputs& inputs) {
  return std::make_unique<PorousReturn<Law>>(law, inputs);
}
/// What is none of these: says what it lacks.
template <class Law>
std::unique_ptr<Strength> make(const Law&, const StrengthInputs&) {
  if constexpr (std::is_base_of_v<PrintedPressureLaw<Law>, Law>) {
    static_assert(PressureLaw<Law>, "this strength lacks what a PressureLaw has");
  } else {
    static_assert(FlowLaw<Law>, "this strength lacks what a FlowLaw has, or a PorousLaw");
  }
  return nullptr;
}
std::unique_ptr<Damage> make(const NoDamage&, const DamageInputs&) { return nullptr; }
template <DamageLaw Law>
std::unique_ptr<Damage> make(const Law& law, const DamageInputs& inputs) {
  return std::make_unique<Softening<Law>>(law, inputs);
}
template <class Law>
std::unique_ptr<Damage> make(const Law&, const DamageInputs&) {
  static_assert(DamageLaw<Law>, "this damage lacks what a DamageLaw has");
  return nullptr;
}

std::unique_ptr<EquationOfState> make(const LinearEos&, const EosInputs& inputs) {
  return std::make_unique<LinearEquation>(inputs.bulk);
}
std::unique_ptr<EquationOfState> make(const MieGruneisen& law, const EosInputs& inputs) {
  return std::make_unique<MieGruneisenEquation>(law, inputs.density);
}
template <EosFormula Law>
std::unique_ptr<EquationOfState> make(const Law& law, const EosInputs& inputs) {
  return std::make_unique<PrintedEquation<Law>>(law, inputs);
}
template <class Law>
std::unique_ptr<EquationOfState> make(const Law&, const EosInputs&) {
  static_assert(EosFormula<Law>, "this equation of state lacks what an EosFormula has");
  return nullptr;
}
}  // namespace

std::unique_ptr<Damage> make_damage(const DamageChoice& law, const DamageInputs& inputs) {
  return std::visit([&](const auto& chosen) { return make(chosen, inputs); }, law);
}

std::unique_ptr<Strength> make_strength(const StrengthLaw& law, const StrengthInputs& inputs) {
  auto wide = wide_lanes() ? make_wide_strength(law, inputs) : nullptr;
  if (wide != nullptr) return wide;
  return std::visit([&](const auto& chosen) { return make(chosen, inputs); }, law);
}

std::optional<OwnConstants> own_constants(const StrengthLaw& law) {
  return std::visit(
      [](const auto& chosen) -> std::optional<OwnConstants> {
        if constexpr (requires { chosen.shear_modulus(); }) {
          return OwnConstants{chosen.bulk_modulus(), chosen.shear_modulus()};
        } else {
          return std::nullopt;
        }
      },
      law);
}

bool is_fluid(const EosLaw& law) {
  return std::visit(
      [](const auto& chosen) {
        return requires { chosen.kFluid; };
      },
      law);
}

std::unique_ptr<EquationOfState> make_eos(const EosLaw& law, const EosInputs& inputs) {
  return std::visit([&](const auto& chosen) { return make(chosen, inputs); }, law);
}

}  // namespace brunt
// Tested by tests/unit/core/material_test.cpp.
