#pragma once
/// Numbers with their derivatives by the state of a flow law: what is computed with them has its
/// slopes too (forward differentiation, Clifford 1873; Wengert 1964).
#include <array>

#include "core/simd_math.hpp"

namespace brunt {

/// A value and its derivatives by eps_p, rate and temperature. V: Real or Pack.
template <class V>
struct Dual {
  V value;
  std::array<V, 3> slope;

  /// A function of this one, by its value and its slope there.
  BRUNT_INLINE Dual chained(V of_value, V of_slope) const {
    return {of_value, {of_slope * slope[0], of_slope * slope[1], of_slope * slope[2]}};
  }

  friend BRUNT_INLINE Dual operator+(const Dual& a, const Dual& b) {
    return {a.value + b.value,
            {a.slope[0] + b.slope[0], a.slope[1] + b.slope[1], a.slope[2] + b.slope[2]}};
  }
  friend BRUNT_INLINE Dual operator-(const Dual& a, const Dual& b) { return a + -1.0 * b; }
  friend BRUNT_INLINE Dual operator*(const Dual& a, const Dual& b) {
    Dual product{a.value * b.value, {}};
    for (std::size_t i = 0; i < 3; ++i) {
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
    return {a * b.value, {a * b.slope[0], a * b.slope[1], a * b.slope[2]}};
  }
  friend BRUNT_INLINE Dual operator*(const Dual& a, Real b) { return b * a; }
  friend BRUNT_INLINE Dual operator/(const Dual& a, Real b) { return (1.0 / b) * a; }
};

namespace detail {
/// Below it roots and powers have slopes that are infinite, of which 0 times would be no number.
template <class V>
BRUNT_INLINE V off_zero(V x) {
  return vmax(x, broadcast<V>(1e-300));
}
}  // namespace detail

template <class V>
BRUNT_INLINE Dual<V> vexp(const Dual<V>& x) {
  const V power = vexp(x.value);
  return x.chained(power, power);
}
template <class V>
BRUNT_INLINE Dual<V> vlog(const Dual<V>& x) {
  return x.chained(vlog(x.value), 1.0 / x.value);
}
template <class V>
BRUNT_INLINE Dual<V> vsqrt(const Dual<V>& x) {
  return x.chained(vsqrt(x.value), 0.5 / vsqrt(detail::off_zero(x.value)));
}
template <class V>
BRUNT_INLINE Dual<V> vpow(const Dual<V>& x, Real exponent) {
  const V base = detail::off_zero(x.value);
  return x.chained(vpow(x.value, exponent), exponent * (vpow(base, exponent) / base));
}

/// The larger of a number and a bound; below the bound nothing changes with it.
template <class V>
BRUNT_INLINE V held_above(V x, Real bound) {
  return vmax(x, broadcast<V>(bound));
}
template <class V>
BRUNT_INLINE Dual<V> held_above(const Dual<V>& x, Real bound) {
  const V zero = broadcast<V>(0.0), least = broadcast<V>(bound);
  const auto below = x.value < least;
  Dual<V> held{select(below, least, x.value), x.slope};
  for (V& one : held.slope) one = select(below, zero, one);
  return held;
}
/// The smaller of both.
template <class V>
BRUNT_INLINE V held_below(V x, Real bound) {
  return vmin(x, broadcast<V>(bound));
}
template <class V>
BRUNT_INLINE Dual<V> held_below(const Dual<V>& x, Real bound) {
  return -1.0 * held_above(-1.0 * x, -bound);
}

}  // namespace brunt
