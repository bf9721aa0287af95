/// Particles that are under stress at time 0. docs/theory/materials.md (M46), (M47)
#include "sph/particles.hpp"

namespace brunt {

/// Of a whole: its parts take their masses from it.
template <int Dim>
void SphParticles<Dim>::compress_masses(const std::vector<ParticleSet>& sets) {
  for (const ParticleSet& set : sets) {
    if (set.stress == nullptr) continue;
    StressedStart start(*set.stress, *set.material, set.temperature, set.adiabatic);
    for (const LocalIndex i : set.particle) {
      points_.mass[i] /= start.ratio(set.stress->at(in_space<Dim>(points_.x[i])));
    }
  }
}

template <int Dim>
void SphParticles<Dim>::begin_under_stress(ParticleBlock& block) {
  const ParticleSet& set = block.set;
  if (set.stress == nullptr) return;
  const Material& material = *set.material;
  StressedStart start(*set.stress, material, set.temperature, !block.state.temperature.empty());
  for (std::size_t slot = 0; slot < set.particle.size(); ++slot) {
    const auto i = slot_of(set.particle[slot]);
    const PlacedStress at = set.stress->at(in_space<Dim>(points_.x[i]));
    auto& state = state_[i];
    state.ratio = start.ratio(at);
    state.stress_work = state.start_volume * start.begin(at, state.ratio, block.state, slot);
    state.volume = state.start_volume * state.ratio;
    const Real modulus = block.state.bulk[slot] + 4.0 / 3.0 * material.shear;
    state.sound_speed = std::sqrt(modulus * state.ratio / material.density);
  }
}

template void SphParticles<2>::compress_masses(const std::vector<ParticleSet>&);
template void SphParticles<3>::compress_masses(const std::vector<ParticleSet>&);
template void SphParticles<2>::begin_under_stress(ParticleBlock&);
template void SphParticles<3>::begin_under_stress(ParticleBlock&);

}  // namespace brunt
// Tested by tests/verification/initial_stress_test.cpp.
