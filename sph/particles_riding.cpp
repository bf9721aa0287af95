/// Particles that ride on nodes of elements that have failed. docs/theory/elements.md, section 9.
#include <algorithm>
#include <cassert>

#include "sph/parallel.hpp"
#include "sph/particle_values.hpp"

namespace brunt {

namespace {
/// A mean of damage is of what is closed. Where a part has failed and is open, what is whole would
/// pull on the volume that has opened at no stress, and have energy that nobody gave: open, a
/// point has the largest damage d of both, and 1 - d of the effective stress, the mean one.
/// docs/theory/elements.md (E18a)
void keep_open(MaterialState& state, std::size_t slot, Real ratio, Real largest) {
  const Real mean = state.damage[slot];  // of ones 1, to rounding
  if (!(ratio > 1 && largest > mean && mean < 1)) return;
  const Real left = std::max(1 - largest, 0.0) / (1 - mean);
  for (auto& component : state.deviator) component[slot] *= left;
  if (state.pressure[slot] < 0) state.pressure[slot] *= left;
  state.damage[slot] = largest;
}
}  // namespace

template <int Dim>
void SphParticles<Dim>::ride_on(ParticleCarrier<Dim>& carrier, std::vector<GlobalId> node) {
  assert(node.size() == n_owned() && std::is_sorted(node.begin(), node.end()));
  carrier_ = &carrier;
  node_id_ = std::move(node);
  node_.clear();
  for (const GlobalId id : node_id_) node_.push_back(carrier.carrying_points().find(id));
  slot_.resize(n_owned());
  for (const auto& block : blocks_) {
    for (std::size_t slot = 0; slot < block.set.particle.size(); ++slot) {
      slot_[block.set.particle[slot]] = static_cast<std::uint32_t>(slot);
    }
  }
  surface_.particles.clear();  // the nodes touch what there is to touch
}

template <int Dim>
bool SphParticles<Dim>::tile_sleeps(const ParticleBlock& block, std::size_t first) const {
  const auto& particle = block.set.particle;
  const std::size_t last = std::min(particle.size(), first + kTile);
  for (std::size_t slot = first; slot < last; ++slot) {
    if (!sleeps(slot_of(particle[slot]))) return false;
  }
  return true;
}

/// [kg] by which neighbours weigh a particle: that of a rider stands in its node.
template <int Dim>
Real SphParticles<Dim>::weighed_mass(std::size_t i) const {
  if (i >= n_owned() || !rides()) return points_.mass[i];
  return blocks_[block_of_[i]].set.material->density * state_[i].start_volume;
}

/// Shares of elements that have failed in this step, in the order of their ids. True where a rider
/// of any rank took one.
template <int Dim>
bool SphParticles<Dim>::take_over() {
  for (const ConvertedShare& share : carrier_->converted()) {
    const auto at = std::lower_bound(node_id_.begin(), node_id_.end(), share.point);
    assert(at != node_id_.end() && *at == share.point);
    take_share(slot_of(at - node_id_.begin()), share);
  }
  return carrier_->any_converted();
}

/// What a rider is and what it takes become one, weighted by volumes at time 0: heat, work and
/// volume are sums, stress and all else are means, but for the damage of what is open.
template <int Dim>
void SphParticles<Dim>::take_share(std::size_t i, const ConvertedShare& share) {
  auto& block = blocks_[block_of_[i]];
  auto& state = state_[i];
  const std::size_t slot = slot_[i];
  const bool wakes = sleeps(i);
  const Real before = state.start_volume, after = before + share.volume;
  const auto mean = [&](Real own, Real other) {
    return wakes ? other : (before * own + share.volume * other) / after;
  };
  const Real* value = share.state.data();
  const Real* const damage = block.state.damage.empty() ? nullptr : &block.state.damage[slot];
  Real largest = 0;
  visit_material_point(block.state, slot, kSaved, [&](Real& own, FieldUse) {
    if (&own == damage) largest = wakes ? *value : std::max(own, *value);
    own = mean(own, *value++);
  });
  assert(value == share.state.data() + share.state.size());
  state.ratio = mean(state.ratio, share.ratio);
  if (damage) keep_open(block.state, slot, state.ratio, largest);
  state.start_volume = after;
  state.volume = after * state.ratio;
  state.stress_work += share.work;
  const Material& material = *block.set.material;
  state.sound_speed = std::sqrt((block.state.bulk[slot] + 4.0 / 3.0 * material.shear) *
                                state.ratio / material.density);
  if (!block.heat_given.empty()) {
    Real heat = 0;
    for (const auto* part : {&block.state.heat, &block.state.compression_heat}) {
      if (!part->empty()) heat += (*part)[slot] * after;
    }
    block.heat_given[slot] = heat;  // by the element, to the same nodes
  }
  set_size(i);
}

/// Riders, and copies of them, where their nodes are. Those that sleep stay where they began.
template <int Dim>
void SphParticles<Dim>::follow_nodes() {
  const Points<Dim>& nodes = carrier_->carrying_points();
  for_each(n_owned(), [&](std::size_t i) {
    if (sleeps(i)) return;
    const auto k = slot_of(node_[i]);
    points_.x[i] = nodes.x[k], points_.x_rest[i] = nodes.x_rest[k], points_.v[i] = nodes.v[k];
    if (points_.conducts) points_.temperature[i] = nodes.temperature[k];
  });
  if (ranks_->alone()) return;
  const bool conducts = points_.conducts;
  refresh_ghosts(
      *ranks_, ghosts_, 2 * Dim + (conducts ? 1 : 0),
      [&](std::size_t i, Real* out) {
        for (int c = 0; c < Dim; ++c) out[c] = points_.x[i][c], out[Dim + c] = points_.v[i][c];
        if (conducts) out[2 * Dim] = points_.temperature[i];
      },
      [&](std::size_t i, const Real* in) {
        for (int c = 0; c < Dim; ++c) points_.x[i][c] = in[c], points_.v[i][c] = in[Dim + c];
        if (conducts) points_.temperature[i] = in[2 * Dim];
      });
}

template <int Dim>
void SphParticles<Dim>::give_forces_to_nodes() {
  Points<Dim>& nodes = carrier_->carrying_points();
  for_each(n_owned(), [&](std::size_t i) {
    if (!sleeps(i)) nodes.f[node_[i]] += points_.f[i];
  });
}

/// Rates of heat and conductances of the step.
template <int Dim>
void SphParticles<Dim>::give_heat_to_nodes() {
  Points<Dim>& nodes = carrier_->carrying_points();
  for_each(n_owned(), [&](std::size_t i) {
    nodes.heat_rate[node_[i]] += points_.heat_rate[i];
    nodes.conductance[node_[i]] += points_.conductance[i];
    points_.heat_rate[i] = points_.conductance[i] = 0;
  });
}

template void SphParticles<2>::ride_on(ParticleCarrier<2>&, std::vector<GlobalId>);
template void SphParticles<3>::ride_on(ParticleCarrier<3>&, std::vector<GlobalId>);
template bool SphParticles<2>::tile_sleeps(const ParticleBlock&, std::size_t) const;
template bool SphParticles<3>::tile_sleeps(const ParticleBlock&, std::size_t) const;
template Real SphParticles<2>::weighed_mass(std::size_t) const;
template Real SphParticles<3>::weighed_mass(std::size_t) const;
template bool SphParticles<2>::take_over();
template bool SphParticles<3>::take_over();
template void SphParticles<2>::take_share(std::size_t, const ConvertedShare&);
template void SphParticles<3>::take_share(std::size_t, const ConvertedShare&);
template void SphParticles<2>::follow_nodes();
template void SphParticles<3>::follow_nodes();
template void SphParticles<2>::give_forces_to_nodes();
template void SphParticles<3>::give_forces_to_nodes();
template void SphParticles<2>::give_heat_to_nodes();
template void SphParticles<3>::give_heat_to_nodes();

}  // namespace brunt
// Tested by tests/verification/conversion_test.cpp.
