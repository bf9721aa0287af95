#pragma once
/// Laws of damage. Each is its printed formula; Softening does the rest
/// (core/materials/softening.hpp).
#include <optional>

#include "core/materials/damage.hpp"
#include "core/materials/law.hpp"
#include "core/schema.hpp"

namespace brunt {

/// The deck's `damage: none`.
struct NoDamage {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "it never fails";
};
inline void describe(Schema&, NoDamage&) {}

/// `energy`, which all laws have.
inline void describe_energy(Schema& s, Real& energy) {
  s.real({"energy",
          "energy of fracture: what a crack takes per area, whatever the size of elements; "
          "without it a point fails in one step"},
         energy, {"J/m^2", at_least(0), between(1, 1e7)});
}

/// The deck's `damage: {johnson-cook: {...}}`.
///   Johnson & Cook, Eng. Fract. Mech. 21, 1985, eqs. 2 and 3: sum of d(eps_p)/eps_f with
///   eps_f = [D1 + D2 exp(D3 s)] [1 + D4 ln(rate/rate_0)] [1 + D5 T*], s = -p/q.
struct JohnsonCookDamage {
  static constexpr const char* deck_name = "johnson-cook";
  static constexpr const char* deck_help =
      "fails where the sum of d(eps_p)/eps_f is 1, eps_f = (D1 + D2 exp(D3 s)) (1 + D4 ln rate) "
      "(1 + D5 T*), s the mean stress over von Mises'";
  static constexpr bool kNeedsPrincipal = false;
  Real D1 = 0, D2 = 0, D3 = 0, D4 = 0, D5 = 0;  ///< [1]
  Real rate = 1;                                ///< [1/s] rate_0, below which rates count as it
  Real T_ref = 298;                             ///< [K]
  std::optional<Real> T_melt;                   ///< [K] needed where D5 is not 0
  Real energy = 0;                              ///< [J/m^2]

  /// eps_f [1], at least 1e-6: the parameters may make it 0 or less in much tension.
  template <class V>
  BRUNT_INLINE V strain_to_fail(const DamagePoint<V>& at) const {
    const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
    // Without a stress there is no plastic flow to count; the bounds keep exp finite.
    const V triaxiality =
        vmin(vmax(-at.pressure / vmax(at.von_mises, broadcast<V>(1e-30)), broadcast<V>(-20.0)),
             broadcast<V>(20.0));
    const V fast = vlog(vmax(at.rate * (1 / rate), one));
    const V hot = vmin(vmax((at.temperature - T_ref) * homologous_slope(), zero), one);
    const V strain = (D1 + D2 * vexp(D3 * triaxiality)) * (1.0 + D4 * fast) * (1.0 + D5 * hot);
    return vmax(strain, broadcast<V>(1e-6));
  }
  template <class V>
  BRUNT_INLINE V index(const DamagePoint<V>& at, V before) const {
    return before + at.increment / strain_to_fail(at);
  }
  bool needs_temperature() const { return D5 != 0; }
  Real homologous_slope() const { return 1 / (T_melt.value_or(kInfinity) - T_ref); }  ///< [1/K]
};

/// The deck's `damage: {strain: 1.5}`: eps_p over the largest one.
struct StrainDamage {
  static constexpr const char* deck_name = "strain";
  static constexpr const char* deck_help = "fails at a plastic strain";
  static constexpr bool deck_open = true, kNeedsPrincipal = false;
  Real strain = 0;  ///< [1]
  Real energy = 0;  ///< [J/m^2]

  template <class V>
  BRUNT_INLINE V index(const DamagePoint<V>& at, V) const {
    return at.eps_p * (1 / strain);
  }
  bool needs_temperature() const { return false; }
};

/// The deck's `damage: {cockcroft_latham: 300 MPa}`: the integral of the largest principal stress
/// that pulls over eps_p, by the value at which it fails.
///   Cockcroft & Latham, J. Inst. Met. 96, 1968
struct CockcroftLatham {
  static constexpr const char* deck_name = "cockcroft_latham";
  static constexpr const char* deck_help =
      "fails where the largest principal stress, integrated over eps_p while it pulls, reaches "
      "this";
  static constexpr bool deck_open = true, kNeedsPrincipal = true;
  Real work = 0;    ///< [Pa] W_cr
  Real energy = 0;  ///< [J/m^2]

  template <class V>
  BRUNT_INLINE V index(const DamagePoint<V>& at, V before) const {
    return before + vmax(at.largest, broadcast<V>(0.0)) * at.increment * (1 / work);
  }
  bool needs_temperature() const { return false; }
};

/// The deck's `damage: {principal_stress: 3 MPa}` (Rankine 1857).
struct PrincipalStressDamage {
  static constexpr const char* deck_name = "principal_stress";
  static constexpr const char* deck_help = "fails where the largest principal stress reaches this";
  static constexpr bool deck_open = true, kNeedsPrincipal = true;
  Real strength = 0;  ///< [Pa]
  Real energy = 0;    ///< [J/m^2]

  template <class V>
  BRUNT_INLINE V index(const DamagePoint<V>& at, V) const {
    return at.largest * (1 / strength);
  }
  bool needs_temperature() const { return false; }
};

/// The deck's `damage: {mean_tension: 1.2 GPa}`: spall by the mean stress.
struct MeanTensionDamage {
  static constexpr const char* deck_name = "mean_tension";
  static constexpr const char* deck_help = "fails where the pressure falls to minus this (spall)";
  static constexpr bool deck_open = true, kNeedsPrincipal = false;
  Real strength = 0;  ///< [Pa]
  Real energy = 0;    ///< [J/m^2]

  template <class V>
  BRUNT_INLINE V index(const DamagePoint<V>& at, V) const {
    return -at.pressure * (1 / strength);
  }
  bool needs_temperature() const { return false; }
};

inline void describe(Schema& s, JohnsonCookDamage& law) {
  s.real({"D1", "strain to fail under much pressure", Need::required}, law.D1,
         {"1", between(-10, 10), between(-1, 10)});
  s.real({"D2", "what tension takes away"}, law.D2, {"1", between(-100, 100), between(-1, 20)});
  s.real({"D3", "exponent of mean stress over von Mises'"}, law.D3,
         {"1", between(-20, 20), between(-10, 5)});
  s.real({"D4", "what the rate adds"}, law.D4, {"1", between(-1, 1), between(-0.5, 0.5)});
  s.real({"D5", "what heat adds, over T* = (T - T_ref)/(T_melt - T_ref)"}, law.D5,
         {"1", between(-100, 100), between(-2, 20)});
  s.real({"rate", "rate below which the law is static"}, law.rate,
         {"1/s", positive(), between(1e-6, 1e4)});
  s.real({"T_ref", "temperature of T* = 0"}, law.T_ref, {"K", positive(), between(1, 2000)});
  s.real({"T_melt",
          "temperature of T* = 1; where D5 is not 0 it, or that of the strength or of `thermal`, "
          "is needed"},
         law.T_melt, {"K", positive(), between(200, 5000)});
  s.require(!law.T_melt || *law.T_melt > law.T_ref, "T_melt", "must be above T_ref");
  describe_energy(s, law.energy);
}
inline void describe(Schema& s, StrainDamage& law) {
  s.real({"strain", "plastic strain at which it fails", Need::required}, law.strain,
         {"1", positive(), between(1e-4, 10)});
  describe_energy(s, law.energy);
}
inline void describe(Schema& s, CockcroftLatham& law) {
  s.real({"cockcroft_latham", "the integral at which it fails", Need::required}, law.work,
         {"Pa", positive(), between(1e5, 1e10)});
  describe_energy(s, law.energy);
}
inline void describe(Schema& s, PrincipalStressDamage& law) {
  s.real({"principal_stress", "strength in tension", Need::required}, law.strength,
         {"Pa", positive(), between(1e3, 1e11)});
  describe_energy(s, law.energy);
}
inline void describe(Schema& s, MeanTensionDamage& law) {
  s.real({"mean_tension", "strength against spall", Need::required}, law.strength,
         {"Pa", positive(), between(1e3, 1e11)});
  describe_energy(s, law.energy);
}

}  // namespace brunt
// Tested by tests/unit/core/damage_test.cpp.
