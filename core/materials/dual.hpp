#pragma once
/// Numbers with their derivatives by the state of a flow law: what is computed with them has its
/// slopes too (forward differentiation, Clifford 1873; Wengert 1964).
#include <array>

#include "core/simd_math.hpp"

namespace brunt {

/// A value and its derivatives by n variables; of a flow law: eps_p, rate and temperature.
/// V: Real or Pack.
template <class V, std::size_t n = 3>
struct Dual {
  V value;
  std::array<V, n> slope;

  /// A function of this one, by its value and its slope there.
  BRUNT_INLINE Dual chained(V of_value, V of_slope) const {
    Dual result{of_value, slope};
    for (V& one : result.slope) one = of_slope * one;
    return result;
  }

  friend BRUNT_INLINE Dual operator+(const Dual& a, const Dual& b) {
    Dual sum{a.value + b.value, a.slope};
    for (std::size_t i = 0; i < n; ++i) sum.slope[i] = a.slope[i] + b.slope[i];
    return sum;
  }
  friend BRUNT_INLINE Dual operator-(const Dual& a, const Dual& b) { return a + -1.0 * b; }
  friend BRUNT_INLINE Dual operator*(const Dual& a, const Dual& b) {
    Dual product{a.value * b.value, {}};
    for (std::size_t i = 0; i < n; ++i) {
      product.slope[i] = a.slope[i] * b.value + a.value * b.slope[i];
    }
    return product;
  }
  friend BRUNT_INLINE Dual operator/(const Dual& a, const Dual& b) {
    const V inverse = 1.0 / b.value;
    return a * b.chained(inverse, -(inverse * inverse));
  }
  friend BRUNT_INLINE Dual operator+(const Dual& a, Real b) { return {a.value + b, a.slope}; }
  friend BRUNT_INLINE Dual operator+(Real a, const Dual& b) { return b + a; }
  friend BRUNT_INLINE Dual operator-(const Dual& a, Real b) { return a + -b; }
  friend BRUNT_INLINE Dual operator-(Real a, const Dual& b) { return -1.0 * b + a; }
  friend BRUNT_INLINE Dual operator*(Real a, const Dual& b) {
    return b.chained(a * b.value, broadcast<V>(a));
  }
  friend BRUNT_INLINE Dual operator*(const Dual& a, Real b) { return b * a; }
  friend BRUNT_INLINE Dual operator/(const Dual& a, Real b) { return (1.0 / b) * a; }
  /// Times what does not depend on the variables.
  friend BRUNT_INLINE Dual operator*(const Dual& a, V b) requires(lanes_of<V> > 1) {
    return a.chained(a.value * b, b);
  }
};

namespace detail {
/// Below it roots and powers have slopes that are infinite, of which 0 times would be no number.
template <class V>
BRUNT_INLINE V off_zero(V x) {
  return vmax(x, broadcast<V>(1e-300));
}
}  // namespace detail

template <class V, std::size_t n>
BRUNT_INLINE Dual<V, n> vexp(const Dual<V, n>& x) {
  const V power = vexp(x.value);
  return x.chained(power, power);
}
template <class V, std::size_t n>
BRUNT_INLINE Dual<V, n> vlog(const Dual<V, n>& x) {
  return x.chained(vlog(x.value), 1.0 / x.value);
}
template <class V, std::size_t n>
BRUNT_INLINE Dual<V, n> vsqrt(const Dual<V, n>& x) {
  return x.chained(vsqrt(x.value), 0.5 / vsqrt(detail::off_zero(x.value)));
}
template <class V, std::size_t n>
BRUNT_INLINE Dual<V, n> vpow(const Dual<V, n>& x, Real exponent) {
  const V base = detail::off_zero(x.value), power = vpow(x.value, exponent);
  V power_of_base = power;
  if (any(x.value < base)) power_of_base = vpow(base, exponent);
  return x.chained(power, exponent * (power_of_base / base));
}

/// The larger of a number and a bound; below the bound nothing changes with it.
template <class V>
BRUNT_INLINE V held_above(V x, Real bound) {
  return vmax(x, broadcast<V>(bound));
}
template <class V, std::size_t n>
BRUNT_INLINE Dual<V, n> held_above(const Dual<V, n>& x, Real bound) {
  const V zero = broadcast<V>(0.0), least = broadcast<V>(bound);
  const auto below = x.value < least;
  Dual<V, n> held{select(below, least, x.value), x.slope};
  for (V& one : held.slope) one = select(below, zero, one);
  return held;
}
/// The smaller of both.
template <class V>
BRUNT_INLINE V held_below(V x, Real bound) {
  return vmin(x, broadcast<V>(bound));
}
template <class V, std::size_t n>
BRUNT_INLINE Dual<V, n> held_below(const Dual<V, n>& x, Real bound) {
  return -1.0 * held_above(-1.0 * x, -bound);
}

}  // namespace brunt
