#include "core/materials/initial_temperature.hpp"

#include <cmath>

#include "core/materials/initial_text.hpp"

namespace brunt {

Real InitialTemperature::at(const Vec3& position) const {
  const Vec3 place = origin + position;
  const Real T = value(place);
  std::string wrong;
  if (!std::isfinite(T)) {
    wrong = "is no number";
  } else if (T < 0) {
    wrong = "is " + short_number(T) + " K, below 0 K";
  } else if (T >= melting) {
    wrong = "is " + short_number(T) + " K, and '" + material +
            "' melts at T_melt = " + short_number(melting) + " K, where it has no strength";
  }
  if (wrong.empty()) return T;
  throw InitialTemperatureError(
      body, wrong + ", " + at_place(place) + "; an expression takes metres and gives kelvins");
}

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
