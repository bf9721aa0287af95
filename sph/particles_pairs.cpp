/// The two passes over pairs of particles, in double or in single precision.
#include <algorithm>
#include <utility>

#include "core/wide_lanes.hpp"
#include "sph/conduction.hpp"
#include "sph/correction.hpp"
#include "sph/fetch_record.hpp"
#include "sph/pair_passes.hpp"
#include "sph/parallel.hpp"
#include "sph/particles.hpp"

namespace brunt {

namespace {
bool is_single(const ParticleBlock& block) {
  return block.set.options.pair_precision == PairPrecision::single_precision;
}
}  // namespace

template <int Dim>
bool SphParticles<Dim>::any_single() const {
  return std::any_of(blocks_.begin(), blocks_.end(), is_single);
}

template <int Dim>
bool SphParticles<Dim>::any_artificial() const {
  return std::any_of(blocks_.begin(), blocks_.end(),
                     [](const auto& block) { return block.set.options.artificial_stress != 0; });
}

template <int Dim>
Real SphParticles<Dim>::least_single_spacing() const {
  Real least = kInfinity;
  for (const auto& block : blocks_) {
    if (!is_single(block)) continue;
    for (const LocalIndex i : block.set.particle) least = std::min(least, spacing_[i]);
  }
  return least;
}

/// The record of i in single precision, out of that in double.
template <int Dim>
void SphParticles<Dim>::set_single_motion(std::size_t i) {
  using Record = MotionRecord<Dim>;
  const Real* from = motion_[i].data;
  float* to = single_motion_[i].data;
  for (int d = 0; d < Dim; ++d) {
    to[d] = std::bit_cast<float>(unit_.steps(from[d]));
    to[Record::kVelocity + d] = static_cast<float>(from[Record::kVelocity + d]);
  }
  to[Record::kInverse] = static_cast<float>(unit_.length * from[Record::kInverse]);
  to[Record::kVolume] = static_cast<float>(
      from[Record::kVolume] *
      (Dim == 3 ? unit_.inverse * unit_.inverse * unit_.inverse : unit_.inverse * unit_.inverse));
}

template <int Dim>
void SphParticles<Dim>::refresh_single_stress() {
  const bool artificial = any_artificial();
  for_each(stress_.size(), [&](std::size_t i) {
    const Real* stress = stress_[i].data;
    for (int k = 0; k <= StressRecord<Dim>::kTension; ++k) {
      single_stress_[i].data[k] = static_cast<float>(stress[k]);
    }
    for (int k = 0; artificial && k < kSymmetric<Dim>; ++k) {
      single_artificial_[i].data[k] = static_cast<float>(artificial_[i].data[k]);
    }
  });
}

template <int Dim>
template <class P>
ForceRecords<Dim, P> SphParticles<Dim>::pair_records() const {
  if constexpr (kIsSingle<P>) {
    return {single_motion_.data(), single_stress_.data(), single_artificial_.data(), unit_.inverse};
  } else {
    return {motion_.data(), stress_.data(), artificial_.data(), 1.0};
  }
}

/// Calls f(P) with the precision of a block, and the lanes of this processor.
template <class F>
void in_precision_of(const ParticleBlock& block, const F& f) {
  if (is_single(block)) {
    f(SinglePairs{});
  } else if (wide_lanes()) {
    f(WidePairs{});
  } else {
    f(DoublePairs{});
  }
}

/// docs/theory/sph.md (S7), (S8), (S8a).
template <int Dim>
void SphParticles<Dim>::take_gradients(const ParticleBlock& block, LocalIndex i,
                                       const GradientSums<Dim>& sums) {
  auto& state = state_[i];
  if (points_.conducts) completeness_[i] = completeness<Dim>(sums.moment);
  if (block.set.options.correction) {
    const bool total = block.set.options.formulation == SphFormulation::total;
    is_thin_[i] = !invert_thick<Dim>(sums.moment, state.correction, total ? kTotalSlack : 1);
    if (!is_thin_[i]) correct_rate<Dim>(sums.rate, state.correction, state.velocity_gradient);
    return;
  }
  is_thin_[i] = false;
  auto& plain = plain_[i];
  std::copy_n(sums.moment, kSymmetric<Dim>, plain.moment);
  invert_moment<Dim>(sums.moment, plain.inverse);
  correct_turn<Dim>(sums.rate, plain, state.velocity_gradient);
}

/// Finds true neighbours, always by the arithmetic of the pair precision of a body: at the rim of a
/// support it decides who is one, and what a step leaves out keeps its row.
template <int Dim>
void SphParticles<Dim>::find_neighbours(Wanted wanted) {
  const auto wants = [&](const ParticleBlock& block, LocalIndex i) {
    if (wanted == Wanted::of_xsph) return block.set.options.xsph != 0;
    return !is_left_out(block, i) && !(keeps_total_rows_ && is_total(slot_of(i)));
  };
  const auto find = [&]<class P>(P) {
    const auto* motion = pair_records<P>().motion;
    for_each(rows_.n_groups(), [&](std::size_t group) {
      unsigned members = 0, bit = 1;
      for (const LocalIndex i : rows_.members(group)) {
        const ParticleBlock& block = blocks_[block_of_[slot_of(i)]];
        if (is_single(block) == kIsSingle<P> && wants(block, i)) members |= bit;
        bit <<= 1;
      }
      if (members != 0) rows_.template find<P>(motion, group, members);
    });
  };
  if (any_single()) find(SinglePairs{});
  if (wide_lanes()) {
    find(WidePairs{});
  } else {
    find(DoublePairs{});
  }
  keeps_total_rows_ = wanted == Wanted::computed;
}

/// Particle by particle, as they lie in memory: members of a group do not lie side by side there.
template <int Dim>
template <class P>
void SphParticles<Dim>::find_gradients(const ParticleBlock& block) {
  if (!block.set.options.correction) plain_.resize(n_owned());
  const auto records = pair_records<P>();
  with_kernel(block.set.options.kernel, [&]<class Kernel>(Kernel) {
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const LocalIndex i = block.set.particle[slot];
      if (is_left_out(block, i)) return;
      fetch_record(state_[slot_of(i)], 0, ParticleState<Dim>::kGradientBytes);
      const auto row = rows_.template row<P>(i);
      take_gradients(block, i,
                     gradients_over<Dim, Kernel, P>(records.motion, i, row, records.inverse_length,
                                                    rows_.weights(i)));
    });
  });
}

/// near += sum_j w_ij e e^T, e along the pair; a row is filled up with the particle itself.
template <int Dim>
void SphParticles<Dim>::add_directions(LocalIndex i, std::span<const LocalIndex> row,
                                       const Real* weights, Real (&near)[kSymmetric<Dim>]) const {
  for (std::size_t n = 0; n < row.size(); ++n) {
    const Vec<Dim> arm = places()[row[n]] - places()[i];
    const Real square = arm.squaredNorm();
    if (row[n] == i || square == 0) continue;
    const Real scale = weights[n] / square;
    for (int a = 0; a < Dim; ++a) {
      for (int b = a; b < Dim; ++b) near[symmetric_place<Dim>(a, b)] += scale * arm[a] * arm[b];
    }
  }
}

/// Axes, correction and gradient of a particle whose neighbourhood is thin.
template <int Dim>
template <class P>
void SphParticles<Dim>::find_thin_gradient(const ParticleBlock& block, LocalIndex i,
                                           ThinMoment<Dim>& thin) {
  const auto records = pair_records<P>();
  const std::span<const LocalIndex> row = rows_.template row<P>(i);
  thread_local std::vector<Real> weights;  // a plate has many such particles
  weights.resize(row.size());
  with_kernel(block.set.options.kernel, [&]<class Kernel>(Kernel) {
    const GradientSums<Dim> sums = gradients_over<Dim, Kernel, P>(
        records.motion, i, row, records.inverse_length, weights.data());
    Real near[kSymmetric<Dim>] = {};
    add_directions(i, row, weights.data(), near);
    thin = thin_moment<Dim>(sums.moment, &near);
    thin_correction<Dim>(thin, state_[i].correction);
    thin_gradient<Dim>(sums.rate, thin, state_[i].velocity_gradient);
  });
}

/// Those whose neighbourhood is thin now; what is known of them stays.
template <int Dim>
void SphParticles<Dim>::list_thin() {
  const std::vector<ThinParticle<Dim>> before = std::exchange(thin_, {});
  auto known = before.begin();
  for (std::size_t i = 0; i < is_thin_.size(); ++i) {
    if (!is_thin_[i]) continue;
    const auto particle = static_cast<LocalIndex>(i);
    while (known != before.end() && known->particle < particle) ++known;
    const bool same = known != before.end() && known->particle == particle;
    thin_.push_back(same ? *known : ThinParticle<Dim>{particle, {}});
  }
}

template <int Dim>
void SphParticles<Dim>::refresh_gradients() {
  is_thin_.resize(n_owned());
  if (points_.conducts) completeness_.resize(n_owned());
  find_neighbours(Wanted::computed);
  for (const auto& block : blocks_) {
    in_precision_of(block, [&]<class P>(P) { find_gradients<P>(block); });
  }
  list_thin();
  for_each(thin_.size(), [&](std::size_t k) {
    ThinParticle<Dim>& thin = thin_[k];
    const ParticleBlock& block = blocks_[block_of_[thin.particle]];
    if (is_left_out(block, thin.particle)) return;
    in_precision_of(block,
                    [&]<class P>(P) { find_thin_gradient<P>(block, thin.particle, thin.moment); });
  });
}

/// Axes of a particle's neighbourhood; null where it is thick.
template <int Dim>
const ThinMoment<Dim>* SphParticles<Dim>::thin_of(LocalIndex i) const {
  if (is_thin_.empty() || !is_thin_[i]) return nullptr;
  return &std::ranges::lower_bound(thin_, i, {}, &ThinParticle<Dim>::particle)->moment;
}

/// Calls take(i, sums) of the forces on each particle of a block.
template <int Dim>
template <class Take>
void SphParticles<Dim>::sum_block_forces(const ParticleBlock& block,
                                         const MonaghanViscosity& viscosity, const Take& take) {
  const SphOptions& options = block.set.options;
  if (options.formulation == SphFormulation::total) {
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const LocalIndex i = block.set.particle[slot];
      if (!is_left_out(block, i)) take(i, total_forces(block, i, viscosity));
    });
    return;
  }
  in_precision_of(block, [&]<class P>(P) {
    const auto records = pair_records<P>();
    with_kernel(options.kernel, [&]<class Kernel>(Kernel) {
      const SphPairOptions pair{viscosity.alpha, viscosity.beta,
                                1.0 / Kernel::value(1.0 / options.smoothing)};
      for_each(block.set.particle.size(), [&](std::size_t slot) {
        const LocalIndex i = block.set.particle[slot];
        if (is_left_out(block, i)) return;
        fetch_record(state_[slot_of(i)], ParticleState<Dim>::kCorrectionByte);
        const auto row = rows_.template row<P>(i);
        take(i, forces_over<Dim, Kernel>(records, i, row, rows_.weights(i), pair));
      });
    });
  });
}

/// Speeds of approach of the start, which the first step limit needs.
template <int Dim>
void SphParticles<Dim>::seed_step_limits() {
  refresh_motion();
  refresh_gradients();
  if (any_total()) refresh_total_records(), refresh_total_ghosts();
  reflect_stress();
  if (any_single()) refresh_single_stress();
  if (any_total()) place_total_records();
  for (const auto& block : blocks_) {
    sum_block_forces(block, {0, 0}, [&](LocalIndex i, const ForceSums<Dim>& sums) {
      state_[i].speed = sums.speed;
      state_[i].mu = sums.mu;
      find_spread(block, i);
    });
  }
}

template <int Dim>
void SphParticles<Dim>::take_forces(const ParticleBlock& block, LocalIndex i,
                                    const ForceSums<Dim>& sums, Real dt) {
  const auto k = slot_of(i);
  auto& state = state_[k];
  ArtificialChannel<Dim> none;
  auto& artificial = channel_.empty() ? none : channel_[k];
  const Real volume = depth_ * motion_[k].data[MotionRecord<Dim>::kVolume];
  for (int d = 0; d < Dim; ++d) {
    state.stress_force[d] = volume * sums.stress[d];
    state.viscous_force[d] = volume * sums.viscosity[d];
    artificial.force[d] = volume * sums.artificial[d];
    points_.f[k][d] += (state.stress_force[d] + state.viscous_force[d]) + artificial.force[d];
  }
  state.viscous_power = volume * sums.viscosity_power;
  state.viscous_work += 0.5 * dt * state.viscous_power;
  artificial.work += 0.5 * dt * volume * sums.artificial_power;
  state.speed = sums.speed;
  state.mu = sums.mu;
  find_spread(block, i);
}

template <int Dim>
void SphParticles<Dim>::add_internal_forces(Real dt) {
  if (held_) return;
  reflect_stress();
  if (!rides()) still_.look_again(watch_);
  if (any_single()) refresh_single_stress();
  if (any_total()) place_total_records();
  for (const auto& block : blocks_) {
    sum_block_forces(
        block, block.set.options.viscosity,
        [&](LocalIndex i, const ForceSums<Dim>& sums) { take_forces(block, i, sums, dt); });
  }
  if (rides()) give_forces_to_nodes();
}

template void SphParticles<2>::find_neighbours(Wanted);
template void SphParticles<3>::find_neighbours(Wanted);
template bool SphParticles<2>::any_single() const;
template bool SphParticles<3>::any_single() const;
template bool SphParticles<2>::any_artificial() const;
template bool SphParticles<3>::any_artificial() const;
template Real SphParticles<2>::least_single_spacing() const;
template Real SphParticles<3>::least_single_spacing() const;
template void SphParticles<2>::set_single_motion(std::size_t);
template void SphParticles<3>::set_single_motion(std::size_t);
template void SphParticles<2>::list_thin();
template void SphParticles<3>::list_thin();
template void SphParticles<2>::refresh_gradients();
template void SphParticles<3>::refresh_gradients();
template const ThinMoment<2>* SphParticles<2>::thin_of(LocalIndex) const;
template void SphParticles<2>::seed_step_limits();
template const ThinMoment<3>* SphParticles<3>::thin_of(LocalIndex) const;
template void SphParticles<3>::seed_step_limits();
template void SphParticles<2>::add_internal_forces(Real);
template void SphParticles<3>::add_internal_forces(Real);

}  // namespace brunt
// Tested by tests/unit/sph/pair_precision_test.cpp.
