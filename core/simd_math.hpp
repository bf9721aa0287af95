#pragma once
/// exp, log and pow on V = Real, Pack or Wide, with the same bits for a Real and for each lane
/// on every instruction set: additions, products, fused or not by name, divisions and bits alone,
/// in one fixed order.
#include <bit>
#include <type_traits>

#include "core/simd.hpp"

namespace brunt {

/// The type of the bits of V, and of its comparisons.
template <class V>
using BitsOf = std::conditional_t<lanes_of<V> == 1, long long, MaskOf<V>>;

template <class V>
BRUNT_INLINE BitsOf<V> bits_of(V x) {
  return __builtin_bit_cast(BitsOf<V>, x);
}
template <class V>
BRUNT_INLINE V from_bits(BitsOf<V> bits) {
  return __builtin_bit_cast(V, bits);
}

namespace detail {
inline constexpr Real kRound = 6755399441055744.0;  // 1.5 2^52: adding it leaves a whole number
inline constexpr Real kLn2High =
    6.93147180369123816490e-01;  // 33 bits: its whole multiples are exact
inline constexpr Real kLn2Low = 1.90821492927058770002e-10;

/// 2^k of a whole number k in [-1022, 1023].
template <class V>
BRUNT_INLINE V power_of_two(V k) {
  return from_bits<V>((bits_of<V>(k + kRound) + 1023) << 52);  // the shift drops kRound's own bits
}
}  // namespace detail

/// e^x within one unit in the last place. Above 709.79 infinity, below -745.2 zero, gradual
/// underflow between; NaN stays NaN.
template <class V>
BRUNT_INLINE V vexp(V x) {
  const V in_range = vmin(broadcast<V>(710.0), vmax(broadcast<V>(-746.0), x));
  const V k = line_at(in_range, detail::kRound, 1.44269504088896340736) - detail::kRound;
  const V r = vfma(k, broadcast<V>(-detail::kLn2Low), in_range - k * detail::kLn2High);
  // Taylor to degree 13 on |r| <= ln(2)/2, summed in pairs (Estrin); 1 + r comes last
  const V r2 = r * r, r4 = r2 * r2;
  const V a = line_at(r, 1.0 / 2, 1.0 / 6), b = line_at(r, 1.0 / 24, 1.0 / 120);
  const V c = line_at(r, 1.0 / 720, 1.0 / 5040), d = line_at(r, 1.0 / 40320, 1.0 / 362880);
  const V e = line_at(r, 1.0 / 3628800, 1.0 / 39916800);
  const V f = line_at(r, 1.0 / 479001600, 1.0 / 6227020800.0);
  const V high = vfma(r4, vfma(r2, f, e), vfma(r2, d, c));
  const V series = vfma(r4, high, vfma(r2, b, a));
  const V result = 1.0 + vfma(r2, series, r);
  // two factors, so that 2^1024 and 2^-1074 are reached
  const V half = line_at(k, detail::kRound, 0.5) - detail::kRound;
  return (result * detail::power_of_two(half)) * detail::power_of_two(k - half);
}

namespace detail {
/// ln(x 2^-shift) of a positive normal number x.
template <class V>
BRUNT_INLINE V log_of_normal(V x, V shift) {
  constexpr long long kMantissa = 0xfffffffffffffLL, kHalf = 0x3feLL << 52;
  const BitsOf<V> bits = bits_of<V>(x);
  // the exponent's bits, below those of 2^52, read as a number; x = mantissa 2^exponent
  const V biased = from_bits<V>(((bits >> 52) & 0x7ffLL) | bits_of<V>(broadcast<V>(0x1p52)));
  V exponent = (biased - (0x1p52 + 1022.0)) - shift;
  V mantissa = from_bits<V>((bits & kMantissa) | kHalf);
  const auto low = mantissa < 0.70710678118654752440;
  mantissa = select(low, mantissa + mantissa, mantissa);
  exponent = select(low, exponent - 1.0, exponent);
  // ln m = 2 artanh(s), s = (m - 1)/(m + 1), |s| < 0.1716; = f - s (f - 2 z (1/3 + z/5 + ...))
  const V f = mantissa - 1.0;
  const V s = f / (mantissa + 1.0), z = s * s, z2 = z * z, z4 = z2 * z2;
  const V a = line_at(z, 2.0 / 3, 2.0 / 5), b = line_at(z, 2.0 / 7, 2.0 / 9);
  const V c = line_at(z, 2.0 / 11, 2.0 / 13), d = line_at(z, 2.0 / 15, 2.0 / 17);
  const V e = line_at(z, 2.0 / 19, 2.0 / 21);
  const V series = z * vfma(z4, vfma(z4, e, vfma(z2, d, c)), vfma(z2, b, a));
  const V rest = vfma(s, f - series, exponent * -kLn2Low);
  return vfma(exponent, broadcast<V>(kLn2High), f - rest);
}
}  // namespace detail

/// ln x within one unit in the last place. ln 0 = -infinity, NaN below 0, ln infinity = infinity;
/// subnormal numbers are exact as all others.
template <class V>
BRUNT_INLINE V vlog(V x) {
  const V zero = broadcast<V>(0.0);
  const auto subnormal = x < std::numeric_limits<Real>::min();
  const V finite = detail::log_of_normal(select(subnormal, x * 0x1p54, x),
                                         select(subnormal, broadcast<V>(54.0), zero));
  const V below = select(x < zero, broadcast<V>(std::numeric_limits<Real>::quiet_NaN()), x);
  const V special = select(x == zero, broadcast<V>(-kInfinity), below);
  return select(zero < x, select(x < kInfinity, finite, x), special);
}

/// x^y for x >= 0: e^(y ln x). Relative error below (1 + |y ln x|) 5e-16, so 1e-14 where
/// |y ln x| < 20. 0^y is 0, 1 or infinity for y above, at or below 0; NaN for x < 0.
template <class V>
BRUNT_INLINE V vpow(V x, V y) {
  return select(y == 0.0, broadcast<V>(1.0), vexp(y * vlog(x)));
}
template <class V>
requires(lanes_of<V> > 1) BRUNT_INLINE V vpow(V x, Real y) {
  return y == 0.0 ? broadcast<V>(1.0) : vexp(y * vlog(x));
}

}  // namespace brunt
