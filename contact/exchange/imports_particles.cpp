/// Particles of other ranks beside those of this one, and what stands behind them for heat.
#include "contact/exchange/imports.hpp"
#include "core/parallel/boxes.hpp"

namespace brunt {

namespace {
/// A particle on its way.
template <int Dim>
struct Visitor {
  LocalIndex surface;
  GlobalId id;
  Label body, piece;
  Real radius, mass;
  ParticleMatter matter;
  std::int32_t specific_heat;
  bool held, born;
  Real x[Dim], v[Dim];  // [m], [m/s]
};

template <int Dim>
Visitor<Dim> visitor_of(const ContactParticle& p, const ContactNodes<Dim>& nodes) {
  const auto i = slot_of(p.node);
  Visitor<Dim> one{p.surface,       p.id,   p.body, p.piece, p.radius, nodes.mass[i], *p.matter,
                   p.specific_heat, p.held, p.born, {},      {}};
  for (int c = 0; c < Dim; ++c) one.x[c] = nodes.x[i][c], one.v[c] = nodes.v[i][c];
  return one;
}
}  // namespace

/// Copies in a group of particles come and go with its own lists, so that nodes of imported ones
/// are always fed by their owners.
template <int Dim>
void ContactImports<Dim>::import_particles(const ImportBoxes<Dim>& boxes, Entities<Dim>& entities) {
  const auto lists = who_wants<Dim>(ranks(), boxes.of_particles, boxes.of_particles);
  std::vector<Bytes> to;
  for (const auto& list : lists) {
    Packer packer;
    for (const LocalIndex k : list) {
      const auto p = slot_of(boxes.particle[slot_of(k)]);
      packer << visitor_of(entities.particles[p], entities.nodes);
    }
    to.push_back(packer.take());
  }
  std::vector<ContactParticle> imported;
  for (const Bytes& bytes : ranks().exchange(to)) {
    Unpacker from(bytes);
    while (!from.done()) {
      Visitor<Dim> one;
      from >> one;
      const LocalIndex node = entities.nodes.add_remote(one.surface, one.id, one.mass,
                                                        Vec<Dim>(one.x), Vec<Dim>(one.v));
      imported_[{one.surface, one.id}] = node;
      imported.push_back({node, one.surface, one.id, one.body, one.piece, one.radius,
                          &*entities.matters.insert(one.matter).first, one.specific_heat, one.held,
                          false, one.born});
    }
  }
  entities.add_particles(imported);
}

template <int Dim>
void ContactImports<Dim>::send_sides(
    const Entities<Dim>& entities, std::span<const PairCandidate> candidates,
    std::span<const PairSide> sides,
    const std::function<void(GlobalId, GlobalId, const PairSide&)>& take) const {
  if (ranks().alone()) return;
  struct Letter {
    GlobalId lower, upper;
    PairSide side;
  };
  std::vector<Packer> to(slot_of(ranks().size()));
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto& pair = candidates[c];
    if (pair.other > pair.particle || pair.mirror >= 0 || sides[c].area == 0) continue;
    const GlobalId lower = entities.particles[slot_of(pair.other)].id;
    const GlobalId upper = entities.particles[slot_of(pair.particle)].id;
    to[slot_of(ranks_.owner_of(lower))] << Letter{lower, upper, sides[c]};
  }
  deliver<Letter>(to, [&](const Letter& letter) { take(letter.lower, letter.upper, letter.side); });
}

template void ContactImports<2>::import_particles(const ImportBoxes<2>&, Entities<2>&);
template void ContactImports<3>::import_particles(const ImportBoxes<3>&, Entities<3>&);
template void ContactImports<2>::send_sides(
    const Entities<2>&, std::span<const PairCandidate>, std::span<const PairSide>,
    const std::function<void(GlobalId, GlobalId, const PairSide&)>&) const;
template void ContactImports<3>::send_sides(
    const Entities<3>&, std::span<const PairCandidate>, std::span<const PairSide>,
    const std::function<void(GlobalId, GlobalId, const PairSide&)>&) const;

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
