#include "app/setup/groups.hpp"

#include <algorithm>
#include <cmath>

#include "app/setup/bonds.hpp"
#include "app/setup/gather.hpp"
#include "app/setup/heat.hpp"
#include "app/setup/initial_temperature.hpp"
#include "app/setup/materials.hpp"
#include "app/setup/mirrors.hpp"
#include "core/geometry/curve.hpp"
#include "core/open_surface.hpp"
#include "fe/finite_elements.hpp"
#include "sph/particles.hpp"

namespace brunt {

namespace {
/// Ids of the points in the named sets of a body.
template <int Dim>
void add_sets(const BodyGeometry<Dim>& body, const std::vector<LocalIndex>& place_of,
              const Points<Dim>& points, std::vector<PointSet>& sets) {
  for (const NamedPoints& named : body.sets) {
    PointSet& set = sets.emplace_back(PointSet{body.label, named.name, {}});
    for (const int i : named.points) {
      const auto place = slot_of(place_of[slot_of(i)]);
      set.points.push_back(points.id[place]);
    }
    std::sort(set.points.begin(), set.points.end());
  }
}

/// Bodies of one method and kind.
template <int Dim>
std::vector<std::size_t> choose(const LoadedDeck& loaded,
                                const std::vector<BodyGeometry<Dim>>& bodies, deck::Method method,
                                GroupKind kind) {
  std::vector<std::size_t> chosen;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [name, body] = loaded.deck.bodies[bodies[b].label];
    if (body.method != method) continue;
    if (group_kind(loaded.deck, body, name) == kind) chosen.push_back(b);
  }
  return chosen;
}

bool is_adiabatic(const Deck& deck, const Named<deck::Body>& body) {
  return heat_mode(deck, body.value, body.name) == HeatMode::adiabatic;
}

/// A body's element options; elements from a file are of the kind that they are there.
template <int Dim>
ElementOptions element_options(const Deck& deck, const deck::Body& body,
                               const BodyElements& elements) {
  const deck::Time& time = deck.time;
  ElementOptions options = body.element;
  options.integration = integration_of(deck, body);
  if (time.mass_scaling) options.least_step = time.mass_scaling->step / time.safety;
  const auto& types = ElementCatalog<Dim>::types;
  options.type =
      static_cast<int>(std::find(types.begin(), types.end(), elements.type) - types.begin());
  return options;
}

bool same_element(const ElementOptions& a, const ElementOptions& b) {
  const auto coefficient = [](const Hourglass& hourglass) {
    if (const auto* viscous = std::get_if<ViscousHourglass>(&hourglass))
      return viscous->coefficient;
    if (const auto* stiff = std::get_if<StiffnessHourglass>(&hourglass)) return stiff->coefficient;
    if (const auto* bends = std::get_if<AssumedStrainHourglass>(&hourglass)) {
      return bends->coefficient;
    }
    return 0.0;
  };
  return a.type == b.type && a.integration == b.integration && a.erosion == b.erosion &&
         a.hourglass.index() == b.hourglass.index() &&
         coefficient(a.hourglass) == coefficient(b.hourglass) &&
         a.bulk_viscosity.linear == b.bulk_viscosity.linear &&
         a.bulk_viscosity.quadratic == b.bulk_viscosity.quadratic;
}

/// The set that elements of a body belong to, without elements.
template <int Dim>
ElementSet<Dim> empty_set_of(const LoadedDeck& loaded, const Scene<Dim>& scene,
                             const BodyGeometry<Dim>& geometry, GroupKind kind) {
  const auto& body = loaded.deck.bodies[geometry.label].value;
  ElementSet<Dim> set;
  set.material = material_of(loaded.deck, scene.materials, body);
  set.options = element_options<Dim>(loaded.deck, body, geometry.elements);
  set.temperature = start_temperature(loaded, scene, geometry);
  set.temperature_field = scene.initial_temperature[geometry.label].get();
  set.adiabatic = is_adiabatic(loaded.deck, loaded.deck.bodies[geometry.label]);
  set.stress = scene.initial_stress[geometry.label].get();
  set.conducts = kind.conducts, set.held = kind.held, set.rigid = kind.rigid;
  return set;
}

template <int Dim>
bool same_set(const ElementSet<Dim>& a, const ElementSet<Dim>& b) {
  return a.material == b.material && a.temperature == b.temperature && a.adiabatic == b.adiabatic &&
         a.temperature_field == b.temperature_field && a.stress == b.stress &&
         same_element(a.options, b.options);
}

/// Sets in the order in which their elements come, with room for all of them.
template <int Dim>
class SetsOfBodies {
 public:
  SetsOfBodies(const LoadedDeck& loaded, const Scene<Dim>& scene,
               const std::vector<BodyGeometry<Dim>>& bodies, const std::vector<std::size_t>& chosen,
               GroupKind kind)
      : bodies_(bodies), chosen_(chosen), of_body_(bodies.size()), number_(bodies.size(), kNone) {
    for (const std::size_t b : chosen) of_body_[b] = empty_set_of(loaded, scene, bodies[b], kind);
  }
  ElementSet<Dim>& of(std::size_t body) {
    if (number_[body] == kNone) begin(body);
    return sets_[number_[body]];
  }
  std::vector<ElementSet<Dim>> take() { return std::move(sets_); }

 private:
  void begin(std::size_t body) {
    std::size_t n = 0;
    for (const std::size_t b : chosen_) {
      if (!same_set(of_body_[b], of_body_[body])) continue;
      number_[b] = sets_.size();
      n += bodies_[b].elements.size();
    }
    auto& set = sets_.emplace_back(of_body_[body]);
    set.corners.reserve(n), set.id.reserve(n), set.body.reserve(n), set.piece.reserve(n);
  }

  static constexpr auto kNone = static_cast<std::size_t>(-1);
  const std::vector<BodyGeometry<Dim>>& bodies_;
  const std::vector<std::size_t>& chosen_;
  std::vector<ElementSet<Dim>> of_body_, sets_;  // the first without elements
  std::vector<std::size_t> number_;              // of the set of each body
};

/// Elements of chosen bodies along the curve through their centres, by set.
template <int Dim>
std::vector<ElementSet<Dim>> gather_elements(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                             const std::vector<BodyGeometry<Dim>>& bodies,
                                             const std::vector<std::size_t>& chosen, GroupKind kind,
                                             Gathered<Dim>& gathered, NextIds& next) {
  std::size_t n = 0;
  for (const std::size_t b : chosen) n += bodies[b].elements.size();
  std::vector<Origin> elements;
  std::vector<Vec<Dim>> centers;
  elements.reserve(n), centers.reserve(n);
  for (const std::size_t b : chosen) {
    for (std::size_t e = 0; e < bodies[b].elements.size(); ++e) {
      Vec<Dim> center = Vec<Dim>::Zero();
      for (const int node : bodies[b].elements[e]) {
        center += bodies[b].points[node] - scene.origin;
      }
      elements.push_back({static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(e)});
      centers.push_back(center / static_cast<Real>(bodies[b].elements.type->corners));
    }
  }
  SetsOfBodies<Dim> sets(loaded, scene, bodies, chosen, kind);
  const auto order = order_of(curve_keys<Dim>(centers));
  for (std::size_t i = 0; i < order.size(); ++i) {
    // The curve goes through bodies in jumps, which no processor foresees.
    constexpr std::size_t kAhead = 16;
    if (i + kAhead < order.size()) {
      const auto [b, e] = elements[order[i + kAhead]];
      __builtin_prefetch(bodies[b].elements[e].data());
    }
    const auto [b, e] = elements[order[i]];
    const auto& geometry = bodies[b];
    auto& set = sets.of(b);
    auto& corners = set.corners.emplace_back();
    for (const int node : geometry.elements[e]) {
      corners[corners.n++] = gathered.place_of[b][node];
      gathered.points.piece[corners[corners.n - 1]] = geometry.piece[e];
    }
    set.id.push_back(next.element++);
    set.body.push_back(geometry.label);
    set.piece.push_back(geometry.piece[e]);
  }
  return sets.take();
}
}  // namespace

template <int Dim>
std::unique_ptr<Solid<Dim>> make_elements(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                          std::vector<BodyGeometry<Dim>>& bodies, GroupKind kind,
                                          NextIds& next) {
  const auto chosen = choose(loaded, bodies, deck::Method::fe, kind);
  if (chosen.empty()) return nullptr;
  auto gathered = gather(loaded, scene, bodies, chosen, next);
  for (const std::size_t b : chosen) {
    add_sets(bodies[b], gathered.place_of[b], gathered.points, next.sets);
  }
  gathered.from = {};
  auto sets = gather_elements(loaded, scene, bodies, chosen, kind, gathered, next);
  for (const std::size_t b : chosen) bodies[b].forget_mesh();
  gathered.place_of = {};
  return std::make_unique<FiniteElements<Dim>>(std::move(gathered.points), std::move(sets),
                                               scene.geometry, scene.depth);
}

namespace {
/// Spacing [m] of the cubic lattice that a body's particles stand for: volume a particle.
template <int Dim>
Real mean_spacing(const BodyGeometry<Dim>& body) {
  return std::pow(body.volume / static_cast<Real>(body.points.size()), 1.0 / Dim);
}

/// [m] By label, the longest of a lattice along its axes; of bodies of elements nothing is meant.
template <int Dim>
std::vector<Real> lattice_spacings(const LoadedDeck& loaded,
                                   const std::vector<BodyGeometry<Dim>>& bodies) {
  std::vector<Real> spacing(loaded.deck.bodies.size());
  for (const auto& body : bodies) {
    for (const Real one : body.spacing) spacing[body.label] = std::max(spacing[body.label], one);
  }
  return spacing;
}

/// Particles of formulation: total keep the neighbours of time 0: a sheet would be one for ever.
template <int Dim>
void require_thick_total(const LoadedDeck& loaded, const SphParticles<Dim>& particles) {
  const LocalIndex thin = particles.thin_total();
  if (thin < 0) return;
  const auto& name = loaded.deck.bodies[particles.points().body[slot_of(thin)]].name;
  throw DeckError({loaded.places.problem(
      "bodies." + name + ".formulation",
      "total takes two particles through the thickness of '" + name +
          "' at the least: particles of it lie in one layer or row, all or those of a sharp edge; "
          "try a smaller `size`, a blunt edge, or updated")});
}
}  // namespace

template <int Dim>
std::unique_ptr<Solid<Dim>> make_particles(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                           std::vector<BodyGeometry<Dim>>& bodies, GroupKind kind,
                                           NextIds& next) {
  const auto chosen = choose(loaded, bodies, deck::Method::sph, kind);
  if (chosen.empty()) return nullptr;
  auto gathered = gather(loaded, scene, bodies, chosen, next);
  std::vector<Real> spacing(gathered.from.size()), spacing_of(bodies.size());
  std::vector<Real> temperature_of(bodies.size());
  for (const std::size_t b : chosen) {
    spacing_of[b] = mean_spacing(bodies[b]);
    temperature_of[b] = start_temperature(loaded, scene, bodies[b]);
  }
  std::vector<ParticleSet> sets;
  for (std::size_t k = 0; k < gathered.from.size(); ++k) {
    const auto& geometry = bodies[gathered.from[k].body];
    const auto& body = loaded.deck.bodies[geometry.label].value;
    const bool adiabatic = is_adiabatic(loaded.deck, loaded.deck.bodies[geometry.label]);
    const Material* material = material_of(loaded.deck, scene.materials, body);
    const Real temperature = temperature_of[gathered.from[k].body];
    const InitialTemperature* field = scene.initial_temperature[geometry.label].get();
    const InitialStress* stress = scene.initial_stress[geometry.label].get();
    auto set = std::find_if(sets.begin(), sets.end(), [&](const ParticleSet& s) {
      return s.material == material && s.temperature == temperature && s.adiabatic == adiabatic &&
             s.temperature_field == field && s.stress == stress && s.options == body.sph;
    });
    if (set == sets.end()) {
      set = sets.insert(sets.end(), {material,
                                     body.sph,
                                     temperature,
                                     adiabatic,
                                     kind.conducts,
                                     kind.held,
                                     {},
                                     stress,
                                     field});
    }
    set->particle.push_back(static_cast<LocalIndex>(k));
    // Each particle carries its share of the exact mass of the shape.
    const Real volume = geometry.volume * (Dim == 2 ? scene.depth : 1.0);
    gathered.points.mass[k] =
        material->density * volume / static_cast<Real>(geometry.points.size());
    gathered.points.piece[k] = geometry.piece[gathered.from[k].index];
    spacing[k] = spacing_of[gathered.from[k].body];
  }
  for (const std::size_t b : chosen) bodies[b].forget_mesh();
  gathered.from = {}, gathered.place_of = {};
  std::vector<Label> sums = sums_of_pieces(loaded.deck, bodies);
  Mirrors<Dim> mirrors =
      mirrors_of(loaded, scene, gathered.points, lattice_spacings(loaded, bodies), sums);
  auto particles = std::make_unique<SphParticles<Dim>>(std::move(gathered.points), spacing,
                                                       std::move(sets), Dim == 2 ? scene.depth : 1,
                                                       std::move(sums), std::move(mirrors));
  particles->set_search(loaded.deck.contact.search);
  require_thick_total(loaded, *particles);
  return particles;
}

namespace {
/// Temperatures of surfaces that are held at them. They take any heat, and store next to none where
/// another temperature is prescribed for them.
template <int Dim>
void hold_temperatures(const LoadedDeck& loaded, Points<Dim>& points) {
  std::vector<Real> at_start;
  for (const Label label : points.body) {
    at_start.push_back(loaded.deck.bodies[label].value.motion->temperature->at(0));
  }
  points.conduct(at_start);
  constexpr Real kNone = 1e-20;  // [J/K]
  std::fill(points.capacity.begin(), points.capacity.end(), kNone);
}
}  // namespace

template <int Dim>
std::unique_ptr<RigidSurfaces<Dim>> make_rigid(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                               const std::vector<BodyGeometry<Dim>>& bodies,
                                               bool heated, NextIds& next) {
  std::vector<std::size_t> chosen;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const auto& [name, body] = loaded.deck.bodies[bodies[b].label];
    if (!body.rigid || group_kind(loaded.deck, body, name).conducts) continue;
    if (is_heated_surface(loaded.deck, body) == heated) chosen.push_back(b);
  }
  if (chosen.empty()) return nullptr;
  auto gathered = gather(loaded, scene, bodies, chosen, next);
  std::vector<Facet<Dim>> facets;
  for (const std::size_t b : chosen) {
    const Real temperature = start_temperature(loaded, scene, bodies[b]);
    const InitialTemperature* field = scene.initial_temperature[bodies[b].label].get();
    // Facets of a piece side by side.
    for (const std::size_t f : order_of({bodies[b].piece.begin(), bodies[b].piece.end()})) {
      const auto& corners = bodies[b].facets[f];
      Facet<Dim> facet;
      for (std::size_t c = 0; c < corners.size(); ++c) {
        facet.node[c] = corners[c] < 0 ? -1 : gathered.place_of[b][corners[c]];
      }
      facet.id = next.element++ << 3;
      facet.body = bodies[b].label;
      facet.piece = bodies[b].piece[f];
      facet.temperature = temperature;
      if (field != nullptr) {
        facet.temperature = field->at(in_space<Dim>(facet_center(facet, gathered.points.x)));
      }
      for (int c = 0; c < facet.n_nodes(); ++c) {
        const auto node = slot_of(facet.node[c]);
        gathered.points.piece[node] = facet.piece;
      }
      if (heated) facet.capacity = kInfinity;
      facets.push_back(facet);
    }
  }
  mark_open<Dim>(facets);
  mark_borders<Dim>(facets, gathered.points.x);
  mark_sharpness<Dim>(facets, gathered.points.x);
  if (heated) hold_temperatures(loaded, gathered.points);
  return std::make_unique<RigidSurfaces<Dim>>(std::move(gathered.points), std::move(facets));
}

template std::unique_ptr<Solid<2>> make_elements<2>(const LoadedDeck&, const Scene<2>&,
                                                    std::vector<BodyGeometry<2>>&, GroupKind,
                                                    NextIds&);
template std::unique_ptr<Solid<3>> make_elements<3>(const LoadedDeck&, const Scene<3>&,
                                                    std::vector<BodyGeometry<3>>&, GroupKind,
                                                    NextIds&);
template std::unique_ptr<Solid<2>> make_particles<2>(const LoadedDeck&, const Scene<2>&,
                                                     std::vector<BodyGeometry<2>>&, GroupKind,
                                                     NextIds&);
template std::unique_ptr<Solid<3>> make_particles<3>(const LoadedDeck&, const Scene<3>&,
                                                     std::vector<BodyGeometry<3>>&, GroupKind,
                                                     NextIds&);
template std::unique_ptr<RigidSurfaces<2>> make_rigid<2>(const LoadedDeck&, const Scene<2>&,
                                                         const std::vector<BodyGeometry<2>>&, bool,
                                                         NextIds&);
template std::unique_ptr<RigidSurfaces<3>> make_rigid<3>(const LoadedDeck&, const Scene<3>&,
                                                         const std::vector<BodyGeometry<3>>&, bool,
                                                         NextIds&);

}  // namespace brunt
