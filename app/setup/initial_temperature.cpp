#include "app/setup/initial_temperature.hpp"

#include "core/boundaries/function.hpp"

namespace brunt {

namespace {
/// [K] at which a body that deforms has no strength any more.
Real melting_of(const Deck& deck, const deck::Body& body) {
  const auto* material = deck.material_named(body.material);
  if (body.rigid || material == nullptr) return kInfinity;
  const StrengthLaw strength = material->melting_strength();
  const auto* law = std::get_if<JohnsonCook>(&strength);
  return law != nullptr && law->T_melt ? *law->T_melt : kInfinity;
}
}  // namespace

template <int Dim>
std::vector<std::unique_ptr<InitialTemperature>> make_initial_temperature(const LoadedDeck& loaded,
                                                                          const Scene<Dim>& scene) {
  std::vector<std::unique_ptr<InitialTemperature>> by_body(loaded.deck.bodies.size());
  for (Label b = 0; b < by_body.size(); ++b) {
    const deck::Body& body = loaded.deck.bodies[b].value;
    if (!deck::has_temperature_field(body)) continue;
    auto& temperature = by_body[b] = std::make_unique<InitialTemperature>();
    temperature->body = b;
    temperature->origin = in_space<Dim>(scene.origin);
    temperature->value = [given = function_of(*body.temperature)](const Vec3& place) {
      return given(0, place);
    };
    temperature->material = body.material;
    temperature->melting = melting_of(loaded.deck, body);
  }
  return by_body;
}

template <int Dim>
Real start_temperature(const LoadedDeck& loaded, const Scene<Dim>& scene,
                       const BodyGeometry<Dim>& body) {
  const auto& given = loaded.deck.bodies[body.label].value.temperature;
  const InitialTemperature* field = scene.initial_temperature[body.label].get();
  if (field == nullptr) return given ? given->constant : loaded.deck.ambient;
  Real sum = 0;
  for (const auto& x : body.points) sum += field->at(in_space<Dim>(x - scene.origin));
  return sum / static_cast<Real>(body.points.size());
}

DeckProblem problem_of(const LoadedDeck& loaded, const InitialTemperatureError& error) {
  return loaded.places.problem("bodies." + loaded.deck.bodies[error.body].name + ".temperature",
                               error.what());
}

template std::vector<std::unique_ptr<InitialTemperature>> make_initial_temperature(
    const LoadedDeck&, const Scene<2>&);
template std::vector<std::unique_ptr<InitialTemperature>> make_initial_temperature(
    const LoadedDeck&, const Scene<3>&);
template Real start_temperature(const LoadedDeck&, const Scene<2>&, const BodyGeometry<2>&);
template Real start_temperature(const LoadedDeck&, const Scene<3>&, const BodyGeometry<3>&);

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
