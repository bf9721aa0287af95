#include <algorithm>
#include <functional>

#include "app/deck/findings.hpp"
#include "app/scene/place.hpp"
#include "app/setup/scene_checks.hpp"
#include "app/setup/suspicious.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {
bool is_tied(const LoadedDeck& loaded, const std::string& pair) {
  return std::any_of(loaded.deck.contact.pairs.begin(), loaded.deck.contact.pairs.end(),
                     [&](const auto& one) { return one.name == pair && one.value.options.tied; });
}

template <int Dim>
void warn_of_contact(const LoadedDeck& loaded, const Scene<Dim>& scene, const Warn& warn_at) {
  if (!scene.contact) return;
  const auto warn = [&](const std::string& pair, const std::string& what) {
    const std::string named = "contact.pairs." + pair;
    warn_at(loaded.places.has(named) ? named : "contact", pair + ": " + what);
  };
  for (const auto& pair : scene.contact->initial_overlaps()) {
    warn(pair.name, std::to_string(pair.contacts) + " contacts overlap at time 0 by up to " +
                        deck::length_text(pair.deepest) +
                        "; they are felt once they have opened, and by what they close again "
                        "(initial_overlap: press feels them at once)");
  }
  for (const auto& pair : scene.contact->held_pairs()) {
    if (pair.places == 0 && is_tied(loaded, pair.name)) {
      warn(pair.name,
           "is tied, but nothing of both bodies touches at time 0 (particles of two "
           "bodies are tied by `bonded`)");
    }
    if (pair.stiffest > 0) {
      warn(pair.name, "its joint goes on along a line from a slope of " +
                          rounded(pair.stiffest, 3) + " Pa/m, " + rounded(pair.times_elements, 3) +
                          " times the elements on both sides: smaller elements, or a larger "
                          "`stiffness` of the pair, allow more");
    }
  }
  for (const auto& pair : scene.contact->one_sided_pairs()) {
    const auto& surface = loaded.deck.bodies[pair.open];
    if (surface.value.file.empty()) continue;  // a plane's front is what its deck says
    warn(pair.name, "elements meet the surface of " + surface.name +
                        ", which has a rim, from the side of its normals alone: see that it faces "
                        "them, or close it (particles meet both sides)");
  }
}

/// Probes and measures at places that lie farther outside of their body than its size, unless
/// `warnings` has them by now.
template <int Dim>
void warn_of_places(const LoadedDeck& loaded, const Scene<Dim>& scene,
                    const std::vector<DeckProblem>& warnings, const Warn& warn) {
  const auto look = [&](const std::string& path, const std::string& body,
                        const std::vector<Real>& at) {
    const auto reported = [&](const DeckProblem& one) { return one.path == path; };
    if (std::any_of(warnings.begin(), warnings.end(), reported)) return;
    const auto part = part_named(scene.body_names, scene.pieces, body);
    if (!part) return;
    const Label label = part->body;
    const deck::Body& given = loaded.deck.bodies[label].value;
    if (given.rigid) return;  // its surface alone has points
    const Real far = find_place(scene.part_view(body, kNoFields), at).point_distance;
    if (far > scene.body_size[label]) {
      warn(path, "lies outside of '" + body + "': values of its nearest point are taken, " +
                     deck::length_text(far) + " away");
    }
  };
  for (const auto& [name, probe] : loaded.deck.probes) {
    look("probes." + name + ".at", probe.body, probe.at);
  }
  for (const auto& [name, measure] : loaded.deck.measures) {
    if (const auto* point = std::get_if<deck::PointMeasure>(&measure.kind)) {
      look("measures." + name + ".point.at", point->body, point->at);
    }
  }
}
}  // namespace

template <int Dim>
void warn_of_scene(const LoadedDeck& loaded, const Scene<Dim>& scene, bool print,
                   std::vector<DeckProblem>& warnings) {
  const auto warn = [&](const std::string& path, const std::string& what) {
    // A value that was doubted when it was read has been reported.
    const auto doubted = [&](const DeckProblem& one) { return one.path == path; };
    if (std::any_of(loaded.warnings.begin(), loaded.warnings.end(), doubted)) return;
    warnings.push_back(loaded.places.problem(path, what));
    if (print) std::fprintf(stderr, "warning: %s\n", warnings.back().text().c_str());
  };
  warn_of_sizes(loaded, scene, warn);
  warn_of_missed_aims(loaded, scene, warn);
  warn_of_contact(loaded, scene, warn);
  warn_of_places(loaded, scene, warnings, warn);
  for (const auto& text : added_mass_warnings(loaded, scene)) {
    warnings.push_back(loaded.places.problem("time.mass_scaling", text));
    if (print) std::fprintf(stderr, "warning: %s\n", warnings.back().text().c_str());
  }
  if (loaded.deck.time.heat_every.value_or(1) > 1 && !scene.conducts()) {
    warn("time.heat_every", "changes nothing: no body conducts heat");
  }
}

template void warn_of_scene<2>(const LoadedDeck&, const Scene<2>&, bool, std::vector<DeckProblem>&);
template void warn_of_scene<3>(const LoadedDeck&, const Scene<3>&, bool, std::vector<DeckProblem>&);

}  // namespace brunt
