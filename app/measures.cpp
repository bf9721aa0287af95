#include "app/measures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "app/place.hpp"
#include "io/deck/expression.hpp"

namespace brunt {

namespace {
int component(const Field& field, const std::string& suffix) {
  static constexpr const char* tensor[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  for (int c = 0; c < field.components; ++c) {
    if (suffix == (field.components == 3 ? kAxes[c] : tensor[c])) return c;
  }
  if (field.components == 6 && suffix == "xz") return zx;
  throw std::invalid_argument("the field '" + field.name + "' has no component '" + suffix + "'");
}

std::vector<Real> pick(const Field& field, const std::string& suffix) {
  const auto n = field.values.size() / static_cast<std::size_t>(field.components);
  if (field.components == 1) return field.values;
  std::vector<Real> values(n);
  const bool magnitude = suffix == "magnitude" || suffix.empty();
  const int c = magnitude ? 0 : component(field, suffix);
  for (std::size_t i = 0; i < n; ++i) {
    const Real* v = &field.values[i * static_cast<std::size_t>(field.components)];
    if (!magnitude) {
      values[i] = v[c];
      continue;
    }
    Real square = 0;
    for (int k = 0; k < field.components; ++k) square += (k > 2 ? 2 : 1) * v[k] * v[k];
    values[i] = std::sqrt(square);
  }
  return values;
}

Real extent(const BodyView& view, int axis) {
  Real low = kInfinity, high = -kInfinity;
  for (std::size_t i = 0; i < view.position.size() / 3; ++i) {
    const Real x = view.position[3 * i + static_cast<std::size_t>(axis)];
    const Real radius = view.point_radius.empty() ? 0.0 : view.point_radius[i];
    low = std::min(low, x - radius), high = std::max(high, x + radius);
  }
  return high - low;
}

Real reduce_history(const deck::HistoryMeasure& measure, const MeasureSource& source) {
  const auto& names = *source.columns;
  const auto found = std::find(names.begin(), names.end(), measure.column);
  if (found == names.end()) {
    throw std::invalid_argument("there is no history column '" + measure.column + "'");
  }
  const auto column = static_cast<std::size_t>(found - names.begin());
  Real sum = 0, low = kInfinity, high = -kInfinity, last = 0, integral = 0, before = 0;
  std::size_t count = 0;
  for (const auto& row : *source.rows) {
    const Real t = row[0], value = row[column];
    if ((measure.from && t < *measure.from) || (measure.to && t > *measure.to)) continue;
    if (count > 0) integral += 0.5 * (t - before) * (value + last);
    sum += value, low = std::min(low, value), high = std::max(high, value);
    last = value, before = t, ++count;
  }
  if (count == 0) throw std::invalid_argument("no history row lies between `from` and `to`");
  switch (measure.reduce) {
    case deck::Reduce::mean:
      return sum / static_cast<Real>(count);
    case deck::Reduce::max:
      return high;
    case deck::Reduce::min:
      return low;
    case deck::Reduce::integral:
      return integral;
    default:
      return last;
  }
}

/// Speed of the centre of mass.
Real center_speed(const BodyView& view) {
  const Field* velocity = field_named(view.point_fields, "velocity");
  Real sum[3] = {0, 0, 0}, mass = 0;
  for (std::size_t i = 0; i < view.point_mass.size(); ++i) {
    mass += view.point_mass[i];
    for (std::size_t c = 0; c < 3; ++c) sum[c] += view.point_mass[i] * velocity->values[3 * i + c];
  }
  return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / mass;
}

struct Evaluate {
  const MeasureSource& source;
  const std::vector<MeasureValue>& before;

  Real operator()(const deck::ExtentMeasure& m) const {
    return extent(source.view(m.body), static_cast<int>(m.axis));
  }
  Real operator()(const deck::MinMeasure& m) const {
    const auto values = field_values(source.view(m.body), m.field);
    return *std::min_element(values.begin(), values.end());
  }
  Real operator()(const deck::MaxMeasure& m) const {
    const auto values = field_values(source.view(m.body), m.field);
    return *std::max_element(values.begin(), values.end());
  }
  Real operator()(const deck::MeanMeasure& m) const {
    std::vector<Real> weights;
    const auto values = field_values(source.view(m.body), m.field, &weights);
    Real sum = 0, total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += weights[i] * values[i], total += weights[i];
    }
    return sum / total;
  }
  Real operator()(const deck::PointMeasure& m) const {
    const BodyView view = source.view(m.body);
    const auto dot = m.field.find('.');
    const bool cells = field_named(view.cell_fields, m.field.substr(0, dot)) != nullptr;
    return value_at(find_place(source.start->at(m.body), m.at), field_values(view, m.field), cells);
  }
  Real operator()(const deck::HistoryMeasure& m) const { return reduce_history(m, source); }
  Real operator()(const deck::RestitutionMeasure& m) const {
    return center_speed(source.view(m.body)) / center_speed(source.start->at(m.body));
  }
  Real operator()(const deck::ExpressionMeasure& m) const {
    return evaluate_formula(m.formula, [this](const std::string& name) -> std::optional<Real> {
      for (const auto& measure : before) {
        if (measure.name == name) return measure.value;
      }
      return std::nullopt;
    });
  }
};
}  // namespace

std::size_t nearest_entity(const BodyView& start, const std::vector<Real>& at, bool cells) {
  const auto corners = static_cast<std::size_t>(cells ? start.corners : 1);
  const std::size_t n = cells ? start.connectivity.size() / corners : start.position.size() / 3;
  std::size_t best = 0;
  Real smallest = kInfinity;
  for (std::size_t e = 0; e < n; ++e) {
    Real square = 0;
    for (std::size_t c = 0; c < at.size(); ++c) {
      Real x = 0;
      for (std::size_t k = 0; k < corners; ++k) {
        const auto p = cells ? static_cast<std::size_t>(start.connectivity[e * corners + k]) : e;
        x += start.position[3 * p + c] / static_cast<Real>(corners);
      }
      square += (x - at[c]) * (x - at[c]);
    }
    if (square < smallest) smallest = square, best = e;
  }
  return best;
}

std::vector<Real> field_values(const BodyView& view, const std::string& field,
                               std::vector<Real>* weights) {
  const auto dot = field.find('.');
  const std::string name = field.substr(0, dot);
  const std::string suffix = dot == std::string::npos ? "" : field.substr(dot + 1);
  if (const Field* found = field_named(view.point_fields, name)) {
    if (weights) *weights = view.point_mass;
    return pick(*found, suffix);
  }
  if (const Field* found = field_named(view.cell_fields, name)) {
    if (weights) *weights = view.cell_volume;
    return pick(*found, suffix);
  }
  throw std::invalid_argument("the body '" + view.body + "' has no field '" + name + "'");
}

Real evaluate_measure(const deck::Measure& measure, const MeasureSource& source,
                      const std::vector<MeasureValue>& before) {
  return std::visit(Evaluate{source, before}, measure.kind);
}

}  // namespace brunt
