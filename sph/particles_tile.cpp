/// The material points of a tile: rotation, law, and what neighbours will read of the stress.
#include "core/geometry/rotation.hpp"
#include "core/transpose.hpp"
#include "sph/correction.hpp"
#include "sph/fetch_record.hpp"
#include "sph/parallel.hpp"
#include "sph/particles.hpp"
#include "sph/principal_tension.hpp"

namespace brunt {

namespace {

/// Spin of the step's middle [rad] turns the deviator; D dt of the middle strains the point.
template <int Dim>
BRUNT_INLINE void rotate_and_strain(const MidStep<Dim, Pack>& mid, Pack (&s)[6],
                                    Pack (&strain)[6]) {
  const auto& g = mid.gradient;
  const Pack zero = broadcast<Pack>(0.0);
  for (auto& component : strain) component = zero;
  step_strain(g, strain);
  if constexpr (Dim == 3) {
    rotate_symmetric(hughes_winget<Pack>(0.5 * (g[2][1] - g[1][2]), 0.5 * (g[0][2] - g[2][0]),
                                         0.5 * (g[1][0] - g[0][1])),
                     s);
  } else {
    rotate_symmetric(hughes_winget<Pack>(0.5 * (g[1][0] - g[0][1])), s);
  }
}

/// Cauchy stress in the plane or in space.
template <int Dim>
BRUNT_INLINE void load_stress(const MaterialState& state, std::size_t at, Pack (&sigma)[Dim][Dim]) {
  const Pack p = load(state.pressure.data() + at);
  const auto component = [&](std::size_t k) { return load(state.deviator[k].data() + at); };
  for (int i = 0; i < Dim; ++i) sigma[i][i] = component(slot_of(i)) - p;
  sigma[0][1] = sigma[1][0] = component(xy);
  if constexpr (Dim == 3) {
    sigma[1][2] = sigma[2][1] = component(yz);
    sigma[0][2] = sigma[2][0] = component(zx);
  }
}

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

bool is_stressed(const MaterialState& state, std::size_t at) {
  return state.pressure[at] != 0 || std::any_of(state.deviator.begin(), state.deviator.end(),
                                                [&](const auto& s) { return s[at] != 0; });
}

/// The same of one point.
template <int Dim>
Eigen::Matrix<Real, Dim, Dim> stress_of(const MaterialState& state, std::size_t at) {
  Eigen::Matrix<Real, Dim, Dim> sigma;
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      const auto component = slot_of(Dim == 3 ? symmetric_place<3>(a, b) : a == b ? a : xy);
      sigma(a, b) = state.deviator[component][at] - (a == b ? state.pressure[at] : 0.0);
    }
  }
  return sigma;
}

}  // namespace

/// What the particles of a tile publish, by slot of the tile.
template <int Dim>
struct SphParticles<Dim>::TileStress {
  alignas(32) Real gradient[Dim * Dim][kTile];  // [1] L dt at x(n+1)
  alignas(32) Real correction[kSymmetric<Dim>][kTile];
  alignas(32) Real moment[kSymmetric<Dim>][kTile];      // [1] K, where B is left out
  alignas(32) Real growth[kTile];                       // [1] V(n+1)/V(n)
  alignas(32) Real corrected[Dim * Dim][kTile];         // [Pa] V(n+1)/V(n) sigma B
  alignas(32) Real artificial[kSymmetric<Dim>][kTile];  // [Pa]
  alignas(32) Real power[kTile];                        // [Pa] sigma : L dt
  alignas(32) Real sound_speed[kTile];                  // [m/s]
};

namespace {

/// product <- a b, b by its symmetric components in a tile.
template <int Dim, class Rows>
BRUNT_INLINE void times_symmetric(const Pack (&a)[Dim][Dim], const Rows& b, int i,
                                  Pack (&product)[Dim][Dim]) {
  for (int r = 0; r < Dim; ++r) {
    for (int k = 0; k < Dim; ++k) {
      Pack sum = broadcast<Pack>(0.0);
      for (int c = 0; c < Dim; ++c) sum = sum + a[r][c] * load(b[symmetric_place<Dim>(c, k)] + i);
      product[r][k] = sum;
    }
  }
}

/// sigma - skew(sigma K) K^-1, which has the power sigma : (R + W - W K) on R (correct_turn).
template <int Dim, class Tile>
BRUNT_INLINE void plain_stress(const Pack (&sigma)[Dim][Dim], const Tile& tile, int i,
                               Pack (&stress)[Dim][Dim]) {
  Pack product[Dim][Dim], skew[Dim][Dim];
  times_symmetric<Dim>(sigma, tile.moment, i, product);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) skew[a][b] = 0.5 * (product[a][b] - product[b][a]);
  }
  times_symmetric<Dim>(skew, tile.correction, i, product);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) stress[a][b] = sigma[a][b] - product[a][b];
  }
}

/// sigma B, the artificial stress -epsilon times the tensile part of sigma, and sigma : L dt of
/// four points.
template <int Dim, class Tile>
BRUNT_INLINE void form_pair_stress(const Pack (&sigma)[Dim][Dim], const SphOptions& options,
                                   Tile& tile, int i) {
  const Real epsilon = options.artificial_stress;
  const Pack growth = load(tile.growth + i);
  Pack power = broadcast<Pack>(0.0), tension[Dim][Dim], pair[Dim][Dim];
  if (options.correction) {
    times_symmetric<Dim>(sigma, tile.correction, i, pair);
  } else {
    plain_stress<Dim>(sigma, tile, i, pair);
  }
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) {
      store(tile.corrected[Dim * a + b] + i, growth * pair[a][b]);
      power = power + sigma[a][b] * load(tile.gradient[Dim * a + b] + i);
    }
  }
  store(tile.power + i, power);
  if (epsilon == 0) return;
  principal_tension<Dim>(sigma, tension);
  for (int a = 0; a < Dim; ++a) {
    for (int b = a; b < Dim; ++b) {
      store(tile.artificial[symmetric_place<Dim>(a, b)] + i, (-epsilon * growth) * tension[a][b]);
    }
  }
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
                                  TileStress& tile) const {
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
                                         TileStress& tile) const {
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
void add_work_of_forces(ParticleState<Dim>& state, const Vec<Dim>& v, Real dt) {
  const Vec<Dim> half = 0.5 * dt * v;
  state.stress_work -= dot<Dim>(state.stress_force, half);
  state.viscous_work -= dot<Dim>(state.viscous_force, half);
  state.artificial_work -= dot<Dim>(state.artificial_force, half);
}

/// The particles of a tile: books the work of their forces, and lays side by side what the tile
/// reads of them.
template <int Dim>
void SphParticles<Dim>::begin_tile(const ParticleBlock& block, std::size_t first, Real dt,
                                   TileStress& stress, MaterialTile& tile) {
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
      add_work_of_forces(own, points_.v[particle[k]], dt);
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

/// Asks for particles of a block, before their tile begins.
template <int Dim>
BRUNT_INLINE void fetch_particles(const std::vector<LocalIndex>& particle, std::size_t first,
                                  std::size_t count, const ParticleState<Dim>* state,
                                  const Vec<Dim>* v) {
  const std::size_t end = std::min(particle.size(), first + count);
  for (std::size_t k = first; k < end; ++k) {
    fetch_record(state[particle[k]]);
    fetch_record(v[particle[k]]);
  }
}

template <int Dim>
void SphParticles<Dim>::update_tile(ParticleBlock& block, std::size_t first, Real dt) {
  const Material& material = *block.set.material;
  TileStress stress;
  MaterialTile tile;
  tile.state = &block.state;
  tile.first = first;
  tile.count = kTile;
  tile.fixed_temperature = block.set.temperature;
  tile.adiabatic = block.set.adiabatic;
  begin_tile(block, first, dt, stress, tile);
  if (!thin_.empty()) turn_thin(block, first, dt, stress);
  // Particles of the next tile arrive while this one is computed, if no more than a few are asked
  // for at once.
  constexpr std::size_t few = kLanes / 2;
  std::size_t next = first + kTile;
  for (int i = 0; i < kTile; i += kLanes, next += few) {
    const std::size_t at = first + slot_of(i);
    fetch_particles<Dim>(block.set.particle, next, few, state_.data(), points_.v.data());
    Pack end[Dim][Dim], s[6], strain[6];
    for (int c = 0; c < Dim * Dim; ++c) end[c / Dim][c % Dim] = load(stress.gradient[c] + i);
    for (std::size_t c = 0; c < 6; ++c) s[c] = load(block.state.deviator[c].data() + at);
    const auto mid = mid_step<Dim>(end);
    rotate_and_strain(mid, s, strain);
    for (std::size_t c = 0; c < 6; ++c) {
      store(block.state.deviator[c].data() + at, s[c]);
      store(tile.strain[c] + i, strain[c]);
    }
    store(stress.growth + i, mid.volume_ratio);
    store(tile.ratio + i, load(tile.ratio_old + i) * mid.volume_ratio);
  }
  material.update(tile, dt);
  for (int i = 0; i < kTile; i += kLanes, next += few) {
    const std::size_t at = first + slot_of(i);
    fetch_particles<Dim>(block.set.particle, next, few, state_.data(), points_.v.data());
    Pack sigma[Dim][Dim];
    load_stress<Dim>(block.state, at, sigma);
    form_pair_stress<Dim>(sigma, block.set.options, stress, i);
    const Pack modulus = load(block.state.bulk.data() + at) + (4.0 / 3.0) * material.shear;
    const Pack density = material.density / load(tile.ratio + i);
    store(stress.sound_speed + i, vsqrt(modulus / density));
  }
  if (!thin_.empty()) form_thin_stress(block, first, dt, stress);
  publish(block, first, stress);
}

template <int Dim>
void SphParticles<Dim>::publish(ParticleBlock& block, std::size_t first, const TileStress& tile) {
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

template struct SphParticles<2>::TileStress;
template struct SphParticles<3>::TileStress;
template void SphParticles<2>::begin_tile(const ParticleBlock&, std::size_t, Real, TileStress&,
                                          MaterialTile&);
template void SphParticles<3>::begin_tile(const ParticleBlock&, std::size_t, Real, TileStress&,
                                          MaterialTile&);
template void SphParticles<2>::update_tile(ParticleBlock&, std::size_t, Real);
template void SphParticles<3>::update_tile(ParticleBlock&, std::size_t, Real);
template void SphParticles<2>::publish(ParticleBlock&, std::size_t, const TileStress&);
template void SphParticles<3>::publish(ParticleBlock&, std::size_t, const TileStress&);
template void SphParticles<2>::move_with_neighbours(Real);
template void SphParticles<3>::move_with_neighbours(Real);

}  // namespace brunt
// Tested by tests/unit/sph/particles_test.cpp.
