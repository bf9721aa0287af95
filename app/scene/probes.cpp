#include "app/scene/probes.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "app/scene/field_values.hpp"
#include "app/scene/place.hpp"
#include "io/deck/number.hpp"

namespace brunt {

namespace {
/// Index of the entity with an id among those that the view owns; -1 where it is not here.
std::ptrdiff_t place_of(const BodyView& view, bool cell, GlobalId id) {
  const auto& fields = cell ? view.cell_fields : view.point_fields;
  const Field* ids = field_named(fields, "id");
  if (ids == nullptr) return -1;
  const auto at = std::find(ids->values.begin(), ids->values.end(), static_cast<Real>(id));
  if (at == ids->values.end()) return -1;
  const auto place = at - ids->values.begin();
  const bool copy = !cell && !view.point_owned.empty() && view.point_owned[place] == 0;
  return copy ? -1 : place;
}

/// What one rank knows of a value.
struct Known {
  Real value = std::numeric_limits<Real>::quiet_NaN();
  bool here = false;
};
}  // namespace

std::string place_text(const Probe& probe) {
  const auto any = [&](char cell) {
    return std::find(probe.of_cell.begin(), probe.of_cell.end(), cell) != probe.of_cell.end();
  };
  std::string text = "probe " + probe.name + ":";
  if (any(0)) {
    if (probe.points.size() > 1) {
      text += " between " + std::to_string(probe.points.size()) + " points";
    } else {
      text += " point " + std::to_string(probe.points.front()) + " at a distance of " +
              shortest_text(probe.point_distance) + " m";
    }
  }
  if (any(1)) {
    text += std::string(any(0) ? ", " : " ") + "element " + std::to_string(probe.cell);
    if (probe.cell_distance > 0) {
      text += ", its centre at a distance of " + shortest_text(probe.cell_distance) + " m";
    }
  }
  return text;
}

std::string column_of(const Probe& probe, std::size_t field) {
  return "probe." + probe.name + "." + probe.fields[field];
}

WantedFields fields_of(const Probe& probe) {
  std::vector<std::string> names{"id"};
  for (const auto& field : probe.fields) names.push_back(field.substr(0, field.find('.')));
  return {names};
}

std::vector<Real> probe_values(const Probe& probe, const BodyView& mine,
                               const Communicator& ranks) {
  std::vector<Known> known;  // by field: of its cell, or of its points one after another
  for (std::size_t f = 0; f < probe.fields.size(); ++f) {
    const bool cell = probe.of_cell[f] != 0;
    const std::size_t n = cell ? 1 : probe.points.size();
    std::vector<Real> mine_values;
    for (std::size_t k = 0; k < n; ++k) {
      known.emplace_back();
      const auto place = place_of(mine, cell, cell ? probe.cell : probe.points[k]);
      if (place < 0) continue;
      if (mine_values.empty()) mine_values = field_values(mine, probe.fields[f]);
      known.back().value = mine_values[place];
      known.back().here = true;
    }
  }
  ranks.reduce_all(std::span(known), [](Known& a, const Known& b) {
    if (!a.here) a = b;
  });
  std::vector<Real> values;
  values.reserve(probe.fields.size());
  auto next = known.cbegin();
  for (std::size_t f = 0; f < probe.fields.size(); ++f) {
    if (probe.of_cell[f] != 0) {
      values.push_back((next++)->value);
      continue;
    }
    const unsigned odd = odd_axes(probe.fields[f]);
    Real sum = 0;
    for (std::size_t k = 0; k < probe.weights.size(); ++k) {
      sum += sign_in_image(odd, probe.reflected[k]) * probe.weights[k] * (next++)->value;
    }
    values.push_back(sum);
  }
  return values;
}

}  // namespace brunt
