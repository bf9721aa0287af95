#pragma once
/// Strength of metals under large strains, high rates and heat.
/// Johnson, G.R. & Cook, W.H., A constitutive model and data for metals subjected to large strains,
/// high strain rates and high temperatures, Proc. 7th Int. Symp. on Ballistics, 1983, eq. 1.
#include <optional>

#include "core/materials/law.hpp"
#include "core/schema.hpp"

namespace brunt {

template <class V>
class NearJohnsonCook;

/// The deck's `strength: {johnson-cook: {...}}`.
struct JohnsonCook {
  static constexpr const char* deck_name = "johnson-cook";
  static constexpr const char* deck_help =
      "flow stress (A + B eps_p^n) (1 + C ln(rate/rate_ref)) (1 - T*^m)";
  Real A = 0;                     ///< [Pa]
  Real B = 0;                     ///< [Pa]
  Real n = 1;                     ///< [1]
  Real C = 0;                     ///< [1]
  Real rate_ref = 1;              ///< [1/s]
  Real m = 1;                     ///< [1]
  std::optional<Real> T_melt;     ///< [K]; none: heat does not soften
  Real T_ref = 298;               ///< [K]
  PowerSeries of_eps_p, of_heat;  ///< of the exponents n and m: set by `prepare`

  /// T* = (T - T_ref)/(T_melt - T_ref), held in [0, 1].
  template <class V>
  BRUNT_INLINE V homologous_temperature(V T) const {
    const V ratio = (T - T_ref) * homologous_slope();
    return vmin(vmax(ratio, broadcast<V>(0.0)), broadcast<V>(1.0));
  }
  /// sigma_y = (A + B eps_p^n) (1 + C ln max(rate/rate_ref, 1)) (1 - T*^m): static below rate_ref,
  /// fluid from T_melt on.
  template <class V>
  BRUNT_INLINE V flow_stress(V eps_p, V rate, V T) const {
    const V relative_rate = vmax(rate * (1.0 / rate_ref), broadcast<V>(1.0));
    return (A + B * vpow(eps_p, n)) * (1.0 + C * vlog(relative_rate)) *
           (1.0 - vpow(homologous_temperature(T), m));
  }
  /// With eps_p^n >= eps_p^k for n <= k and eps_p <= 1, and T*^m <= T* for m >= 1.
  template <class V>
  BRUNT_INLINE V static_floor(V eps_p, V T) const {
    V power = n <= 1.0 ? vmin(eps_p, broadcast<V>(1.0)) : broadcast<V>(0.0);
    if (n <= 0.5) power = vsqrt(power);
    if (n <= 0.25) power = vsqrt(power);
    const V hot = homologous_temperature(T);
    const V cold = m >= 1.0 ? 1.0 - hot : select(0.0 < hot, broadcast<V>(0.0), 1.0 - hot);
    return ((1.0 - 1e-12) * (A + B * power)) * cold;  // round-off lifts nothing above it
  }
  void prepare() { of_eps_p = PowerSeries(n), of_heat = PowerSeries(m); }
  template <class V>
  BRUNT_INLINE NearJohnsonCook<V> near(V eps_p, V T) const {
    return NearJohnsonCook<V>(*this, eps_p, T);
  }
  bool needs_temperature() const { return T_melt.has_value(); }
  Real homologous_slope() const { return T_melt ? 1.0 / (*T_melt - T_ref) : 0.0; }  ///< [1/K]
};

/// The law about a point: its powers once, then by series while steps are small.
template <class V>
class NearJohnsonCook {
 public:
  NearJohnsonCook() = default;
  BRUNT_INLINE NearJohnsonCook(const JohnsonCook& law, V eps_p, V T)
      : law_(&law),
        per_rate_(1.0 / law.rate_ref),
        per_kelvin_(law.homologous_slope()),
        eps_p_(eps_p),
        inverse_(1.0 / eps_p),
        power_(power_of(eps_p, law.n)),
        T_(T),
        hot_(law.homologous_temperature(T)),
        inverse_hot_(1.0 / hot_),
        softening_(power_of(hot_, law.m)) {}

  BRUNT_INLINE V static_stress() const { return (law_->A + law_->B * power_) * (1.0 - softening_); }
  BRUNT_INLINE V hardening() const {
    return (law_->B * law_->n) * (power_ * inverse_) * (1.0 - softening_);
  }
  BRUNT_INLINE V rate_hardening() const { return law_->C * static_stress(); }
  Real corner_rate() const { return law_->C != 0 ? law_->rate_ref : 0.0; }
  BRUNT_INLINE FlowStress<V> at(V increment, V rate, V T) const {
    const JohnsonCook& law = *law_;
    const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
    const V eps_p = eps_p_ + increment;
    const V power = power_near(eps_p, eps_p_, inverse_, power_, law.of_eps_p);
    const V hardened = law.A + law.B * power;
    const V hot = vmin(vmax((T - law.T_ref) * per_kelvin_, zero), one);
    // One division for all three slopes.
    const V least = broadcast<V>(1e-100), fast = vmax(rate, least), warm = vmax(hot, least);
    const V both = eps_p * fast, inverse = 1.0 / (both * warm);
    V rate_factor = one, rate_slope = zero;
    auto smooth = zero < one;
    if (law.C != 0) {
      const V relative_rate = rate * per_rate_;
      rate_factor = 1.0 + law.C * detail::log_of_normal(vmax(relative_rate, one), zero);
      rate_slope = select(one < relative_rate, (law.C * (eps_p * warm)) * inverse, zero);
    }
    V soft = softening_, soft_slope = zero;
    if (law.T_melt) {
      soft = power_near(hot, hot_, inverse_hot_, softening_, law.of_heat);
      const auto inside = (zero < hot) & (hot < one);
      // Neither where heat begins to soften, nor at melting.
      smooth = ((law.T_ref <= T_) | (T + (T - T_) < law.T_ref)) & (hot < 0.999);
      soft_slope = select(inside, (law.m * per_kelvin_) * soft * (both * inverse), zero);
    }
    const V cold = 1.0 - soft;
    const V per_eps_p = (fast * warm) * inverse;
    const V static_slope = (law.B * law.n) * power * per_eps_p * cold;
    const V slope = static_slope * rate_factor;
    return {
        hardened * rate_factor * cold,
        slope,
        hardened * cold * rate_slope,
        -(hardened * rate_factor * soft_slope),
        (1.0 - law.n) * slope * (increment * per_eps_p) - 2.0 * (static_slope * rate_slope * rate),
        smooth};
  }

 private:
  const JohnsonCook* law_;
  Real per_rate_, per_kelvin_;       // [s], [1/K]: one division each for all iterations
  V eps_p_, inverse_, power_;        // eps_p, 1/eps_p, eps_p^n
  V T_;                              // [K]
  V hot_, inverse_hot_, softening_;  // T*, 1/T*, T*^m
};

inline void describe(Schema& s, JohnsonCook& law) {
  s.real({"A", "static flow stress at no plastic strain and T_ref", Need::required}, law.A,
         {"Pa", at_least(0), between(1e5, 1e10)});
  s.real({"B", "factor of hardening B eps_p^n", Need::required}, law.B,
         {"Pa", at_least(0), between(0, 1e10)});
  s.real({"n", "exponent of hardening", Need::required}, law.n,
         {"1", {0, 10, true, false}, between(0.01, 2)});
  s.real({"C", "flow stress gained per e-fold of the rate above rate_ref"}, law.C,
         {"1", at_least(0), between(0, 0.2)});
  s.real({"rate_ref", "plastic strain rate below which the law is static"}, law.rate_ref,
         {"1/s", positive(), between(1e-6, 1e3)});
  s.real({"m", "exponent of thermal softening"}, law.m,
         {"1", {0, 10, true, false}, between(0.3, 3)});
  s.real(
      {"T_melt", "temperature of melting: no strength from there; without it heat does not soften"},
      law.T_melt, {"K", positive(), between(200, 5000)});
  s.real({"T_ref", "temperature up to which heat does not soften"}, law.T_ref,
         {"K", at_least(0), between(50, 1000)});
  s.require(!law.T_melt || *law.T_melt > law.T_ref, "T_melt", "T_melt must be above T_ref");
}

}  // namespace brunt
