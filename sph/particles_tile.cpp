/// The material points of a tile: rotation, law, and what neighbours will read of the stress.
#include "core/transpose.hpp"
#include "sph/parallel.hpp"
#include "sph/tile_passes.hpp"

namespace brunt {

namespace {

/// Rows of a tile from `slot` on <- the arrays of four records, which array_of points to.
template <class Record, class ArrayOf, std::size_t N>
BRUNT_INLINE void lay_side_by_side(const Record* const (&record)[kLanes], const ArrayOf& array_of,
                                   int slot, Real (&row)[N][kTile]) {
  constexpr int n = N;
  for (int c = 0; c < n; c += kLanes) {
    const int at = std::min(c, n - kLanes);  // the last four overlap those before
    if (at < 0 || c + 1 == n) {
      for (int r = c; r < n; ++r) {
        for (int k = 0; k < kLanes; ++k) row[r][slot + k] = array_of(*record[k])[r];
      }
      continue;
    }
    Pack part[kLanes];
    transpose(load(array_of(*record[0]) + at), load(array_of(*record[1]) + at),
              load(array_of(*record[2]) + at), load(array_of(*record[3]) + at), part);
    for (int r = c; r < std::min(c + kLanes, n); ++r) store(row[r] + slot, part[r - at]);
  }
}

TilePoints points_of(MaterialState& state, std::size_t first, const Material& material) {
  TilePoints points;
  for (std::size_t c = 0; c < 6; ++c) points.deviator[c] = state.deviator[c].data() + first;
  points.pressure = state.pressure.data() + first;
  points.bulk = state.bulk.data() + first;
  points.density = material.density, points.shear = material.shear;
  return points;
}

bool is_stressed(const MaterialState& state, std::size_t at) {
  return state.pressure[at] != 0 || std::any_of(state.deviator.begin(), state.deviator.end(),
                                                [&](const auto& s) { return s[at] != 0; });
}

}  // namespace

/// dt L of a particle [1].
template <int Dim>
Eigen::Matrix<Real, Dim, Dim> step_gradient(const ParticleState<Dim>& state, Real dt) {
  return dt *
         Eigen::Map<const Eigen::Matrix<Real, Dim, Dim, Eigen::RowMajor>>(state.velocity_gradient);
}

/// Of those whose neighbourhood is thin: what the gradient misses of their turn.
template <int Dim>
void SphParticles<Dim>::turn_thin(const ParticleBlock& block, std::size_t first, Real dt,
                                  TileStress<Dim>& tile) const {
  const std::size_t n = std::min(block.set.particle.size() - first, std::size_t{kTile});
  for (std::size_t slot = 0; slot < n; ++slot) {
    const LocalIndex i = block.set.particle[first + slot];
    const ThinMoment<Dim>* thin = thin_of(i);
    if (!thin) continue;
    const Eigen::Matrix<Real, Dim, Dim> missed =
        missed_turn<Dim>(step_gradient(state_[i], dt), *thin);
    for (int c = 0; c < Dim * Dim; ++c) tile.gradient[c][slot] += missed(c / Dim, c % Dim);
  }
}

/// T B of those whose neighbourhood is thin, in place of sigma B, and its power.
template <int Dim>
void SphParticles<Dim>::form_thin_stress(const ParticleBlock& block, std::size_t first, Real dt,
                                         TileStress<Dim>& tile) const {
  const std::size_t n = std::min(block.set.particle.size() - first, std::size_t{kTile});
  for (std::size_t slot = 0; slot < n; ++slot) {
    const LocalIndex i = block.set.particle[first + slot];
    const ThinMoment<Dim>* thin = thin_of(i);
    if (!thin) continue;
    const Eigen::Matrix<Real, Dim, Dim> sigma = stress_of<Dim>(block.state, first + slot);
    const Eigen::Matrix<Real, Dim, Dim> pair = tile.growth[slot] * thin_stress<Dim>(sigma, *thin);
    for (int c = 0; c < Dim * Dim; ++c) tile.corrected[c][slot] = pair(c / Dim, c % Dim);
    tile.power[slot] = sigma.cwiseProduct(step_gradient(state_[i], dt)).sum();
  }
}

/// What the forces that were added last do until the middle of the step, by channel.
template <int Dim>
void add_work_of_forces(ParticleState<Dim>& state, ArtificialChannel<Dim>* artificial,
                        const Vec<Dim>& v, Real dt) {
  const Vec<Dim> half = 0.5 * dt * v;
  state.stress_work -= dot<Dim>(state.stress_force, half);
  state.viscous_work -= dot<Dim>(state.viscous_force, half);
  if (artificial) artificial->work -= dot<Dim>(artificial->force, half);
}

/// The particles of a tile: books the work of their forces, and lays side by side what the tile
/// reads of them.
template <int Dim>
void SphParticles<Dim>::begin_tile(const ParticleBlock& block, std::size_t first, Real dt,
                                   TileStress<Dim>& stress, MaterialTile& tile) {
  const auto& particle = block.set.particle;
  const std::size_t n = particle.size();
  const bool correction = block.set.options.correction;
  static const ParticleState<Dim> resting;
  static const PlainMoment<Dim> none;
  for (int slot = 0; slot < kTile; slot += kLanes) {
    const ParticleState<Dim>* state[kLanes];
    const PlainMoment<Dim>* plain[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      const std::size_t k = first + slot_of(slot + lane);
      state[lane] = &resting, plain[lane] = &none;
      if (k >= n) continue;
      auto& own = state_[particle[k]];
      add_work_of_forces(own, channel_.empty() ? nullptr : &channel_[particle[k]],
                         points_.v[particle[k]], dt);
      state[lane] = &own;
      if (!correction) plain[lane] = &plain_[particle[k]];
    }
    lay_side_by_side(
        state, [](const auto& s) { return s.velocity_gradient; }, slot, stress.gradient);
    for (auto& row : stress.gradient) store(row + slot, dt * load(row + slot));
    if (correction) {
      lay_side_by_side(
          state, [](const auto& s) { return s.correction; }, slot, stress.correction);
    } else {
      lay_side_by_side(
          plain, [](const auto& p) { return p.inverse; }, slot, stress.correction);
      lay_side_by_side(
          plain, [](const auto& p) { return p.moment; }, slot, stress.moment);
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      const auto& own = *state[lane];
      tile.ratio_old[slot + lane] = own.ratio;
      tile.viscous_work[slot + lane] =
          own.start_volume > 0 ? dt * own.viscous_power / own.start_volume : 0.0;
    }
  }
}

template <int Dim>
void SphParticles<Dim>::update_tile(ParticleBlock& block, std::size_t first, Real dt) {
  const Material& material = *block.set.material;
  TileStress<Dim> stress;
  alignas(64) MaterialTile tile;
  tile.state = &block.state;
  tile.first = first;
  tile.count = kTile;
  tile.fixed_temperature = block.set.temperature;
  tile.adiabatic = block.set.adiabatic;
  begin_tile(block, first, dt, stress, tile);
  if (!thin_.empty()) turn_thin(block, first, dt, stress);
  const TilePoints points = points_of(block.state, first, material);
  // Half of the next tile's particles while this one is strained, half while its stress is formed.
  const auto& particle = block.set.particle;
  const std::size_t n = particle.size();
  const auto ahead_from = [&](std::size_t k) {
    return ParticlesAhead<Dim>{particle.data() + std::min(k, n), particle.data() + n, state_.data(),
                               points_.v.data()};
  };
  const auto soon = ahead_from(first + kTile), later = ahead_from(first + kTile + kTile / 2);
  const bool wide = wide_lanes();
  if (wide) {
    strain_points_by<Dim, Wide>(points, soon, stress, tile);
  } else {
    strain_points<Dim, Pack>(points, soon, stress, tile);
  }
  const bool total = block.set.options.formulation == SphFormulation::total;
  if (total) set_total_volumes(block, first, stress, tile);
  material.update(tile, dt);
  if (wide) {
    stress_points_by<Dim, Wide>(points, block.set.options, tile.ratio, later, stress);
  } else {
    stress_points<Dim, Pack>(points, block.set.options, tile.ratio, later, stress);
  }
  if (!thin_.empty()) form_thin_stress(block, first, dt, stress);
  if (total) form_total_stress(block, first, stress);
  publish(block, first, stress);
}

template <int Dim>
void SphParticles<Dim>::publish(ParticleBlock& block, std::size_t first,
                                const TileStress<Dim>& tile) {
  using Record = StressRecord<Dim>;
  const bool artificial = block.set.options.artificial_stress != 0;
  const bool any_still = !still_.all_stirred();
  const std::size_t n = std::min(block.set.particle.size() - first, std::size_t{kTile});
  for (std::size_t slot = 0; slot < n; ++slot) {
    const auto i = slot_of(block.set.particle[first + slot]);
    auto& state = state_[i];
    state.ratio *= tile.growth[slot];
    state.volume = state.start_volume * state.ratio;
    state.sound_speed = tile.sound_speed[slot];
    state.stress_work += 0.5 * state.volume * tile.power[slot];
    Real* stress = stress_[i].data;
    for (int c = 0; c < Dim * Dim; ++c) stress[c] = tile.corrected[c][slot];
    stress[Record::kSoundSpeed] = tile.sound_speed[slot];
    set_size(i);
    if (any_still && !still_.is_stirred(i) &&
        (tile.growth[slot] != 1 || is_stressed(block.state, first + slot))) {
      still_.stir(i);
    }
    if (!artificial) continue;
    bool tension = false;
    for (int c = 0; c < kSymmetric<Dim>; ++c) {
      artificial_[i].data[c] = tile.artificial[c][slot];
      tension = tension || tile.artificial[c][slot] != 0;
    }
    stress[Record::kTension] = tension ? 1.0 : 0.0;
  }
}

/// XSPH (Monaghan 1989): positions move with a mean of the neighbours' velocities,
/// x_i += dt xsph sum m_j/rho_ij (v_j - v_i) W, which keeps the centre of mass.
/// docs/theory/sph.md (S20).
template <int Dim>
void SphParticles<Dim>::move_with_neighbours(Real dt) {
  const bool any_moves = std::any_of(blocks_.begin(), blocks_.end(),
                                     [](const auto& block) { return block.set.options.xsph != 0; });
  if (!any_moves) return;
  find_neighbours(Wanted::of_xsph);
  std::vector<Vec<Dim>> shift(state_.size(), Vec<Dim>::Zero());
  for (const auto& block : blocks_) {
    const Real strength = block.set.options.xsph;
    if (strength == 0) continue;
    with_kernel(block.set.options.kernel, [&]<class Kernel>(Kernel) {
      for_each(block.set.particle.size(), [&](std::size_t slot) {
        const LocalIndex i = block.set.particle[slot];
        const auto k = slot_of(i);
        const auto mean =
            mean_velocity<Dim, Kernel>(motion_.data(), stress_.data(), i, rows_.row(i));
        shift[k] = (dt * strength) * mean;
      });
    });
  }
  for_each(n_owned(), [&](std::size_t i) { points_.move(i, shift[i]); });
  refresh_ghost_positions();
  renew_lists();
  refresh_motion();
}

template void SphParticles<2>::begin_tile(const ParticleBlock&, std::size_t, Real, TileStress<2>&,
                                          MaterialTile&);
template void SphParticles<3>::begin_tile(const ParticleBlock&, std::size_t, Real, TileStress<3>&,
                                          MaterialTile&);
template void SphParticles<2>::update_tile(ParticleBlock&, std::size_t, Real);
template void SphParticles<3>::update_tile(ParticleBlock&, std::size_t, Real);
template void SphParticles<2>::publish(ParticleBlock&, std::size_t, const TileStress<2>&);
template void SphParticles<3>::publish(ParticleBlock&, std::size_t, const TileStress<3>&);
template void SphParticles<2>::move_with_neighbours(Real);
template void SphParticles<3>::move_with_neighbours(Real);

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
