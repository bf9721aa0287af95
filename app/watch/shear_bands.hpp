#pragma once
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/scene/scene.hpp"
#include "io/summary.hpp"

namespace brunt {

/// Cells in which plastic strain has localised: above 0.3, and three times the lower quartile of
/// the cells that share a corner with it. More of these lie beside a band of one or two cells than
/// in it.
/// view  with eps_p by cell
std::vector<std::size_t> localised_cells(const BodyView& view);

/// True where the flow stress has fallen by a twentieth of its largest value on the way to a state:
/// heat softens the material more than strain hardens it. The way is straight in plastic strain and
/// temperature.
/// start, temperature  [K]
bool has_softened(const Material& material, Real start, Real eps_p, Real temperature);

/// Bodies of elements in which strain has localised where heat softens them: such a band has the
/// width of an element, whatever that is, and what it carries follows from it. One warning a body.
/// Collective; the root has them.
template <int Dim>
std::vector<RunWarning> find_shear_bands(const Scene<Dim>& scene, const Deck& deck);

}  // namespace brunt
// Tested by tests/verification/shear_band_test.cpp.
