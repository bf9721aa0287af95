#include "app/watch/measures.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "app/scene/field_values.hpp"
#include "app/scene/place.hpp"
#include "io/deck/expression.hpp"

namespace brunt {

namespace {
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
    const BodyView& view = source.view(m.body);
    const auto dot = m.field.find('.');
    const bool cells = field_named(view.cell_fields, m.field.substr(0, dot)) != nullptr;
    return value_at(find_place(source.start->at(m.body), m.at), field_values(view, m.field), cells);
  }
  Real operator()(const deck::HistoryMeasure& m) const { return reduce_history(m, source); }
  Real operator()(const deck::RestitutionMeasure& m) const {
    const auto speed = &deck::SpeedMeasure::speed_of;
    return speed(source.view(m.body)) / speed(source.start->at(m.body));
  }
  template <class Own>
  Real operator()(const Own& own) const {
    return own.value(source);
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

std::optional<MeasureReads> reads_of(const deck::Measure& measure) {
  return std::visit(
      [](const auto& kind) -> std::optional<MeasureReads> {
        using Kind = std::remove_cvref_t<decltype(kind)>;
        if constexpr (requires { kind.body; }) {
          MeasureReads reads{kind.body, kNoFields};
          if constexpr (requires { kind.field; }) {
            reads.fields = {{{kind.field.substr(0, kind.field.find('.'))}}};
          } else if constexpr (requires { Kind::reads; }) {
            reads.fields = {{{Kind::reads}}};
          }
          reads.at_start = std::is_same_v<Kind, deck::PointMeasure> ||
                           std::is_same_v<Kind, deck::RestitutionMeasure>;
          return reads;
        } else {
          return std::nullopt;
        }
      },
      measure.kind);
}

Real evaluate_measure(const deck::Measure& measure, const MeasureSource& source,
                      const std::vector<MeasureValue>& before) {
  return std::visit(Evaluate{source, before}, measure.kind);
}

}  // namespace brunt
