#include "sph/particles.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "sph/correction.hpp"
#include "sph/parallel.hpp"

namespace brunt {

template <int Dim>
SphParticles<Dim>::SphParticles(Points<Dim> points, std::span<const Real> spacing,
                                std::vector<ParticleSet> sets, Real depth,
                                std::vector<Label> sum_of_piece, Mirrors<Dim> mirrors)
    : points_(std::move(points)),
      depth_(Dim == 2 ? depth : 1.0),
      sum_of_piece_(std::move(sum_of_piece)),
      mirrors_(std::move(mirrors)) {
  assert(spacing.size() == points_.x.size());
  assert(std::is_sorted(points_.id.begin(), points_.id.end()));
  compress_masses(sets);
  take_sets(std::move(sets), spacing);
  if (any_single()) unit_ = SingleUnit(least_single_spacing());
  const auto conducts = [](const auto& block) { return block.set.conducts; };
  const bool any_conducts = std::any_of(blocks_.begin(), blocks_.end(), conducts);
  if (any_conducts) set_capacities();
  const auto held = [](const auto& block) { return block.set.held; };
  held_ = surface_.held = !blocks_.empty() && std::all_of(blocks_.begin(), blocks_.end(), held);
  rearrange();
  seed_step_limits();
  if (any_conducts) start_conduction();
}

/// Room for particles, owned and copies, and for what sums read of them and of their images.
template <int Dim>
void SphParticles<Dim>::hold(std::size_t n_points, std::size_t n_all) {
  state_.resize(n_points);
  if (any_artificial() || wants_total()) channel_.resize(n_points);
  if (wants_total()) total_.resize(n_points), total_record_.resize(n_all);
  if (wants_total() || mirrors_.any()) place_.resize(n_all);
  smoothing_length_.resize(n_all);
  motion_.resize(n_all);
  stress_.resize(n_all);
  if (any_artificial()) artificial_.resize(n_all);
  if (!any_single()) return;
  single_motion_.resize(n_all);
  single_stress_.resize(n_all);
  if (any_artificial()) single_artificial_.resize(n_all);
}

template <int Dim>
void SphParticles<Dim>::take_sets(std::vector<ParticleSet> sets, std::span<const Real> spacing) {
  hold(n_owned(), n_owned());
  block_of_.resize(n_owned());
  spacing_.assign(spacing.begin(), spacing.end());
  surface_.points = &points_;
  surface_.particles.resize(n_owned());
  for (auto& set : sets) {
    const Material& material = *set.material;
    ParticleMatter shown{material.modulus()};
    if (set.conducts) {
      shown.conductivity = material.conductivity.at(set.temperature);
      shown.effusivity = material.effusivity(set.temperature);
    }
    const auto matter = surface_.place_of(shown);
    for (const LocalIndex i : set.particle) {
      const auto k = slot_of(i);
      block_of_[k] = static_cast<std::uint16_t>(blocks_.size());
      auto& state = state_[k];
      state.start_volume = state.volume = points_.mass[k] / material.density;
      state.stress_work = material.eos->initial_energy() * state.start_volume;
      state.sound_speed = std::sqrt(material.modulus() / material.density);
      surface_.particles[k] = {i, false, matter, 0.5 * spacing[k]};
    }
    const bool heats = material.yields() || material.heats_by_compression();
    MaterialState state =
        material.initial_state(set.particle.size(), set.temperature,
                               set.adiabatic || (set.conducts && material.keeps_temperature()));
    for (std::size_t slot = 0; slot < set.particle.size() && !state.length.empty(); ++slot) {
      state.length[slot] = spacing[slot_of(set.particle[slot])];
    }
    std::vector<Real> given;
    if (set.conducts && heats) given.assign(set.particle.size(), 0.0);
    blocks_.push_back({std::move(set), std::move(state), std::move(given)});
    begin_temperatures(blocks_.back());
    begin_under_stress(blocks_.back());
    for (const LocalIndex i : blocks_.back().set.particle) set_size(slot_of(i));
  }
  hold(n_owned(), n_owned());  // what the sets need
  if (any_total()) start_total();
}

/// docs/theory/sph.md (S5).
/// The smoothing length follows the volume. The contact radius does not: its spring is that of the
/// reference geometry, or it would have no potential.
template <int Dim>
void SphParticles<Dim>::set_size(std::size_t i) {
  const SphOptions& options = blocks_[block_of_[i]].set.options;
  const Real ratio = state_[i].ratio;
  Real size = spacing_[i];
  if (options.adaptive_h && options.formulation == SphFormulation::updated)
    size *= Dim == 2 ? std::sqrt(ratio) : std::cbrt(ratio);
  smoothing_length_[i] = options.smoothing * size;
}

template <int Dim>
void SphParticles<Dim>::refresh_motion() {
  using Record = MotionRecord<Dim>;
  refresh_places();
  const std::span<const Vec<Dim>> place = places();
  for_each(points_.x.size(), [&](std::size_t i) {
    Real* record = motion_[i].data;
    for (int d = 0; d < Dim; ++d) {
      record[d] = place[i][d];
      record[Record::kVelocity + d] = points_.v[i][d];
    }
    const bool total = is_total(i);
    record[Record::kInverse] = 1.0 / smoothing_length_[i];
    record[Record::kVolume] = (total ? total_[i].seen : state_[i].volume) / depth_;
    stress_[i].data[StressRecord<Dim>::kDensity] =
        weighed_mass(i) / (total ? total_[i].volume : state_[i].volume);
    if (!single_motion_.empty()) set_single_motion(i);
  });
  reflect_motion();
}

/// What of the spin w = curl v / 2 no shear accounts for: w max(0, 1 - 2 s/|w|), s^2 = D':D'/2 of
/// the trace-free rate of strain. All of it where the material only turns; none in simple shear,
/// where s = |w|, nor in what shears half as fast as it turns: under a surface that is rubbed,
/// turning is the slip itself.
template <int Dim>
void SphParticles<Dim>::publish_spins() {
  surface_.spin.resize(n_owned());
  for_each(n_owned(), [&](std::size_t i) {
    Mat3 L = Mat3::Zero();
    for (int c = 0; c < Dim * Dim; ++c) L(c / Dim, c % Dim) = state_[i].velocity_gradient[c];
    const Vec3 spin = 0.5 * Vec3(L(2, 1) - L(1, 2), L(0, 2) - L(2, 0), L(1, 0) - L(0, 1));
    Real square = -(L(0, 0) + L(1, 1) + L(2, 2)) * (L(0, 0) + L(1, 1) + L(2, 2)) / Dim;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) square += 0.25 * (L(a, b) + L(b, a)) * (L(a, b) + L(b, a));
    }
    const Real size = spin.norm(), shear = std::sqrt(0.5 * std::max(square, 0.0));
    surface_.spin[i] = size > 2 * shear ? Vec3((1 - 2 * shear / size) * spin) : Vec3(Vec3::Zero());
  });
}

/// What friction sees of each particle; that of a rider stands with its node.
template <int Dim>
void SphParticles<Dim>::publish_materials() {
  auto* const all = rides() ? carrier_->shown_materials() : &surface_.particle_material;
  if (all == nullptr) return;
  if (!rides()) all->resize(n_owned());
  for (const auto& block : blocks_) {
    const auto& state = block.state;
    const auto& strength = *block.set.material->strength;
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const auto i = slot_of(block.set.particle[slot]);
      const auto at = rides() ? slot_of(node_[i]) : i;
      if (sleeps(i) || at >= all->size()) return;
      auto& shown = (*all)[at];
      shown.temperature =
          state.temperature.empty() ? block.set.temperature : state.temperature[slot];
      shown.flow_stress = strength.flow_stress(state, slot, block.set.temperature);
    });
  }
}

template <int Dim>
void SphParticles<Dim>::update_state(Real dt) {
  if (points_.conducts) take_temperatures();
  if (held_) {
    if (!settled_) refresh_motion(), refresh_gradients();
    settled_ = true;
    if (surface_.needs_material) publish_materials();
    return;
  }
  refresh_motion();
  move_with_neighbours(dt);
  if (!rides()) still_.look(watch_, points_, images_);
  refresh_gradients();
  if (any_total()) advance_total(dt);
  if (surface_.needs_spin) publish_spins();
  for (auto& block : blocks_) {
    const std::size_t n_tiles = block.state.size() / kTile;
    for_each(n_tiles, [&](std::size_t tile) {
      const std::size_t first = tile * kTile;
      if (rides() ? tile_sleeps(block, first) : tile_is_left_out(block, first)) return;
      update_tile(block, first, dt);
    });
  }
  if (any_total()) refresh_total_records();
  if (surface_.needs_material || rides()) publish_materials();
}

template class SphParticles<2>;
template class SphParticles<3>;

}  // namespace brunt
