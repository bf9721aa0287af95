/// Particles of formulation: total. docs/theory/sph.md, section 13.
#include "sph/parallel.hpp"
#include "sph/particles.hpp"
#include "sph/tile_passes.hpp"

namespace brunt {

namespace {

template <int Dim>
using RowMatrix = typename TotalState<Dim>::Matrix;

bool is_total_block(const ParticleBlock& block) {
  return block.set.options.formulation == SphFormulation::total;
}

/// [1] of F; rounding takes nothing below 0.
template <int Dim>
Real least_stretch(const RowMatrix<Dim>& gradient) {
  const Eigen::Matrix<Real, Dim, Dim> square = gradient.transpose() * gradient;
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, Dim, Dim>> solver;
  solver.computeDirect(square, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(solver.eigenvalues()[0], 0.0));
}

/// [1] What of a point has not failed.
Real sound_share(const MaterialState& state, std::size_t slot) {
  return state.damage.empty() ? 1.0 : 1.0 - state.damage[slot];
}

/// Of a viscosity rho c dp.
constexpr Real kHourglassDamping = 0.25;

}  // namespace

template <int Dim>
bool SphParticles<Dim>::wants_total() const {
  return std::any_of(blocks_.begin(), blocks_.end(), is_total_block);
}

template <int Dim>
void SphParticles<Dim>::start_total() {
  for (const auto& block : blocks_) {
    if (!is_total_block(block)) continue;
    for (const LocalIndex i : block.set.particle) {
      total_[i].volume = total_[i].seen = state_[i].volume;
    }
  }
}

template <int Dim>
void SphParticles<Dim>::refresh_places() {
  if (place_.empty()) return;
  for_each(points_.x.size(),
           [&](std::size_t i) { place_[i] = is_total(i) ? points_.x_start[i] : points_.x[i]; });
  place_images();
}

template <int Dim>
LocalIndex SphParticles<Dim>::thin_total() const {
  for (std::size_t i = 0; i < is_thin_.size(); ++i) {
    if (is_thin_[i] && is_total(i)) return static_cast<LocalIndex>(i);
  }
  return -1;
}

/// F(n+1) = F(n) + dt dF/dt, and L = (dF/dt) F^-1 at the end of the step in place of dF/dt. What is
/// crushed, or has failed and is open, stays as it is, and goes from the sums of the next step on.
/// docs/theory/sph.md (S30), (S31).
template <int Dim>
void SphParticles<Dim>::advance_total(Real dt) {
  for (const auto& block : blocks_) {
    if (!is_total_block(block)) continue;
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const LocalIndex i = block.set.particle[slot];
      if (is_left_out(block, i)) return;
      const bool failed = !(sound_share(block.state, slot) > 0);
      Eigen::Map<RowMatrix<Dim>> rate(state_[slot_of(i)].velocity_gradient);
      auto& total = total_[slot_of(i)];
      const RowMatrix<Dim> gradient = total.gradient + dt * rate;
      const Real growth = gradient.determinant();
      const Real stretch = growth > 0 ? least_stretch<Dim>(gradient) : 0;
      const bool open = failed && growth > kOpen;
      if (is_gone(slot_of(i)) || open || !(stretch > kCrushed) || is_thin_[slot_of(i)]) {
        total.seen = 0;
        rate.setZero();
        return;
      }
      total.gradient = gradient, total.stretch = stretch;
      rate = (rate * gradient.inverse()).eval();
    });
  }
}

/// V/V0 is that of F, to rounding that of all steps: strains of a step may be limited (S10).
template <int Dim>
void SphParticles<Dim>::set_total_volumes(const ParticleBlock& block, std::size_t first,
                                          TileStress<Dim>& stress, MaterialTile& tile) const {
  const std::size_t n = std::min(block.set.particle.size() - first, std::size_t{kTile});
  for (std::size_t slot = 0; slot < n; ++slot) {
    const auto i = slot_of(block.set.particle[first + slot]);
    const Real ratio = total_[i].gradient.determinant() * total_[i].volume / state_[i].start_volume;
    if (!(ratio > 0)) continue;
    tile.ratio[slot] = ratio, stress.growth[slot] = ratio / tile.ratio_old[slot];
  }
}

/// P K = J sigma F^-T K of each, which neighbours read with the volumes of time 0; of what
/// goes nothing, as it takes part in no strain.
/// docs/theory/sph.md (S32).
template <int Dim>
void SphParticles<Dim>::form_total_stress(const ParticleBlock& block, std::size_t first,
                                          TileStress<Dim>& tile) const {
  const std::size_t n = std::min(block.set.particle.size() - first, std::size_t{kTile});
  for (std::size_t slot = 0; slot < n; ++slot) {
    const auto i = slot_of(block.set.particle[first + slot]);
    const RowMatrix<Dim>& F = total_[i].gradient;
    const RowMatrix<Dim> cofactor = F.determinant() * F.inverse().transpose();
    const RowMatrix<Dim> sigma = stress_of<Dim>(block.state, first + slot);
    RowMatrix<Dim> pair = sigma * (cofactor * full_matrix<Dim>(state_[i].correction));
    if (is_gone(i)) pair.setZero();
    for (int c = 0; c < Dim * Dim; ++c) tile.corrected[c][slot] = pair(c / Dim, c % Dim);
  }
}

/// Of owned particles, all but their places.
template <int Dim>
void SphParticles<Dim>::refresh_total_records() {
  using Record = TotalRecord<Dim>;
  for (const auto& block : blocks_) {
    if (!is_total_block(block)) continue;
    const Material& material = *block.set.material;
    const Real share = block.set.options.hourglass / 100;
    const bool yields = material.yields();
    const Real impedance = std::sqrt(material.density * material.modulus());
    for_each(block.set.particle.size(), [&](std::size_t slot) {
      const auto i = slot_of(block.set.particle[slot]);
      const Real sound = sound_share(block.state, slot);
      const Real stiffness = yields ? 0.0 : share * sound * material.shear;
      const Real damping =
          yields ? share * sound * (kHourglassDamping * impedance * spacing_[i]) : 0.0;
      const Eigen::Map<const RowMatrix<Dim>> L(state_[i].velocity_gradient);
      const RowMatrix<Dim>& F = total_[i].gradient;
      const RowMatrix<Dim> affine = stiffness * F + damping * (L * F);
      Real* record = total_record_[i].data;
      for (int c = 0; c < Dim * Dim; ++c) record[Record::kAffine + c] = affine(c / Dim, c % Dim);
      record[Record::kStiffness] = stiffness, record[Record::kDamping] = damping;
      record[Record::kSound] = sound;
    });
  }
}

template <int Dim>
void SphParticles<Dim>::refresh_total_ghosts() {
  if (ranks_->alone() || !any_total()) return;
  constexpr std::size_t width = Dim * Dim + 3;
  refresh_ghosts(
      *ranks_, ghosts_, width + 1,
      [&](std::size_t i, Real* out) {
        out = std::copy_n(total_record_[i].data + Dim, width, out);
        *out = total_[i].seen;
      },
      [&](std::size_t i, const Real* in) {
        std::copy_n(in, width, total_record_[i].data + Dim);
        total_[i].seen = in[width];
      });
}

/// Where particles are now, copies and images too.
template <int Dim>
void SphParticles<Dim>::place_total_records() {
  const std::size_t n = points_.x.size();
  for_each(total_record_.size(), [&](std::size_t i) {
    const Vec<Dim> x = i < n
                           ? points_.x[i]
                           : mirrors_.reflected(points_.x[images_[i - n].of], images_[i - n].axes);
    for (int d = 0; d < Dim; ++d) total_record_[i].data[d] = x[d];
  });
}

/// docs/theory/sph.md (S32) to (S34).
template <int Dim>
ForceSums<Dim> SphParticles<Dim>::total_forces(const ParticleBlock& block, LocalIndex i,
                                               const MonaghanViscosity& viscosity) {
  const ForceRecords<Dim> records{motion_.data(), stress_.data(), nullptr};
  const auto row = rows_.row(i);
  const TotalSums<Dim> sums = with_kernel(block.set.options.kernel, [&]<class Kernel>(Kernel) {
    return sum_total<Dim, Kernel>(records, total_record_.data(), i, row, rows_.weights(i),
                                  {viscosity.alpha, viscosity.beta, 1});
  });
  auto& total = total_[slot_of(i)];
  total.stiffness_sum = sums.stiffness, total.damping_sum = sums.damping;
  return sums.forces;
}

/// What the shortest stretch and the forces of (S33) leave of a step [s] of the places of time 0.
/// docs/theory/sph.md (S35).
template <int Dim>
Real SphParticles<Dim>::bound_of_total(std::size_t i, Real step) const {
  const auto& total = total_[i];
  const Real density = points_.mass[i] / total.volume, rate = 1 / (total.stretch * step);
  return 1 / (std::sqrt(rate * rate + total.stiffness_sum / (2 * density)) +
              total.damping_sum / density);
}

#define BRUNT_TOTAL(Dim)                                                                     \
  template bool SphParticles<Dim>::wants_total() const;                                      \
  template void SphParticles<Dim>::start_total();                                            \
  template void SphParticles<Dim>::refresh_places();                                         \
  template LocalIndex SphParticles<Dim>::thin_total() const;                                 \
  template void SphParticles<Dim>::advance_total(Real);                                      \
  template void SphParticles<Dim>::set_total_volumes(const ParticleBlock&, std::size_t,      \
                                                     TileStress<Dim>&, MaterialTile&) const; \
  template void SphParticles<Dim>::form_total_stress(const ParticleBlock&, std::size_t,      \
                                                     TileStress<Dim>&) const;                \
  template void SphParticles<Dim>::refresh_total_records();                                  \
  template void SphParticles<Dim>::refresh_total_ghosts();                                   \
  template void SphParticles<Dim>::place_total_records();                                    \
  template ForceSums<Dim> SphParticles<Dim>::total_forces(const ParticleBlock&, LocalIndex,  \
                                                          const MonaghanViscosity&);         \
  template Real SphParticles<Dim>::bound_of_total(std::size_t, Real) const;
BRUNT_TOTAL(2)
BRUNT_TOTAL(3)
#undef BRUNT_TOTAL

}  // namespace brunt
// Tested by tests/verification/total_particles_test.cpp.
