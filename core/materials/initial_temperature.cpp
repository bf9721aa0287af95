#include "core/materials/initial_temperature.hpp"

#include <cmath>
#include <sstream>

namespace brunt {

namespace {
std::string number(Real value) {
  std::ostringstream out;
  out.precision(4);
  out << value;
  return out.str();
}
}  // namespace

Real InitialTemperature::at(const Vec3& position) const {
  const Vec3 place = origin + position;
  const Real T = value(place);
  std::string wrong;
  if (!std::isfinite(T)) {
    wrong = "is no number";
  } else if (T < 0) {
    wrong = "is " + number(T) + " K, below 0 K";
  } else if (T >= melting) {
    wrong = "is " + number(T) + " K, and '" + material + "' melts at T_melt = " + number(melting) +
            " K, where it has no strength";
  }
  if (wrong.empty()) return T;
  throw InitialTemperatureError(body, wrong + ", at (" + number(place[0]) + ", " +
                                          number(place[1]) + ", " + number(place[2]) +
                                          ") m; an expression takes metres and gives kelvins");
}

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
