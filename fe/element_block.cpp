#include "fe/element_block.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <string>

#include "core/errors.hpp"
#include "core/parallel/threads.hpp"
#include "fe/elements/catalog.hpp"
#include "fe/initial_stress.hpp"
#include "fe/initial_temperature.hpp"

namespace brunt {
namespace {

Hourglass resolved(const Hourglass& hourglass, const Material& material) {
  if (!std::holds_alternative<AutomaticHourglass>(hourglass)) return hourglass;
  if (material.yields() || material.shear == 0) return ViscousHourglass{};
  return AssumedStrainHourglass{};
}

[[noreturn]] void report_inverted(GlobalId id, Real volume) {
  throw PhysicsError({0, "", "element " + std::to_string(id), "volume", volume,
                      "the element is inverted at the start: check the order of its corners"});
}

template <int Dim>
void copy_elements(const ElementSet<Dim>& set, ElementBlock<Dim>& block) {
  const auto n = slot_of(block.corners);
  const auto padded = slot_of(block.n_padded);
  block.corner.resize(padded * n);
  block.id.resize(padded);
  block.body.resize(padded);
  block.piece.resize(padded);
  for (std::size_t e = 0; e < padded; ++e) {
    const std::size_t from = std::min(e, set.id.size() - 1);
    std::copy_n(set.corners[from].begin(), n, block.corner.begin() + static_cast<long>(e * n));
    block.id[e] = set.id[from];
    block.body[e] = set.body[from];
    block.piece[e] = set.piece[from];
  }
}

/// The set with its elements by ascending id.
template <int Dim>
ElementSet<Dim> in_order(const ElementSet<Dim>& set) {
  std::vector<std::size_t> order(set.id.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return set.id[a] < set.id[b]; });
  ElementSet<Dim> sorted = set;
  for (std::size_t e = 0; e < order.size(); ++e) {
    sorted.corners[e] = set.corners[order[e]];
    sorted.id[e] = set.id[order[e]];
    sorted.body[e] = set.body[order[e]];
    sorted.piece[e] = set.piece[order[e]];
    if (!set.owned.empty()) sorted.owned[e] = set.owned[order[e]];
  }
  return sorted;
}

/// Reference volumes and masses of the four elements from e on; which is the first of them without
/// volume, kLanes where all have some.
template <int Dim>
int measure_four(const Points<Dim>& points, const Thickness& thickness, ElementBlock<Dim>& block,
                 std::size_t e) {
  const Formulation<Dim>& kind = *block.formulation;
  const auto of = kind.parts_of_four(block, e, points, thickness);
  std::array<Real, kLanes> volume{};
  // By the arithmetic of the steps: what has not moved is not strained by a rounding.
  if (block.gauss == 1) volume = kind.step_volumes(block, e, points, thickness);
  int wrong = kLanes;
  for (int lane = kLanes - 1; lane >= 0; --lane) {
    const PartVolumes& parts = of[lane];
    const auto k = static_cast<LocalIndex>(e) + lane;
    const auto places = [&] { return corner_positions(block, k, points); };
    if (block.gauss > 1) volume[lane] = kind.volume(places(), false, thickness);
    block.element_volume[k] = volume[lane];
    block.mass[k] = block.material->density * parts.sum();
    const Real size = Dim == 3 ? volume[lane] : kind.volume(places(), true, Thickness{1, 0});
    block.reference_size[k] = Dim == 3 ? std::cbrt(size) : std::sqrt(size);
    for (int g = 0; g < block.gauss; ++g) {
      block.reference_volume[block.point(k, g)] = block.gauss == 1 ? volume[lane] : parts.part[g];
    }
    const Real least = *std::min_element(parts.part.begin(), parts.part.begin() + parts.n);
    if (!(volume[lane] > 0) || (block.gauss > 1 && !(least > 0))) wrong = lane;
  }
  return wrong;
}

/// Reference volumes and masses. Throws at the first element in order of storage without volume.
template <int Dim>
void measure_elements(const Points<Dim>& points, const Thickness& thickness,
                      ElementBlock<Dim>& block) {
  const auto padded = slot_of(block.n_padded);
  block.reference_volume.resize(padded * slot_of(block.gauss));
  block.element_volume.resize(padded);
  block.reference_size.resize(padded);
  block.mass.resize(padded);
  std::atomic<LocalIndex> wrong{block.n_padded};
  for_each(block.n_padded / kLanes, kPointsWorthThreads / kLanes, [&](LocalIndex four) {
    const LocalIndex e = four * kLanes;
    const int lane = measure_four(points, thickness, block, slot_of(e));
    if (lane == kLanes) return;
    LocalIndex first = wrong;
    while (e + lane < first && !wrong.compare_exchange_weak(first, e + lane)) {
    }
  });
  if (wrong < block.n_padded) report_inverted(block.id[wrong], block.element_volume[wrong]);
}

}  // namespace

Thickness thickness_of(Geometry geometry, Real depth) {
  switch (geometry) {
    case Geometry::plane_strain:
      return {depth, 0};
    case Geometry::axisymmetric:
      return {0, 2 * kPi};
    case Geometry::three_d:
      break;
  }
  return {1, 0};
}

template <int Dim>
std::vector<LocalIndex> axis_nodes(const Points<Dim>& points, const Thickness& thickness) {
  std::vector<LocalIndex> nodes;
  if (thickness.radial == 0) return nodes;
  Real largest = 0;
  for (const auto& x : points.x) largest = std::max(largest, std::abs(x[0]));
  for (LocalIndex k = 0; k < points.size(); ++k) {
    if (std::abs(points.x[k][0]) <= 1e-12 * largest) nodes.push_back(k);
  }
  return nodes;
}

template <int Dim>
ElementBlock<Dim> make_block(const ElementSet<Dim>& set, const Points<Dim>& points,
                             const Thickness& thickness) {
  if (!std::is_sorted(set.id.begin(), set.id.end())) {
    return make_block(in_order(set), points, thickness);
  }
  ElementBlock<Dim> block;
  block.material = set.material;
  block.options = set.options;
  block.options.integration = resolved(set.options, false);
  block.options.hourglass = resolved(set.options.hourglass, *set.material);
  block.formulation = &formulation_of<Dim>(set.options.type);
  block.corners = block.formulation->type().corners;
  block.gauss = block.formulation->material_points(block.options);
  block.adiabatic = set.adiabatic;
  block.conducts = set.conducts, block.held = set.held, block.rigid = set.rigid;
  block.temperature = set.temperature;
  block.stress = set.stress, block.temperature_field = set.temperature_field;
  block.n = static_cast<LocalIndex>(set.id.size());
  const int tile = block.elements_per_tile();
  block.n_padded = (block.n + tile - 1) / tile * tile;
  if (block.n == 0) return block;
  copy_elements(set, block);
  block.owned = set.owned;
  block.owned.resize(slot_of(block.n), 1);
  measure_elements(points, thickness, block);
  const auto padded = slot_of(block.n_padded);
  const bool heats = set.material->yields() || set.material->heats_by_compression();
  block.state = set.material->initial_state(
      padded * slot_of(block.gauss), set.temperature,
      set.adiabatic || (set.conducts && set.material->keeps_temperature()));
  for (LocalIndex e = 0; e < block.n_padded && !block.state.length.empty(); ++e) {
    for (int g = 0; g < block.gauss; ++g) {
      block.state.length[block.point(e, g)] = block.reference_size[e];
    }
  }
  if (block.conducts) {
    block.heat_share = corner_shares(block, points, thickness);
    if (heats) block.heat_given.assign(padded, 0.0);
  }
  for (auto* field : {&block.viscous_pressure, &block.stress_work, &block.hourglass_work,
                      &block.viscous_work, &block.stable_step}) {
    field->assign(padded, 0.0);
  }
  const Real energy = set.material->eos->initial_energy();  // [J/m^3] that a gas can give
  for (std::size_t e = 0; e < block.id.size(); ++e) {
    block.stress_work[e] = energy * block.element_volume[e];
  }
  block.rest.assign(slot_of(block.n_tiles()), Rest::unknown);
  if (block.formulation->averages_volumes()) block.volume_ratio.assign(padded, 1.0);
  if (block.temperature_field != nullptr) begin_temperatures(points, block);
  if (block.stress != nullptr) begin_under_stress(points, block);
  block.formulation->start(points, block);
  return block;
}

template <int Dim>
std::vector<Real> corner_shares(const ElementBlock<Dim>& block, const Points<Dim>& points,
                                const Thickness& thickness) {
  std::vector<Real> shares(block.corner.size());
  for (LocalIndex e = 0; e < block.n_padded; ++e) {
    std::array<Real, kMostCorners> part{};
    const Real whole = block.formulation->add_corner_volumes(corner_positions(block, e, points),
                                                             thickness, 1, part.data());
    for (std::size_t I = 0; I < slot_of(block.corners); ++I) {
      shares[block.heat_share_at(slot_of(e), I)] = part[I] / whole;
    }
  }
  return shares;
}

template <int Dim>
void corner_masses(const ElementBlock<Dim>& block, LocalIndex e, const Points<Dim>& points,
                   const Thickness& thickness, Real* share) {
  const auto n = slot_of(block.corners);
  std::fill_n(share, n, block.mass[e] / block.corners);
  if (block.gauss == 1 || thickness.radial == 0) return;
  std::fill_n(share, n, 0.0);
  const auto x = corner_positions(block, e, points);
  Real density = block.material->density;
  if (block.stress != nullptr) {
    density = block.material_mass(slot_of(e)) / block.formulation->volume(x, false, thickness);
  }
  block.formulation->add_corner_volumes(x, thickness, density, share);
  if (block.mass_scale.empty()) return;
  const Real scale = block.mass_scale[slot_of(e)];
  for (std::size_t I = 0; I < n; ++I) share[I] *= scale;
}

template std::vector<LocalIndex> axis_nodes(const Points<2>&, const Thickness&);
template std::vector<LocalIndex> axis_nodes(const Points<3>&, const Thickness&);
template ElementBlock<2> make_block(const ElementSet<2>&, const Points<2>&, const Thickness&);
template ElementBlock<3> make_block(const ElementSet<3>&, const Points<3>&, const Thickness&);
template std::vector<Real> corner_shares(const ElementBlock<2>&, const Points<2>&,
                                         const Thickness&);
template std::vector<Real> corner_shares(const ElementBlock<3>&, const Points<3>&,
                                         const Thickness&);
template void corner_masses(const ElementBlock<2>&, LocalIndex, const Points<2>&, const Thickness&,
                            Real*);
template void corner_masses(const ElementBlock<3>&, LocalIndex, const Points<3>&, const Thickness&,
                            Real*);

}  // namespace brunt
