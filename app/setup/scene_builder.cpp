#include "app/setup/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/setup/bodies.hpp"
#include "app/setup/bonds.hpp"
#include "app/setup/boundaries.hpp"
#include "app/setup/groups.hpp"
#include "app/setup/initial_stress.hpp"
#include "app/setup/initial_temperature.hpp"
#include "app/setup/materials.hpp"
#include "app/setup/planes.hpp"
#include "app/setup/riders.hpp"
#include "app/setup/rigid.hpp"
#include "app/setup/scene_checks.hpp"
#include "app/setup/sound_part.hpp"
#include "app/setup/watch.hpp"
#include "sph/particles.hpp"

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

/// How the rigid bodies move whose motion is prescribed.
template <int Dim>
std::vector<RigidMotion<Dim>> prescribed_motions(const LoadedDeck& loaded,
                                                 const Scene<Dim>& scene) {
  std::vector<RigidMotion<Dim>> motions;
  for (Label b = 0; b < loaded.deck.bodies.size(); ++b) {
    const auto& body = loaded.deck.bodies[b].value;
    if (deck::follows_forces(body) || !body.rigid || !body.motion) continue;
    motions.push_back(motion_of<Dim>(body, b, scene.origin));
  }
  return motions;
}

/// Bodies that follow their forces, and the groups that have their points.
template <int Dim>
struct Followers {
  std::vector<Points<Dim>*> groups;
  std::vector<FreeBody<Dim>> bodies;

  void add(Points<Dim>& points, std::vector<FreeBody<Dim>> more) {
    if (more.empty()) return;
    groups.push_back(&points);
    bodies.insert(bodies.end(), more.begin(), more.end());
  }
};

/// All that deforms: elements, then particles.
template <int Dim>
void add_deforming(const LoadedDeck& loaded, std::vector<BodyGeometry<Dim>>& bodies,
                   Scene<Dim>& scene, NextIds& next) {
  const auto add = [&](std::unique_ptr<Solid<Dim>> group) {
    if (group) scene.solids.push_back(std::move(group));
  };
  for (const auto kind : kGroupKinds) add(make_elements(loaded, scene, bodies, kind, next));
  for (const auto kind : kGroupKinds) add(make_particles(loaded, scene, bodies, kind, next));
}

/// Rigid bodies that conduct: first those that follow their forces, whose faces press all others.
template <int Dim>
void add_rigid_conductors(const LoadedDeck& loaded, std::vector<BodyGeometry<Dim>>& bodies,
                          Scene<Dim>& scene, NextIds& next, Followers<Dim>& followers,
                          std::vector<DeckProblem>& problems) {
  if (auto free = make_elements(loaded, scene, bodies, kFreeConductors, next)) {
    followers.add(free->points(), free_bodies_of(loaded, scene, free->surface(), problems));
    scene.solids.push_back(std::move(free));
  }
  if (auto prescribed = make_elements(loaded, scene, bodies, kRigidConductors, next)) {
    scene.rigid_motions.add(prescribed->points(), prescribed_motions(loaded, scene));
    find_rigid_centers(loaded.deck, prescribed->surface(), scene);
    scene.solids.push_back(std::move(prescribed));
  }
}

/// Rigid surfaces: of bodies that are held, have a prescribed motion, or follow their forces.
template <int Dim>
void add_rigid(const LoadedDeck& loaded, Scene<Dim>& scene,
               std::unique_ptr<RigidSurfaces<Dim>> surfaces, Followers<Dim>& followers,
               std::vector<DeckProblem>& problems) {
  std::set<Label> free;
  for (Label b = 0; b < loaded.deck.bodies.size(); ++b) {
    if (deck::follows_forces(loaded.deck.bodies[b].value)) free.insert(b);
  }
  const auto made = free_bodies_of(loaded, scene, surfaces->surface(), problems);
  if (!made.empty()) surfaces->set_shares(mass_shares<Dim>(made, surfaces->points()));
  followers.add(surfaces->points(), made);
  scene.rigid_motions.add(surfaces->points(), prescribed_motions(loaded, scene), std::move(free));
  find_rigid_centers(loaded.deck, surfaces->surface(), scene);
  scene.solids.push_back(std::move(surfaces));
}

/// All that has points. Faces that are held or have a prescribed motion come after those that are
/// partitioned and do not, and those that stand on every rank last: whatever a lower face asks of
/// others can be sent beforehand.
template <int Dim>
void add_groups(const LoadedDeck& loaded, std::vector<BodyGeometry<Dim>>& bodies, Scene<Dim>& scene,
                NextIds& next, std::vector<DeckProblem>& problems) {
  add_deforming(loaded, bodies, scene, next);
  Followers<Dim> followers;
  add_rigid_conductors(loaded, bodies, scene, next, followers, problems);
  for (const bool heated : {false, true}) {
    auto rigid = make_rigid(loaded, scene, bodies, heated, next);
    if (rigid) add_rigid(loaded, scene, std::move(rigid), followers, problems);
  }
  if (followers.bodies.empty()) return;
  scene.rigid = std::make_unique<FreeBodies<Dim>>(followers.groups, std::move(followers.bodies));
}

/// True where some pair of bodies, or pieces of a body, may touch. Bodies that never move do so
/// only where heat passes.
bool anything_can_touch(const Deck& deck, const ContactOptions& options) {
  const bool all_held = std::all_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
    const bool still = !body.value.motion && !deck::follows_forces(body.value);
    return body.value.rigid ? still : is_held(deck, body.name);
  });
  const auto passes = [](const auto& pair) { return pair.second.passes_heat(); };
  const bool heat = options.fallback.passes_heat() ||
                    std::any_of(options.pairs.begin(), options.pairs.end(), passes);
  if (all_held && !heat) return false;
  if (!options.fallback.ignore) return !deck.bodies.empty();
  return std::any_of(options.pairs.begin(), options.pairs.end(),
                     [](const auto& pair) { return !pair.second.ignore; });
}

/// Contact between all that can touch; none where nothing can.
template <int Dim>
void add_contact(const Deck& deck, Scene<Dim>& scene) {
  const ContactOptions options = contact_options(deck);
  if (!anything_can_touch(deck, options)) return;
  find_half_thicknesses(scene);
  std::vector<Surface<Dim>*> surfaces;
  for (auto& solid : scene.solids) surfaces.push_back(&solid->surface());
  scene.contact = std::make_unique<ContactManager<Dim>>(options, deck.geometry, surfaces,
                                                        scene.body_names, deck.depth);
  if (scene.contact->n_pairs() <= kMostReportedPairs) return;
  scene.notes.push_back(std::to_string(scene.contact->n_pairs()) +
                        " pairs of bodies may touch: history.csv has columns of those that "
                        "`contact: {pairs: ...}` names");
}

/// What only the files of bodies know: sizes of their elements, and what was found in them.
template <int Dim>
void take_from_files(const Deck& deck, const std::vector<BodyGeometry<Dim>>& bodies,
                     Scene<Dim>& scene) {
  for (const auto& body : bodies) {
    const std::string& name = deck.bodies[body.label].name;
    if (body.shortest_edge > 0) scene.body_size[body.label] = body.shortest_edge;
    for (const auto& note : body.notes) scene.notes.push_back(name + ": " + note);
    if (body.left_out == 0) continue;
    scene.notes.push_back(name + ": " + std::to_string(body.left_out) +
                          " triangles of its file have no area and were left out");
  }
}
/// Names of pieces, by label: bodies have theirs one after another.
template <int Dim>
std::vector<NamedPiece> name_pieces(const Deck& deck,
                                    const std::vector<BodyGeometry<Dim>>& bodies) {
  std::vector<NamedPiece> pieces;
  for (const auto& body : bodies) {
    const std::string& whole = deck.bodies[body.label].name;
    for (const auto& name : body.piece_names) {
      pieces.push_back({body.label, name.empty() ? "" : whole + "." + name});
    }
  }
  return pieces;
}

/// What a scene keeps of its bodies, by label.
template <int Dim>
void list_bodies(const Deck& deck, Scene<Dim>& scene) {
  for (const auto& body : deck.bodies) {
    const auto& erosion = body.value.element.erosion;
    scene.body_names.push_back(body.name);
    scene.body_size.push_back(deck::smallest_size(body.value));
    const bool total = body.value.sph.formulation == SphFormulation::total;
    scene.mirrors.emplace_back();
    scene.erodes.push_back(erosion.has_value() || total);
    scene.converts.push_back(erosion && erosion->to == ErodeTo::sph);
  }
}

/// In which planes particles of bodies are reflected, for probes near them.
template <int Dim>
void list_mirrors(const Deck& deck, Scene<Dim>& scene) {
  for (const auto& solid : scene.solids) {
    const auto* particles = dynamic_cast<const SphParticles<Dim>*>(solid.get());
    if (particles == nullptr) continue;
    for (Label body = 0; body < deck.bodies.size(); ++body) {
      const MirrorAxes axes = particles->mirrored(body);
      for (int c = 0; c < Dim; ++c) {
        if (is_across(axes, c)) scene.mirrors[body][slot_of(c)] = deck.symmetry->across(c);
      }
    }
  }
}

}  // namespace

template <int Dim>
std::unique_ptr<Scene<Dim>> build_scene(const LoadedDeck& loaded) {
  const Deck& deck = loaded.deck;
  std::vector<DeckProblem> problems;
  auto bodies = make_bodies<Dim>(loaded, problems);
  if (!problems.empty()) {
    add_build_problems(loaded, problems);
    throw DeckError(problems);
  }

  check_bonds(loaded, problems);
  check_anything_is_computed(loaded, problems);
  if (!problems.empty()) throw DeckError(problems);
  auto scene = std::make_unique<Scene<Dim>>(rounded_center(bodies, deck.geometry), deck.geometry,
                                            deck.depth);
  list_bodies(deck, *scene);
  scene->pieces = name_pieces(deck, bodies);
  scene->sum_of_body = first_bonded(deck);
  scene->materials = make_materials(deck);
  take_from_files(deck, bodies, *scene);

  scene->initial_stress = make_initial_stress(loaded, *scene, problems);
  if (!problems.empty()) throw DeckError(problems);
  scene->initial_temperature = make_initial_temperature(loaded, *scene);

  NextIds next;
  try {
    add_groups(loaded, bodies, *scene, next, problems);
  } catch (const InitialStressError& error) {
    throw DeckError({problem_of(loaded, error)});
  } catch (const InitialTemperatureError& error) {
    throw DeckError({problem_of(loaded, error)});
  }
  scene->point_sets = std::move(next.sets);
  list_mirrors(deck, *scene);
  hold_temperatures(loaded, *scene);
  add_boundaries(loaded, *scene, problems);
  check_planes(loaded, *scene, problems);
  check_constraints(loaded, *scene, problems);
  check_overlaps(loaded, *scene, problems);
  check_added_mass(loaded, *scene, problems);
  add_contact(deck, *scene);
  add_watches(loaded, *scene, problems);
  check_measures(loaded, *scene, problems);
  if (!problems.empty()) {
    sort_problems(problems);
    throw DeckError(problems);
  }
  add_riders(loaded, *scene, next);
  scene->heat_windows = HeatWindows(deck.time.heat_every);
  for (auto& solid : scene->solids) {
    auto& points = solid->points();
    points.conduction_steps = scene->heat_windows.steps();
    if (scene->heat_windows.may_last() && points.conducts) points.keep_conduction();
  }
  return scene;
}

template std::unique_ptr<Scene<2>> build_scene<2>(const LoadedDeck&);
template std::unique_ptr<Scene<3>> build_scene<3>(const LoadedDeck&);

}  // namespace brunt
