#pragma once
/// What a particle carries from step to step, listed once: rows of a checkpoint and hashes read it.
#include "core/materials/state_rows.hpp"
#include "sph/particles.hpp"

namespace brunt {

/// Hands every value of the material point in a slot of a block to f(value, use).
template <class Block, class F>
void visit_slot(Block& block, std::size_t slot, const F& f) {
  visit_material_point(block.state, slot, kState, f);
  if (!block.heat_given.empty()) f(block.heat_given[slot], kSaved);
}

/// Hands every other value of a particle to f(value, use). Rows of a checkpoint have this order.
/// spacing [m]; artificial  that channel
template <class State, class Spacing, class Artificial, class F>
void visit_particle(State& state, Spacing& spacing, Artificial&& artificial, const F& f) {
  for (auto& value : state.velocity_gradient) f(value, kSaved);
  for (auto& value : state.correction) f(value, kSaved);
  f(spacing, kSaved);
  f(state.start_volume, kSaved);
  f(state.ratio, kState);
  f(state.volume, kSaved);
  f(state.sound_speed, kSaved);
  f(state.speed, kSaved);
  f(state.mu, kSaved);
  f(state.spread.trace, kSaved);
  f(state.spread.largest, kSaved);
  f(state.stress_force, kSaved);
  f(state.viscous_force, kSaved);
  f(artificial.force, kSaved);
  f(state.stress_work, kState);
  f(state.viscous_work, kState);
  f(artificial.work, kState);
  f(state.viscous_power, kState);
}

/// The same of what one of formulation: total carries beside it.
template <class Total, class F>
void visit_total(Total& total, const F& f) {
  auto* const gradient = total.gradient.data();
  for (Eigen::Index c = 0; c < total.gradient.size(); ++c) f(gradient[c], kState);
  f(total.volume, kSaved);
  f(total.seen, kState);
  f(total.stretch, kSaved);
  f(total.stiffness_sum, kSaved);
  f(total.damping_sum, kSaved);
}

}  // namespace brunt
// Tested by tests/unit/sph/state_test.cpp.
