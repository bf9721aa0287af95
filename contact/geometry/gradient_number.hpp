#pragma once
#include <array>
#include <cmath>
#include <type_traits>

#include "core/types.hpp"

namespace brunt {

/// A number with its derivatives by n variables: what is computed with it has its gradient too.
template <int n>
struct GradientNumber {
  Real value = 0;
  std::array<Real, n> slope{};

  GradientNumber() = default;
  explicit GradientNumber(Real constant) : value(constant) {}

  /// A function of this one by its value and its slope there.
  GradientNumber chained(Real of_value, Real of_slope) const {
    GradientNumber result(of_value);
    for (std::size_t i = 0; i < n; ++i) result.slope[i] = of_slope * slope[i];
    return result;
  }
  friend GradientNumber operator+(GradientNumber a, const GradientNumber& b) {
    a.value += b.value;
    for (std::size_t i = 0; i < n; ++i) a.slope[i] += b.slope[i];
    return a;
  }
  friend GradientNumber operator-(GradientNumber a, const GradientNumber& b) {
    a.value -= b.value;
    for (std::size_t i = 0; i < n; ++i) a.slope[i] -= b.slope[i];
    return a;
  }
  friend GradientNumber operator*(const GradientNumber& a, const GradientNumber& b) {
    GradientNumber result(a.value * b.value);
    for (std::size_t i = 0; i < n; ++i) {
      result.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
    }
    return result;
  }
  friend GradientNumber operator/(const GradientNumber& a, const GradientNumber& b) {
    return a * b.chained(1 / b.value, -1 / (b.value * b.value));
  }
};

inline Real value_of(Real x) { return x; }
template <int n>
Real value_of(const GradientNumber<n>& x) {
  return x.value;
}
inline Real root_of(Real x) { return std::sqrt(x); }
template <int n>
GradientNumber<n> root_of(const GradientNumber<n>& x) {
  const Real root = std::sqrt(x.value);
  return x.chained(root, 0.5 / root);
}

/// The variable with a number; of plain numbers its value alone.
template <class Number>
Number variable(Real value, int i) {
  Number x(value);
  if constexpr (!std::is_same_v<Number, Real>) x.slope[slot_of(i)] = 1;
  return x;
}

}  // namespace brunt
