/// Heat between particles: what stands behind each side of a contact, from the owner of each.
#include <map>

#include "contact/manager/implementation.hpp"

namespace brunt {

template <int Dim>
void ContactManager<Dim>::Implementation::complete_pair_heat() {
  if (!pairs.particles_meet()) return;
  const auto rows = candidates.pairs();
  std::map<std::pair<GlobalId, GlobalId>, PairSide> elsewhere;
  imports.send_sides(entities, rows, sides,
                     [&](GlobalId lower, GlobalId upper, const PairSide& side) {
                       elsewhere[{lower, upper}] = side;
                     });
  // Faces did not know what else takes the heat of their particle.
  const auto share = [&](HeatFlow<Dim>& flow) {
    if (flow.h_area == 0 || loads.empty()) return;
    const ParticleLoad& load = loads[entities.particle_with(flow.key.first)];
    flow.upper.capacity *= static_cast<Real>(load.on_faces) / load.heat_contacts;
  };
  records.change_heat_of_particles(share, [&](PairHeatPath<Dim>& heat) {
    if (heat.per_area == 0) return;
    const auto& pair = rows[heat.candidate];
    const auto& key = heat.flow.key;
    heat.complete(sides[heat.candidate], pair.mirror >= 0
                                             ? sides[static_cast<std::size_t>(pair.mirror)]
                                             : elsewhere.at({key.first, key.second}));
  });
}

template void ContactManager<2>::Implementation::complete_pair_heat();
template void ContactManager<3>::Implementation::complete_pair_heat();

}  // namespace brunt
