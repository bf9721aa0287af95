#pragma once
/// Heat of plastic work, compression and viscosity, which elements that conduct give to their nodes
/// in each step. docs/theory/heat.md (H10)
#include "fe/corner_values.hpp"
#include "fe/element_block.hpp"

namespace brunt {

/// Adds the heat [J] of elements from that of their material points [J/m^3 reference], the first of
/// which is `first`; none where there is none.
template <class V, int Dim>
BRUNT_INLINE void add_heat_of(const ElementBlock<Dim>& block, std::size_t first,
                              const std::vector<Real>& by_point, V& heat) {
  if (by_point.empty()) return;
  V sum = broadcast<V>(0);
  for (int g = 0; g < block.gauss; ++g) {
    const std::size_t at = first + slot_of(kGroup * g);
    sum =
        vfma(load_as<V>(block.reference_volume.data() + at), load_as<V>(by_point.data() + at), sum);
  }
  heat += sum;
}

/// The mechanical heat of lanes_of<V> elements from e on that their nodes do not have yet: given in
/// this step of dt [s]. None in a block that does not conduct, or whose material gives none.
template <class V, int Dim>
BRUNT_INLINE SharedHeat<V> mechanical_heat(ElementBlock<Dim>& block, std::size_t e, Real dt) {
  if (block.heat_given.empty()) return {};
  const std::size_t first = block.point(static_cast<LocalIndex>(e), 0);
  V heat = broadcast<V>(0);
  add_heat_of(block, first, block.state.heat, heat);
  add_heat_of(block, first, block.state.compression_heat, heat);
  Real* const given = block.heat_given.data() + e;
  const V rate = (1.0 / dt) * (heat - load_as<V>(given));
  store(given, heat);
  return {rate, block.heat_share.data() + block.heat_share_at(e, 0)};
}

}  // namespace brunt
// Tested by tests/unit/fe/conduction_test.cpp.
