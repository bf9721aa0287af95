#include <cmath>

#include "app/deck/findings.hpp"
#include "app/setup/scene_checks.hpp"

namespace brunt {

namespace {
constexpr const char* kPath = "time.mass_scaling";
constexpr Real kMuchMass = 0.01;  // of a body's own

template <int Dim>
AddedMass added_to(const Scene<Dim>& scene, Label body) {
  AddedMass all;
  for (const auto& solid : scene.solids) {
    const AddedMass own = solid->added_mass(body);
    all.added += own.added, all.material += own.material;
    all.n_scaled += own.n_scaled, all.n += own.n;
  }
  return all;
}

std::string text_of(const std::string& body, const AddedMass& mass) {
  return "adds " + deck::short_text(100 * mass.added / mass.material) + " % (" +
         deck::short_text(mass.added) + " kg) to the mass of " + body + ", in " +
         std::to_string(mass.n_scaled) + " of its " + std::to_string(mass.n) + " elements";
}
}  // namespace

template <int Dim>
void check_added_mass(const LoadedDeck& loaded, Scene<Dim>& scene,
                      std::vector<DeckProblem>& problems) {
  const auto& scaling = loaded.deck.time.mass_scaling;
  if (!scaling) return;
  for (Label b = 0; b < scene.body_names.size(); ++b) {
    const AddedMass mass = added_to(scene, b);
    if (mass.added > 0) scene.notes.push_back("mass scaling " + text_of(scene.body_names[b], mass));
    if (!(mass.added > scaling->max_added_mass * mass.material)) continue;
    problems.push_back(loaded.places.problem(
        kPath, text_of(scene.body_names[b], mass) + ", more than max_added_mass = " +
                   deck::short_text(100 * scaling->max_added_mass) +
                   " %: a shorter `step`, or coarser elements where they are smallest"));
  }
}

template <int Dim>
std::vector<std::string> added_mass_warnings(const LoadedDeck& loaded, const Scene<Dim>& scene) {
  std::vector<std::string> texts;
  const auto& scaling = loaded.deck.time.mass_scaling;
  if (!scaling) return texts;
  bool any = false;
  for (Label b = 0; b < scene.body_names.size(); ++b) {
    const AddedMass mass = added_to(scene, b);
    any = any || mass.added > 0;
    if (!(mass.added > kMuchMass * mass.material)) continue;
    texts.push_back(text_of(scene.body_names[b], mass) +
                    ": what moves them is slower by that, and they weigh more");
  }
  if (!any) {
    texts.push_back("changes nothing: all elements allow a step of " +
                    deck::time_text(loaded.deck.time.real(scaling->step)) + " as they are");
  }
  return texts;
}

template void check_added_mass<2>(const LoadedDeck&, Scene<2>&, std::vector<DeckProblem>&);
template void check_added_mass<3>(const LoadedDeck&, Scene<3>&, std::vector<DeckProblem>&);
template std::vector<std::string> added_mass_warnings<2>(const LoadedDeck&, const Scene<2>&);
template std::vector<std::string> added_mass_warnings<3>(const LoadedDeck&, const Scene<3>&);

}  // namespace brunt
