/// What contacts elsewhere need to know of nodes and faces besides motion, and what they send back
/// besides forces: temperatures and heat, tractions.
#include <algorithm>

#include "contact/exchange/imports.hpp"

namespace brunt {

/// Like plan(), but of all nodes that others own, copies of points here too: what heat makes of
/// their temperatures in a step only their owners know.
template <int Dim>
void ContactImports<Dim>::plan_temperatures(const ContactNodes<Dim>& nodes) {
  temperatures_.clear();
  for (std::size_t s = 0; s < surfaces_.size(); ++s) {
    std::vector<GlobalId> ids, owned;
    std::vector<LocalIndex> places;
    std::vector<int> owners;
    auto& sent = temperatures_.emplace_back();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      if (nodes.surface[i] != static_cast<LocalIndex>(s)) continue;
      if (nodes.owned[i]) {
        sent.from.push_back(static_cast<LocalIndex>(i));
      } else if (surfaces_[s]->points->conducts) {
        ids.push_back(nodes.id[i]);
        places.push_back(static_cast<LocalIndex>(i));
        owners.push_back(ranks_.owner_of(nodes.id[i]));
      }
    }
    std::sort(sent.from.begin(), sent.from.end(), [&](LocalIndex a, LocalIndex b) {
      return nodes.id[slot_of(a)] < nodes.id[slot_of(b)];
    });
    for (const LocalIndex i : sent.from) owned.push_back(nodes.id[slot_of(i)]);
    sent.plan = plan_ghosts(ranks(), ids, places, owners, owned);
  }
}

template <int Dim>
void ContactImports<Dim>::refresh_temperatures(std::vector<Real>& temperature) const {
  for (const auto& sent : temperatures_) {
    refresh_ghosts(
        ranks(), sent.plan, 1,
        [&](std::size_t i, Real* out) { *out = temperature[slot_of(sent.from[i])]; },
        [&](std::size_t i, const Real* in) { temperature[i] = *in; });
  }
}

template <int Dim>
std::vector<HeatShare> ContactImports<Dim>::send_heat(const Records<Dim>& records,
                                                      const ContactNodes<Dim>& nodes,
                                                      std::vector<EndedHeat>& ended) const {
  std::vector<HeatShare> received;
  if (ranks().alone()) return received;
  struct Letter {
    ContactKey key;
    LocalIndex surface;
    GlobalId point;
    Real heat;  // [W], of what ended [J]
    bool ended;
  };
  std::vector<Packer> to(slot_of(ranks().size()));
  for (const auto& one : ended) {
    if (!ranks_.owns(one.point)) {
      to[slot_of(ranks_.owner_of(one.point))]
          << Letter{one.key, one.surface, one.point, one.heat, true};
    }
  }
  std::erase_if(ended, [&](const auto& one) { return !ranks_.owns(one.point); });
  records.visit_heat([&](const HeatFlow<Dim>& flow) {
    for (std::size_t k = 0; k < slot_of(flow.n_nodes); ++k) {
      const auto at = slot_of(flow.node[k]);
      if (nodes.owned[at]) continue;
      const Letter letter{flow.key, nodes.surface[at], nodes.id[at], flow.rate[k], false};
      to[slot_of(ranks_.owner_of(nodes.id[at]))] << letter;
    }
  });
  deliver<Letter>(to, [&](const Letter& letter) {
    const auto& [key, surface, point, heat, has_ended] = letter;
    if (has_ended) {
      ended.push_back({key, surface, point, heat});
    } else {
      received.push_back({key, node_of_letter(surface, point), heat});
    }
  });
  const auto by_key = [](const auto& a, const auto& b) { return a.key < b.key; };
  std::sort(received.begin(), received.end(), by_key);
  std::sort(ended.begin(), ended.end(), by_key);
  return received;
}

/// A face belongs to the owner of its first corner.
template <int Dim>
int ContactImports<Dim>::owner_of(const Entities<Dim>& entities,
                                  const ContactFace<Dim>& face) const {
  return ranks_.owner_of(entities.nodes.id[slot_of(face.node[0])]);
}

template <int Dim>
void ContactImports<Dim>::plan_tractions(const Entities<Dim>& entities) {
  std::vector<GlobalId> ids, owned;
  std::vector<LocalIndex> places;
  std::vector<int> owners;
  sent_from_.clear();
  for (std::size_t f = 0; f < entities.faces.size(); ++f) {
    const auto& face = entities.faces[f];
    if (face.rigid()) continue;  // stands on every rank, and carries nothing on
    if (face.owned) {
      owned.push_back(face.id);
      sent_from_.push_back(static_cast<LocalIndex>(f));
    } else {
      ids.push_back(face.id);
      places.push_back(static_cast<LocalIndex>(f));
      owners.push_back(owner_of(entities, face));
    }
  }
  tractions_ = plan_ghosts(ranks(), ids, places, owners, owned);
}

template <int Dim>
void ContactImports<Dim>::refresh_tractions(Entities<Dim>& entities) const {
  if (!entities.nodes.has_friction) return;
  refresh_ghosts(
      ranks(), tractions_, 2 + Dim,
      [&](std::size_t i, Real* out) {
        const auto& from = entities.tractions[slot_of(sent_from_[i])];
        out[0] = from.area;
        for (int c = 0; c < Dim; ++c) out[1 + c] = from.force[c];
        out[1 + Dim] = from.growth;
      },
      [&](std::size_t i, const Real* in) {
        entities.tractions[i].area = in[0];
        for (int c = 0; c < Dim; ++c) entities.tractions[i].force[c] = in[1 + c];
        entities.tractions[i].growth = in[1 + Dim];
      });
}

template <int Dim>
void ContactImports<Dim>::refresh_materials(std::vector<SurfaceMaterial>& materials) const {
  refresh_ghosts(
      ranks(), tractions_, 2,
      [&](std::size_t i, Real* out) {
        const auto& from = materials[slot_of(sent_from_[i])];
        out[0] = from.temperature, out[1] = from.flow_stress;
      },
      [&](std::size_t i, const Real* in) {
        materials[i] = {in[0], in[1]};
      });
}

template <int Dim>
std::vector<TractionShare<Dim>> ContactImports<Dim>::send_tractions(
    const Records<Dim>& records, const Entities<Dim>& entities) const {
  std::vector<TractionShare<Dim>> received;
  if (ranks().alone()) return received;
  std::vector<Packer> to(slot_of(ranks().size()));
  records.visit_with_friction([&](const ContactRecord<Dim>& record, const Friction<Dim>* friction) {
    if (friction == nullptr || record.kind != ContactKind::face_face) return;
    const auto& upper = entities.faces[slot_of(record.second_place)];
    if (upper.owned || upper.rigid()) return;
    TractionShare<Dim> share{friction->key, friction->area, {}};
    const Vec<Dim> force = friction->slider();
    for (int c = 0; c < Dim; ++c) share.force[c] = force[c];
    to[slot_of(owner_of(entities, upper))] << share;
  });
  deliver<TractionShare<Dim>>(to, [&](TractionShare<Dim> share) { received.push_back(share); });
  std::sort(received.begin(), received.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
  return received;
}

template void ContactImports<2>::plan_temperatures(const ContactNodes<2>&);
template void ContactImports<3>::plan_temperatures(const ContactNodes<3>&);
template void ContactImports<2>::plan_tractions(const Entities<2>&);
template void ContactImports<3>::plan_tractions(const Entities<3>&);
template void ContactImports<2>::refresh_temperatures(std::vector<Real>&) const;
template void ContactImports<3>::refresh_temperatures(std::vector<Real>&) const;
template void ContactImports<2>::refresh_materials(std::vector<SurfaceMaterial>&) const;
template void ContactImports<3>::refresh_materials(std::vector<SurfaceMaterial>&) const;
template void ContactImports<2>::refresh_tractions(Entities<2>&) const;
template void ContactImports<3>::refresh_tractions(Entities<3>&) const;
template std::vector<HeatShare> ContactImports<2>::send_heat(const Records<2>&,
                                                             const ContactNodes<2>&,
                                                             std::vector<EndedHeat>&) const;
template std::vector<HeatShare> ContactImports<3>::send_heat(const Records<3>&,
                                                             const ContactNodes<3>&,
                                                             std::vector<EndedHeat>&) const;
template std::vector<TractionShare<2>> ContactImports<2>::send_tractions(const Records<2>&,
                                                                         const Entities<2>&) const;
template std::vector<TractionShare<3>> ContactImports<3>::send_tractions(const Records<3>&,
                                                                         const Entities<3>&) const;

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
