#include "contact/exchange/imports.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "core/parallel/boxes.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// What a corner of a face needs to be a node elsewhere.
template <int Dim>
struct Corner {
  GlobalId id;
  Real mass;            // [kg]
  Real x[Dim], v[Dim];  // [m], [m/s]
};

/// A contribution on its way: the node by its name.
template <int Dim>
struct Letter {
  Contribution<Dim> what;
  LocalIndex surface;
  GlobalId point;
};

/// The part of a face that is no array of nodes.
template <int Dim>
struct FaceData {
  int n_nodes;
  LocalIndex surface;
  GlobalId id;
  Label body, piece;
  Real stiffness, areal_mass, depth, area_start, phi, phi_always, zeta, footprint, capacity;
  Real effusivity;
  Real compliance, half_thickness, sharpness, recoil;
  std::int32_t specific_heat;
  bool held, born;
  std::uint8_t borders;
};

template <int Dim>
FaceData<Dim> data_of(const ContactFace<Dim>& f) {
  return {f.n_nodes,    f.surface,       f.id,         f.body,       f.piece,          f.stiffness,
          f.areal_mass, f.depth,         f.area_start, f.phi,        f.phi_always,     f.zeta,
          f.footprint,  f.capacity,      f.effusivity, f.compliance, f.half_thickness, f.sharpness,
          f.recoil,     f.specific_heat, f.held,       f.born,       f.borders};
}

template <int Dim>
ContactFace<Dim> face_of(const FaceData<Dim>& d) {
  ContactFace<Dim> f;
  f.node.fill(-1);
  f.n_nodes = d.n_nodes, f.surface = d.surface, f.id = d.id, f.body = d.body, f.piece = d.piece;
  f.owned = false;
  f.stiffness = d.stiffness, f.areal_mass = d.areal_mass, f.depth = d.depth;
  f.area_start = d.area_start, f.phi = d.phi, f.phi_always = d.phi_always;
  f.zeta = d.zeta, f.footprint = d.footprint;
  f.capacity = d.capacity, f.effusivity = d.effusivity, f.compliance = d.compliance;
  f.half_thickness = d.half_thickness, f.sharpness = d.sharpness, f.recoil = d.recoil;
  f.specific_heat = d.specific_heat, f.held = d.held, f.borders = d.borders;
  f.born = d.born;
  return f;
}
}  // namespace

template <int Dim>
void ContactImports<Dim>::renew(const ImportBoxes<Dim>& offers, Entities<Dim>& entities) {
  if (ranks().alone()) return;
  name_nodes(entities.nodes);
  // One rank offers a face: its owner. Those of rigid surfaces are everywhere already.
  std::vector<SearchBox<Dim>> boxes;
  std::vector<LocalIndex> face;
  for (std::size_t f = 0; f < entities.faces.size(); ++f) {
    if (!entities.faces[f].owned || entities.faces[f].everywhere) continue;
    boxes.push_back(offers.offered[f]);
    face.push_back(static_cast<LocalIndex>(f));
  }
  auto lists = who_wants<Dim>(ranks(), boxes, offers.wanted);
  std::vector<Bytes> to;
  for (auto& list : lists) {
    for (auto& one : list) one = face[slot_of(one)];
    to.push_back(pack_faces(list, entities));
  }
  std::vector<ContactFace<Dim>> imported;
  for (const Bytes& bytes : ranks().exchange(to)) unpack_faces(bytes, entities, imported);
  entities.add_faces(imported);
  if (offers.particles_meet) import_particles(offers, entities);
  entities.refresh_planes();
  plan(entities.nodes);
  find_peers(entities.nodes);
  if (entities.nodes.has_friction) plan_tractions(entities);
  if (entities.nodes.conduct) plan_temperatures(entities.nodes);
}

/// Names the nodes of what is here; others have not shown theirs yet.
template <int Dim>
void ContactImports<Dim>::name_nodes(const ContactNodes<Dim>& nodes) {
  imported_.clear();
  node_of_point_.resize(surfaces_.size());
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    node_of_point_[s].assign(slot_of(surfaces_[s]->points->size()), -1);
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    node_of_point_[slot_of(nodes.surface[i])][slot_of(nodes.point[i])] = static_cast<LocalIndex>(i);
  }
}

/// -1: there is none.
template <int Dim>
LocalIndex ContactImports<Dim>::find_node(LocalIndex surface, GlobalId id) const {
  const auto& here = node_of_point_[slot_of(surface)];
  const auto point = slot_of(surfaces_[slot_of(surface)]->points->find(id));
  if (point < here.size() && here[point] >= 0) return here[point];
  const auto at = imported_.find({surface, id});
  return at == imported_.end() ? -1 : at->second;
}

template <int Dim>
LocalIndex ContactImports<Dim>::node_of_letter(LocalIndex surface, GlobalId id) const {
  const LocalIndex node = find_node(surface, id);
  if (node < 0) throw std::logic_error("contact forces for a point of another rank");
  return node;
}

template <int Dim>
Bytes ContactImports<Dim>::pack_faces(const std::vector<LocalIndex>& chosen,
                                      const Entities<Dim>& entities) const {
  Packer packer;
  for (const LocalIndex f : chosen) {
    const auto& face = entities.faces[slot_of(f)];
    packer << data_of(face);
    for (int c = 0; c < face.n_nodes; ++c) {
      const auto i = slot_of(face.node[slot_of(c)]);
      Corner<Dim> corner{entities.nodes.id[i], entities.nodes.mass[i], {}, {}};
      for (int d = 0; d < Dim; ++d) {
        corner.x[d] = entities.nodes.x[i][d];
        corner.v[d] = entities.nodes.v[i][d];
      }
      packer << corner;
    }
  }
  return packer.take();
}

template <int Dim>
void ContactImports<Dim>::unpack_faces(const Bytes& bytes, Entities<Dim>& entities,
                                       std::vector<ContactFace<Dim>>& faces) {
  Unpacker from(bytes);
  while (!from.done()) {
    FaceData<Dim> data;
    from >> data;
    auto face = face_of(data);
    const bool here = entities.has_face(face.id);  // its element touches a point of this rank
    for (int c = 0; c < face.n_nodes; ++c) {
      Corner<Dim> corner;
      from >> corner;
      if (here) continue;
      const Vec<Dim> x(corner.x), v(corner.v);
      face.node[slot_of(c)] = node_of(face.surface, corner.id, corner.mass, x, v, entities);
    }
    if (!here) faces.push_back(face);
  }
}

template <int Dim>
LocalIndex ContactImports<Dim>::node_of(LocalIndex surface, GlobalId id, Real mass,
                                        const Vec<Dim>& x, const Vec<Dim>& v,
                                        Entities<Dim>& entities) {
  const LocalIndex known = find_node(surface, id);
  if (known >= 0) return known;
  const auto& points = *surfaces_[slot_of(surface)]->points;
  const LocalIndex here = points.find(id);
  const LocalIndex node = here >= 0 ? entities.nodes.add(surface, here, points)
                                    : entities.nodes.add_remote(surface, id, mass, x, v);
  // Of a loaded state that of the last evaluation, which a copy of the point does not have.
  entities.nodes.v[slot_of(node)] = v;
  imported_[{surface, id}] = node;
  return node;
}

/// Who sends the motion of which of its points to which nodes here.
template <int Dim>
void ContactImports<Dim>::plan(const ContactNodes<Dim>& nodes) {
  plans_.clear();
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    std::vector<GlobalId> ids;
    std::vector<LocalIndex> places;
    std::vector<int> owners;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes.point[i] >= 0 || nodes.surface[i] != static_cast<LocalIndex>(s)) continue;
      ids.push_back(nodes.id[i]);
      places.push_back(static_cast<LocalIndex>(i));
      owners.push_back(ranks_.owner_of(nodes.id[i]));
    }
    plans_.push_back(plan_ghosts(ranks(), ids, places, owners, surfaces_[s]->points->owned_ids()));
  }
}

/// Ranks that forces of this one may go to, and ranks that may send some here.
template <int Dim>
void ContactImports<Dim>::find_peers(const ContactNodes<Dim>& nodes) {
  const auto n = slot_of(ranks().size());
  std::vector<char> is_peer(n, 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes.owned[i]) is_peer[slot_of(ranks_.owner_of(nodes.id[i]))] = 1;
  }
  std::vector<Bytes> word(n);
  for (std::size_t r = 0; r < n; ++r) {
    if (is_peer[r]) word[r].resize(1);
  }
  const auto heard = ranks().exchange(word);
  const std::vector<int> before = std::exchange(neighbours_, {});
  for (int r = 0; r < ranks().size(); ++r) {
    const auto k = slot_of(r);
    if (r != ranks().rank() && (is_peer[k] || !heard[k].empty())) neighbours_.push_back(r);
  }
  peers_.clear();
  std::set_union(before.begin(), before.end(), neighbours_.begin(), neighbours_.end(),
                 std::back_inserter(peers_));
}

template <int Dim>
void ContactImports<Dim>::refresh_motion(ContactNodes<Dim>& nodes) const {
  for (std::size_t s = 0; s < plans_.size(); ++s) {
    const auto& points = *surfaces_[s]->points;
    const auto& spin = surfaces_[s]->spin;
    const auto& material = surfaces_[s]->particle_material;
    constexpr int kMotion = 2 * Dim;
    const int before_material = kMotion + (nodes.turns ? 3 : 0);
    refresh_ghosts(
        ranks(), plans_[s], before_material + (nodes.needs_material ? 2 : 0),
        [&](std::size_t i, Real* out) {
          for (int c = 0; c < Dim; ++c) out[c] = points.x[i][c], out[Dim + c] = points.v[i][c];
          for (int c = 0; c < 3 && nodes.turns; ++c) {
            out[kMotion + c] = i < spin.size() ? spin[i][c] : 0.0;
          }
          if (!nodes.needs_material) return;
          const SurfaceMaterial shown = i < material.size() ? material[i] : SurfaceMaterial{};
          out[before_material] = shown.temperature, out[before_material + 1] = shown.flow_stress;
        },
        [&](std::size_t i, const Real* in) {
          for (int c = 0; c < Dim; ++c) nodes.x[i][c] = in[c], nodes.v[i][c] = in[Dim + c];
          for (int c = 0; c < 3 && nodes.turns; ++c) nodes.spin[i][c] = in[kMotion + c];
          if (!nodes.needs_material) return;
          nodes.material[i] = {in[before_material], in[before_material + 1]};
        });
  }
}

template <int Dim>
std::vector<Contribution<Dim>> ContactImports<Dim>::send_home(
    const Records<Dim>& records, const ContactNodes<Dim>& nodes) const {
  std::vector<Contribution<Dim>> received;
  if (ranks().alone()) return received;
  std::vector<Packer> to(slot_of(ranks().size()));
  records.visit_whole([&](const WholeRecord<Dim>& whole) {
    const auto& record = whole.record;
    for (int i = 0; i < record.n_nodes; ++i) {
      const auto k = slot_of(i);
      const auto at = slot_of(record.node[k]);
      if (nodes.owned[at]) continue;
      const Vec<Dim> spring = whole.spring_on(k);
      const Vec<Dim> damping = record.weight[k] * record.damping * record.normal;
      Letter<Dim> letter{{key_of(record), 0, {}, {}, {}}, nodes.surface[at], nodes.id[at]};
      for (int c = 0; c < Dim; ++c) {
        letter.what.spring[c] = spring[c];
        letter.what.damping[c] = damping[c];
        if (whole.friction != nullptr) letter.what.friction[c] = whole.friction->force[k][c];
      }
      to[slot_of(ranks_.owner_of(nodes.id[at]))] << letter;
    }
  });
  deliver<Letter<Dim>>(to, [&](Letter<Dim> letter) {
    letter.what.node = node_of_letter(letter.surface, letter.point);
    received.push_back(letter.what);
  });
  std::sort(received.begin(), received.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
  return received;
}

template class ContactImports<2>;
template class ContactImports<3>;

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
