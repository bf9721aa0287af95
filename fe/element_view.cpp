/// FiniteElements::view: fields of one body for output.
#include <algorithm>
#include <cmath>

#include "fe/finite_elements.hpp"

namespace brunt {
namespace {

constexpr std::size_t kViewWorthThreads = 2000;  // points or elements

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
  const auto ascends = [](const Cell<Dim>& a, const Cell<Dim>& b) { return a.id() < b.id(); };
  if (!std::is_sorted(cells.begin(), cells.end(), ascends)) {
    std::sort(cells.begin(), cells.end(), ascends);
  }
  return cells;
}

/// Points of the cells by ascending id; also their places in the view, by node.
template <int Dim>
std::vector<LocalIndex> nodes_of(const std::vector<Cell<Dim>>& cells, const Points<Dim>& points,
                                 std::vector<std::int64_t>& place) {
  place.assign(points.x.size(), -1);
  for (const Cell<Dim>& cell : cells) {
    for (const LocalIndex node : cell.block->corners_of(cell.element)) place[node] = 0;
  }
  std::vector<LocalIndex> nodes;
  for (std::size_t i = 0; i < place.size(); ++i) {
    if (place[i] == 0) nodes.push_back(static_cast<LocalIndex>(i));
  }
  const auto ascends = [&points](LocalIndex a, LocalIndex b) {
    return points.id[a] < points.id[b] || (points.id[a] == points.id[b] && a < b);
  };
  if (!std::is_sorted(nodes.begin(), nodes.end(), ascends)) {
    std::sort(nodes.begin(), nodes.end(), ascends);
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = static_cast<std::int64_t>(k);
  return nodes;
}

template <int Dim, class Value>
Field vector_field(const char* name, const std::vector<LocalIndex>& nodes, const Value& value) {
  Field field{name, 3, std::vector<Real>(3 * nodes.size())};
#pragma omp parallel for schedule(static) if (nodes.size() > kViewWorthThreads)
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Vec<Dim> v = value(nodes[k]);
    for (int i = 0; i < Dim; ++i) field.values[3 * k + slot_of(i)] = v[i];
  }
  return field;
}

/// Adds what is wanted of a list of fields, each only then computed.
class FieldAdder {
 public:
  FieldAdder(const WantedFields& wanted, std::vector<Field>& fields)
      : wanted_(wanted), fields_(fields) {}
  /// make()  the field, or one of no values where it is not there
  template <class Make>
  void add(const char* name, const Make& make) {
    if (wanted_.has(name)) fields_.push_back(make(name));
  }
  /// value(k)  of the k-th of n entities
  template <class Value>
  void add_scalar(const char* name, std::size_t n, const Value& value) {
    if (!wanted_.has(name)) return;
    Field& field = fields_.emplace_back(Field{name, 1, std::vector<Real>(n)});
#pragma omp parallel for schedule(static) if (n > kViewWorthThreads)
    for (std::size_t k = 0; k < n; ++k) field.values[k] = value(k);
  }

 private:
  const WantedFields& wanted_;
  std::vector<Field>& fields_;
};

template <int Dim>
void add_point_fields(const Points<Dim>& points, const std::vector<LocalIndex>& nodes,
                      const WantedFields& wanted, BodyView& view) {
  view.position = vector_field<Dim>("", nodes, [&](LocalIndex k) { return points.x[k]; }).values;
  FieldAdder fields(wanted, view.point_fields);
  const auto add_vector = [&](const char* name, const auto& value) {
    fields.add(name, [&](const char* of) { return vector_field<Dim>(of, nodes, value); });
  };
  add_vector("displacement",
             [&](LocalIndex k) -> Vec<Dim> { return points.x[k] - points.x_start[k]; });
  add_vector("velocity", [&](LocalIndex k) { return points.v[k]; });
  add_vector("acceleration", [&](LocalIndex k) { return points.a[k]; });
  add_vector("force", [&](LocalIndex k) { return points.f[k]; });
  const std::size_t n = nodes.size();
  fields.add_scalar("id", n, [&](std::size_t k) { return static_cast<Real>(points.id[nodes[k]]); });
  fields.add_scalar("piece", n,
                    [&](std::size_t k) { return static_cast<Real>(points.piece[nodes[k]]); });
  view.point_mass.reserve(n), view.point_owned.reserve(n);
  for (const LocalIndex node : nodes) {
    // Means over a rigid body, which has no mass, are weighted by heat capacities.
    const bool rigid = points.mass[node] == 0 && points.conducts;
    view.point_mass.push_back(rigid ? points.capacity[node] : points.mass[node]);
    view.point_owned.push_back(node < points.n_owned);
  }
  if (!points.conducts) return;
  fields.add_scalar("temperature", n, [&](std::size_t k) { return points.temperature[nodes[k]]; });
}

/// Mean of a quantity of the material points of an element, weighted by their volumes at time 0.
template <int Dim, class Value>
Real mean_of(const Cell<Dim>& cell, const Value& value) {
  if (cell.block->gauss == 1) return value(cell.block->point(cell.element, 0));
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
void add_stress_fields(const std::vector<Cell<Dim>>& cells, FieldAdder& fields) {
  const auto pressure = [&](std::size_t c) {
    const MaterialState& state = cells[c].block->state;
    return mean_of(cells[c], [&](std::size_t k) { return state.pressure[k]; });
  };
  fields.add("stress", [&](const char* name) {
    Field stress{name, 6, std::vector<Real>(6 * cells.size())};
#pragma omp parallel for schedule(static) if (cells.size() > kViewWorthThreads)
    for (std::size_t c = 0; c < cells.size(); ++c) {
      Real* const to = &stress.values[6 * c];
      const MaterialState& state = cells[c].block->state;
      const Real p = pressure(c);
      for (int i = 0; i < 6; ++i) {
        const Real s = mean_of(cells[c], [&](std::size_t k) { return state.deviator[i][k]; });
        to[i] = i < 3 ? s - p : s;
      }
    }
    return stress;
  });
  fields.add_scalar("pressure", cells.size(), pressure);
  fields.add_scalar("von_mises", cells.size(), [&](std::size_t c) {
    const MaterialState& state = cells[c].block->state;
    return mean_of(cells[c], [&](std::size_t k) { return von_mises(state, k); });
  });
}

/// A state field, where the law of the body's elements has it.
template <int Dim>
void add_state_field(const char* name, std::vector<Real> MaterialState::*member,
                     const std::vector<Cell<Dim>>& cells, FieldAdder& fields) {
  const bool there = std::none_of(cells.begin(), cells.end(), [&](const Cell<Dim>& cell) {
    return (cell.block->state.*member).empty();
  });
  if (!there) return;
  fields.add_scalar(name, cells.size(), [&](std::size_t c) {
    const std::vector<Real>& values = cells[c].block->state.*member;
    return mean_of(cells[c], [&](std::size_t k) { return values[k]; });
  });
}

}  // namespace

template <int Dim>
BodyView FiniteElements<Dim>::view(Label body, const WantedFields& wanted) const {
  BodyView view;
  std::vector<Cell<Dim>> cells = cells_of(blocks_, body);
  view.corners = cells.empty() ? Shape<Dim>::kCorners : cells.front().block->corners;
  view.cell_dimension = Dim;
  std::vector<std::int64_t> place;
  add_point_fields(points_, nodes_of(cells, points_, place), wanted, view);
  std::erase_if(cells, [](const Cell<Dim>& cell) { return !cell.block->owned[cell.element]; });
  FieldAdder fields(wanted, view.cell_fields);
  add_stress_fields(cells, fields);
  add_state_field("eps_p", &MaterialState::eps_p, cells, fields);
  add_state_field("strain_rate", &MaterialState::strain_rate, cells, fields);
  add_state_field("plastic_volume", &MaterialState::plastic_volume, cells, fields);
  add_state_field("opening", &MaterialState::opening, cells, fields);
  add_state_field("damage", &MaterialState::damage, cells, fields);
  add_state_field("porosity", &MaterialState::porosity, cells, fields);
  add_state_field("tensile_strength", &MaterialState::tensile_strength, cells, fields);
  if (!points_.conducts) add_state_field("temperature", &MaterialState::temperature, cells, fields);
  const std::size_t n = cells.size();
  const auto corners = slot_of(view.corners);
  view.connectivity.resize(n * corners);
  view.cell_volume.resize(n);
#pragma omp parallel for schedule(static) if (n > kViewWorthThreads)
  for (std::size_t c = 0; c < n; ++c) {
    const ElementBlock<Dim>& block = *cells[c].block;
    const auto nodes = block.corners_of(cells[c].element);
    std::transform(nodes.begin(), nodes.end(), &view.connectivity[c * corners],
                   [&place](LocalIndex node) { return place[node]; });
    const auto x = corner_positions(block, cells[c].element, points_);
    // Where rings have no part in it steps find the exact volume, for a tenth of the price.
    view.cell_volume[c] = thickness_.radial == 0 ? block.formulation->step_volume(x, thickness_)
                                                 : block.formulation->volume(x, false, thickness_);
  }
  fields.add_scalar("density", n, [&](std::size_t c) {
    return cells[c].block->mass[cells[c].element] / view.cell_volume[c];
  });
  fields.add_scalar("piece", n, [&](std::size_t c) {
    return static_cast<Real>(cells[c].block->piece[cells[c].element]);
  });
  fields.add_scalar("id", n, [&](std::size_t c) { return static_cast<Real>(cells[c].id()); });
  return view;
}

template BodyView FiniteElements<2>::view(Label, const WantedFields&) const;
template BodyView FiniteElements<3>::view(Label, const WantedFields&) const;

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
