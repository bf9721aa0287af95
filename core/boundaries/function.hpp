#pragma once
#include <array>
#include <functional>
#include <optional>

#include "core/schema.hpp"

namespace brunt {

/// A value as a function of time [s] and of the place [m] at time 0, absolute. May be called by
/// many threads at once.
using FunctionOfTimeAndPlace = std::function<Real(Real t, const Vec3& start)>;

/// The function that a deck's constant, table over time or expression of t, x, y, z is.
inline FunctionOfTimeAndPlace function_of(const Varying& varying) {
  if (varying.over == Varying::Over::expression) {
    return [evaluate = varying.evaluate](Real t, const Vec3& x) {
      return evaluate({t, x[0], x[1], x[2]});
    };
  }
  return [varying](Real t, const Vec3&) { return varying.at(t); };
}
/// None where the deck says nothing.
inline std::optional<FunctionOfTimeAndPlace> function_of(const std::optional<Varying>& varying) {
  if (!varying) return std::nullopt;
  return function_of(*varying);
}

/// What such a value may depend on in a deck.
inline constexpr std::array kTimeOrPlace{Varying::Over::time, Varying::Over::expression};

}  // namespace brunt
// Tested by tests/verification/pressure_test.cpp.
