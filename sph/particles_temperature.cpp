/// Particles whose temperature at time 0 depends on the place.
#include "sph/particles.hpp"

namespace brunt {

/// [K] of particle i of a set at time 0.
template <int Dim>
Real SphParticles<Dim>::start_temperature(const ParticleSet& set, std::size_t i) const {
  if (set.temperature_field == nullptr) return set.temperature;
  return set.temperature_field->at(in_space<Dim>(points_.x_start[i]));
}

template <int Dim>
void SphParticles<Dim>::begin_temperatures(ParticleBlock& block) {
  const ParticleSet& set = block.set;
  if (set.temperature_field == nullptr) return;
  auto& temperature = block.state.temperature;
  temperature.resize(block.state.size(), set.temperature);
  for (std::size_t slot = 0; slot < set.particle.size(); ++slot) {
    temperature[slot] = start_temperature(set, slot_of(set.particle[slot]));
  }
  if (!block.state.expansion.empty()) block.state.start_temperature = temperature;
}

template Real SphParticles<2>::start_temperature(const ParticleSet&, std::size_t) const;
template Real SphParticles<3>::start_temperature(const ParticleSet&, std::size_t) const;
template void SphParticles<2>::begin_temperatures(ParticleBlock&);
template void SphParticles<3>::begin_temperatures(ParticleBlock&);

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
