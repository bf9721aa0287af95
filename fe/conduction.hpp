#pragma once
/// Heat conduction in elements, with all Gauss points: one-point gradients would not see the
/// hourglass modes of temperature.
#include "fe/element_block.hpp"

namespace brunt {

/// One step of conduction for the kernels, which write the heat rates of kGroup elements from e on:
///   q_I = sum_J K_IJ (T_I - T_J),  K_IJ = int k grad N_I . grad N_J dV,  k at the mean temperature
/// so that heat flows between pairs of corners and none is lost. The conductance of a corner is
/// 1/2 sum_J |K_IJ|: by Gershgorin's theorem a step of capacity/conductance is stable, whatever
/// the element's shape.
template <int Dim>
struct ConductionStep {
  const Vec<Dim>* x = nullptr;        ///< [m] by node, x(n+1)
  const Real* temperature = nullptr;  ///< [K] by node, T(n)
  Thickness thickness;
  Real* corner_heat = nullptr; /**< [element][corner][2], written: heat rate [W] and conductance
                                    [W/K] of the corner */
};

/// Heat rates and conductances of the corners of lanes_of<V> hexahedra, [element][corner][2].
/// corner        8 nodes each
/// conductivity  of each [W/m/K]
template <class V>
void conduct_hexes(const LocalIndex* corner, const Real* conductivity,
                   const ConductionStep<3>& step, Real* corner_heat);

/// Materials of conducting blocks whose specific heat varies, each once, in the order of blocks: in
/// it stand their specific heats among those of the points.
template <int Dim>
std::vector<const Material*> materials_that_vary(const std::vector<ElementBlock<Dim>>& blocks);

/// Heat of one element [J] from that of its material points [J/m^3 reference]; 0 where there is
/// none.
template <int Dim>
Real heat_of(const ElementBlock<Dim>& block, const std::vector<Real>& by_point, LocalIndex e) {
  if (by_point.empty()) return 0;
  Real sum = 0;
  for (int g = 0; g < block.gauss; ++g) {
    const std::size_t k = block.point(e, g);
    sum += block.reference_volume[k] * by_point[k];
  }
  return sum;
}
/// Plastic work of one element that has become heat since time 0 [J].
template <int Dim>
Real plastic_heat(const ElementBlock<Dim>& block, LocalIndex e) {
  return heat_of(block, block.state.heat, e);
}
/// What compression and viscosity have given to one element since time 0 [J].
template <int Dim>
Real compression_heat(const ElementBlock<Dim>& block, LocalIndex e) {
  return heat_of(block, block.state.compression_heat, e);
}
/// Work of the pressure of one element on its thermal expansion since time 0 [J].
template <int Dim>
Real expansion_work(const ElementBlock<Dim>& block, LocalIndex e) {
  return heat_of(block, block.state.expansion_work, e);
}

}  // namespace brunt
