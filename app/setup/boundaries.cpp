#include "app/setup/boundaries.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "app/setup/heat.hpp"

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

  Vec<Dim> place(LocalIndex i) const {
    return points.x_start[static_cast<std::size_t>(i)] + origin;
  }
  template <class Test>
  std::vector<LocalIndex> where(Test test) const {
    std::vector<LocalIndex> chosen;
    for (LocalIndex i = 0; i < points.n_owned; ++i) {
      if (points.body[static_cast<std::size_t>(i)] == body && test(i)) chosen.push_back(i);
    }
    return chosen;
  }

  std::vector<LocalIndex> operator()(const deck::WhereAll&) const {
    return where([](LocalIndex) { return true; });
  }
  std::vector<LocalIndex> operator()(const deck::WhereSurface&) const {
    std::set<LocalIndex> outer;
    for (const auto& facet : surface.facets) {
      for (int k = 0; k < facet.n_nodes(); ++k)
        outer.insert(facet.node[static_cast<std::size_t>(k)]);
    }
    return where([&](LocalIndex i) { return outer.count(i) > 0; });
  }
  std::vector<LocalIndex> operator()(const deck::WherePlane& plane) const {
    const int c = static_cast<int>(plane.axis);
    return where([&](LocalIndex i) { return std::fabs(place(i)[c] - plane.at) <= tolerance; });
  }
  std::vector<LocalIndex> operator()(const deck::WhereBox& box) const {
    return where([&](LocalIndex i) {
      bool inside = true;
      for (int c = 0; c < Dim; ++c) {
        const auto k = static_cast<std::size_t>(c);
        inside = inside && place(i)[c] >= box.min[k] - tolerance &&
                 place(i)[c] <= box.max[k] + tolerance;
      }
      return inside;
    });
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
      const GlobalId id = points.id[static_cast<std::size_t>(i)];
      return std::binary_search(set->points.begin(), set->points.end(), id);
    });
  }
};

PrescribedVelocity function_of(const Varying& varying) {
  if (varying.over == Varying::Over::expression) {
    return [evaluate = varying.evaluate](Real t, const Vec3& x) {
      return evaluate({t, x[0], x[1], x[2]});
    };
  }
  return [varying](Real t, const Vec3&) { return varying.at(t); };
}

template <int Dim>
void add_velocity(const std::string& name, const deck::Boundary& boundary, Points<Dim>& points,
                  const std::vector<LocalIndex>& chosen, Scene<Dim>& scene) {
  Constraint<Dim> constraint;
  constraint.name = name;
  constraint.points = &points;
  constraint.chosen = chosen;
  constraint.from = boundary.from, constraint.to = boundary.to;
  for (const auto& axis : boundary.fix) {
    const int c = axis[0] - 'x';
    if (c < Dim)
      constraint.velocity[static_cast<std::size_t>(c)] = [](Real, const Vec3&) { return 0.0; };
  }
  if (boundary.velocity) {
    for (std::size_t c = 0; c < boundary.velocity->size() && c < Dim; ++c) {
      if ((*boundary.velocity)[c]) constraint.velocity[c] = function_of(*(*boundary.velocity)[c]);
    }
  }
  scene.supports.constrain(std::move(constraint));
}

template <int Dim>
void add_force(const std::string& name, const deck::Boundary& boundary, Points<Dim>& points,
               const std::vector<LocalIndex>& chosen, Scene<Dim>& scene) {
  AppliedForce<Dim> force;
  force.name = name;
  force.points = &points;
  force.chosen = chosen;
  force.from = boundary.from, force.to = boundary.to;
  ExactSum mass;
  for (const LocalIndex i : chosen) mass.add(points.mass[static_cast<std::size_t>(i)]);
  for (const LocalIndex i : chosen) {
    force.share.push_back(points.mass[static_cast<std::size_t>(i)] / mass.value());
  }
  for (std::size_t c = 0; c < boundary.force->size() && c < Dim; ++c) {
    if ((*boundary.force)[c]) force.force[c] = function_of(*(*boundary.force)[c]);
  }
  scene.loads.apply(std::move(force));
}

/// Facets of the surface all of whose points are chosen, by id.
template <int Dim>
std::vector<Facet<Dim>> facets_between(const Surface<Dim>& surface,
                                       const std::vector<LocalIndex>& chosen) {
  std::vector<Facet<Dim>> facets;  // chosen points ascend
  for (const auto& facet : surface.facets) {
    bool all = true;
    for (int k = 0; k < facet.n_nodes(); ++k) {
      const LocalIndex node = facet.node[static_cast<std::size_t>(k)];
      all = all && std::binary_search(chosen.begin(), chosen.end(), node);
    }
    if (all) facets.push_back(facet);
  }
  return facets;
}

std::optional<PrescribedVelocity> value_of(const std::optional<Varying>& varying) {
  if (!varying) return std::nullopt;
  return function_of(*varying);
}

/// The boundary that holds points of this one at another temperature, when both begin to act;
/// null where none does.
template <int Dim>
const HeatBoundary<Dim>* contradiction(const HeatBoundary<Dim>& heat, const Scene<Dim>& scene) {
  for (const auto& other : scene.heat.all()) {
    const Real from = std::max(heat.from, other.from);
    if (!heat.temperature || !other.temperature || other.points != heat.points) continue;
    if (!(from < std::min(heat.to, other.to))) continue;
    for (const LocalIndex i : heat.chosen) {
      if (!std::binary_search(other.chosen.begin(), other.chosen.end(), i)) continue;
      Vec3 place = Vec3::Zero();
      place.template head<Dim>() = heat.points->x_start[static_cast<std::size_t>(i)] + scene.origin;
      if ((*heat.temperature)(from, place) != (*other.temperature)(from, place)) return &other;
    }
  }
  return nullptr;
}

/// Returns what is wrong, "" where nothing is.
template <int Dim>
std::string add_heat(const std::string& name, const deck::Boundary& boundary, Solid<Dim>& solid,
                     const std::vector<LocalIndex>& chosen, Scene<Dim>& scene) {
  if (!solid.points().conducts) {
    return "'" + boundary.body + "' does not conduct heat: give its material `thermal: {cp, k}`" +
           ", and write heat: conduct or auto";
  }
  HeatBoundary<Dim> heat;
  heat.name = name, heat.points = &solid.points(), heat.chosen = chosen;
  heat.from = boundary.from, heat.to = boundary.to;
  heat.temperature = value_of(boundary.temperature);
  heat.flux = value_of(boundary.flux);
  if (boundary.convection) {
    heat.film = value_of(boundary.convection->h), heat.film_T = value_of(boundary.convection->T);
  }
  if (boundary.radiation) {
    heat.emissivity = boundary.radiation->emissivity;
    heat.radiation_T = value_of(boundary.radiation->T);
  }
  if (heat.acts_on_areas()) {
    const Surface<Dim>& surface = solid.surface();
    if (solid.n_particles() > 0) {
      if (std::holds_alternative<deck::WhereAll>(boundary.where)) {
        return "acts on an area, and most of these particles are inside: choose a side or a plane";
      }
      for (const LocalIndex i : chosen) {
        const Real width = 2 * surface.particles[static_cast<std::size_t>(i)].radius;
        heat.fixed_area.push_back(width * (Dim == 3 ? width : scene.depth));
      }
    } else {
      heat.facets = facets_between(surface, chosen);
      if (heat.facets.empty()) return "there is no outer facet all of whose points are chosen";
    }
  }
  if (const auto* other = contradiction(heat, scene)) {
    return "shares points with '" + other->name + "', which holds them at another temperature";
  }
  scene.heat.add(std::move(heat));
  return "";
}

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

template <int Dim>
Solid<Dim>* solid_of(Scene<Dim>& scene, Label label) {
  for (auto& solid : scene.solids) {
    const auto& bodies = solid->points().body;
    if (std::find(bodies.begin(), bodies.end(), label) != bodies.end()) return solid.get();
  }
  return nullptr;
}
}  // namespace

template <int Dim>
void add_boundaries(const LoadedDeck& loaded, Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems) {
  const Deck& deck = loaded.deck;
  for (const auto& [name, boundary] : deck.boundaries) {
    const std::string path = "boundaries." + name;
    const auto found = label_of(deck, boundary.body);
    if (!found) continue;  // reported by the deck's own checks
    const Label label = *found;
    const deck::Body& body = deck.bodies[label].value;
    const bool moves = !boundary.fix.empty() || boundary.velocity || boundary.force;
    if (body.rigid && (moves || !acts_on_heat(boundary))) {
      problems.push_back(loaded.places.problem(
          path + ".body", "'" + boundary.body + "' is rigid: give it `motion` instead"));
      continue;
    }
    Solid<Dim>* solid = solid_of(scene, label);
    if (!solid) continue;
    auto& points = solid->points();
    const Choose<Dim> choose{
        points,          solid->surface(), scene.origin, label, 0.1 * scene.body_size[label],
        scene.point_sets};
    const auto chosen = std::visit(choose, boundary.where);
    if (chosen.empty()) {
      problems.push_back(loaded.places.problem(
          path + ".where", "no point of '" + boundary.body + "' lies there at time 0" +
                               sets_of(boundary.where, label, scene.point_sets)));
      continue;
    }
    if (!boundary.fix.empty() || boundary.velocity) {
      add_velocity(name, boundary, points, chosen, scene);
    }
    if (boundary.force) add_force(name, boundary, points, chosen, scene);
    if (!acts_on_heat(boundary)) continue;
    const std::string wrong = add_heat(name, boundary, *solid, chosen, scene);
    if (!wrong.empty()) problems.push_back(loaded.places.problem(path, wrong));
  }
  if (!deck.gravity.empty()) {
    Vec<Dim> g;
    for (int c = 0; c < Dim; ++c) g[c] = deck.gravity[static_cast<std::size_t>(c)];
    scene.loads.gravity(g);
  }
  if (deck.damping) scene.loads.damp(deck.damping->rate, deck.damping->until);
  if (!scene.loads.empty()) {
    for (auto& solid : scene.solids) {
      if (solid->n_elements() + solid->n_particles() > 0) scene.loads.act_on(solid->points());
    }
    if (scene.rigid) scene.loads.act_on(*scene.rigid);
  }
}

template <int Dim>
void hold_temperatures(const LoadedDeck& loaded, Scene<Dim>& scene) {
  for (Label label = 0; label < loaded.deck.bodies.size(); ++label) {
    const auto& [name, body] = loaded.deck.bodies[label];
    if (!body.motion || !body.motion->temperature) continue;
    Solid<Dim>* solid = solid_of(scene, label);
    if (!solid || !solid->points().conducts) continue;
    HeatBoundary<Dim> heat;
    heat.name = name + ".motion", heat.points = &solid->points();
    heat.temperature = value_of(body.motion->temperature);
    for (LocalIndex i = 0; i < solid->points().n_owned; ++i) {
      if (solid->points().body[static_cast<std::size_t>(i)] == label) heat.chosen.push_back(i);
    }
    scene.heat.add(std::move(heat));
  }
}

template void hold_temperatures<2>(const LoadedDeck&, Scene<2>&);
template void hold_temperatures<3>(const LoadedDeck&, Scene<3>&);
template void add_boundaries<2>(const LoadedDeck&, Scene<2>&, std::vector<DeckProblem>&);
template void add_boundaries<3>(const LoadedDeck&, Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
