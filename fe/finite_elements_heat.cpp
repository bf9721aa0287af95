/// Conduction of a group of finite elements: temperatures live at its nodes.
#include <algorithm>

#include "core/parallel/threads.hpp"
#include "fe/conduction.hpp"
#include "fe/finite_elements.hpp"
#include "fe/initial_temperature.hpp"

namespace brunt {
namespace {
[[maybe_unused]] constexpr int kGroupsWorthThreads =
    64;  // groups of four elements; of some 1 us each
}

/// Temperatures at time 0 and heat capacities of nodes, from the elements around them.
template <int Dim>
void FiniteElements<Dim>::set_capacities() {
  order_corners();
  std::vector<Real> at_start(points_.x.size(), 0.0);
  std::vector<Real> share(n_corners_, 0.0);
  for (const auto& block : blocks_) {
    const auto n = slot_of(block.corners);
    for (std::size_t e = 0; e < slot_of(block.n); ++e) {
      const Real capacity =
          block.material_mass(e) * block.material->specific_heat.at(block.temperature);
      for (std::size_t I = 0; I < n; ++I) {
        const std::size_t corner = e * n + I;
        at_start[block.corner[corner]] = start_temperature(block, points_, block.corner[corner]);
        share[block.first_corner + corner] = capacity * block.heat_share[block.heat_share_at(e, I)];
      }
    }
  }
  points_.conduct(at_start);
  std::vector<Vec<1>> sum(points_.x.size(), Vec<1>::Zero());
  gather_.template add<1>(share.data(), sum);
  for (std::size_t k = 0; k < sum.size(); ++k) points_.capacity[k] = sum[k][0];
  if (!materials_that_vary(blocks_).empty()) vary_capacities();
}

/// Nodes of several materials, one of which varies at least, have the specific heat of their
/// mixture.
template <int Dim>
void FiniteElements<Dim>::vary_capacities() {
  const auto varying = materials_that_vary(blocks_);
  std::vector<const Material*> materials = varying;
  for (const auto& block : blocks_) {
    if (std::find(materials.begin(), materials.end(), block.material) == materials.end()) {
      materials.push_back(block.material);
    }
  }
  std::vector<std::vector<Vec<1>>> mass;  // [kg] by material, node
  for (const Material* material : materials) {
    std::vector<Real> share(n_corners_, 0.0);
    for (const auto& block : blocks_) {
      if (block.material != material) continue;
      const auto n = slot_of(block.corners);
      for (std::size_t c = 0; c < slot_of(block.n) * n; ++c) {
        share[block.first_corner + c] =
            block.material_mass(c / n) * block.heat_share[block.heat_share_at(c / n, c % n)];
      }
    }
    gather_.template add<1>(share.data(), mass.emplace_back(points_.x.size(), Vec<1>::Zero()));
  }
  std::vector<SpecificHeat> heats;
  heats.reserve(varying.size());
  for (const Material* material : varying) heats.push_back(material->specific_heat);
  points_.vary_capacities(heats);
  for (std::size_t i = 0; i < points_.x.size(); ++i) {
    Real sum = 0;
    for (const auto& of : mass) sum += of[i][0];
    std::vector<const SpecificHeat*> parts;
    std::vector<Real> shares;
    for (std::size_t m = 0; m < materials.size(); ++m) {
      if (mass[m][i][0] == 0) continue;
      parts.push_back(&materials[m]->specific_heat);
      shares.push_back(mass[m][i][0] / sum);
    }
    const auto mixture = SpecificHeat::of_mixture(parts, shares);
    if (!mixture.varies()) continue;
    std::size_t which = 0;
    while (which < points_.specific_heats.size() && points_.specific_heats[which] != mixture)
      ++which;
    if (which == points_.specific_heats.size()) points_.specific_heats.push_back(mixture);
    points_.vary_capacity(i, static_cast<std::int32_t>(which), sum);
  }
}

/// Leaves nothing but heat: no mass, and facets that contact sees as rigid.
template <int Dim>
void FiniteElements<Dim>::make_rigid() {
  std::fill(points_.mass.begin(), points_.mass.end(), 0.0);
  for (auto& facet : surface_.facets) facet.stiffness = facet.areal_mass = facet.depth = 0;
}

/// Conductances of the start, which the first step limit needs.
template <int Dim>
void FiniteElements<Dim>::start_conduction() {
  order_corners();
  corner_heat_.assign(n_corners_ * 2, 0.0);
  std::fill(points_.conductance.begin(), points_.conductance.end(), 0.0);
  conduct();
  std::fill(points_.heat_rate.begin(), points_.heat_rate.end(), 0.0);
}

template <int Dim>
void FiniteElements<Dim>::interpolate_temperatures() {
  for (auto& block : blocks_) {
    if (block.state.temperature.empty()) continue;
    const int n = block.n_padded / kLanes;
    for_each(n, kGroupsWorthThreads, [&](int k) {
      block.formulation->interpolate_temperature(block, slot_of(k) * kLanes,
                                                 points_.temperature.data());
    });
  }
}

/// Writes node_heat_.
template <int Dim>
void FiniteElements<Dim>::sum_conduction() {
  for (auto& block : blocks_) {
    const ConductionStep<Dim> step{points_.x.data(), points_.temperature.data(), thickness_,
                                   corner_heat_.data() + 2 * block.first_corner};
    const int n = block.n_padded / kGroup;
    for_each(n, kGroupsWorthThreads,
             [&](int k) { block.formulation->conduct(block, slot_of(k) * kGroup, step); });
  }
  node_heat_.assign(points_.x.size(), Vec<2>::Zero());
  gather_.template add<2>(corner_heat_.data(), node_heat_);
}

template <int Dim>
void FiniteElements<Dim>::conduct() {
  sum_conduction();
  for (std::size_t i = 0; i < points_.owned(); ++i) {
    points_.heat_rate[i] += node_heat_[i][0];
    points_.conductance[i] += node_heat_[i][1];
  }
}

template <int Dim>
void FiniteElements<Dim>::keep_conduction() {
  sum_conduction();
  for (std::size_t i = 0; i < points_.owned(); ++i) {
    points_.kept_rate[i] = node_heat_[i][0];
    points_.kept_conductance[i] = node_heat_[i][1];
  }
}

/// Mechanical heat is given with the internal forces.
template <int Dim>
void FiniteElements<Dim>::add_conduction(Real /*dt*/) {
  if (!points_.conducts) return;
  if (points_.conduction_steps == 1) return conduct();
  if (!points_.evaluates_conduction) return;  // they began with what is kept
  keep_conduction();
  points_.add_kept_conduction();
}

template void FiniteElements<2>::set_capacities();
template void FiniteElements<3>::set_capacities();
template void FiniteElements<2>::make_rigid();
template void FiniteElements<3>::make_rigid();
template void FiniteElements<2>::start_conduction();
template void FiniteElements<3>::start_conduction();
template void FiniteElements<2>::interpolate_temperatures();
template void FiniteElements<3>::interpolate_temperatures();
template void FiniteElements<2>::add_conduction(Real);
template void FiniteElements<3>::add_conduction(Real);

}  // namespace brunt
// Tested by tests/unit/fe/conduction_test.cpp.
