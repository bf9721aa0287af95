#include "app/build/scene_builder.hpp"

#include <algorithm>
#include <cmath>

#include "app/build/bodies.hpp"
#include "app/build/boundaries.hpp"
#include "app/build/groups.hpp"
#include "app/build/materials.hpp"
#include "app/build/scene_checks.hpp"
#include "app/build/sound_part.hpp"
#include "app/build/watch.hpp"

namespace brunt {

namespace {
/// The centre of the first bounding box, rounded to a power of two of its size: positions near 0
/// keep their bits, and adding it back is exact where it can be.
template <int Dim>
Vec<Dim> rounded_center(const std::vector<BodyGeometry<Dim>>& bodies, Geometry geometry) {
  Vec<Dim> low = Vec<Dim>::Constant(kInfinity), high = Vec<Dim>::Constant(-kInfinity);
  for (const auto& body : bodies) {
    for (const auto& x : body.points) low = low.cwiseMin(x), high = high.cwiseMax(x);
  }
  const Real extent = (high - low).maxCoeff();
  if (!(extent > 0) || !std::isfinite(extent)) return Vec<Dim>::Zero();
  const Real step = std::exp2(std::ceil(std::log2(extent)) + 1);
  Vec<Dim> center;
  for (int c = 0; c < Dim; ++c) center[c] = step * std::nearbyint(0.5 * (low[c] + high[c]) / step);
  if (geometry == Geometry::axisymmetric) center[0] = 0;  // x is a radius
  return center;
}

Label label_of(const Deck& deck, const std::string& name) {
  const auto found = std::find_if(deck.bodies.begin(), deck.bodies.end(),
                                  [&](const auto& body) { return body.name == name; });
  return static_cast<Label>(found - deck.bodies.begin());
}

/// Options of each pair of labels; `any` stands for every body.
ContactOptions contact_options(const Deck& deck) {
  ContactOptions options;
  options.fallback = deck.contact.fallback;
  options.search = deck.contact.search;
  options.skin = deck.contact.skin;
  for (const auto& [name, pair] : deck.contact.pairs) {
    const Label first = label_of(deck, pair.between[0]);
    for (Label other = 0; other < deck.bodies.size(); ++other) {
      const bool any = pair.between[1] == "any";
      if (!any && other != label_of(deck, pair.between[1])) continue;
      const std::pair key{std::min(first, other), std::max(first, other)};
      if (any && options.pairs.count(key)) continue;  // a pair named in full has its own options
      options.pairs[key] = pair.options;
      // Contact counts the share of the body with the lower label.
      auto& split = options.pairs[key].friction_heat.split;
      if (split && first > other) split = 1 - *split;
      if (!any) options.pair_names[key] = name;
    }
  }
  return options;
}

template <int Dim>
std::vector<RigidMotion<Dim>> motions_of(const LoadedDeck& loaded, const Scene<Dim>& scene) {
  std::vector<RigidMotion<Dim>> motions;
  for (std::size_t b = 0; b < loaded.deck.bodies.size(); ++b) {
    const auto& body = loaded.deck.bodies[b].value;
    if (!body.rigid || !body.motion) continue;
    RigidMotion<Dim> motion;
    motion.body = static_cast<Label>(b);
    for (std::size_t c = 0; c < body.motion->velocity.size() && c < Dim; ++c) {
      motion.velocity[static_cast<int>(c)] = body.motion->velocity[c];
    }
    motion.center = -scene.origin;
    if (body.motion->spin) {
      const auto& spin = *body.motion->spin;
      motion.spin = spin.rate;
      if (Dim == 3) motion.axis = Vec3(spin.axis[0], spin.axis[1], spin.axis[2]).normalized();
      for (std::size_t c = 0; c < spin.about.size() && c < Dim; ++c) {
        motion.center[static_cast<int>(c)] += spin.about[c];
      }
    }
    motions.push_back(motion);
  }
  return motions;
}

/// True where some pair of bodies, or pieces of a body, may touch. Bodies that never move do so
/// only where heat passes.
bool anything_can_touch(const Deck& deck, const ContactOptions& options) {
  const bool all_held = std::all_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
    return body.value.rigid ? !body.value.motion : is_held(deck, body.name);
  });
  const auto passes = [](const auto& pair) { return pair.second.passes_heat(); };
  const bool heat = options.fallback.passes_heat() ||
                    std::any_of(options.pairs.begin(), options.pairs.end(), passes);
  if (all_held && !heat) return false;
  if (!options.fallback.ignore) return !deck.bodies.empty();
  return std::any_of(options.pairs.begin(), options.pairs.end(),
                     [](const auto& pair) { return !pair.second.ignore; });
}
}  // namespace

template <int Dim>
std::unique_ptr<Scene<Dim>> build_scene(const LoadedDeck& loaded) {
  const Deck& deck = loaded.deck;
  std::vector<DeckProblem> problems;
  const auto bodies = make_bodies<Dim>(loaded, problems);
  if (!problems.empty()) {
    add_build_problems(loaded, problems);
    throw DeckError(problems);
  }

  auto scene = std::make_unique<Scene<Dim>>(rounded_center(bodies, deck.geometry), deck.geometry,
                                            deck.depth);
  for (const auto& body : deck.bodies) scene->body_names.push_back(body.name);
  scene->materials = make_materials(deck);

  NextIds next;
  for (const GroupKind kind : kGroupKinds) {
    auto elements = make_elements(loaded, *scene, bodies, kind, next);
    if (elements) scene->solids.push_back(std::move(elements));
  }
  for (const GroupKind kind : kGroupKinds) {
    auto particles = make_particles(loaded, *scene, bodies, kind, next);
    if (particles) scene->solids.push_back(std::move(particles));
  }
  // Rigid faces come after all others: they are never the lower face of a pair.
  if (auto rigid = make_elements(loaded, *scene, bodies, kRigidConductors, next)) {
    scene->supports.move_rigid(rigid->points(), motions_of(loaded, *scene));
    scene->solids.push_back(std::move(rigid));
  }
  for (const bool warm : {false, true}) {
    auto rigid = make_rigid(loaded, *scene, bodies, warm, next);
    if (!rigid) continue;
    scene->supports.move_rigid(rigid->points(), motions_of(loaded, *scene));
    scene->solids.push_back(std::move(rigid));
  }
  hold_temperatures(loaded, *scene);
  add_boundaries(loaded, *scene, problems);
  check_constraints(loaded, *scene, problems);
  check_overlaps(loaded, *scene, problems);
  const ContactOptions options = contact_options(deck);
  if (anything_can_touch(deck, options)) {
    std::vector<Surface<Dim>*> surfaces;
    for (auto& solid : scene->solids) surfaces.push_back(&solid->surface());
    scene->contact = std::make_unique<ContactManager<Dim>>(options, deck.geometry, surfaces,
                                                           scene->body_names, deck.depth);
  }
  add_watches(loaded, *scene, problems);
  check_measures(loaded, *scene, problems);
  if (!problems.empty()) {
    sort_problems(problems);
    throw DeckError(problems);
  }
  return scene;
}

template std::unique_ptr<Scene<2>> build_scene<2>(const LoadedDeck&);
template std::unique_ptr<Scene<3>> build_scene<3>(const LoadedDeck&);

}  // namespace brunt
