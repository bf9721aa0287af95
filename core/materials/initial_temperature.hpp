#pragma once
/// Temperature at time 0 as the deck gives it over the place.
#include <functional>
#include <stdexcept>
#include <string>

#include "core/types.hpp"

namespace brunt {

/// Temperature of one body at time 0.
struct InitialTemperature {
  Label body = 0;
  Vec3 origin = Vec3::Zero();              ///< [m] to which positions are relative
  std::function<Real(const Vec3&)> value;  ///< [K] over the absolute place [m]
  std::string material;                    ///< its name, for messages
  Real melting = kInfinity;                ///< [K] below which the material has a strength

  /// [K] at a position [m], what a plane scene leaves out 0. Throws InitialTemperatureError where
  /// it is no number, below 0 K, or such that the body would have no strength.
  Real at(const Vec3& position) const;
};

/// Says why a body cannot begin with a temperature, and where.
class InitialTemperatureError : public std::domain_error {
 public:
  InitialTemperatureError(Label of, const std::string& message)
      : std::domain_error(message), body(of) {}
  Label body;
};

}  // namespace brunt
// Tested by tests/verification/initial_temperature_test.cpp.
