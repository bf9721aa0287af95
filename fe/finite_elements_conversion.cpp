/// What nodes take over of elements that become particles. docs/theory/elements.md, section 9.
#include <algorithm>

#include "core/materials/state_rows.hpp"
#include "fe/erosion.hpp"
#include "fe/finite_elements.hpp"
#include "fe/formulation.hpp"
#include "fe/last_work.hpp"

namespace brunt {
namespace {

/// Mean of what the material points of an element carry, by their volumes at time 0.
template <int Dim>
std::vector<Real> mean_state(const ElementBlock<Dim>& block, LocalIndex e) {
  std::vector<Real> mean;
  for (int g = 0; g < block.gauss; ++g) {
    const std::size_t k = block.point(e, g);
    const Real share = block.gauss == 1 ? 1 : block.reference_volume[k] / block.element_volume[e];
    std::size_t at = 0;
    visit_material_point(block.state, k, kSaved, [&](Real value, FieldUse) {
      if (g == 0) mean.push_back(0);
      mean[at++] += share * value;
    });
  }
  return mean;
}

/// [1] volume of an element at positions x [m] over that at time 0. One that is all but flat has
/// exerted what its law says at the least volume that is taken here.
template <int Dim>
Real volume_ratio(const ElementBlock<Dim>& block, LocalIndex e, const std::vector<Vec<Dim>>& x,
                  const Thickness& thickness) {
  constexpr Real kLeast = 0.05;
  CornerPositions<Dim> places;
  for (const LocalIndex node : block.corners_of(e)) places.x[places.n++] = x[node];
  const Real volume = block.formulation->volume(places, block.gauss == 1, thickness);
  return std::max(volume / block.element_volume[e], kLeast);
}

}  // namespace

/// Each corner takes an equal share of an element that becomes particles, as of its mass: what the
/// element had of work and heat is no longer among what has eroded.
/// x_before  [m] by point, x(n), where the stress of the elements is from
template <int Dim>
void FiniteElements<Dim>::convert(const std::vector<ErodedElement>& going,
                                  const std::vector<Vec<Dim>>& x_before) {
  const auto converts = [&](Label body) {
    const auto to = erosion_->to.find(body);
    return to != erosion_->to.end() && to->second == ErodeTo::sph;
  };
  for (const ErodedElement& one : going) any_converted_ = any_converted_ || converts(one.body);
  if (!any_converted_) return;
  for (const auto& block : blocks_) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      if (!converts(block.body[e]) || !is_among(going, block.id[e])) continue;
      const auto& books = *place_among(erosion_->eroded, block.id[e]);
      ConvertedShare share;
      share.element = block.id[e];
      share.volume = block.element_volume[e] / block.corners;
      share.ratio = volume_ratio(block, e, x_before, thickness_);
      share.work = (books.energy + books.heat) / block.corners;
      share.state = mean_state(block, e);
      for (const LocalIndex node : block.corners_of(e)) {
        if (node >= points_.n_owned) continue;
        share.point = points_.id[node];
        converted_.push_back(share);
      }
    }
  }
  std::sort(converted_.begin(), converted_.end(), [](const auto& a, const auto& b) {
    return std::pair(a.point, a.element) < std::pair(b.point, b.element);
  });
  for (const ErodedElement& one : going) {
    if (!converts(one.body)) continue;
    auto& books = *place_among(erosion_->eroded, one.id);
    books.energy = books.heat = books.compression = 0;
  }
}

template void FiniteElements<2>::convert(const std::vector<ErodedElement>&,
                                         const std::vector<Vec<2>>&);
template void FiniteElements<3>::convert(const std::vector<ErodedElement>&,
                                         const std::vector<Vec<3>>&);

}  // namespace brunt
// Tested by tests/verification/conversion_test.cpp.
