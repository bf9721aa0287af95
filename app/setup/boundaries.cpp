#include "app/setup/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

#include "app/setup/materials.hpp"
#include "app/setup/rigid.hpp"

namespace brunt {

namespace {
template <int Dim>
struct Choose {
  const Points<Dim>& points;
  const Surface<Dim>& surface;
  Vec<Dim> origin;
  Label body;
  Real tolerance;  // [m]
  const std::vector<PointSet>& sets;

  Vec<Dim> place(LocalIndex i) const { return points.x_start[i] + origin; }
  template <class Test>
  std::vector<LocalIndex> where(Test test) const {
    std::vector<LocalIndex> chosen;
    for (LocalIndex i = 0; i < points.n_owned; ++i) {
      if (points.body[i] == body && test(i)) chosen.push_back(i);
    }
    return chosen;
  }

  template <class Part>
  std::vector<LocalIndex> inside(const Part& part) const {
    return where([&](LocalIndex i) {
      const Vec<Dim> x = place(i);
      return part.holds(std::span<const Real>(x.data(), Dim), tolerance);
    });
  }

  std::vector<LocalIndex> operator()(const deck::WhereAll&) const {
    return where([](LocalIndex) { return true; });
  }
  std::vector<LocalIndex> operator()(const deck::WhereSurface&) const {
    std::set<LocalIndex> outer;
    for (const auto& facet : surface.facets) {
      for (int k = 0; k < facet.n_nodes(); ++k) outer.insert(facet.node[k]);
    }
    return where([&](LocalIndex i) { return outer.count(i) > 0; });
  }
  std::vector<LocalIndex> operator()(const deck::WherePlane& plane) const {
    const int c = static_cast<int>(plane.axis);
    return where([&](LocalIndex i) { return std::fabs(place(i)[c] - plane.at) <= tolerance; });
  }
  std::vector<LocalIndex> operator()(const deck::WhereBox& box) const { return inside(box); }
  std::vector<LocalIndex> operator()(const deck::WhereCylinder& cylinder) const {
    return inside(cylinder);
  }
  std::vector<LocalIndex> operator()(const deck::WhereSide& side) const {
    const int c = static_cast<int>(side.side) / 2;
    const Real sign = static_cast<int>(side.side) % 2 ? 1 : -1;
    Real extreme = -kInfinity;
    for (const LocalIndex i : (*this)(deck::WhereAll{})) {
      extreme = std::max(extreme, sign * place(i)[c]);
    }
    return where([&](LocalIndex i) { return sign * place(i)[c] >= extreme - tolerance; });
  }
  std::vector<LocalIndex> operator()(const deck::WhereSet& wanted) const {
    const auto set = std::find_if(sets.begin(), sets.end(), [&](const PointSet& one) {
      return one.body == body && one.name == wanted.name;
    });
    if (set == sets.end()) return {};
    return where([&](LocalIndex i) {
      const GlobalId id = points.id[slot_of(i)];
      return std::binary_search(set->points.begin(), set->points.end(), id);
    });
  }
};

/// "; its sets are ...", where a set was meant.
std::string sets_of(const deck::Where& where, Label body, const std::vector<PointSet>& sets) {
  if (!std::holds_alternative<deck::WhereSet>(where)) return "";
  std::string names;
  for (const PointSet& set : sets) {
    if (set.body == body) names += (names.empty() ? "'" : ", '") + set.name + "'";
  }
  return names.empty() ? ": it has no sets, which only a mesh file gives it"
                       : "; its sets are " + names;
}

/// "; ...", where a surface was meant that particles do not have.
std::string surface_of(const deck::Where& where, const deck::Body& body) {
  const bool meant = std::holds_alternative<deck::WhereSurface>(where);
  if (!meant || body.method != deck::Method::sph) return "";
  return ": bodies of particles have no faces; choose a side, a plane or a box";
}

template <int Dim>
Solid<Dim>* solid_of(Scene<Dim>& scene, Label label) {
  for (auto& solid : scene.solids) {
    const auto& bodies = solid->points().body;
    if (std::find(bodies.begin(), bodies.end(), label) != bodies.end()) return solid.get();
  }
  return nullptr;
}

/// Takes faces in planes of symmetry out: there the body goes on.
template <int Dim>
void leave_out_cuts(const LoadedDeck& loaded, const Scene<Dim>& scene, Label label,
                    const Points<Dim>& points, std::vector<Facet<Dim>>& facets) {
  for (int axis = 0; loaded.deck.symmetry && axis < Dim; ++axis) {
    const auto& at = loaded.deck.symmetry->across(axis);
    if (!at) continue;
    std::erase_if(facets, [&](const Facet<Dim>& facet) {
      bool all = true;
      for (int k = 0; k < facet.n_nodes(); ++k) {
        const Real x = points.x_start[slot_of(facet.node[k])][axis] + scene.origin[axis];
        all = all && std::fabs(x - *at) <= 0.1 * scene.body_size[label];
      }
      return all;
    });
  }
}

/// What acts on these points of a body of the group.
/// names_a_side  the deck names a plane or side, and means the faces there
template <int Dim>
Patch<Dim> patch_of(const std::string& name, const LoadedDeck& loaded, Label label,
                    const std::vector<LocalIndex>& chosen, bool names_a_side, Solid<Dim>& solid,
                    const Scene<Dim>& scene) {
  const auto& [body, given] = loaded.deck.bodies[label];
  const Surface<Dim>& surface = solid.surface();
  Patch<Dim> patch;
  patch.name = name, patch.body = body;
  patch.points = &solid.points();
  patch.chosen = chosen;
  patch.origin = scene.origin;
  patch.depth = scene.geometry == Geometry::axisymmetric ? 0 : scene.depth;
  patch.material = material_of(loaded.deck, scene.materials, given);
  if (solid.n_particles() == 0) {
    auto facets = facets_between(surface, patch.chosen);
    if (!names_a_side) leave_out_cuts(loaded, scene, label, solid.points(), facets);
    patch.take_facets(std::move(facets));
    return patch;
  }
  for (const LocalIndex i : patch.chosen) {
    patch.spacing.push_back(2 * surface.particles[i].radius);
  }
  return patch;
}

/// Shares of a force on a rigid body: of all of its points by ones that add up at its centre of
/// mass, of some by the areas of the faces between them.
template <int Dim>
std::vector<Real> rigid_weights(const Scene<Dim>& scene, const Patch<Dim>& patch) {
  if (!patch.whole) {
    return patch.integral(Real{0}, [](const FacetPoint<Dim>& at) { return at.area.norm(); });
  }
  const auto shares = mass_shares<Dim>(scene.rigid->all(), *patch.points);
  std::vector<Real> weights;
  for (std::size_t k = 0; k < patch.size(); ++k) weights.push_back(shares[patch.point(k)]);
  return weights;
}

/// Whether a rigid body takes all that a boundary does.
bool suits_rigid(const deck::Boundary& boundary, const deck::Body& body) {
  bool suits = true;
  visit_given(boundary, [&](const auto& kind) {
    using Kind = std::remove_cvref_t<decltype(kind)>;
    suits = suits && (heats<Kind>() || (is_force<Kind>() && deck::follows_forces(body)));
  });
  return suits;
}

/// Adds one boundary of the deck, kind by kind.
template <int Dim>
void add_boundary(const Named<deck::Boundary>& named, const LoadedDeck& loaded, Label label,
                  Scene<Dim>& scene, std::vector<DeckProblem>& problems) {
  const auto& [name, boundary] = named;
  const std::string path = "boundaries." + name;
  const deck::Body& body = loaded.deck.bodies[label].value;
  if (body.rigid && !suits_rigid(boundary, body)) {
    const char* free = deck::follows_forces(body) ? "; of boundaries it takes forces and heat" : "";
    problems.push_back(loaded.places.problem(
        path + ".body", "'" + boundary.body + "' is rigid: give it `motion` instead" + free));
    return;
  }
  Solid<Dim>* solid = solid_of(scene, label);
  if (!solid) return;
  const Choose<Dim> choose{
      solid->points(), solid->surface(), scene.origin, label, 0.1 * scene.body_size[label],
      scene.point_sets};
  auto chosen = std::visit(choose, boundary.where);
  if (chosen.empty()) {
    problems.push_back(loaded.places.problem(
        path + ".where", "no point of '" + boundary.body + "' lies there at time 0" +
                             sets_of(boundary.where, label, scene.point_sets) +
                             surface_of(boundary.where, body)));
    return;
  }
  const bool names_a_side = std::holds_alternative<deck::WherePlane>(boundary.where) ||
                            std::holds_alternative<deck::WhereSide>(boundary.where);
  auto patch = patch_of(name, loaded, label, chosen, names_a_side, *solid, scene);
  patch.whole = std::holds_alternative<deck::WhereAll>(boundary.where);
  patch.from = boundary.from, patch.to = boundary.to;
  if (deck::follows_forces(body)) {
    patch.weight = rigid_weights(scene, patch);
    if (boundary.of<AppliedForce>().given() &&
        std::count(patch.weight.begin(), patch.weight.end(), Real{0}) == std::ssize(patch.weight)) {
      problems.push_back(loaded.places.problem(path + ".where", patch.needs_areas()));
      return;
    }
  }
  visit_given(boundary, [&](const auto& kind) {
    const std::string wrong = scene.boundaries.add(kind, patch);
    if (!wrong.empty()) problems.push_back(loaded.places.problem(path, wrong));
  });
}
/// Holds a body of elements on a plane of symmetry; what is wrong with it, or nothing. Particles
/// have images instead (app/setup/mirrors.hpp).
template <int Dim>
std::string add_mirror(const LoadedDeck& loaded, Label label, int axis, Scene<Dim>& scene) {
  const auto& [name, body] = loaded.deck.bodies[label];
  const bool held = !body.rigid && body.method != deck::Method::sph;  // particles have images
  Solid<Dim>* solid = held ? solid_of(scene, label) : nullptr;
  if (!solid) return "";
  const Real at = *loaded.deck.symmetry->across(axis), size = scene.body_size[label];
  const Choose<Dim> choose{solid->points(), solid->surface(), scene.origin,
                           label,           0.1 * size,       scene.point_sets};
  Real least = kInfinity, most = -kInfinity;
  for (const LocalIndex i : choose(deck::WhereAll{})) {
    least = std::min(least, choose.place(i)[axis] - at);
    most = std::max(most, choose.place(i)[axis] - at);
  }
  const Real reach = 0.1 * size;
  if (least > reach || most < -reach) return "";
  if (least < -reach && most > reach) {
    return "'" + name + "' lies on both sides of the plane: take the half of it away";
  }
  deck::Boundary mirror;
  mirror.body = name;
  mirror.where = deck::WherePlane{static_cast<deck::Axis>(axis), at};
  const std::string letter(1, static_cast<char>('x' + axis));
  std::get<PrescribedMotion>(mirror.kinds).fix = {letter};
  std::vector<DeckProblem> problems;
  add_boundary<Dim>({"symmetry-" + letter + "-" + name, mirror}, loaded, label, scene, problems);
  return problems.empty() ? "" : problems.front().message;
}

template <int Dim>
void add_symmetry(const LoadedDeck& loaded, Scene<Dim>& scene, std::vector<DeckProblem>& problems) {
  for (int axis = 0; loaded.deck.symmetry && axis < Dim; ++axis) {
    if (!loaded.deck.symmetry->across(axis)) continue;
    for (Label label = 0; label < loaded.deck.bodies.size(); ++label) {
      const std::string wrong = add_mirror(loaded, label, axis, scene);
      const std::string path = "symmetry." + std::string(1, static_cast<char>('x' + axis));
      if (!wrong.empty()) problems.push_back(loaded.places.problem(path, wrong));
    }
  }
}
}  // namespace

template <int Dim>
void add_boundaries(const LoadedDeck& loaded, Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems) {
  const Deck& deck = loaded.deck;
  for (const auto& boundary : deck.boundaries) {
    const auto label = label_of(deck, boundary.value.body);
    if (!label) continue;  // reported by the deck's own checks
    add_boundary(boundary, loaded, *label, scene, problems);
  }
  add_symmetry(loaded, scene, problems);
  if (deck.has_gravity()) {
    const auto at = [gravity = deck.gravity](Real time) {
      const auto now = deck::gravity_at(gravity, time);
      return Vec<Dim>(Eigen::Map<const Vec<Dim>>(now.data()));
    };
    if (deck::is_over_time(deck.gravity)) {
      scene.loads.gravity(at);
    } else {
      scene.loads.gravity(at(0));
    }
  }
  if (deck.damping) scene.loads.damp(deck.damping->rate, deck.damping->until);
  if (scene.loads.empty()) return;
  for (auto& solid : scene.solids) {
    if (solid->n_elements() + solid->n_particles() > 0) scene.loads.act_on(solid->points());
  }
  if (scene.rigid) scene.loads.act_on(*scene.rigid);
}

template <int Dim>
void hold_temperatures(const LoadedDeck& loaded, Scene<Dim>& scene) {
  for (Label label = 0; label < loaded.deck.bodies.size(); ++label) {
    const auto& [name, body] = loaded.deck.bodies[label];
    if (!body.motion || !body.motion->temperature) continue;
    Solid<Dim>* solid = solid_of(scene, label);
    if (!solid || !solid->points().conducts) continue;
    std::vector<LocalIndex> all;
    for (LocalIndex i = 0; i < solid->points().n_owned; ++i) {
      if (solid->points().body[i] == label) all.push_back(i);
    }
    SurfaceHeat heat;
    heat.temperature = body.motion->temperature;
    scene.boundaries.add(heat, patch_of(name + ".motion", loaded, label, all, true, *solid, scene));
  }
}

template void hold_temperatures<2>(const LoadedDeck&, Scene<2>&);
template void hold_temperatures<3>(const LoadedDeck&, Scene<3>&);
template void add_boundaries<2>(const LoadedDeck&, Scene<2>&, std::vector<DeckProblem>&);
template void add_boundaries<3>(const LoadedDeck&, Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
