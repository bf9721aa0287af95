/// FiniteElements::view: fields of one body for output.
#include <algorithm>
#include <cmath>

#include "fe/finite_elements.hpp"

namespace brunt {
namespace {

template <int Dim>
struct Cell {
  const ElementBlock<Dim>* block;
  LocalIndex element;
  GlobalId id() const { return block->id[element]; }
};

/// Elements of one body by ascending id.
template <int Dim>
std::vector<Cell<Dim>> cells_of(const std::vector<ElementBlock<Dim>>& blocks, Label body) {
  std::vector<Cell<Dim>> cells;
  for (const auto& block : blocks) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      if (block.body[e] == body) cells.push_back({&block, e});
    }
  }
  std::sort(cells.begin(), cells.end(),
            [](const Cell<Dim>& a, const Cell<Dim>& b) { return a.id() < b.id(); });
  return cells;
}

/// Points of the cells by ascending id; also their places in the view, by node.
template <int Dim>
std::vector<LocalIndex> nodes_of(const std::vector<Cell<Dim>>& cells, const Points<Dim>& points,
                                 std::vector<std::int64_t>& place) {
  place.assign(points.x.size(), -1);
  std::vector<LocalIndex> nodes;
  for (const Cell<Dim>& cell : cells) {
    for (const LocalIndex node : cell.block->corners_of(cell.element)) {
      if (place[node] < 0) nodes.push_back(node);
      place[node] = 0;
    }
  }
  std::sort(nodes.begin(), nodes.end(), [&points](LocalIndex a, LocalIndex b) {
    return points.id[a] < points.id[b] || (points.id[a] == points.id[b] && a < b);
  });
  for (std::size_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = static_cast<std::int64_t>(k);
  return nodes;
}

template <int Dim, class Value>
Field vector_field(const char* name, const std::vector<LocalIndex>& nodes, const Value& value) {
  Field field{name, 3, {}};
  field.values.reserve(3 * nodes.size());
  for (const LocalIndex node : nodes) {
    const Vec<Dim> v = value(node);
    for (int i = 0; i < 3; ++i) field.values.push_back(i < Dim ? v[i] : 0);
  }
  return field;
}

template <int Dim>
void add_point_fields(const Points<Dim>& points, const std::vector<LocalIndex>& nodes,
                      BodyView& view) {
  view.position = vector_field<Dim>("", nodes, [&](LocalIndex k) { return points.x[k]; }).values;
  auto& fields = view.point_fields;
  fields.push_back(vector_field<Dim>("displacement", nodes, [&](LocalIndex k) -> Vec<Dim> {
    return points.x[k] - points.x_start[k];
  }));
  fields.push_back(vector_field<Dim>("velocity", nodes, [&](LocalIndex k) { return points.v[k]; }));
  fields.push_back(
      vector_field<Dim>("acceleration", nodes, [&](LocalIndex k) { return points.a[k]; }));
  fields.push_back(vector_field<Dim>("force", nodes, [&](LocalIndex k) { return points.f[k]; }));
  Field id{"id", 1, {}}, piece{"piece", 1, {}};
  for (const LocalIndex node : nodes) {
    id.values.push_back(static_cast<Real>(points.id[node]));
    piece.values.push_back(static_cast<Real>(points.piece[node]));
    // Means over a rigid body, which has no mass, are weighted by heat capacities.
    const bool rigid = points.mass[node] == 0 && points.conducts;
    view.point_mass.push_back(rigid ? points.capacity[node] : points.mass[node]);
    view.point_owned.push_back(node < points.n_owned);
  }
  fields.push_back(std::move(id));
  fields.push_back(std::move(piece));
  if (!points.conducts) return;
  Field temperature{"temperature", 1, {}};
  for (const LocalIndex node : nodes) temperature.values.push_back(points.temperature[node]);
  fields.push_back(std::move(temperature));
}

/// Mean of a quantity of the material points of an element, weighted by their volumes at time 0.
template <int Dim, class Value>
Real mean_of(const Cell<Dim>& cell, const Value& value) {
  Real sum = 0, weight = 0;
  for (int g = 0; g < cell.block->gauss; ++g) {
    const std::size_t k = cell.block->point(cell.element, g);
    sum += cell.block->reference_volume[k] * value(k);
    weight += cell.block->reference_volume[k];
  }
  return sum / weight;
}

Real von_mises(const MaterialState& state, std::size_t k) {
  Real sum = 0;
  for (int i = 0; i < 6; ++i) {
    const Real s = state.deviator[i][k];
    sum += (i < 3 ? 1.0 : 2.0) * s * s;
  }
  return std::sqrt(1.5 * sum);
}

template <int Dim>
void add_stress_fields(const std::vector<Cell<Dim>>& cells, BodyView& view) {
  Field stress{"stress", 6, {}}, pressure{"pressure", 1, {}}, mises{"von_mises", 1, {}};
  for (const Cell<Dim>& cell : cells) {
    const MaterialState& state = cell.block->state;
    const Real p = mean_of(cell, [&](std::size_t k) { return state.pressure[k]; });
    for (int i = 0; i < 6; ++i) {
      const Real s = mean_of(cell, [&](std::size_t k) { return state.deviator[i][k]; });
      stress.values.push_back(i < 3 ? s - p : s);
    }
    pressure.values.push_back(p);
    mises.values.push_back(mean_of(cell, [&](std::size_t k) { return von_mises(state, k); }));
  }
  view.cell_fields.push_back(std::move(stress));
  view.cell_fields.push_back(std::move(pressure));
  view.cell_fields.push_back(std::move(mises));
}

/// A state field, where the law of the body's elements has it.
template <int Dim>
void add_state_field(const char* name, std::vector<Real> MaterialState::*member,
                     const std::vector<Cell<Dim>>& cells, BodyView& view) {
  Field field{name, 1, {}};
  for (const Cell<Dim>& cell : cells) {
    const std::vector<Real>& values = cell.block->state.*member;
    if (values.empty()) return;
    field.values.push_back(mean_of(cell, [&](std::size_t k) { return values[k]; }));
  }
  view.cell_fields.push_back(std::move(field));
}

}  // namespace

template <int Dim>
BodyView FiniteElements<Dim>::view(Label body) const {
  BodyView view;
  std::vector<Cell<Dim>> cells = cells_of(blocks_, body);
  view.corners = cells.empty() ? Shape<Dim>::kCorners : cells.front().block->corners;
  view.cell_dimension = Dim;
  std::vector<std::int64_t> place;
  add_point_fields(points_, nodes_of(cells, points_, place), view);
  std::erase_if(cells, [](const Cell<Dim>& cell) { return !cell.block->owned[cell.element]; });
  add_stress_fields(cells, view);
  add_state_field("eps_p", &MaterialState::eps_p, cells, view);
  add_state_field("strain_rate", &MaterialState::strain_rate, cells, view);
  add_state_field("plastic_volume", &MaterialState::plastic_volume, cells, view);
  add_state_field("opening", &MaterialState::opening, cells, view);
  add_state_field("damage", &MaterialState::damage, cells, view);
  add_state_field("porosity", &MaterialState::porosity, cells, view);
  add_state_field("tensile_strength", &MaterialState::tensile_strength, cells, view);
  if (!points_.conducts) add_state_field("temperature", &MaterialState::temperature, cells, view);
  Field density{"density", 1, {}}, piece{"piece", 1, {}}, id{"id", 1, {}};
  for (const Cell<Dim>& cell : cells) {
    const ElementBlock<Dim>& block = *cell.block;
    const LocalIndex e = cell.element;
    for (const LocalIndex node : block.corners_of(e)) view.connectivity.push_back(place[node]);
    const Real volume =
        block.formulation->volume(corner_positions(block, e, points_), false, thickness_);
    view.cell_volume.push_back(volume);
    density.values.push_back(block.mass[e] / volume);
    piece.values.push_back(static_cast<Real>(block.piece[e]));
    id.values.push_back(static_cast<Real>(block.id[e]));
  }
  for (Field* field : {&density, &piece, &id}) view.cell_fields.push_back(std::move(*field));
  return view;
}

template BodyView FiniteElements<2>::view(Label) const;
template BodyView FiniteElements<3>::view(Label) const;

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
