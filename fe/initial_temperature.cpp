#include "fe/initial_temperature.hpp"

namespace brunt {

template <int Dim>
Real start_temperature(const ElementBlock<Dim>& block, const Points<Dim>& points, LocalIndex node) {
  if (block.temperature_field == nullptr) return block.temperature;
  return block.temperature_field->at(in_space<Dim>(points.x[slot_of(node)]));
}

template <int Dim>
void begin_temperatures(const Points<Dim>& points, ElementBlock<Dim>& block) {
  auto& temperature = block.state.temperature;
  temperature.resize(block.state.size());
  if (block.conducts) {
    std::vector<Real> at_node(points.x.size(), 0.0);
    for (const LocalIndex node : block.corner) {
      at_node[slot_of(node)] = start_temperature(block, points, node);
    }
    for (LocalIndex e = 0; e < block.n_padded; e += kLanes) {
      block.formulation->interpolate_temperature(block, slot_of(e), at_node.data());
    }
  } else {
    for (LocalIndex e = 0; e < block.n_padded; ++e) {
      const auto x = corner_positions(block, e, points);
      for (int g = 0; g < block.gauss; ++g) {
        const Vec<Dim> place = block.formulation->material_place(x, block.gauss, g);
        temperature[block.point(e, g)] = block.temperature_field->at(in_space<Dim>(place));
      }
    }
  }
  if (!block.state.expansion.empty()) block.state.start_temperature = temperature;
}

template Real start_temperature(const ElementBlock<2>&, const Points<2>&, LocalIndex);
template Real start_temperature(const ElementBlock<3>&, const Points<3>&, LocalIndex);
template void begin_temperatures(const Points<2>&, ElementBlock<2>&);
template void begin_temperatures(const Points<3>&, ElementBlock<3>&);

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
