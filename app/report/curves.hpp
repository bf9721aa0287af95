#pragma once
#include <string>
#include <vector>

#include "io/drawing.hpp"
#include "io/history.hpp"

namespace brunt {

/// A quantity over time.
struct Curve {
  std::string name;
  std::vector<Real> values;  ///< one a row of the history
};

/// Curves that share an axis.
struct CurveChart {
  std::string title;
  std::string unit;  ///< SI
  std::vector<Curve> curves;
};

/// What of a history is worth a chart: energies, contact forces, reactions, sections, speeds, heat
/// and the time step. The largest eight of each kind, none of those that are zero throughout.
std::vector<CurveChart> charts_of(const History& history);

/// Curves over time on linear axes with a legend; each of at most some 600 line segments, which
/// keep the peaks.
Drawing draw_chart(const CurveChart& chart, const std::vector<Real>& time);

/// Round numbers from low to high, about `count` of them.
std::vector<Real> linear_ticks(Real low, Real high, int count);

}  // namespace brunt
