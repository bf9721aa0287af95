#include "app/trade/chart.hpp"

#include <algorithm>
#include <cmath>

#include "io/number.hpp"

namespace brunt {

namespace {
constexpr Ink kBlack = {40, 40, 40}, kGrid = {226, 229, 233}, kFrame = {120, 126, 134};
constexpr Ink kFront = {20, 92, 158}, kDominated = {150, 150, 150};
constexpr int kPanelWidth = 600, kPanelHeight = 430;
constexpr int kLeft = 86, kRight = 28, kTop = 54, kBottom = 62;
constexpr int kLetter = 14;

struct ChartPoint {
  Real cost = 0, low = 0, high = 0, error = 0;  // error: of its size alone
  std::string label;
  bool on_front = false;
};

/// What a panel shows of one front.
std::vector<ChartPoint> points_of(const Trade& trade, const TradeFront& front) {
  std::vector<ChartPoint> points;
  for (std::size_t r = 0; r < trade.rows.size(); ++r) {
    const auto& error = front.errors[r];
    const auto& time = trade.rows[r].runs.processor;
    if (!error || !std::isfinite(error->error) || error->error == 0) continue;
    if (!(time.median > 0)) continue;
    if (front.against == Against::finest && trade.finest == r) continue;
    const Real factor = error->relative ? 100 : 1;
    points.push_back({time.median, time.low, time.high, factor * std::fabs(error->error),
                      trade.rows[r].label, !front.dominated_by[r].has_value()});
  }
  return points;
}

/// A logarithmic axis from low to high, on pixels a to b.
struct LogAxis {
  Real low = 1, high = 10, a = 0, b = 1;
  Real at(Real value) const { return a + (b - a) * std::log(value / low) / std::log(high / low); }
};

/// Room beyond the values, at least a factor of two in all.
LogAxis axis_of(Real low, Real high, Real a, Real b) {
  constexpr Real kRoom = 1.35;
  const Real widened = std::max(1.0, std::sqrt(2 * low / high));
  return {low / kRoom / widened, high * kRoom * widened, a, b};
}

struct PixelBox {
  Real x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  bool overlaps(const PixelBox& other) const {
    return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
  }
};

/// Places labels beside their marks, where there is the most room.
class Labels {
 public:
  explicit Labels(PixelBox panel) : panel_(panel) {}
  void avoid(const PixelBox& box) { taken_.push_back(box); }

  void place(Drawing& drawing, Real x, Real y, const std::string& label, const Ink& ink) {
    constexpr Real kAway = 10;
    const Real width = text_width(label, kLetter - 2), half = 0.5 * kLetter;
    struct Choice {
      Real x, y, anchor;
    };
    const Choice choices[] = {
        {x + kAway, y - kAway, 0},     {x - kAway, y - kAway, 1},     {x + kAway, y + kAway, 0},
        {x - kAway, y + kAway, 1},     {x, y - 1.6 * kAway, 0.5},     {x, y + 1.6 * kAway, 0.5},
        {x + 1.2 * kAway, y, 0},       {x - 1.2 * kAway, y, 1},       {x, y - 3.2 * kAway, 0.5},
        {x, y + 3.2 * kAway, 0.5},     {x + kAway, y - 3 * kAway, 0}, {x + kAway, y + 3 * kAway, 0},
        {x - kAway, y - 3 * kAway, 1}, {x - kAway, y + 3 * kAway, 1}};
    const Choice* best = nullptr;
    Real least = kInfinity;
    for (const auto& choice : choices) {
      const PixelBox box{choice.x - choice.anchor * width, choice.y - half,
                         choice.x + (1 - choice.anchor) * width, choice.y + half};
      Real cost = 0;
      for (const auto& other : taken_) cost += box.overlaps(other) ? 1 : 0;
      const bool inside =
          box.x0 >= panel_.x0 && box.x1 <= panel_.x1 && box.y0 >= panel_.y0 && box.y1 <= panel_.y1;
      if (!inside) cost += 10;
      if (cost < least) least = cost, best = &choice;
    }
    avoid({best->x - best->anchor * width, best->y - half, best->x + (1 - best->anchor) * width,
           best->y + half});
    drawing.texts.push_back(
        {best->x, best->y, label, kLetter - 2, best->anchor, false, false, ink});
  }

 private:
  PixelBox panel_;
  std::vector<PixelBox> taken_;
};

void draw_axes_of(Drawing& drawing, const PixelBox& panel, const LogAxis& x, const LogAxis& y) {
  for (const Real tick : log_ticks(x.low, x.high)) {
    const Real at = x.at(tick);
    drawing.lines.push_back({at, panel.y0, at, panel.y1, 1, kGrid});
    drawing.texts.push_back(
        {at, panel.y1 + 14, rounded(tick, 3), kLetter - 1, 0.5, false, false, kBlack});
  }
  for (const Real tick : log_ticks(y.low, y.high)) {
    const Real at = y.at(tick);
    drawing.lines.push_back({panel.x0, at, panel.x1, at, 1, kGrid});
    drawing.texts.push_back(
        {panel.x0 - 8, at, rounded(tick, 3), kLetter - 1, 1, false, false, kBlack});
  }
  drawing.lines.push_back({panel.x0, panel.y1, panel.x1, panel.y1, 1.5, kFrame});
  drawing.lines.push_back({panel.x0, panel.y0, panel.x0, panel.y1, 1.5, kFrame});
}

/// The front as steps: what more processor time buys.
void draw_front(Drawing& drawing, std::vector<ChartPoint> points, const LogAxis& x,
                const LogAxis& y, const PixelBox& panel) {
  std::erase_if(points, [](const ChartPoint& point) { return !point.on_front; });
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.cost < b.cost; });
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Real from = x.at(points[k].cost), level = y.at(points[k].error);
    const bool last = k + 1 == points.size();
    const Real to = last ? panel.x1 : x.at(points[k + 1].cost);
    drawing.lines.push_back({from, level, to, level, 2, kFront});
    if (!last) drawing.lines.push_back({to, level, to, y.at(points[k + 1].error), 2, kFront});
  }
}

std::string error_axis_title(const TradeFront& front) {
  const bool relative = std::any_of(front.errors.begin(), front.errors.end(),
                                    [](const auto& e) { return e && e->relative; });
  const std::string against = front.against == Against::finest
                                  ? "the finest run"
                                  : "the " + std::string(against_word(front.against)) + " value";
  const bool plain = front.unit.empty() || front.unit == "any" || front.unit == "1";
  const std::string unit = relative ? " [%]" : plain ? "" : " [" + front.unit + "]";
  return "error to " + against + unit;
}

void draw_panel(Drawing& drawing, const Trade& trade, const TradeFront& front, Real x0, Real y0) {
  const auto points = points_of(trade, front);
  const PixelBox panel{x0 + kLeft, y0 + kTop, x0 + kPanelWidth - kRight,
                       y0 + kPanelHeight - kBottom};
  const std::string name = front.measure == "all" ? "all measures, the largest" : front.measure;
  drawing.texts.push_back({panel.x0, panel.y0 - 18, name, kLetter + 2, 0, true, false, kBlack});
  const Real middle = 0.5 * (panel.x0 + panel.x1);
  if (points.empty()) {
    drawing.texts.push_back({middle, 0.5 * (panel.y0 + panel.y1), "no error to show", kLetter, 0.5,
                             false, false, kDominated});
    return;
  }
  Real least = kInfinity, most = 0, cheap = kInfinity, dear = 0;
  for (const auto& point : points) {
    least = std::min(least, point.error), most = std::max(most, point.error);
    cheap = std::min(cheap, point.low), dear = std::max(dear, point.high);
  }
  const LogAxis x = axis_of(cheap, dear, panel.x0, panel.x1);
  const LogAxis y = axis_of(least, most, panel.y1, panel.y0);
  draw_axes_of(drawing, panel, x, y);
  drawing.texts.push_back(
      {middle, panel.y1 + 40, "processor time [s]", kLetter, 0.5, false, false, kBlack});
  drawing.texts.push_back({x0 + 22, 0.5 * (panel.y0 + panel.y1), error_axis_title(front), kLetter,
                           0.5, false, true, kBlack});
  draw_front(drawing, points, x, y, panel);
  Labels labels(panel);
  for (const auto& point : points) {
    const Real at = x.at(point.cost), level = y.at(point.error);
    const Ink& ink = point.on_front ? kFront : kDominated;
    drawing.lines.push_back({x.at(point.low), level, x.at(point.high), level, 1.5, ink});
    drawing.marks.push_back({at, level, 5, ink, point.on_front});
    constexpr Real kMark = 7;
    labels.avoid({at - kMark, level - kMark, at + kMark, level + kMark});
  }
  for (const bool on_front : {true, false}) {
    for (const auto& point : points) {
      if (point.on_front != on_front) continue;
      labels.place(drawing, x.at(point.cost), y.at(point.error), point.label,
                   on_front ? kBlack : kFrame);
    }
  }
}
}  // namespace

std::vector<Real> log_ticks(Real low, Real high) {
  constexpr Real kWide = 200;  // beyond this powers of ten suffice
  const bool powers_alone = high / low > kWide;
  std::vector<Real> ticks;
  for (int power = static_cast<int>(std::floor(std::log10(low))); std::pow(10, power) <= high;
       ++power) {
    for (const Real digit : {1.0, 2.0, 5.0}) {
      const Real tick = digit * std::pow(10, power);
      if (tick >= low && tick <= high && (digit == 1.0 || !powers_alone)) ticks.push_back(tick);
    }
  }
  return ticks;
}

Drawing trade_chart(const Trade& trade) {
  Drawing drawing;
  constexpr int kTitle = 66;
  const auto panels = static_cast<int>(trade.fronts.size());
  const int columns = panels > 1 ? 2 : 1, rows = (panels + columns - 1) / columns;
  drawing.width = columns * kPanelWidth;
  drawing.height = kTitle + rows * kPanelHeight;
  drawing.texts.push_back({30, 26, trade.title, kLetter + 4, 0, true, false, kBlack});
  drawing.marks.push_back({36, 52, 5, kFront, true});
  const std::string front = "on the front";
  drawing.texts.push_back({48, 52, front, kLetter - 1, 0, false, false, kBlack});
  drawing.marks.push_back({160, 52, 5, kDominated, false});
  drawing.texts.push_back({172, 52, "dominated: another is cheaper and no worse", kLetter - 1, 0,
                           false, false, kBlack});
  for (int k = 0; k < panels; ++k) {
    const int row = k / columns, column = k % columns;
    draw_panel(drawing, trade, trade.fronts[slot_of(k)], column * kPanelWidth,
               kTitle + row * kPanelHeight);
  }
  return drawing;
}

}  // namespace brunt
// Tested by tests/unit/app/trade_results_test.cpp.
