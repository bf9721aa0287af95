/// What particles carry from step to step, as tables by the ids of their points. The records that
/// neighbours read, smoothing lengths and lists follow from it.
#include <algorithm>

#include "core/materials/state_rows.hpp"
#include "core/points_state.hpp"
#include "sph/particles.hpp"

namespace brunt {
namespace {

/// A name for all blocks whose material points have rows of the same columns.
std::string table_of(const ParticleBlock& block) {
  return "particle.material" + fields_of(block.state) + (block.heat_given.empty() ? "" : ".given");
}

template <class Row, class Block>
void visit_slot(Row& row, Block& block, std::size_t slot) {
  visit_material_point(row, block.state, slot);
  if (!block.heat_given.empty()) row(block.heat_given[slot]);
}

template <class Row, class State>
void visit_particle(Row& row, State& state) {
  for (auto& value : state.velocity_gradient) row(value);
  for (auto& value : state.correction) row(value);
  for (auto* value : {&state.spacing, &state.start_volume, &state.ratio, &state.volume,
                      &state.sound_speed, &state.speed, &state.mu, &state.viscous_power,
                      &state.spread.trace, &state.spread.largest}) {
    row(*value);
  }
  row(state.stress_force);
  row(state.viscous_force);
  row(state.artificial_force);
  for (auto* value : {&state.stress_work, &state.viscous_work, &state.artificial_work}) row(*value);
}

}  // namespace

template <int Dim>
void SphParticles<Dim>::save_state(std::vector<StateTable>& tables) const {
  save_points(points_, tables);
  save_rows(
      "particles", static_cast<std::size_t>(points_.n_owned),
      [&](std::size_t i) { return points_.id[i]; },
      [&](auto& row, std::size_t i) { visit_particle(row, state_[i]); }, tables);
  for (const auto& block : blocks_) {
    // Ghosts come last among the points, so their slots come last among the slots of a block.
    const auto& particle = block.set.particle;
    const auto owned = static_cast<std::size_t>(
        std::lower_bound(particle.begin(), particle.end(), points_.n_owned) - particle.begin());
    save_rows(
        table_of(block), owned,
        [&](std::size_t slot) { return points_.id[static_cast<std::size_t>(particle[slot])]; },
        [&](auto& row, std::size_t slot) { visit_slot(row, block, slot); }, tables);
  }
}

template <int Dim>
void SphParticles<Dim>::load_state(const StateTables& tables) {
  load_points(points_, tables);
  load_rows(
      "particles", n_owned(), [&](std::size_t i) { return points_.id[i]; },
      [&](auto& row, std::size_t i) { visit_particle(row, state_[i]); }, tables);
  for (auto& block : blocks_) {
    const auto& particle = block.set.particle;
    load_rows(
        table_of(block), particle.size(),
        [&](std::size_t slot) { return points_.id[static_cast<std::size_t>(particle[slot])]; },
        [&](auto& row, std::size_t slot) { visit_slot(row, block, slot); }, tables);
  }
  for (std::size_t i = 0; i < n_owned(); ++i) set_size(i);
}

template void SphParticles<2>::save_state(std::vector<StateTable>&) const;
template void SphParticles<3>::save_state(std::vector<StateTable>&) const;
template void SphParticles<2>::load_state(const StateTables&);
template void SphParticles<3>::load_state(const StateTables&);

}  // namespace brunt
// Tested by tests/unit/sph/state_test.cpp.
