/// FiniteElements::view: fields of one body for output.
#include <algorithm>
#include <memory>

#include "core/materials/state_fields.hpp"
#include "core/parallel/threads.hpp"
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
                                 std::vector<LocalIndex>& place) {
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
  for (std::size_t k = 0; k < nodes.size(); ++k) place[nodes[k]] = static_cast<LocalIndex>(k);
  return nodes;
}

/// What a view shows of a body, held as long as a field waits for it.
template <int Dim>
struct Shown {
  std::vector<Cell<Dim>> cells;
  std::vector<LocalIndex> nodes;
  std::vector<LocalIndex> place;  ///< of nodes in the view
  std::vector<Real> volume;       ///< [m^3] of the cells
};
template <int Dim>
using ShownPointer = std::shared_ptr<const Shown<Dim>>;

/// weights  of means as well
template <int Dim>
void add_points(const Points<Dim>& points, const std::vector<LocalIndex>& nodes, bool weights,
                BodyView& view) {
  const std::size_t n = nodes.size();
  view.position.resize(3 * n), view.point_owned.resize(n);
  if (weights) view.point_mass.resize(n);
  for_each(n, kViewWorthThreads, [&](std::size_t k) {
    const LocalIndex node = nodes[k];
    put_values<Dim>(points.x[node], &view.position[3 * k]);
    view.point_owned[k] = static_cast<char>(node < points.n_owned);
    if (!weights) return;
    // Means over a rigid body, which has no mass, are weighted by heat capacities.
    const bool rigid = points.mass[node] == 0 && points.conducts;
    view.point_mass[k] = rigid ? points.capacity[node] : points.mass[node];
  });
}

template <int Dim>
void add_point_fields(const Points<Dim>& points, const ShownPointer<Dim>& of, FieldAdder& fields) {
  const auto add = [&](const char* name, const auto& value) {
    fields.add(name, of->nodes.size(),
               [of, &points, value](std::size_t k) { return value(points, of->nodes[k]); });
  };
  using Of = const Points<Dim>&;
  add("displacement", [](Of p, LocalIndex k) -> Vec<Dim> { return p.x[k] - p.x_start[k]; });
  add("velocity", [](Of p, LocalIndex k) { return p.v[k]; });
  add("acceleration", [](Of p, LocalIndex k) { return p.a[k]; });
  add("force", [](Of p, LocalIndex k) { return p.f[k]; });
  add("id", [](Of p, LocalIndex k) { return static_cast<Real>(p.id[k]); });
  add("piece", [](Of p, LocalIndex k) { return static_cast<Real>(p.piece[k]); });
  if (points.conducts) add("temperature", [](Of p, LocalIndex k) { return p.temperature[k]; });
}

/// Sums of numbers and of arrays of them, weighted.
void add_weighted(Real& sum, Real weight, Real value) { sum += weight * value; }
template <std::size_t n>
void add_weighted(std::array<Real, n>& sum, Real weight, const std::array<Real, n>& value) {
  for (std::size_t i = 0; i < n; ++i) sum[i] += weight * value[i];
}
Real divided(Real sum, Real weight) { return sum / weight; }
template <std::size_t n>
std::array<Real, n> divided(std::array<Real, n> sum, Real weight) {
  for (Real& part : sum) part /= weight;
  return sum;
}

/// Mean of a quantity of the material points of an element, weighted by their volumes at time 0.
template <int Dim, class Value>
auto mean_of(const Cell<Dim>& cell, const Value& value) {
  const ElementBlock<Dim>& block = *cell.block;
  if (block.gauss == 1) return value(block.state, block.point(cell.element, 0));
  decltype(value(block.state, 0)) sum = {};
  Real weight = 0;
  for (int g = 0; g < block.gauss; ++g) {
    const std::size_t k = block.point(cell.element, g);
    add_weighted(sum, block.reference_volume[k], value(block.state, k));
    weight += block.reference_volume[k];
  }
  return divided(sum, weight);
}

/// Where rings have no part in it steps find the exact volume, for a tenth of the price.
template <int Dim>
Real volume_of(const Cell<Dim>& cell, const Points<Dim>& points, const Thickness& thickness) {
  const auto& formulation = *cell.block->formulation;
  const auto x = corner_positions(*cell.block, cell.element, points);
  return thickness.radial == 0 ? formulation.step_volume(x, thickness)
                               : formulation.volume(x, false, thickness);
}

/// True where the four cells from c on are four elements side by side.
template <int Dim>
bool are_four(const std::vector<Cell<Dim>>& cells, std::size_t c) {
  if (c + kLanes > cells.size()) return false;
  const Cell<Dim>* const first = &cells[c];
  for (LocalIndex k = 1; k < kLanes; ++k) {
    if (first[k].block != first->block || first[k].element != first->element + k) return false;
  }
  return true;
}

/// [m^3] of the cells.
template <int Dim>
std::vector<Real> volumes_of(const std::vector<Cell<Dim>>& cells, const Points<Dim>& points,
                             const Thickness& thickness) {
  const std::size_t n = cells.size();
  std::vector<Real> volume(n);
  for_each((n + kLanes - 1) / kLanes, kViewWorthThreads / kLanes, [&](std::size_t group) {
    const std::size_t c = group * kLanes;
    if (thickness.radial == 0 && are_four(cells, c)) {
      const auto& block = *cells[c].block;
      const auto four =
          block.formulation->step_volumes(block, slot_of(cells[c].element), points, thickness);
      std::copy(four.begin(), four.end(), &volume[c]);
      return;
    }
    for (std::size_t k = c; k < std::min(n, c + kLanes); ++k) {
      volume[k] = volume_of(cells[k], points, thickness);
    }
  });
  return volume;
}

/// Corners of cells first to last - 1, as places in the view.
template <int Dim>
void put_corners(const Shown<Dim>& of, std::size_t first, std::size_t last, std::int64_t* to) {
  for (std::size_t c = first; c < last; ++c) {
    const auto nodes = of.cells[c].block->corners_of(of.cells[c].element);
    to = std::transform(nodes.begin(), nodes.end(), to,
                        [&of](LocalIndex node) { return of.place[node]; });
  }
}

/// Corners of all cells, or how they are made.
template <int Dim>
void add_corners(const ShownPointer<Dim>& of, bool may_wait, BodyView& view) {
  const std::size_t n = of->cells.size(), corners = slot_of(view.corners);
  if (may_wait) {
    view.n_waiting_cells = n;
    view.fill_corners = [of](std::size_t first, std::size_t last, std::int64_t* to) {
      put_corners(*of, first, last, to);
    };
    return;
  }
  view.connectivity.resize(n * corners);
  for_each(n, kViewWorthThreads,
           [&](std::size_t c) { put_corners(*of, c, c + 1, &view.connectivity[c * corners]); });
}

}  // namespace

template <int Dim>
BodyView FiniteElements<Dim>::view(Label body, const WantedFields& wanted) const {
  BodyView view;
  const auto shown = std::make_shared<Shown<Dim>>();
  const ShownPointer<Dim> of = shown;
  auto& cells = shown->cells;
  cells = cells_of(blocks_, body);
  if (cells.size() > wanted.most) cells.resize(wanted.most);
  view.corners = cells.empty() ? Shape<Dim>::kCorners : cells.front().block->corners;
  view.cell_dimension = Dim;
  shown->nodes = nodes_of(cells, points_, shown->place);
  add_points(points_, of->nodes, !wanted.may_wait, view);
  FieldAdder point_fields(wanted, view.point_fields);
  add_point_fields(points_, of, point_fields);

  std::erase_if(cells, [](const Cell<Dim>& cell) { return !cell.block->owned[cell.element]; });
  add_corners(of, wanted.may_wait, view);
  const std::size_t n = cells.size();
  shown->volume = volumes_of(cells, points_, thickness_);
  if (!wanted.may_wait) view.cell_volume = shown->volume;
  FieldAdder fields(wanted, view.cell_fields);
  add_state_fields(
      fields, n, [of](std::size_t c, const auto& value) { return mean_of(of->cells[c], value); },
      [&cells](auto member) {
        return std::none_of(cells.begin(), cells.end(), [member](const Cell<Dim>& cell) {
          return (cell.block->state.*member).empty();
        });
      },
      !points_.conducts);
  const auto add = [&](const char* name, const auto& value) {
    fields.add(name, n, [of, value](std::size_t c) { return value(of->cells[c]); });
  };
  fields.add("density", n, [of](std::size_t c) {
    return of->cells[c].block->mass[of->cells[c].element] / of->volume[c];
  });
  add("piece",
      [](const Cell<Dim>& cell) { return static_cast<Real>(cell.block->piece[cell.element]); });
  add("id", [](const Cell<Dim>& cell) { return static_cast<Real>(cell.id()); });
  return view;
}

template BodyView FiniteElements<2>::view(Label, const WantedFields&) const;
template BodyView FiniteElements<3>::view(Label, const WantedFields&) const;

}  // namespace brunt
// Tested by tests/unit/fe/finite_elements_test.cpp.
