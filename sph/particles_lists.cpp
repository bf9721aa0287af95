/// Neighbour lists and what bounds them, and the bound on the time step.
#include <algorithm>

#include "core/parallel/threads.hpp"
#include "sph/correction.hpp"
#include "sph/fetch_record.hpp"
#include "sph/parallel.hpp"
#include "sph/particles.hpp"

namespace brunt {

namespace {

/// Merges results of chunks of particles, in any order: each thread has its own.
template <class Result, class Add, class Merge>
Result over_chunks(std::size_t n, const Result& blank, Add add, Merge merge) {
  Result all = blank;
  on_threads(n >= 4096, [&] {
    Result own = blank;
#pragma omp for schedule(static) nowait
    for (std::size_t i = 0; i < n; ++i) add(own, i);
#pragma omp critical(brunt_sph_chunks)
    merge(all, own);
  });
  return all;
}

/// The less of a step [s] and of 0.25 sqrt(h/|a|), whose roots and quotient are left out where it
/// is longer by far more than rounding.
/// square  |a|^2 [m^2/s^4]
Real least_of_acceleration(Real step, Real h, Real square) {
  const Real squared = 16 * step * step;
  constexpr Real margin = 1 + 1e-6;
  if (!(square > 0) || h * h > margin * square * (squared * squared)) return step;
  return std::min(step, 0.25 * std::sqrt(h / std::sqrt(square)));
}

}  // namespace

/// True if the lists of all ranks hold every pair within reach at the present positions, and the
/// copies every particle that they need. One reduction.
template <int Dim>
bool SphParticles<Dim>::lists_hold() const {
  const bool mine_hold = watch_.covers(places(), smoothing_length_) && images_hold();
  return ranks_->alone() ? mine_hold : sums_hold(mine_hold);
}

/// An exact check, so that no list is late however far a step or its supports have moved the
/// particles.
template <int Dim>
void SphParticles<Dim>::renew_lists() {
  if (held_) return;
  const bool woken = rides() && take_over();
  if (rides()) follow_nodes();
  refresh_places();
  if (woken || !lists_hold()) rearrange();
}

template <int Dim>
void SphParticles<Dim>::set_skin(Real skin) {
  skin_ratio_ = skin;
  rearrange();
}

template <int Dim>
void SphParticles<Dim>::label_sums() {
  constexpr Label kAsleep = Label{1} << 31;  // each in a sum of its own
  sum_ = points_.body;
  for (std::size_t i = 0; i < sum_.size(); ++i) {
    if (!sum_of_piece_.empty()) sum_[i] = sum_of_piece_[points_.piece[i]];
    if (i < n_owned() && sleeps(i)) sum_[i] = kAsleep + static_cast<Label>(i);
  }
}

template <int Dim>
void SphParticles<Dim>::rearrange() {
  settled_ = keeps_total_rows_ = false;
  Real longest = 0;
  for (std::size_t i = 0; i < n_owned(); ++i) longest = std::max(longest, smoothing_length_[i]);
  longest = ranks_->max(longest);
  const Real skin = skin_ratio_ * longest;
  images_.clear();
  label_sums();
  refresh_places();
  const Real reach = longest + skin + (mirrors_.any() ? depth_behind_mirrors() : 0);
  if (!ranks_->alone()) {
    renew_ghosts(skin, reach);
    label_sums();
    refresh_places();
  }
  renew_images(reach);
  rows_.forget();
  rows_.assign(shared_neighbours<Dim>(places(), smoothing_length_, sum_, skin, points_.n_owned,
                                      NeighbourRows<Dim>::kShare, search_));
  if (!ranks_->alone()) rows_.merge_copies(ids_in_rows(), points_.n_owned);
  watch_.start(places(), sum_, smoothing_length_, skin);
  still_.start(watch_, n_owned());
  ++n_searches_;
}

/// What conducts is computed always: its temperatures move the stress of what lies still.
template <int Dim>
bool SphParticles<Dim>::is_left_out(const ParticleBlock& block, LocalIndex i) const {
  return still_.leaves_out(i) && !block.set.conducts;
}

template <int Dim>
bool SphParticles<Dim>::tile_is_left_out(const ParticleBlock& block, std::size_t first) const {
  if (still_.count() == 0) return false;
  const auto& particle = block.set.particle;
  const auto begin = particle.begin() + static_cast<std::ptrdiff_t>(first);
  const auto n = static_cast<std::ptrdiff_t>(std::min(particle.size() - first, std::size_t{kTile}));
  return std::all_of(begin, begin + n, [&](LocalIndex i) { return is_left_out(block, i); });
}

/// Of the undamped limit of a lattice: what is left for disorder, and where the lattice is that of
/// time 0 for ever.
constexpr Real kDisorder = 0.5, kOrder = 0.9;

/// Of the bound of thin bodies: shear beside it, rows that are no boxes and disorder take up to 7%.
constexpr Real kThinFactor = 0.93;

template <int Dim>
Real shear_share(const Material& material, const ParticleState<Dim>& state) {
  return 2 * material.shear * state.ratio /
         (material.density * state.sound_speed * state.sound_speed);
}

template <int Dim>
void SphParticles<Dim>::find_spread(const ParticleBlock& block, LocalIndex i) {
  auto& state = state_[i];
  state.spread = {};
  if (!(frobenius_square<Dim>(state.correction) > kSteepCorrection)) return;
  state.spread = with_kernel(block.set.options.kernel, [&]<class Kernel>(Kernel) {
    return inverse_spread<Dim, Kernel>(motion_.data(), i, rows_.row(i),
                                       shear_share(*block.set.material, state), thin_of(i));
  });
}

/// Half of a h/c_eff with c_eff = c + |v_ij| + 1.2 (alpha c + beta max |mu_ij|), a from the
/// dispersion of the kernel on a lattice, half for disorder; and 0.25 sqrt(h/|a_i|).
/// docs/theory/sph.md (S21) to (S24).
template <int Dim>
StepLimit SphParticles<Dim>::stable_step() const {
  if (held_) return {};
  const auto bound = [&](std::size_t i) {
    const SphOptions& options = blocks_[block_of_[i]].set.options;
    const auto& state = state_[i];
    const Real h = smoothing_length_[i];
    const Real factor =
        with_kernel(options.kernel, [](auto kernel) { return decltype(kernel)::kStepFactor; });
    const Real viscous =
        options.viscosity.alpha * state.sound_speed + options.viscosity.beta * state.mu;
    const Real speed = state.sound_speed + state.speed + 1.2 * viscous;
    const Vec<Dim>& a = rides() ? carrier_->carrying_points().a[node_[i]] : points_.a[i];
    const Real share = options.formulation == SphFormulation::total ? kOrder : kDisorder;
    Real length = share * factor * h;
    if (state.spread.trace != 0 || state.spread.largest != 0) {
      const Material& material = *blocks_[block_of_[i]].set.material;
      const Real stiffness = state.spread.stiffness(shear_share(material, state));
      length = std::min(length, 2 * kThinFactor / std::sqrt(stiffness));
    }
    const Real step = is_total(i) ? bound_of_total(i, length / speed) : length / speed;
    return least_of_acceleration(step, h, dot<Dim>(a, a));
  };
  return over_chunks(
      n_owned(), StepLimit{},
      [&](StepLimit& own, std::size_t i) {
        fetch_line(state_[std::min(i + kFetchAhead, n_owned() - 1)].start_volume);
        if (sleeps(i) || is_gone(i)) return;
        const Real step = bound(i);  // a step that is not a number collapses the run at once
        own.take({step > 0 ? step : 0.0, "particle", points_.body[i], points_.id[i]});
      },
      [](StepLimit& all, const StepLimit& own) { all.take(own); });
}

template bool SphParticles<2>::lists_hold() const;
template bool SphParticles<3>::lists_hold() const;
template void SphParticles<2>::renew_lists();
template void SphParticles<3>::renew_lists();
template void SphParticles<2>::set_skin(Real);
template void SphParticles<3>::set_skin(Real);
template void SphParticles<2>::label_sums();
template void SphParticles<3>::label_sums();
template void SphParticles<2>::rearrange();
template void SphParticles<3>::rearrange();
template bool SphParticles<2>::is_left_out(const ParticleBlock&, LocalIndex) const;
template bool SphParticles<3>::is_left_out(const ParticleBlock&, LocalIndex) const;
template bool SphParticles<2>::tile_is_left_out(const ParticleBlock&, std::size_t) const;
template bool SphParticles<3>::tile_is_left_out(const ParticleBlock&, std::size_t) const;
template void SphParticles<2>::find_spread(const ParticleBlock&, LocalIndex);
template void SphParticles<3>::find_spread(const ParticleBlock&, LocalIndex);
template StepLimit SphParticles<2>::stable_step() const;
template StepLimit SphParticles<3>::stable_step() const;

}  // namespace brunt
