#include "app/watch/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "app/scene/field_values.hpp"
#include "app/scene/place.hpp"
#include "app/watch/parts.hpp"
#include "io/deck/expression.hpp"

namespace brunt {

namespace {
/// What is measured is no longer there.
constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();

Real extent(const BodyView& view, int axis) {
  Real low = kInfinity, high = -kInfinity;
  for (std::size_t i = 0; i < view.position.size() / 3; ++i) {
    const Real x = view.position[3 * i + slot_of(axis)];
    const Real radius = view.point_radius.empty() ? 0.0 : view.point_radius[i];
    low = std::min(low, x - radius), high = std::max(high, x + radius);
  }
  return low <= high ? high - low : kNone;  // all of it may have eroded
}

Real reduce_history(const deck::HistoryMeasure& measure, const MeasureSource& source) {
  const auto& names = *source.columns;
  const auto found = std::find(names.begin(), names.end(), measure.column);
  if (found == names.end()) {
    throw std::invalid_argument("there is no history column '" + measure.column + "'");
  }
  const auto column = slot_of(found - names.begin());
  Real sum = 0, low = kInfinity, high = -kInfinity, last = 0, integral = 0, before = 0;
  std::size_t count = 0;
  for (const auto& row : *source.rows) {
    const Real t = row[0], value = row[column];
    if ((measure.from && t < *measure.from) || (measure.to && t > *measure.to)) continue;
    if (count > 0) integral += 0.5 * (t - before) * (value + last);
    sum += value, low = std::min(low, value), high = std::max(high, value);
    last = value, before = t, ++count;
  }
  if (count == 0) {
    throw std::invalid_argument(
        "no history row lies between `from` and `to`: a shorter output.history writes more");
  }
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

/// The entry of `now` with the id that entry `at` of `start` has.
std::optional<std::size_t> entry_now(const std::vector<Field>& start, const std::vector<Field>& now,
                                     std::size_t at) {
  const Field *before = field_named(start, "id"), *after = field_named(now, "id");
  if (before == nullptr || after == nullptr) return at;
  const auto& ids = after->values;
  const auto found = std::find(ids.begin(), ids.end(), before->values[at]);
  if (found == ids.end()) return std::nullopt;
  return slot_of(found - ids.begin());
}

/// A place of time 0 among what is left by now; none where a part of it has eroded.
std::optional<Place> place_now(Place place, const BodyView& start, const BodyView& now,
                               bool cells) {
  if (cells) {
    const auto cell = entry_now(start.cell_fields, now.cell_fields, place.cell);
    if (!cell) return std::nullopt;
    place.cell = *cell;
    return place;
  }
  for (auto& point : place.points) {
    const auto here = entry_now(start.point_fields, now.point_fields, point);
    if (!here) return std::nullopt;
    point = *here;
  }
  return place;
}

/// True where a field such as "stress.xx" is of cells; what is of points too counts as theirs.
bool has_cell_field(const BodyView& view, const std::string& field) {
  const std::string name = field.substr(0, field.find('.'));
  return field_named(view.point_fields, name) == nullptr &&
         field_named(view.cell_fields, name) != nullptr;
}

struct Evaluate {
  const MeasureSource& source;
  const std::vector<MeasureValue>& before;

  Real operator()(const deck::ExtentMeasure& m) const {
    return extent(source.view(m.body), static_cast<int>(m.axis));
  }
  /// Values of a part of the body, or of all of it.
  template <class M>
  std::vector<Real> values_of(const M& m, std::vector<Real>* weights = nullptr) const {
    const BodyView& view = source.view(m.body);
    auto values = field_values(view, m.field, weights);
    if (std::holds_alternative<deck::WhereAll>(m.where)) return values;
    const auto held =
        held_now(m.where, source.start->at(m.body), view, has_cell_field(view, m.field));
    const auto leave_out = [&](std::vector<Real>& all) {
      std::size_t n = 0;
      for (std::size_t i = 0; i < held.size(); ++i) {
        if (held[i] != 0) all[n++] = all[i];
      }
      all.resize(n);
    };
    leave_out(values);
    if (weights != nullptr) leave_out(*weights);
    return values;
  }
  Real operator()(const deck::MinMeasure& m) const {
    const auto values = values_of(m);
    return values.empty() ? kNone : *std::min_element(values.begin(), values.end());
  }
  Real operator()(const deck::MaxMeasure& m) const {
    const auto values = values_of(m);
    return values.empty() ? kNone : *std::max_element(values.begin(), values.end());
  }
  Real operator()(const deck::MeanMeasure& m) const {
    std::vector<Real> weights;
    const auto values = values_of(m, &weights);
    Real sum = 0, total = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += weights[i] * values[i], total += weights[i];
    }
    return sum / total;
  }
  Real operator()(const deck::PointMeasure& m) const {
    const BodyView& view = source.view(m.body);
    const bool cells = has_cell_field(view, m.field);
    const BodyView& start = source.start->at(m.body);
    const auto place = place_now(find_place(start, m.at), start, view, cells);
    return place ? value_at(*place, field_values(view, m.field), cells, odd_axes(m.field)) : kNone;
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
          if constexpr (requires { Kind::reads_start; }) reads.at_start = true;
          if constexpr (requires { kind.where; }) {
            reads.at_start = !std::holds_alternative<deck::WhereAll>(kind.where);
          }
          if (reads.at_start) reads.fields.names->push_back("id");  // to find entries again
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
