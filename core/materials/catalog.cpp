#include "core/materials/catalog.hpp"

namespace brunt {

std::unique_ptr<Strength> make_strength(const NoStrength&, const StrengthInputs& inputs) {
  return std::make_unique<ElasticStrength>(inputs.shear);
}
std::unique_ptr<Strength> make_strength(const J2& law, const StrengthInputs& inputs) {
  return std::make_unique<RadialReturn<J2>>(law, inputs);
}
std::unique_ptr<Strength> make_strength(const JohnsonCook& law, const StrengthInputs& inputs) {
  return std::make_unique<RadialReturn<JohnsonCook>>(law, inputs);
}
std::unique_ptr<Strength> make_strength(const StrengthLaw& law, const StrengthInputs& inputs) {
  return std::visit([&](const auto& chosen) { return make_strength(chosen, inputs); }, law);
}

std::unique_ptr<EquationOfState> make_eos(const LinearEos&, const EosInputs& inputs) {
  return std::make_unique<LinearEquation>(inputs.bulk);
}
std::unique_ptr<EquationOfState> make_eos(const MieGruneisen& law, const EosInputs& inputs) {
  return std::make_unique<MieGruneisenEquation>(law, inputs.density);
}
std::unique_ptr<EquationOfState> make_eos(const EosLaw& law, const EosInputs& inputs) {
  return std::visit([&](const auto& chosen) { return make_eos(chosen, inputs); }, law);
}

}  // namespace brunt
