#pragma once
/// Flow laws that are no more than their printed formula: all that RadialReturn needs of a law
/// follows from it, slopes by dual numbers. A law that is called often may bring its own instead
/// (johnson_cook.hpp).
#include "core/materials/law.hpp"

namespace brunt {

/// A law about a point, by its formula.
template <class Law, class V>
class NearPrinted {
 public:
  NearPrinted() = default;
  BRUNT_INLINE NearPrinted(const Law& law, V eps_p, V T) : law_(&law), eps_p_(eps_p), T_(T) {}

  BRUNT_INLINE V static_stress() const {
    return law_->formula(FlowState<V>{eps_p_, broadcast<V>(0.0), T_});
  }
  BRUNT_INLINE V hardening() const { return with_slopes(eps_p_, broadcast<V>(0.0), T_).slope[0]; }
  BRUNT_INLINE V rate_hardening() const { return broadcast<V>(0.0); }
  Real corner_rate() const { return law_->corner_rate(); }
  BRUNT_INLINE FlowStress<V> at(V increment, V rate, V T) const {
    const auto flow = with_slopes(eps_p_ + increment, rate, T);
    return {flow.value, flow.slope[0], flow.slope[1], flow.slope[2], V{}};
  }

 private:
  BRUNT_INLINE Dual<V> with_slopes(V eps_p, V rate, V T) const {
    const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
    return law_->formula(FlowState<Dual<V>>{
        {eps_p, {one, zero, zero}}, {rate, {zero, one, zero}}, {T, {zero, zero, one}}});
  }

  const Law* law_;
  V eps_p_, T_;
};

/// Makes a FlowLaw of a struct with
///   template <class N> N formula(const FlowState<N>& at) const;   // [Pa], as printed
/// that is finite at no rate and grows with it.
template <class Law>
struct PrintedLaw {
  void prepare() {}
  Real corner_rate() const { return 0; }
  template <class V>
  BRUNT_INLINE V flow_stress(V eps_p, V rate, V T) const {
    return law().formula(FlowState<V>{eps_p, rate, T});
  }
  /// The static flow stress itself, less what rounding may lift above it.
  template <class V>
  BRUNT_INLINE V static_floor(V eps_p, V T) const {
    return (1.0 - 1e-12) * flow_stress(eps_p, broadcast<V>(0.0), T);
  }
  template <class V>
  BRUNT_INLINE NearPrinted<Law, V> near(V eps_p, V T) const {
    return {law(), eps_p, T};
  }

 private:
  const Law& law() const { return static_cast<const Law&>(*this); }
};

/// Makes a PressureLaw of a struct with
///   template <class N> N formula(const PressureState<N>& at) const;   // [Pa], as printed
/// that is finite at no rate and grows with it. Where plastic flow changes the volume it says so by
/// kChangesVolume, and brings dilation and tension_limit.
template <class Law>
struct PrintedPressureLaw {
  static constexpr bool kChangesVolume = false;
  void prepare() {}
  Real dilation() const { return 0; }
  Real tension_limit() const { return kInfinity; }

  template <class V>
  BRUNT_INLINE V flow_stress(const PressureState<V>& at) const {
    return static_cast<const Law&>(*this).formula(at);
  }
  template <class V>
  BRUNT_INLINE Dual<V, 1> along(const PressureState<V>& at, const PressureState<V>& by) const {
    return static_cast<const Law&>(*this).formula(PressureState<Dual<V, 1>>{
        {{at.eps_p, {by.eps_p}}, {at.rate, {by.rate}}, {at.temperature, {by.temperature}}},
        {at.pressure, {by.pressure}},
        at.relative_density});
  }
};

}  // namespace brunt
// Tested by tests/unit/core/zerilli_armstrong_test.cpp.
