#pragma once
/// Return to the flow stress of a law that sees the pressure, over tiles; its plastic flow may
/// change the volume, and at its limit of tension it opens. docs/theory/materials.md (M13) to (M18)
#include <utility>

#include "core/materials/elastic.hpp"
#include "core/materials/law.hpp"
#include "core/materials/radial_return.hpp"

namespace brunt {

/// The return of some points of a law that sees the pressure.
template <class V>
struct PressurePoint : ReturnPoint<V> {
  V deviator[6];       ///< [Pa] trial
  V eps_p;             ///< [1] before the step
  V relative_density;  ///< [1] rho/rho0
  V pressure;          ///< [Pa] of the trial, with the plastic volume of before
  V bulk;              ///< [Pa] what it gains per plastic volume strain
  V closing;           ///< [1] volume strain by which the opening closes, <= 0
  V dilation;          ///< [1] plastic volume strain per eps_p; 0 where it is open
};

/// Strength that follows a law over pressure as well. The bits of a point do not depend on V.
/// Reads the pressure and the bulk modulus of the trial from the state, and leaves there the
/// pressure after plastic flow.
template <PressureLaw Law, class V = Pack>
class PressureReturn final : public Strength {
 public:
  PressureReturn(Law law, const StrengthInputs& inputs) : law_(std::move(law)), inputs_(inputs) {
    law_.prepare();
    dilation_ = law_.dilation();
    limit_ = vmin(law_.tension_limit(), inputs.tensile_cutoff);
  }

  void update(MaterialTile& tile, Real dt) const override {
    const Real inverse_dt = dt > 0 ? 1.0 / dt : 0.0;
    for (int i = 0; i < tile.count; i += lanes_of<V>) {
      PressurePoint<V> p;
      trial(tile, i, p);
      solve(p, inverse_dt);
      finish(tile, i, inverse_dt, p);
    }
  }
  bool yields() const override { return true; }
  bool needs_temperature() const override { return law_.needs_temperature(); }
  bool sees_pressure() const override { return true; }
  bool changes_volume() const override { return Law::kChangesVolume; }
  /// The density is that at which K (1 - rho0/rho) = p, K the tangent modulus: that of a linear
  /// equation of state.
  Real flow_stress(const MaterialState& state, std::size_t k,
                   Real fixed_temperature) const override {
    const Real T = state.temperature.empty() ? fixed_temperature : state.temperature[k];
    const Real p = state.pressure[k], density = 1.0 / (1.0 - p / state.bulk[k]);
    return law_.flow_stress(
        PressureState<Real>{{state.eps_p[k], state.strain_rate[k], T}, p, density});
  }

 private:
  static constexpr int kMaxIterations = 50;

  void trial(MaterialTile& tile, int i, PressurePoint<V>& p) const;
  void close(const MaterialState& state, std::size_t at, PressurePoint<V>& p) const;
  void solve(PressurePoint<V>& p, Real inverse_dt) const;
  void newton(PressurePoint<V>& p, Real inverse_dt, int iteration) const;
  void finish(MaterialTile& tile, int i, Real inverse_dt, const PressurePoint<V>& p) const;
  BRUNT_INLINE V held(V pressure) const {
    return Law::kChangesVolume ? vmax(pressure, broadcast<V>(-limit_)) : pressure;
  }

  Law law_;
  StrengthInputs inputs_;
  Real dilation_ = 0;  // [1] plastic volume strain per eps_p
  Real limit_ = 0;     // [Pa] of tension
};

/// What has opened closes first, without resistance: (M17). What is open still does not dilate.
template <PressureLaw Law, class V>
BRUNT_INLINE void PressureReturn<Law, V>::close(const MaterialState& state, std::size_t at,
                                                PressurePoint<V>& p) const {
  const V zero = broadcast<V>(0.0);
  const V most = 1.0 / load_as<V>(state.opening.data() + at) - 1.0;
  p.closing = vmax(-(vmax(p.pressure, zero) / p.bulk), most);
  p.closing = vmin(p.closing, zero);
  p.dilation = select(most < p.closing, zero, p.dilation);
  p.pressure = p.pressure + p.bulk * p.closing;
}

/// Elastic trial of some points.
template <PressureLaw Law, class V>
BRUNT_INLINE void PressureReturn<Law, V>::trial(MaterialTile& tile, int i,
                                                PressurePoint<V>& p) const {
  const MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const V third = (load_as<V>(tile.strain[xx] + i) + load_as<V>(tile.strain[yy] + i) +
                   load_as<V>(tile.strain[zz] + i)) *
                  (1.0 / 3.0);
  V old_square = broadcast<V>(0.0), square = old_square;
  for (std::size_t c = 0; c < 6; ++c) {
    const V old = load_as<V>(state.deviator[c].data() + at);
    const V strain = load_as<V>(tile.strain[c] + i);
    p.deviator[c] = trial_stress(old, strain, c < 3 ? third : V{}, inputs_.shear);
    const Real weight = c < 3 ? 1.5 : 3.0;
    old_square = old_square + weight * (old * old);
    square = square + weight * (p.deviator[c] * p.deviator[c]);
  }
  p.q_trial = vsqrt(square), p.q_old = vsqrt(old_square);
  p.eps_p = load_as<V>(state.eps_p.data() + at);
  p.relative_density = 1.0 / load_as<V>(tile.ratio + i);
  p.pressure = load_as<V>(state.pressure.data() + at);
  p.bulk = load_as<V>(state.bulk.data() + at);
  p.closing = broadcast<V>(0.0), p.dilation = broadcast<V>(dilation_);
  if constexpr (Law::kChangesVolume) close(state, at, p);
  p.temperature = state.temperature.empty() ? broadcast<V>(tile.fixed_temperature)
                                            : load_as<V>(state.temperature.data() + at);
  p.heating = broadcast<V>(0.0);
  if (law_.needs_temperature() && heats(inputs_, tile)) {
    p.heating = heating_at(inputs_, p.temperature, heat_factor<V>(inputs_, tile, i));
  }
}

/// Newton's step of g(d) = q* - 3 G d - sigma_y(eps_p + d, d/dt, T + dT(d), p + K D d), D the
/// dilation: (M14) and (M16), the slopes along d.
template <PressureLaw Law, class V>
BRUNT_INLINE void PressureReturn<Law, V>::newton(PressurePoint<V>& p, Real inverse_dt,
                                                 int iteration) const {
  const Real shear = inputs_.shear;
  const V d = p.increment, zero = broadcast<V>(0.0);
  const V q = p.q_trial - (3.0 * shear) * d;
  V gain = zero, pressure = p.pressure;
  if constexpr (Law::kChangesVolume) {
    gain = p.dilation * p.bulk;
    const V dilated = p.pressure + gain * d;
    pressure = held(dilated);
    gain = select(dilated < pressure, zero, gain);
  }
  const V both = p.q_old + q - p.dilation * (held(p.pressure) + pressure);
  const V of_heat = (0.5 * p.heating) * (both - (3.0 * shear + p.dilation * gain) * d);
  const PressureState<V> at{
      {p.eps_p + d, d * inverse_dt, p.temperature + (0.5 * p.heating) * (both * d)},
      pressure,
      p.relative_density};
  const PressureState<V> by{{broadcast<V>(1.0), broadcast<V>(inverse_dt), of_heat}, gain, zero};
  const auto flow = law_.along(at, by);
  improve(p, {q - flow.value, -3.0 * shear - flow.slope[0], zero, broadcast<V>(kNewtonStep), zero},
          iteration);
}

template <PressureLaw Law, class V>
BRUNT_INLINE void PressureReturn<Law, V>::solve(PressurePoint<V>& p, Real inverse_dt) const {
  const Real shear = inputs_.shear;
  const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
  p.increment = p.lo = p.step = zero;
  const PressureState<V> at{{p.eps_p, zero, p.temperature}, held(p.pressure), p.relative_density};
  const PressureState<V> by{{one, zero, zero}, p.dilation * p.bulk, zero};
  const auto flow = law_.along(at, by);
  p.active = flow.value < p.q_trial;
  p.q_old = vmax(p.q_old, flow.value);
  if (!any(p.active)) return;
  // A flow stress that rises without limit at the start says nothing about the increment.
  const V slope = vmin(vmax(flow.slope[0], zero), broadcast<V>(1e3 * shear));
  p.hi = p.q_trial * (1.0 / (3.0 * shear));
  V start = (p.q_trial - flow.value) / (3.0 * shear + slope);
  start = vmin(vmax(start, 1e-7 * p.hi), 0.999 * p.hi);
  p.increment = select(p.active, start, zero);
  for (int iteration = 0; any(p.active) && iteration < kMaxIterations; ++iteration) {
    newton(p, inverse_dt, iteration);
  }
}

/// Brings the return into the state; what the tension lacks beyond its limit opens.
template <PressureLaw Law, class V>
BRUNT_INLINE void PressureReturn<Law, V>::finish(MaterialTile& tile, int i, Real inverse_dt,
                                                 const PressurePoint<V>& p) const {
  MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
  const V q = vmax(p.q_trial - (3.0 * inputs_.shear) * p.increment, zero);
  const auto flows = zero < p.increment;
  const V scale = select(flows, q / select(flows, p.q_trial, one), one);
  for (std::size_t c = 0; c < 6; ++c) {
    store(state.deviator[c].data() + at, p.deviator[c] * scale);
  }
  store(state.eps_p.data() + at, p.eps_p + p.increment);
  store(state.strain_rate.data() + at, p.increment * inverse_dt);
  V work = p.q_old + q;
  if constexpr (Law::kChangesVolume) {
    const V dilated = p.pressure + p.bulk * (p.dilation * p.increment), pressure = held(dilated);
    const auto opens = dilated < pressure;
    const V opened = select(opens, (pressure - p.pressure) / p.bulk, zero);
    const V dilation = select(opens, zero, p.dilation * p.increment);
    work = 0.5 * (work - p.dilation * (held(p.pressure) + pressure)) * p.increment;
    work = work + vmax(-pressure, zero) * opened;
    store(state.pressure.data() + at, pressure);
    // Both together grow by 1 + dilation + opening, so that the pressure is that of the return.
    const V growth = 1.0 + dilation;
    Real* volume = state.plastic_volume.data() + at;
    store(volume, load_as<V>(volume) * growth);
    Real* opening = state.opening.data() + at;
    store(opening, vmax(load_as<V>(opening) * (1.0 + (p.closing + opened) / growth), one));
  } else {
    work = 0.5 * (work * p.increment);
  }
  if (!state.heat.empty()) add_plastic_heat(inputs_, tile, i, work);
}

}  // namespace brunt
// Tested by tests/unit/core/drucker_prager_test.cpp.
