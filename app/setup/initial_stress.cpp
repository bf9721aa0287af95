#include "app/setup/initial_stress.hpp"

#include "app/setup/materials.hpp"
#include "core/boundaries/function.hpp"

namespace brunt {

template <int Dim>
std::vector<std::unique_ptr<InitialStress>> make_initial_stress(
    const LoadedDeck& loaded, const Scene<Dim>& scene, std::vector<DeckProblem>& problems) {
  std::vector<std::unique_ptr<InitialStress>> by_body(loaded.deck.bodies.size());
  for (Label b = 0; b < by_body.size(); ++b) {
    const deck::Body& body = loaded.deck.bodies[b].value;
    const Material* material = material_of(loaded.deck, scene.materials, body);
    if (!body.stress || material == nullptr) continue;
    const std::string wrong = initial_stress_problem(*material);
    if (!wrong.empty()) problems.push_back(problem_of(loaded, InitialStressError(b, wrong)));
    auto& stress = by_body[b] = std::make_unique<InitialStress>();
    stress->body = b;
    stress->origin = in_space<Dim>(scene.origin);
    for (std::size_t c = 0; c < stress->component.size(); ++c) {
      const auto given = function_of(body.stress->component[c]);
      if (!given) continue;
      stress->component[c] = [given = *given](const Vec3& place) { return given(0, place); };
    }
  }
  return by_body;
}

DeckProblem problem_of(const LoadedDeck& loaded, const InitialStressError& error) {
  return loaded.places.problem("bodies." + loaded.deck.bodies[error.body].name + ".stress",
                               error.what());
}

template std::vector<std::unique_ptr<InitialStress>> make_initial_stress(const LoadedDeck&,
                                                                         const Scene<2>&,
                                                                         std::vector<DeckProblem>&);
template std::vector<std::unique_ptr<InitialStress>> make_initial_stress(const LoadedDeck&,
                                                                         const Scene<3>&,
                                                                         std::vector<DeckProblem>&);

}  // namespace brunt
// Tested by tests/verification/initial_stress_test.cpp.
