#include "contact/entities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "contact/law.hpp"
#include "contact/own_springs.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// Nodes of one surface, numbered when first asked for.
template <int Dim>
class Numbering {
 public:
  Numbering(const std::vector<Surface<Dim>*>& surfaces, ContactNodes<Dim>& nodes)
      : surfaces_(surfaces), nodes_(nodes), known_(surfaces.size()) {
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      known_[s].assign(static_cast<std::size_t>(surfaces[s]->points->size()), -1);
    }
  }
  LocalIndex operator()(LocalIndex surface, LocalIndex point) {
    const auto s = static_cast<std::size_t>(surface);
    auto& number = known_[s][static_cast<std::size_t>(point)];
    if (number < 0) number = nodes_.add(surface, point, *surfaces_[s]->points);
    return number;
  }

 private:
  const std::vector<Surface<Dim>*>& surfaces_;
  ContactNodes<Dim>& nodes_;
  std::vector<std::vector<LocalIndex>> known_;
};

template <int Dim>
ContactFace<Dim> face_from(const Facet<Dim>& facet, LocalIndex surface) {
  ContactFace<Dim> face;
  face.node = facet.node;
  face.n_nodes = facet.n_nodes();
  face.surface = surface;
  face.id = facet.id;
  face.body = facet.body, face.piece = facet.piece;
  face.owned = facet.owned;
  face.stiffness = facet.stiffness;
  face.areal_mass = facet.areal_mass;
  face.depth = facet.depth;
  face.capacity = facet.capacity, face.effusivity = facet.effusivity;
  face.compliance = facet.compliance;
  return face;
}

template <int Dim>
Real area_at_start(const ContactFace<Dim>& face, const Points<Dim>& points) {
  FacePlane<Dim> plane;
  plane.n_corners = face.n_nodes;
  for (auto& corner : plane.corner) corner.setZero();
  for (int c = 0; c < face.n_nodes; ++c) {
    const auto k = static_cast<std::size_t>(c);
    plane.corner[k] = points.x_start[static_cast<std::size_t>(face.node[k])];
  }
  refresh(plane);
  return plane.area;
}

template <int Dim>
SearchBox<Dim> grown(const FacePlane<Dim>& plane, Real depth, const SearchBox<Dim>& box) {
  SearchBox<Dim> reach;
  for (int c = 0; c < Dim; ++c) {
    const auto k = static_cast<std::size_t>(c);
    const Real by =
        kReachPerDepth * depth * std::fabs(plane.normal[c]) + kReachPerWarp * plane.warp;
    reach.lo[k] = box.lo[k] - by;
    reach.hi[k] = box.hi[k] + by;
  }
  return reach;
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
                 Entities<Dim>& entities) {
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
    face.zeta = strongest.damping;
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
}  // namespace

template <int Dim>
LocalIndex ContactNodes<Dim>::add(LocalIndex on_surface, LocalIndex at_point,
                                  const Points<Dim>& points) {
  const auto p = static_cast<std::size_t>(at_point);
  const LocalIndex place =
      add_remote(on_surface, points.id[p], points.mass[p], points.x[p], points.v[p]);
  point.back() = at_point;
  owned.back() = at_point < points.n_owned;
  return place;
}

template <int Dim>
LocalIndex ContactNodes<Dim>::add_remote(LocalIndex on_surface, GlobalId of, Real m,
                                         const Vec<Dim>& at, const Vec<Dim>& velocity) {
  surface.push_back(on_surface);
  point.push_back(-1);
  owned.push_back(0);
  id.push_back(of);
  mass.push_back(m);
  x.push_back(at);
  v.push_back(velocity);
  for (auto* field : {&spring, &damping, &spring_last, &damping_last}) {
    field->push_back(Vec<Dim>::Zero());
  }
  spring_energy.push_back(0);
  damping_energy.push_back(0);
  if (warm) {
    for (auto* field : {&temperature, &capacity, &heat_rate, &ended_heat, &friction_given})
      field->push_back(0);
  }
  if (rubs) {
    friction.push_back(Vec<Dim>::Zero());
    for (auto* field : {&friction_heat, &friction_stored, &friction_damped, &pair_energy})
      field->push_back(0);
  }
  return static_cast<LocalIndex>(size()) - 1;
}

template <int Dim>
void ContactNodes<Dim>::read_motion(const std::vector<Surface<Dim>*>& surfaces) {
#pragma omp parallel for schedule(static) if (size() > kWorthThreads)
  for (std::size_t i = 0; i < size(); ++i) {
    if (point[i] < 0) continue;
    const auto& points = *surfaces[static_cast<std::size_t>(surface[i])]->points;
    x[i] = points.x[static_cast<std::size_t>(point[i])];
    v[i] = points.v[static_cast<std::size_t>(point[i])];
    if (!warm || !points.conducts) continue;
    capacity[i] = points.capacity[static_cast<std::size_t>(point[i])];
  }
}

template <int Dim>
void ContactNodes<Dim>::foresee_temperatures(const std::vector<Surface<Dim>*>& surfaces, Real dt) {
  for (std::size_t i = 0; i < size(); ++i) {
    if (!owned[i]) continue;
    const auto& points = *surfaces[static_cast<std::size_t>(surface[i])]->points;
    if (!points.conducts) continue;
    const auto p = static_cast<std::size_t>(point[i]);
    temperature[i] = points.temperature[p] + dt * points.heat_rate[p] / points.capacity[p];
  }
}

template <int Dim>
void ContactNodes<Dim>::inherit(const ContactNodes& old) {
  const auto name_of = [](const ContactNodes& nodes, std::size_t i) {
    return std::pair(nodes.surface[i], nodes.id[i]);
  };
  std::vector<std::size_t> order(old.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return name_of(old, a) < name_of(old, b); });
  for (std::size_t i = 0; i < size(); ++i) {
    const auto name = name_of(*this, i);
    const auto it =
        std::lower_bound(order.begin(), order.end(), name,
                         [&](std::size_t k, const auto& of) { return name_of(old, k) < of; });
    if (it == order.end() || name_of(old, *it) != name) continue;
    v[i] = old.v[*it];
    spring[i] = old.spring[*it], damping[i] = old.damping[*it];
    spring_last[i] = old.spring_last[*it], damping_last[i] = old.damping_last[*it];
    spring_energy[i] = old.spring_energy[*it], damping_energy[i] = old.damping_energy[*it];
    if (warm) friction_given[i] = old.friction_given[*it];
    if (!rubs) continue;
    friction[i] = old.friction[*it], friction_heat[i] = old.friction_heat[*it];
    friction_stored[i] = old.friction_stored[*it], pair_energy[i] = old.pair_energy[*it];
    friction_damped[i] = old.friction_damped[*it];
  }
}

template <int Dim>
Entities<Dim>::Entities(const std::vector<Surface<Dim>*>& surfaces, const PairTable& pairs,
                        const Section& section, const ContactRanks& ranks) {
  nodes.rubs = pairs.rubs();
  for (const auto* surface : surfaces) nodes.warm = nodes.warm || surface->points->conducts;
  std::vector<Real> sizes;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const auto& surface = *surfaces[s];
    for (const auto& facet : surface.facets) {
      if (pairs.strongest(facet.body).ignore) continue;
      auto& face = faces.emplace_back(face_from(facet, static_cast<LocalIndex>(s)));
      face.area_start = area_at_start(face, *surface.points);
      face.held = surface.held;
      deepest = std::max(deepest, face.depth);
      sizes.push_back(Dim == 2 ? face.area_start : std::sqrt(face.area_start));
    }
    for (const auto& shown : surface.particles) {
      if (shown.point >= surface.points->n_owned) continue;
      const auto p = static_cast<std::size_t>(shown.point);
      const Label body = surface.points->body[p];
      if (pairs.strongest(body).ignore) continue;
      particles.push_back({shown.point, static_cast<LocalIndex>(s), surface.points->id[p], body,
                           surface.points->piece[p], shown.radius, shown.modulus,
                           shown.conductivity, shown.effusivity, surface.held});
      sizes.push_back(2 * shown.radius);
    }
  }
  sort_by_id(faces);
  sort_by_id(particles);
  Numbering<Dim> number(surfaces, nodes);
  for (auto& face : faces) {
    for (int c = 0; c < face.n_nodes; ++c) {
      auto& node = face.node[static_cast<std::size_t>(c)];
      node = number(face.surface, node);
    }
  }
  for (auto& particle : particles) particle.node = number(particle.surface, particle.node);
  if (!sizes.empty()) {
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    size = *middle;
  }
  deepest = ranks.all->max(deepest);
  size = ranks.all->max(size);
  const auto diameters = largest_diameters(*this, ranks);
  any_particles = !diameters.empty();
  set_options(pairs, diameters, *this);
  constant_vote = vote_of_particles<Dim>(pairs, section, *this);
  constant_vote.take(vote_of_rigid<Dim>(section, *this));
  add_faces({});
}

template <int Dim>
void Entities<Dim>::add_faces(const std::vector<ContactFace<Dim>>& imported) {
  faces.insert(faces.end(), imported.begin(), imported.end());
  if (!imported.empty()) sort_by_id(faces);
  planes.resize(faces.size());
  face_velocity.resize(faces.size());
  boxes.resize(faces.size());
  reaches.resize(faces.size());
  if (nodes.rubs) tractions.assign(faces.size(), {});
}

namespace {
template <class Table>
std::size_t place_of(const Table& table, GlobalId id) {
  const auto at =
      std::lower_bound(table.begin(), table.end(), id,
                       [](const auto& one, GlobalId wanted) { return one.id < wanted; });
  return static_cast<std::size_t>(at - table.begin());
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
void Entities<Dim>::inherit_tractions(const Entities& old) {
  if (!nodes.rubs) return;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const std::size_t before = old.face_with(faces[f].id);
    if (before < old.faces.size() && old.faces[before].id == faces[f].id) {
      tractions[f] = old.tractions[before];
    }
  }
}

template <int Dim>
void Entities<Dim>::refresh_planes() {
#pragma omp parallel for schedule(static) if (faces.size() > kWorthThreads)
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const auto& face = faces[f];
    auto& plane = planes[f];
    plane.n_corners = face.n_nodes;
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (int c = 0; c < FacePlane<Dim>::kCorners; ++c) {
      const auto k = static_cast<std::size_t>(c);
      const bool there = c < face.n_nodes;
      plane.corner[k] = Vec<Dim>::Zero();
      if (!there) continue;
      const auto node = static_cast<std::size_t>(face.node[k]);
      plane.corner[k] = nodes.x[node];
      sum += nodes.v[node];
    }
    face_velocity[f] = sum / face.n_nodes;
    refresh(plane);
    boxes[f] = box_of(plane, 0.0);
    reaches[f] = grown(plane, face.rigid() ? deepest : face.depth, boxes[f]);
  }
}

template <int Dim>
StepVote Entities<Dim>::stiffness_vote() const {
  StepVote vote = constant_vote;
#pragma omp parallel if (faces.size() > kWorthThreads)
  {
    StepVote part;
#pragma omp for schedule(static) nowait
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto& face = faces[f];
      if (face.everywhere() || face.held || !(face.area_start > 0)) continue;
      const Real area = std::max(planes[f].area, face.footprint);
      const Real elements = std::sqrt(2 * face.areal_mass / face.stiffness);
      const Real ratio = surface_step_ratio(face.phi * area / face.area_start, face.zeta);
      part.take({elements * ratio, "contact stiffness", face.body, face.id});
    }
#pragma omp critical(brunt_contact_vote)
    vote.take(part);
  }
  return vote;
}

template struct ContactNodes<2>;
template struct ContactNodes<3>;
template struct Entities<2>;
template struct Entities<3>;

}  // namespace brunt
