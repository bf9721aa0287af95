#pragma once
#include <cmath>

#include "app/deck/measure_source.hpp"
#include "core/schema.hpp"

namespace brunt::deck {

/// Speed of a body's centre of mass: |sum m v| / sum m [m/s].
struct SpeedMeasure {
  static constexpr const char* deck_name = "speed";
  static constexpr const char* deck_help = "speed of a body's centre of mass";
  static constexpr const char* unit = "m/s";
  static constexpr const char* reads = "velocity";
  std::string body;

  Real value(const MeasureSource& source) const { return speed_of(source.view(body)); }

  static Real speed_of(const BodyView& view) {
    const Field* velocity = field_named(view.point_fields, "velocity");
    Real sum[3] = {0, 0, 0}, mass = 0;
    for (std::size_t i = 0; i < view.point_mass.size(); ++i) {
      mass += view.point_mass[i];
      for (std::size_t c = 0; c < 3; ++c) {
        sum[c] += view.point_mass[i] * velocity->values[3 * i + c];
      }
    }
    return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]) / mass;
  }
};

inline void describe(Schema& s, SpeedMeasure& measure) {
  s.text({"body", "name of a body, or of a piece of one: wall.1.0", Need::required}, measure.body);
}

}  // namespace brunt::deck
// Tested by tests/unit/app/measures_test.cpp.
