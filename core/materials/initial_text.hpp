#pragma once
/// Numbers and places in what is said of states at time 0.
#include <sstream>
#include <string>

#include "core/types.hpp"

namespace brunt {

/// With four digits.
inline std::string short_number(Real value) {
  std::ostringstream out;
  out.precision(4);
  out << value;
  return out.str();
}

/// "at (0.1, 0, 0) m"
inline std::string at_place(const Vec3& place) {
  return "at (" + short_number(place[0]) + ", " + short_number(place[1]) + ", " +
         short_number(place[2]) + ") m";
}

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
