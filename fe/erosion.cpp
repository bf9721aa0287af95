#include "fe/erosion.hpp"

#include <algorithm>
#include <cmath>

#include "fe/formulation.hpp"

namespace brunt {
namespace {

/// Mean of a field over the material points of an element, by their volumes at time 0.
template <int Dim>
Real mean_over(const ElementBlock<Dim>& block, LocalIndex e, const std::vector<Real>& field) {
  Real sum = 0, volume = 0;
  for (int g = 0; g < block.gauss; ++g) {
    const std::size_t k = block.point(e, g);
    sum += block.reference_volume[k] * field[k];
    volume += block.reference_volume[k];
  }
  return sum / volume;
}

/// A block without the state of its elements: what decides which faces are outer ones.
template <int Dim>
ElementBlock<Dim> without_state(const ElementBlock<Dim>& block) {
  ElementBlock<Dim> bare;
  bare.formulation = block.formulation, bare.material = block.material;
  bare.options = block.options;
  bare.corners = block.corners, bare.gauss = block.gauss;
  bare.adiabatic = block.adiabatic, bare.conducts = block.conducts;
  bare.held = block.held, bare.rigid = block.rigid;
  bare.temperature = block.temperature, bare.temperature_field = block.temperature_field;
  bare.stress = block.stress;
  return bare;
}

template <int Dim>
void copy_element(const ElementBlock<Dim>& from, LocalIndex e, ElementBlock<Dim>& to) {
  for (const LocalIndex node : from.corners_of(e)) to.corner.push_back(node);
  to.id.push_back(from.id[e]);
  to.body.push_back(from.body[e]), to.piece.push_back(from.piece[e]);
  to.n_padded = ++to.n;
}

/// What nodes of an element would be as particles: as large as their share of the smallest of those
/// about, as stiff as the stiffest.
template <int Dim>
void take_free_points(const ElementBlock<Dim>& block, const std::vector<Real>& volume,
                      std::vector<FreePoint>& free) {
  for (LocalIndex e = 0; e < block.n; ++e) {
    for (const LocalIndex node : block.corners_of(e)) {
      auto& point = free[node];
      const Real share = std::min(volume[node] / block.element_volume[e], 1.0);
      const Real radius = 0.5 * block.reference_size[e] * std::pow(share, 1.0 / Dim);
      point.radius = point.radius > 0 ? std::min(point.radius, radius) : radius;
      point.modulus = std::max(point.modulus, block.material->modulus());
      const auto& temperature = block.state.temperature;
      point.material.temperature =
          temperature.empty() ? block.temperature : temperature[block.point(e, 0)];
      const Real flow_stress =
          block.material->strength->flow_stress(block.state, block.point(e, 0), block.temperature);
      point.material.flow_stress = std::min(point.material.flow_stress, flow_stress);
      if (!block.conducts) continue;
      point.conductivity =
          std::max(point.conductivity, block.material->conductivity.at(block.temperature));
      point.effusivity = std::max(point.effusivity, block.material->effusivity(block.temperature));
    }
  }
}

}  // namespace

template <int Dim>
bool has_failed(const ElementBlock<Dim>& block, LocalIndex e) {
  constexpr Real kNothingLeft = 1 - 1e-9;  // of the stress
  const ErodeWhen& when = block.options.erosion->when;
  const MaterialState& state = block.state;
  if (when.damage && !state.damage.empty() && mean_over(block, e, state.damage) >= kNothingLeft)
    return true;
  if (when.strain && !state.eps_p.empty() && mean_over(block, e, state.eps_p) >= *when.strain)
    return true;
  return when.step && !(block.stable_step[e] >= *when.step);
}

template <int Dim>
bool ErosionState<Dim>::has_gone(GlobalId element) const {
  const auto at =
      std::lower_bound(eroded.begin(), eroded.end(), element,
                       [](const ErodedElement& one, GlobalId wanted) { return one.id < wanted; });
  return at != eroded.end() && at->id == element;
}

template <int Dim>
std::vector<ElementBlock<Dim>> ErosionState<Dim>::left() const {
  std::vector<ElementBlock<Dim>> kept;
  for (const auto& block : blocks) {
    kept.push_back(without_state(block));
    for (LocalIndex e = 0; e < block.n; ++e) {
      if (!has_gone(block.id[e])) copy_element(block, e, kept.back());
    }
  }
  return kept;
}

template <int Dim>
std::unique_ptr<ErosionState<Dim>> erosion_at_start(const std::vector<ElementBlock<Dim>>& blocks,
                                                    const Points<Dim>& points,
                                                    const Surface<Dim>& surface) {
  const auto erodes = [](const auto& block) { return block.options.erosion.has_value(); };
  if (!std::any_of(blocks.begin(), blocks.end(), erodes)) return nullptr;
  auto state = std::make_unique<ErosionState<Dim>>();
  state->start.id = points.id, state->start.x = points.x;
  state->axis = surface.axis, state->facets = surface.facets;
  state->free.resize(points.x.size());
  state->owner.assign(points.x.size(), 0);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    state->place.push_back(static_cast<LocalIndex>(i));
  }
  std::vector<Real> volume(points.x.size(), 0.0);  // [m^3] that each node stands for
  for (const auto& block : blocks) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      for (const LocalIndex node : block.corners_of(e)) {
        volume[node] += block.element_volume[e] / block.corners;
      }
    }
  }
  // The particle that a node on the axis becomes goes on behind it.
  for (const LocalIndex node : surface.axis) volume[node] *= 2;
  for (const auto& block : blocks) {
    auto& bare = state->blocks.emplace_back(without_state(block));
    take_free_points(block, volume, state->free);
    for (LocalIndex e = 0; e < block.n; ++e) {
      copy_element(block, e, bare);
      if (erodes(block)) state->to[block.body[e]] = block.options.erosion->to;
      state->start_step.take({block.stable_step[e], "element", block.body[e], block.id[e]});
    }
    state->n_alive += slot_of(block.n);
  }
  return state;
}

template struct ErosionState<2>;
template struct ErosionState<3>;
template bool has_failed(const ElementBlock<2>&, LocalIndex);
template bool has_failed(const ElementBlock<3>&, LocalIndex);
template std::unique_ptr<ErosionState<2>> erosion_at_start(const std::vector<ElementBlock<2>>&,
                                                           const Points<2>&, const Surface<2>&);
template std::unique_ptr<ErosionState<3>> erosion_at_start(const std::vector<ElementBlock<3>>&,
                                                           const Points<3>&, const Surface<3>&);

}  // namespace brunt
