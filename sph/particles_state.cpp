/// What particles carry from step to step, as tables by the ids of their points. The records that
/// neighbours read, smoothing lengths and lists follow from it.
#include "core/points_state.hpp"
#include "sph/particle_values.hpp"

namespace brunt {
namespace {

constexpr const char* kTotalTable = "particles.total";

/// A name for all blocks whose material points have rows of the same columns, and as many of them.
std::string table_of(const ParticleBlock& block) {
  StateCounter values;
  if (!block.set.particle.empty()) visit_slot(block, 0, saved_in(values));
  return "particle.material" + fields_of(block.state) + (block.heat_given.empty() ? "" : ".given") +
         "." + std::to_string(values.count);
}

}  // namespace

/// Those of formulation: total, ascending.
template <int Dim>
std::vector<LocalIndex> SphParticles<Dim>::total_particles() const {
  std::vector<LocalIndex> total;
  for (std::size_t i = 0; i < n_owned(); ++i) {
    if (is_total(i)) total.push_back(static_cast<LocalIndex>(i));
  }
  return total;
}

template <int Dim>
void SphParticles<Dim>::save_state(std::vector<StateTable>& tables) const {
  save_points(points_, tables);
  save_rows(
      "particles.state", points_.owned(), [&](std::size_t i) { return points_.id[i]; },
      [&](auto& row, std::size_t i) {
        visit_particle(state_[i], spacing_[i], artificial_of(i), saved_in(row));
      },
      tables);
  const std::vector<LocalIndex> total = total_particles();
  save_rows(
      kTotalTable, total.size(), [&](std::size_t k) { return points_.id[total[k]]; },
      [&](auto& row, std::size_t k) { visit_total(total_[total[k]], saved_in(row)); }, tables);
  for (const auto& block : blocks_) {
    const auto& particle = block.set.particle;  // of owned ones: copies are in no block
    save_rows(
        table_of(block), particle.size(),
        [&](std::size_t slot) { return points_.id[particle[slot]]; },
        [&](auto& row, std::size_t slot) { visit_slot(block, slot, saved_in(row)); }, tables);
  }
}

template <int Dim>
void SphParticles<Dim>::load_state(const StateTables& tables) {
  load_points(points_, tables);
  load_rows(
      "particles.state", n_owned(), [&](std::size_t i) { return points_.id[i]; },
      [&](auto& row, std::size_t i) {
        ArtificialChannel<Dim> artificial;
        visit_particle(state_[i], spacing_[i], artificial, saved_in(row));
        if (!channel_.empty()) channel_[i] = artificial;
      },
      tables);
  const std::vector<LocalIndex> total = total_particles();
  load_rows(
      kTotalTable, total.size(), [&](std::size_t k) { return points_.id[total[k]]; },
      [&](auto& row, std::size_t k) { visit_total(total_[total[k]], saved_in(row)); }, tables);
  for (auto& block : blocks_) {
    const auto& particle = block.set.particle;
    load_rows(
        table_of(block), particle.size(),
        [&](std::size_t slot) { return points_.id[particle[slot]]; },
        [&](auto& row, std::size_t slot) { visit_slot(block, slot, saved_in(row)); }, tables);
  }
  for (std::size_t i = 0; i < n_owned(); ++i) set_size(i);
}

template void SphParticles<2>::save_state(std::vector<StateTable>&) const;
template void SphParticles<3>::save_state(std::vector<StateTable>&) const;
template void SphParticles<2>::load_state(const StateTables&);
template void SphParticles<3>::load_state(const StateTables&);

}  // namespace brunt
// Tested by tests/unit/sph/state_test.cpp.
