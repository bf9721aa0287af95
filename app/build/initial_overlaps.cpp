#include <cstdio>

#include "app/build/scene_checks.hpp"
#include "app/deck/findings.hpp"

namespace brunt {

template <int Dim>
void warn_of_overlaps(const LoadedDeck& loaded, const Scene<Dim>& scene, bool print,
                      std::vector<DeckProblem>& warnings) {
  if (!scene.contact) return;
  for (const auto& pair : scene.contact->initial_overlaps()) {
    const std::string named = "contact.pairs." + pair.name;
    warnings.push_back(loaded.places.problem(
        loaded.places.has(named) ? named : "contact",
        pair.name + ": " + std::to_string(pair.contacts) + " contacts overlap at time 0 by up to " +
            deck::length_text(pair.deepest) +
            "; they are felt once they have opened, and by what they close again "
            "(initial_overlap: press feels them at once)"));
    if (print) std::fprintf(stderr, "warning: %s\n", warnings.back().text().c_str());
  }
}

template void warn_of_overlaps<2>(const LoadedDeck&, const Scene<2>&, bool,
                                  std::vector<DeckProblem>&);
template void warn_of_overlaps<3>(const LoadedDeck&, const Scene<3>&, bool,
                                  std::vector<DeckProblem>&);

}  // namespace brunt
