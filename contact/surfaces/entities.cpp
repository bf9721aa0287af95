#include "contact/surfaces/entities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "contact/surfaces/numbering.hpp"
#include "contact/surfaces/own_springs.hpp"
#include "core/parallel/median.hpp"
#include "core/parallel/packing.hpp"
#include "core/parallel/threads.hpp"

namespace brunt {

namespace {
template <int Dim>
ContactFace<Dim> face_from(const Facet<Dim>& facet, LocalIndex surface) {
  ContactFace<Dim> face;
  face.node = facet.node;
  face.n_nodes = facet.n_nodes();
  face.surface = surface;
  face.id = facet.id;
  face.body = facet.body, face.piece = facet.piece;
  face.owned = facet.owned, face.born = facet.born;
  face.stiffness = facet.stiffness;
  face.areal_mass = facet.areal_mass;
  face.depth = facet.depth;
  face.capacity = facet.capacity, face.effusivity = facet.effusivity;
  face.specific_heat = facet.specific_heat;
  face.compliance = facet.compliance, face.mean_compliance = facet.mean_compliance;
  face.half_thickness = face.deforms() ? facet.depth : facet.half_thickness;
  face.open = facet.open;
  face.borders = facet.borders;
  face.sharpness = facet.sharpness;
  return face;
}

template <int Dim>
Real area_at_start(const ContactFace<Dim>& face, const Points<Dim>& points) {
  FacePlane<Dim> plane;
  plane.n_corners = face.n_nodes;
  for (auto& corner : plane.corner) corner.setZero();
  for (int c = 0; c < face.n_nodes; ++c) {
    const auto k = slot_of(c);
    plane.corner[k] = points.x_start[slot_of(face.node[k])];
  }
  refresh(plane);
  return plane.area;
}

/// Diameter [m] of the largest particle of each body, over all ranks.
template <int Dim>
std::map<Label, Real> largest_diameters(const Entities<Dim>& entities, const ContactRanks& ranks) {
  std::map<Label, Real> diameter;
  const auto take = [&](Label body, Real d) {
    auto& largest = diameter[body];
    largest = std::max(largest, d);
  };
  for (const auto& particle : entities.particles) take(particle.body, 2 * particle.radius);
  if (ranks.alone()) return diameter;
  Packer mine;
  for (const auto& [body, d] : diameter) mine << body << d;
  for (const auto& bytes : ranks.all->all_gather(mine.take())) {
    Unpacker from(bytes);
    while (!from.done()) {
      Label body = 0;
      Real d = 0;
      from >> body >> d;
      take(body, d);
    }
  }
  return diameter;
}

/// What the faces' own step bounds need to know of those that may touch them.
template <int Dim>
void set_options(const PairTable& pairs, const std::map<Label, Real>& diameter,
                 const RigidSprings& rigid, Entities<Dim>& entities) {
  std::map<Label, Real> footprint;
  for (const auto& [a, b] : pairs.pairs()) {
    for (const auto& [face, particle] : {std::pair(a, b), std::pair(b, a)}) {
      const auto it = diameter.find(particle);
      if (it == diameter.end()) continue;
      footprint[face] = std::max(footprint[face], std::pow(it->second, Dim - 1));
    }
  }
  for (auto& face : entities.faces) {
    const PairOptions strongest = pairs.strongest(face.body);
    face.phi = strongest.stiffness;
    face.phi_always = pairs.always(face.body);
    face.zeta = strongest.damping;
    face.recoil = rigid.recoil_beside(face.body);
    const auto it = footprint.find(face.body);
    if (it != footprint.end()) face.footprint = it->second;
  }
}

template <class Entity>
void sort_by_id(std::vector<Entity>& entities) {
  std::sort(entities.begin(), entities.end(), [](const Entity& a, const Entity& b) {
    return a.id != b.id ? a.id < b.id : a.surface < b.surface;
  });
}

/// matter  of the particle, where it stays
template <int Dim>
ContactParticle particle_from(const SurfaceParticle& shown, const Surface<Dim>& surface,
                              LocalIndex number, const ParticleMatter* matter) {
  const auto& points = *surface.points;
  const auto p = slot_of(shown.point);
  ContactParticle particle{shown.point,     number,       points.id[p], points.body[p],
                           points.piece[p], shown.radius, matter};
  if (!points.specific_heat.empty()) particle.specific_heat = points.specific_heat[p];
  particle.held = surface.held, particle.born = shown.born;
  return particle;
}

/// Those of a surface that may touch anything; sizes  [m] theirs, too.
template <int Dim>
void take_particles(const Surface<Dim>& surface, LocalIndex number, const PairTable& pairs,
                    Entities<Dim>& entities, std::vector<Real>& sizes) {
  std::vector<const ParticleMatter*> kept;
  for (const auto& one : surface.matters) kept.push_back(&*entities.matters.insert(one).first);
  for (const auto& shown : surface.particles) {
    if (shown.point >= surface.points->n_owned) continue;
    if (pairs.strongest(surface.points->body[slot_of(shown.point)]).ignore) continue;
    entities.particles.push_back(particle_from(shown, surface, number, kept[shown.matter]));
    sizes.push_back(2 * shown.radius);
  }
}
}  // namespace

template <int Dim>
Entities<Dim>::Entities(const std::vector<Surface<Dim>*>& surfaces, const PairTable& pairs,
                        const Section& section, const ContactRanks& ranks,
                        const RigidSprings& rigid) {
  nodes.has_friction = pairs.has_friction(), nodes.holds = pairs.holds();
  gaps = pairs.gaps();
  nodes.turns = pairs.particles_have_friction();
  nodes.needs_material = pairs.needs_material();
  for (const auto* surface : surfaces) {
    nodes.conduct = nodes.conduct || surface->points->conducts;
    nodes.erodes = nodes.erodes || surface->erodes;
  }
  std::vector<Real> sizes;
  std::size_t most_particles = 0;
  for (const auto* surface : surfaces) most_particles += surface->particles.size();
  particles.reserve(most_particles);
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const auto& surface = *surfaces[s];
    conducts.push_back(surface.points->conducts);
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
      const auto& facet = surface.facets[f];
      if (pairs.strongest(facet.body).ignore) continue;
      auto& face = faces.emplace_back(face_from(facet, static_cast<LocalIndex>(s)));
      face.facet = static_cast<LocalIndex>(f);
      face.area_start = area_at_start(face, *surface.points);
      // Elements that only conduct are held, but not the free rigid body that they are.
      face.held = surface.held && face.compliance == 0, face.everywhere = surface.everywhere;
      any_open = any_open || face.open;
      deepest = std::max(deepest, face.depth);
      if (!face.rigid()) {
        const Real inside = pairs.touches_itself(face.body) ? kDeepestInside : 1.0;
        least_limit = std::min(least_limit, inside * face.depth);
      }
      if (!face.owned) continue;  // another rank counts it
      sizes.push_back(Dim == 2 ? face.area_start : std::sqrt(face.area_start));
    }
    take_particles(surface, static_cast<LocalIndex>(s), pairs, *this, sizes);
  }
  sort_by_id(faces);
  sort_by_id(particles);
  number_nodes(surfaces);
  deepest = ranks.all->max(deepest);
  size = median_of_all(sizes, *ranks.all);
  any_born = std::any_of(particles.begin(), particles.end(), [](auto& one) { return one.born; });
  const auto diameters = largest_diameters(*this, ranks);
  any_particles = !diameters.empty();
  set_options(pairs, diameters, rigid, *this);
  set_limits_of_particles<Dim>(pairs, section, rigid, *this);
  add_faces({});
  for (const auto& face : faces) {
    if (face.deforms() && !face.held) longest_step = std::min(longest_step, face.element_step);
  }
  least_limit = -ranks.all->max(-least_limit);
  longest_step = -ranks.all->max(-longest_step);
}

template <int Dim>
void Entities<Dim>::number_nodes(const std::vector<Surface<Dim>*>& surfaces) {
  Numbering<Dim> number(surfaces, nodes);
  number.reserve_for(*this);
  for (auto& face : faces) number.name_corners(face);
  for (auto& particle : particles) particle.node = number(particle.surface, particle.node);
  number.add_gone();
  own_nodes_ = nodes.size();
}

template <int Dim>
void Entities<Dim>::add_faces(const std::vector<ContactFace<Dim>>& imported) {
  faces.insert(faces.end(), imported.begin(), imported.end());
  if (!imported.empty()) sort_by_id(faces);
  for (auto& face : faces) {
    any_born = any_born || face.born;
    if (face.deforms()) face.element_step = std::sqrt(2 * face.areal_mass / face.stiffness);
    shallowest = std::min(shallowest, face.half_thickness);
  }
  planes.resize(faces.size());
  boxes.resize(faces.size());
  reaches.resize(faces.size());
  if (nodes.has_friction) tractions.assign(faces.size(), {});
  if (nodes.needs_material) materials.assign(faces.size(), {});
  find_near();
}

template <int Dim>
void Entities<Dim>::add_particles(const std::vector<ContactParticle>& imported) {
  particles.insert(particles.end(), imported.begin(), imported.end());
  for (const auto& particle : imported) any_born = any_born || particle.born;
  if (!imported.empty()) sort_by_id(particles);
  find_near();
}

namespace {
template <class Table>
std::size_t place_of(const Table& table, GlobalId id) {
  const auto at =
      std::lower_bound(table.begin(), table.end(), id,
                       [](const auto& one, GlobalId wanted) { return one.id < wanted; });
  return slot_of(at - table.begin());
}
}  // namespace

template <int Dim>
std::size_t Entities<Dim>::face_with(GlobalId id) const {
  return place_of(faces, id);
}

template <int Dim>
std::size_t Entities<Dim>::particle_with(GlobalId id) const {
  return place_of(particles, id);
}

template <int Dim>
CarriedTractions<Dim> Entities<Dim>::carried_tractions() const {
  CarriedTractions<Dim> carried;
  if (!nodes.has_friction) return carried;
  carried.traction = tractions;
  carried.face.reserve(faces.size());
  for (const auto& face : faces) carried.face.push_back(face.id);
  return carried;
}

template <int Dim>
void Entities<Dim>::inherit_tractions(const CarriedTractions<Dim>& carried) {
  if (!nodes.has_friction) return;
  std::size_t before = 0;  // both ascend
  for (std::size_t f = 0; f < faces.size(); ++f) {
    while (before < carried.face.size() && carried.face[before] < faces[f].id) ++before;
    if (before == carried.face.size()) return;
    if (carried.face[before] == faces[f].id) tractions[f] = carried.traction[before];
  }
}

template <int Dim>
void Entities<Dim>::read_materials(const std::vector<Surface<Dim>*>& surfaces) {
  for_each(faces.size(), kWorthThreads, [&](std::size_t f) {
    if (faces[f].facet < 0) return;
    const auto& surface = *surfaces[slot_of(faces[f].surface)];
    const auto at = slot_of(faces[f].facet);
    materials[f] = surface.facet_material.empty()
                       ? SurfaceMaterial{surface.facets[at].temperature, kInfinity}
                       : surface.facet_material[at];
  });
}

template <int Dim>
StepLimit Entities<Dim>::stiffness_limit() const {
  StepLimit step_limit = constant_limit;
  step_limit.take(surface_limit);
  step_limit.take(limit_of_rings(*this));
  return step_limit;
}

template struct Entities<2>;
template struct Entities<3>;

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
