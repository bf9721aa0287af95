#pragma once
/// Equations of state that are no more than their printed formula: pressure, energy, stiffness and
/// heating follow from it, slopes by dual numbers. docs/theory/materials.md (M25) to (M28)
#include <concepts>
#include <utility>

#include "core/materials/compression_heat.hpp"
#include "core/materials/dual.hpp"
#include "core/materials/material.hpp"

namespace brunt {

/// What a pressure depends on. N: Real, Pack, or a Dual of one of them.
template <class N>
struct EosState {
  N ratio;             ///< [1] V/V0
  N relative_density;  ///< [1] rho/rho0 = V0/V
  N energy;            ///< [J/m^3 reference] internal energy; 0 where the law needs none
};

/// What PrintedEquation needs of a law, a plain struct of parameters that derives from PrintedEos.
template <class Law>
concept EosFormula = requires(Law law, const Law& made, const EosState<Real>& at,
                              const EosInputs& inputs) {
  /// Pressure [Pa] as printed, positive in compression; linear in the energy.
  { made.formula(at) } -> std::same_as<Real>;
  /// Computes, once, what the formula has from the material.
  law.prepare(inputs);
  { made.needs_energy() } -> std::same_as<bool>;
  /// At the reference state [J/m^3].
  { made.initial_energy() } -> std::same_as<Real>;
};

/// What most laws answer.
struct PrintedEos {
  void prepare(const EosInputs&) {}
  bool needs_energy() const { return true; }
  Real initial_energy() const { return 0; }
};

/// An equation of state by its formula p(V/V0, E), E per reference volume.
template <EosFormula Law>
class PrintedEquation final : public EquationOfState {
 public:
  PrintedEquation(Law law, const EosInputs& inputs) : law_(std::move(law)) {
    law_.prepare(inputs);
    const auto at = slopes(Real{1}, law_.initial_energy());
    initial_pressure_ = at.value;
    bulk_ = stiffness(Real{1}, at);
  }

  /// E = E_old + work - 1/2 (p_old + p) d(V/V0), p linear in E: solved exactly.
  void update(MaterialTile& tile, const Real* deviatoric_work) const override {
    const bool energetic = law_.needs_energy();
    for (int i = 0; i < tile.count; i += kLanes) {
      const std::size_t at = tile.first + slot_of(i);
      Real* pressure = tile.state->pressure.data() + at;
      const Pack ratio = load(tile.ratio + i);
      auto p = slopes(ratio, Pack{});
      if (energetic) {
        Real* energy = tile.state->energy.data() + at;
        const Pack change = ratio - load(tile.ratio_old + i);
        const Pack known = load(energy) + load(deviatoric_work + i) + load(tile.viscous_work + i) -
                           (0.5 * load(pressure)) * change;
        const Pack e = (known - (0.5 * p.value) * change) / (1.0 + (0.5 * p.slope[1]) * change);
        store(energy, e);
        p = slopes(ratio, e);
      }
      store(pressure, p.value);
      // Where a formula falls with the density it has no sound; the step goes on as if it had.
      const Pack stiff = stiffness(ratio, p);
      store(tile.state->bulk.data() + at, vmax(stiff, broadcast<Pack>(kLeast * bulk_)));
    }
  }
  bool needs_energy() const override { return law_.needs_energy(); }
  Real bulk_modulus() const override { return bulk_; }
  Real initial_energy() const override { return law_.initial_energy(); }
  Real initial_pressure() const override { return initial_pressure_; }
  /// d ln T = -Gamma d ln V, Gamma = (V/V0) dp/dE, by the mean Gamma of the step; none where the
  /// tension is cut off.
  void isentropic_heating(const MaterialTile& tile, Real cutoff, Real* logarithm) const override {
    for (int i = 0; i < tile.count; i += kLanes) {
      const std::size_t at = tile.first + slot_of(i);
      const Pack old = load(tile.ratio_old + i), now = load(tile.ratio + i);
      const Pack gamma =
          0.5 * (old * slopes(old, Pack{}).slope[1] + now * slopes(now, Pack{}).slope[1]);
      const Pack heating = gamma * vlog(old / now);
      const auto opens = load(tile.state->pressure.data() + at) <= broadcast<Pack>(-cutoff);
      store(logarithm + i, select(opens, Pack{}, heating));
    }
  }

  void held_ratio(Real tension, const Real* ratio, const Real* energy, int count,
                  Real* held) const override {
    for (int i = 0; i < count; i += kLanes) {
      const Pack e = load(energy + i);
      store(held + i, held_ratio_of(load(ratio + i), tension, [&](Pack at) {
              const auto p = slopes(at, e);
              return std::pair{p.value, -p.slope[0]};
            }));
    }
  }

  /// Pressure [Pa] at V/V0 and E [J/m^3].
  Real pressure(Real ratio, Real energy) const { return slopes(ratio, energy).value; }

 private:
  static constexpr Real kLeast = 1e-3;  // of the stiffness at the reference state

  /// p, and its slopes by V/V0 and by E.
  template <class V>
  BRUNT_INLINE Dual<V, 2> slopes(V ratio, V energy) const {
    const V zero = broadcast<V>(0.0), one = broadcast<V>(1.0);
    const Dual<V, 2> volume{ratio, {one, zero}};
    const V density = 1.0 / ratio;
    return law_.formula(EosState<Dual<V, 2>>{
        volume, volume.chained(density, -(density * density)), {energy, {zero, one}}});
  }

  /// rho c^2 = (V/V0) (-dp/d(V/V0) + p dp/dE) along the isentrope. In tension the second part is
  /// negative and could swallow the first: there it counts as 0, on the safe side of the step.
  template <class V>
  BRUNT_INLINE V stiffness(V ratio, const Dual<V, 2>& p) const {
    return ratio * (vmax(p.value, broadcast<V>(0.0)) * p.slope[1] - p.slope[0]);
  }

  Law law_;
  Real initial_pressure_ = 0;  // [Pa]
  Real bulk_ = 0;              // [Pa] at the reference state
};

}  // namespace brunt
// Tested by tests/unit/core/ideal_gas_test.cpp.
