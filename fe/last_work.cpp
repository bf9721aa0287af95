#include "fe/last_work.hpp"

#include <algorithm>

#include "fe/element_values.hpp"
#include "fe/formulation.hpp"

namespace brunt {

std::vector<ErodedElement>::iterator place_among(std::vector<ErodedElement>& going, GlobalId id) {
  return std::lower_bound(
      going.begin(), going.end(), id,
      [](const ErodedElement& one, GlobalId wanted) { return one.id < wanted; });
}

bool is_among(const std::vector<ErodedElement>& going, GlobalId id) {
  const auto at =
      std::lower_bound(going.begin(), going.end(), id,
                       [](const ErodedElement& one, GlobalId wanted) { return one.id < wanted; });
  return at != going.end() && at->id == id;
}

template <int Dim>
ElementSet<Dim> set_of(const ElementBlock<Dim>& block, const std::vector<ErodedElement>& going) {
  ElementSet<Dim> set;
  set.material = block.material, set.options = block.options;
  set.temperature = block.temperature, set.adiabatic = block.adiabatic;
  set.conducts = block.conducts, set.held = block.held, set.rigid = block.rigid;
  set.stress = block.stress, set.temperature_field = block.temperature_field;
  for (LocalIndex e = 0; e < block.n; ++e) {
    if (!is_among(going, block.id[e])) continue;
    auto& corners = set.corners.emplace_back();
    for (const LocalIndex node : block.corners_of(e)) corners[corners.n++] = node;
    set.id.push_back(block.id[e]);
    set.body.push_back(block.body[e]), set.piece.push_back(block.piece[e]);
  }
  return set;
}

template <int Dim>
std::vector<Real> taken_in_step(ElementBlock<Dim>& block, ElementStep<Dim>& step) {
  const auto corners = slot_of(block.corners);
  const auto per_tile = slot_of(block.elements_per_tile());
  std::vector<std::uint16_t> place(per_tile * corners);
  for (std::size_t c = 0; c < place.size(); ++c) {
    place[c] = static_cast<std::uint16_t>(c * kSumRow);
  }
  std::vector<Real> row(place.size() * kSumRow), taken;
  for (int tile = 0; tile < block.n_tiles(); ++tile) {
    const std::size_t first = slot_of(tile) * per_tile;
    std::fill(row.begin(), row.end(), 0.0);
    step.sums = {place.data(), first, row.data()};
    block.formulation->advance(block, tile, step);
    for (std::size_t e = first; e < first + per_tile; ++e) {
      Real by_new = 0;
      for (std::size_t I = 0; I < corners; ++I) {
        const Real* force = row.data() + ((e - first) * corners + I) * kSumRow;
        const Vec<Dim>& v = step.v[block.corner[e * corners + I]];
        for (int c = 0; c < Dim; ++c) by_new -= step.dt * force[c] * v[c];
      }
      taken.push_back(block.stress_work[e] + block.hourglass_work[e] + block.viscous_work[e] -
                      0.5 * by_new);
    }
  }
  return taken;
}

template <int Dim>
void copy_state(const ElementBlock<Dim>& from, ElementBlock<Dim>& to) {
  std::vector<Real> row;
  for (LocalIndex e = 0; e < to.n_padded; ++e) {
    const auto begin = from.id.begin(), end = begin + from.n;
    const auto at = std::lower_bound(begin, end, to.id[e]);
    if (at == end || *at != to.id[e]) continue;
    row.clear();
    visit_element(from, slot_of(at - begin), [&](Real value, FieldUse) { row.push_back(value); });
    const Real* next = row.data();
    visit_element(to, slot_of(e), [&](Real& value, FieldUse) { value = *next++; });
  }
}

template void copy_state(const ElementBlock<2>&, ElementBlock<2>&);
template void copy_state(const ElementBlock<3>&, ElementBlock<3>&);
template ElementSet<2> set_of(const ElementBlock<2>&, const std::vector<ErodedElement>&);
template ElementSet<3> set_of(const ElementBlock<3>&, const std::vector<ErodedElement>&);
template std::vector<Real> taken_in_step(ElementBlock<2>&, ElementStep<2>&);
template std::vector<Real> taken_in_step(ElementBlock<3>&, ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/erosion_test.cpp.
