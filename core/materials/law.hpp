#pragma once
#include <array>
#include <concepts>
#include <limits>

#include "core/materials/dual.hpp"

namespace brunt {

/// Flow stress with its slopes, of one point (Real) or four (Pack).
template <class V>
struct FlowStress {
  V value;          ///< [Pa]
  V d_eps_p;        ///< [Pa]
  V d_rate;         ///< [Pa s]
  V d_temperature;  ///< [Pa/K]
  /// [Pa] minus the increment times the second slope along it, of hardening and of both.
  V bend{};
  /// Where this tells how the law bends by eps_p, and there is no corner of softening near.
  decltype(V{} < V{}) smooth{};
};

/// What RadialReturn needs of a law, a plain struct of parameters; its functions are templates on
/// V = Real or Pack. Units as in FlowStress; rate is the equivalent plastic strain rate [1/s].
template <class Law>
concept FlowLaw = requires(Law made, const Law& law, Real eps_p, Real rate, Real T) {
  /// Computes, once, what `near` has from the parameters.
  made.prepare();
  /// The formula as printed.
  { law.flow_stress(eps_p, rate, T) } -> std::same_as<Real>;
  /// Cheap, and never above the static flow stress: below it no point yields.
  { law.static_floor(eps_p, T) } -> std::same_as<Real>;
  /// The law about a point, and its flow stress there at the rate 0.
  { law.near(eps_p, T).static_stress() } -> std::same_as<Real>;
  /// A guess of d(flow stress)/d(eps_p) there [Pa]; may be infinite.
  { law.near(eps_p, T).hardening() } -> std::same_as<Real>;
  /// A guess of d(flow stress)/d(ln rate) there [Pa].
  { law.near(eps_p, T).rate_hardening() } -> std::same_as<Real>;
  /// [1/s] where the law has a corner; 0: nowhere.
  { law.near(eps_p, T).corner_rate() } -> std::same_as<Real>;
  /// The law at eps_p + increment and another rate and temperature.
  { law.near(eps_p, T).at(eps_p, rate, T) } -> std::same_as<FlowStress<Real>>;
  { law.needs_temperature() } -> std::same_as<bool>;
};

/// What a flow stress depends on. N: Real, Pack, or a Dual of one of them.
template <class N>
struct FlowState {
  N eps_p;        ///< [1]
  N rate;         ///< [1/s] of eps_p
  N temperature;  ///< [K]
};

/// The value in a number that may carry slopes.
template <class N>
struct ValueOf {
  using Type = N;
};
template <class V, std::size_t n>
struct ValueOf<Dual<V, n>> {
  using Type = V;
};

/// The same for a law that sees the pressure, which its strength comes after then.
template <class N>
struct PressureState : FlowState<N> {
  N pressure;                                  ///< [Pa] positive in compression
  typename ValueOf<N>::Type relative_density;  ///< [1] rho/rho0
};

/// What PressureReturn needs of a law.
template <class Law>
concept PressureLaw = requires(Law law, const Law& made, const PressureState<Real>& at) {
  /// The formula as printed.
  { made.flow_stress(at) } -> std::same_as<Real>;
  /// The same, and its slope where the state moves by `at`.
  { made.along(at, at) } -> std::same_as<Dual<Real, 1>>;
  /// Computes, once, what the formula has from the parameters.
  law.prepare();
  /// Plastic volume strain per eps_p, at least 0, and the largest tension [Pa]; read only where
  /// plastic flow changes the volume.
  { made.dilation() } -> std::same_as<Real>;
  { made.tension_limit() } -> std::same_as<Real>;
  { Law::kChangesVolume } -> std::convertible_to<bool>;
  { made.needs_temperature() } -> std::same_as<bool>;
};

/// base^exponent for 0 <= base < infinity and exponent > 0, by vpow without its special cases:
/// below 1e-300 a base counts as 0.
template <class V>
BRUNT_INLINE V power_of(V base, Real exponent) {
  const V least = broadcast<V>(1e-300), normal = vmax(base, least);
  const V power = vexp(exponent * detail::log_of_normal(normal, broadcast<V>(0.0)));
  return select(base < least, broadcast<V>(0.0), power);
}
/// For callers that rarely need it: out of line, so that they keep their registers.
template <class V>
__attribute__((noinline)) V power_apart(V base, Real exponent) {
  return power_of(base, exponent);
}

/// The binomial series of (1 + x)^exponent, up to x^7.
struct PowerSeries {
  Real exponent;
  std::array<Real, 8> factor;  ///< of x^k

  PowerSeries() : PowerSeries(std::numeric_limits<Real>::quiet_NaN()) {}
  explicit PowerSeries(Real exponent_) : exponent(exponent_) {
    factor[0] = 1;
    for (std::size_t k = 1; k < factor.size(); ++k) {
      factor[k] = factor[k - 1] * (exponent - static_cast<Real>(k - 1)) / static_cast<Real>(k);
    }
  }
  /// Summed in pairs (Estrin): exactly 1 at x = 0.
  template <class V>
  BRUNT_INLINE V at(V x) const {
    const V x2 = x * x;
    const V a = line_at(x, factor[0], factor[1]), b = line_at(x, factor[2], factor[3]);
    const V c = line_at(x, factor[4], factor[5]), d = line_at(x, factor[6], factor[7]);
    return vfma(x2 * x2, vfma(x2, d, c), vfma(x2, b, a));
  }
};

/// base^exponent where power = reference^exponent is known: by its series where base is within 2 %
/// of the reference, else by power_of. Relative error 1e-15; of an exponent of 10, 1e-12.
/// inverse  1 / reference
template <class V>
BRUNT_INLINE V power_near(V base, V reference, V inverse, V power, const PowerSeries& series) {
  const V x = select(base == reference, broadcast<V>(0.0), (base - reference) * inverse);
  const V close = power * series.at(x);
  const auto is_close = vabs(x) < 0.02;  // false where the reference alone is 0
  if (!any(!is_close)) return close;
  return select(is_close, close, power_apart(base, series.exponent));
}

}  // namespace brunt
// Tested by tests/unit/core/material_test.cpp.
