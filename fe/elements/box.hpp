#pragma once
/// Quadrilaterals and hexahedra: one point with hourglass control (fe/one_point.cpp), or 2^Dim
/// Gauss points (fe/gauss.cpp).
#include "core/elements/box_element.hpp"
#include "fe/formulation.hpp"

namespace brunt {

const Formulation<2>& formulation(Quad4);
const Formulation<3>& formulation(Hex8);

/// Volumes [m^3] of the Gauss points of one element at positions x; they sum to its exact volume.
template <int Dim>
std::array<Real, Shape<Dim>::kGauss> gauss_volumes(CornerPlaces<Dim> x, const Thickness& thickness);

/// Volume [m^3] as the element's formulation measures it: axisymmetric one-point elements take
/// 2 pi times area times mean radius, of which their forces are the derivative.
template <int Dim>
Real element_volume(CornerPlaces<Dim> x, bool one_point, const Thickness& thickness);

/// Volume [m^3] as one-point elements measure it, from its gradient: to round-off that of
/// element_volume, for a tenth of the price.
template <int Dim>
Real one_point_volume(CornerPlaces<Dim> x, const Thickness& thickness);

}  // namespace brunt
