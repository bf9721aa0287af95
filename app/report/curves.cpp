#include "app/report/curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "io/number.hpp"

namespace brunt {

namespace {
constexpr std::size_t kMostCurves = 8;
constexpr std::array<Ink, kMostCurves> kInks{{{20, 92, 158},
                                              {200, 80, 20},
                                              {30, 130, 76},
                                              {150, 40, 120},
                                              {120, 90, 30},
                                              {60, 60, 60},
                                              {0, 150, 170},
                                              {190, 30, 50}}};
constexpr Ink kBlack = {40, 40, 40}, kGrid = {226, 229, 233}, kFrame = {120, 126, 134};
constexpr int kWidth = 760, kHeight = 340, kLegend = 250, kLetter = 13;
constexpr int kLeft = 84, kTop = 40, kBottom = 52;

Real size_of(const Curve& curve) {
  Real size = 0;
  for (const Real value : curve.values) {
    if (std::isfinite(value)) size = std::max(size, std::fabs(value));
  }
  return size;
}

std::vector<Real> column(const History& history, std::size_t index) {
  std::vector<Real> values;
  values.reserve(history.rows.size());
  for (const auto& row : history.rows) values.push_back(row[index]);
  return values;
}

/// The largest curves, none below `least` of the largest of all.
std::vector<Curve> largest(std::vector<Curve> curves, Real least) {
  std::stable_sort(curves.begin(), curves.end(),
                   [](const Curve& a, const Curve& b) { return size_of(a) > size_of(b); });
  const Real top = curves.empty() ? 0 : size_of(curves.front());
  std::erase_if(curves, [&](const Curve& curve) {
    const Real size = size_of(curve);
    return !(size > 0) || size < least * top;
  });
  if (curves.size() > kMostCurves) curves.resize(kMostCurves);
  return curves;
}

/// Lengths of vectors `PREFIX.NAME.WHAT.x`, `.y`, `.z`, by NAME.
std::vector<Curve> lengths(const History& history, const std::string& prefix,
                           const std::string& what) {
  std::map<std::string, std::vector<std::size_t>> parts;
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    const std::string& name = history.columns[c];
    const std::string end = "." + what + ".";
    if (!name.starts_with(prefix) || name.size() < prefix.size() + end.size() + 1) continue;
    const std::size_t at = name.size() - 1 - end.size();
    if (at < prefix.size() || name.compare(at, end.size(), end) != 0) continue;
    parts[name.substr(prefix.size(), at - prefix.size())].push_back(c);
  }
  std::vector<Curve> curves;
  for (const auto& [name, columns] : parts) {
    Curve& curve = curves.emplace_back(Curve{name, {}});
    for (const auto& row : history.rows) {
      Real square = 0;
      for (const std::size_t c : columns) square += row[c] * row[c];
      curve.values.push_back(std::sqrt(square));
    }
  }
  return curves;
}

/// Columns `PREFIX.NAME.WHAT`, by NAME; `what` empty: the rest of the name.
std::vector<Curve> scalars(const History& history, const std::string& prefix,
                           const std::string& what) {
  std::vector<Curve> curves;
  for (std::size_t c = 0; c < history.columns.size(); ++c) {
    const std::string& name = history.columns[c];
    if (!name.starts_with(prefix) || !name.ends_with(what)) continue;
    if (name.size() <= prefix.size() + what.size()) continue;
    const std::string own = name.substr(prefix.size(), name.size() - prefix.size() - what.size());
    if (own == "drift") continue;
    curves.push_back({own, column(history, c)});
  }
  return curves;
}

/// A power of a thousand and its prefix, so that numbers up to `size` are easy to read.
std::pair<Real, std::string> prefix_of(Real size) {
  static constexpr std::pair<Real, const char*> kPrefixes[] = {
      {1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}};
  for (const auto& [factor, word] : kPrefixes) {
    if (size >= factor) return {factor, word};
  }
  return {1e-12, "p"};
}

struct Axis {
  Real low = 0, high = 1, a = 0, b = 1;
  Real at(Real value) const { return a + (b - a) * (value - low) / (high - low); }
};

struct Frame {
  Axis x, y;
  Real x_unit = 1, y_unit = 1;
};

void draw_axes_of(Drawing& drawing, const Frame& frame, const std::string& x_title,
                  const std::string& y_title) {
  const auto& [x, y, x_unit, y_unit] = frame;
  for (const Real tick : linear_ticks(x.low, x.high, 6)) {
    drawing.lines.push_back({x.at(tick), y.a, x.at(tick), y.b, 1, kGrid});
    drawing.texts.push_back(
        {x.at(tick), y.a + 13, rounded(tick / x_unit, 4), kLetter - 1, 0.5, false, false, kBlack});
  }
  for (const Real tick : linear_ticks(y.low, y.high, 5)) {
    drawing.lines.push_back({x.a, y.at(tick), x.b, y.at(tick), 1, kGrid});
    drawing.texts.push_back(
        {x.a - 7, y.at(tick), rounded(tick / y_unit, 4), kLetter - 1, 1, false, false, kBlack});
  }
  drawing.lines.push_back({x.a, y.a, x.b, y.a, 1.5, kFrame});
  drawing.lines.push_back({x.a, y.a, x.a, y.b, 1.5, kFrame});
  drawing.texts.push_back(
      {0.5 * (x.a + x.b), y.a + 36, x_title, kLetter, 0.5, false, false, kBlack});
  drawing.texts.push_back({20, 0.5 * (y.a + y.b), y_title, kLetter, 0.5, false, true, kBlack});
}

/// The rows that stand for all of a curve: of each of 300 spans of rows the least and the largest.
std::vector<std::size_t> shown_rows(const std::vector<Real>& values) {
  constexpr std::size_t kSpans = 300;
  std::vector<std::size_t> rows;
  const std::size_t n = values.size(), spans = std::min(n, kSpans);
  for (std::size_t s = 0; s < spans; ++s) {
    const std::size_t first = s * n / spans, last = (s + 1) * n / spans;
    std::size_t least = first, most = first;
    for (std::size_t i = first; i < last; ++i) {
      if (values[i] < values[least]) least = i;
      if (values[i] > values[most]) most = i;
    }
    rows.push_back(std::min(least, most));
    if (least != most) rows.push_back(std::max(least, most));
  }
  if (n > 0 && rows.back() != n - 1) rows.push_back(n - 1);
  return rows;
}
}  // namespace

std::vector<Real> linear_ticks(Real low, Real high, int count) {
  std::vector<Real> ticks;
  if (!(high > low)) return ticks;
  const Real raw = (high - low) / count, power = std::pow(10, std::floor(std::log10(raw)));
  Real step = 10 * power;
  for (const Real digit : {5.0, 2.0, 1.0}) {
    if (raw <= digit * power) step = digit * power;
  }
  const Real slack = 1e-9 * (high - low);
  for (Real k = std::ceil((low - slack) / step); k * step <= high + slack; ++k) {
    ticks.push_back(k == 0 ? 0 : k * step);
  }
  return ticks;
}

std::vector<CurveChart> charts_of(const History& history) {
  constexpr Real kWorthShowing = 0.005;
  std::vector<CurveChart> charts{
      {"Energies", "J", largest(scalars(history, "energy.", ""), kWorthShowing)},
      {"Contact forces", "N", largest(lengths(history, "contact.", "force"), 0)},
      {"Reactions of boundaries", "N", largest(lengths(history, "boundary.", "reaction"), 0)},
      {"Forces through sections", "N", largest(lengths(history, "section.", "force"), 0)},
      {"Speeds of bodies", "m/s", largest(lengths(history, "body.", "velocity"), 0)},
      {"Heat of bodies", "J", largest(scalars(history, "body.", ".heat"), 0)},
      {"Time step", "s", {}}};
  if (const int step = history.index("dt"); step >= 0) {
    charts.back().curves.push_back({"dt", column(history, slot_of(step))});
  }
  std::erase_if(charts, [](const CurveChart& chart) { return chart.curves.empty(); });
  return charts;
}

Drawing draw_chart(const CurveChart& chart, const std::vector<Real>& time) {
  Drawing drawing;
  drawing.width = kWidth + kLegend, drawing.height = kHeight;
  Real low = 0, high = 0;
  for (const Curve& curve : chart.curves) {
    for (const Real value : curve.values) {
      if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    }
  }
  if (!(high > low)) high = low + 1;
  const Real room = 0.04 * (high - low);
  low -= low < 0 ? room : 0, high += high > 0 ? room : 0;
  Real end = time.empty() ? 1 : time.back();
  const Real begin = time.empty() ? 0 : time.front();
  if (!(end > begin)) end = begin + 1;
  const auto [x_unit, x_word] = prefix_of(std::max(std::fabs(begin), std::fabs(end)));
  const auto [y_unit, y_word] = prefix_of(std::max(-low, high));
  const Frame frame{
      {begin, end, kLeft, kWidth - 20}, {low, high, kHeight - kBottom, kTop}, x_unit, y_unit};
  drawing.texts.push_back({kLeft, 20, chart.title, kLetter + 3, 0, true, false, kBlack});
  draw_axes_of(drawing, frame, "time [" + x_word + "s]", "[" + y_word + chart.unit + "]");
  for (std::size_t c = 0; c < chart.curves.size(); ++c) {
    const auto& [name, values] = chart.curves[c];
    const Ink& ink = kInks[c % kMostCurves];
    const auto rows = shown_rows(values);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      const std::size_t i = rows[k - 1], j = rows[k];
      if (!std::isfinite(values[i]) || !std::isfinite(values[j])) continue;
      drawing.lines.push_back({frame.x.at(time[i]), frame.y.at(values[i]), frame.x.at(time[j]),
                               frame.y.at(values[j]), 1.6, ink});
    }
    const Real level = kTop + 10 + 22 * static_cast<Real>(c);
    drawing.lines.push_back({kWidth, level, kWidth + 22, level, 3, ink});
    drawing.texts.push_back({kWidth + 30, level, name, kLetter, 0, false, false, kBlack});
  }
  return drawing;
}

}  // namespace brunt
