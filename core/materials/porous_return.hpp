#pragma once
/// Laws of porous solids, whose pores close under pressure: pressure, strength and pores of a step
/// depend on each other, so that one law gives them all. docs/theory/materials.md section 8.
#include <array>
#include <concepts>
#include <utility>

#include "core/materials/elastic.hpp"
#include "core/materials/plastic_heat.hpp"
#include "core/simd_math.hpp"

namespace brunt {

/// A point as a law of porous solids sees it. It is isotropic: of the deviator it needs the size.
template <std::size_t n_own>
struct PorousPoint {
  Real ratio = 1;           ///< [1] V/V0 after the step
  Real rate = 0;            ///< [1/s] equivalent rate of strain, elastic and plastic
  Real length = 1;          ///< [m] size of the element or particle
  Real pressure = 0;        ///< [Pa] before the step; after it
  Real q = 0;               ///< [Pa] equivalent stress of the elastic trial; after the step
  Real bulk = 0;            ///< [Pa] after the step: tangent modulus of loading or release
  Real eps_p = 0;           ///< [1] before the step
  Real increment = 0;       ///< [1] of eps_p, of this step
  Real plastic_volume = 0;  ///< [1] logarithmic volume strain of this step that does not come back
  Real damage = 0;          ///< [1] share of the strength that is lost, after the step
  Real porosity = 0;        ///< [1] share of pores, after the step
  Real tension = 0;         ///< [Pa] the largest that is left, after the step
  std::array<Real, n_own> own{};  ///< what the law keeps, before the step; after it
};

/// What PorousReturn needs of a law, a plain struct of parameters.
template <class Law>
concept PorousLaw = requires(Law law, const Law& made, PorousPoint<Law::kOwn>& at) {
  /// Computes, once, what the formulas have from the parameters.
  law.prepare();
  /// One step of a point.
  made.step(at);
  /// The same at rest, at time 0.
  made.start(at);
  /// Parts that a step is taken in, so that each is small against what the law curves over; of the
  /// trial as a whole (pressure and own those before the step), and the equivalent stress before.
  { made.parts(std::as_const(at), Real{}) } -> std::same_as<int>;
  /// Equivalent stress [Pa] at which it yields at the pressure and the state of a point.
  { made.strength(at) } -> std::same_as<Real>;
  /// Elastic constants [Pa] at the start.
  { made.bulk_modulus() } -> std::same_as<Real>;
  { made.shear_modulus() } -> std::same_as<Real>;
  /// Its porosity is worth a field; its softening depends on the size of elements.
  { Law::kPores } -> std::convertible_to<bool>;
  { Law::kRegularised } -> std::convertible_to<bool>;
};

/// Elastic trial of the deviator, the law's step, and the deviator scaled to what it returns.
template <PorousLaw Law>
class PorousReturn final : public Strength {
 public:
  PorousReturn(Law law, const StrengthInputs& inputs) : law_(std::move(law)), inputs_(inputs) {
    law_.prepare();
    inputs_.shear = law_.shear_modulus();
  }

  void update(MaterialTile& tile, Real dt) const override {
    const Real inverse_dt = dt > 0 ? 1.0 / dt : 0.0;
    for (int i = 0; i < tile.count; ++i) update_point(tile, i, inverse_dt);
  }
  bool yields() const override { return true; }
  bool needs_temperature() const override { return false; }
  bool sees_pressure() const override { return true; }
  bool gives_pressure() const override { return true; }
  void add_fields(MaterialState& state, std::size_t size) const override {
    Point at;
    law_.start(at);
    state.own.resize(Law::kOwn);
    for (std::size_t n = 0; n < Law::kOwn; ++n) state.own[n].assign(size, at.own[n]);
    state.damage.assign(size, 0.0);
    state.tensile_strength.assign(size, at.tension);
    if (Law::kPores) state.porosity.assign(size, at.porosity);
    if (Law::kRegularised) state.length.assign(size, 1.0);
  }
  Real flow_stress(const MaterialState& state, std::size_t k, Real) const override {
    Point at = point(state, k);
    at.rate = state.strain_rate[k];
    return law_.strength(at);
  }

 private:
  using Point = PorousPoint<Law::kOwn>;

  Point point(const MaterialState& state, std::size_t k) const {
    Point at;
    at.pressure = state.pressure[k];
    at.eps_p = state.eps_p[k];
    at.damage = state.damage[k];
    if (Law::kRegularised) at.length = state.length[k];
    for (std::size_t n = 0; n < Law::kOwn; ++n) at.own[n] = state.own[n][k];
    return at;
  }
  void update_point(MaterialTile& tile, int i, Real inverse_dt) const;
  Real step_part(Point& at, const Real (&trial)[6], Real (&s)[6]) const;

  Law law_;
  StrengthInputs inputs_;
};

/// Size of a deviator, components as SymmetricIndex: the equivalent stress of stresses.
inline Real equivalent_of(const Real (&s)[6]) {
  Real square = 0;
  for (std::size_t c = 0; c < 6; ++c) square += (c < 3 ? 1.0 : 2.0) * (s[c] * s[c]);
  return std::sqrt(1.5 * square);
}

/// One part of the step of a point: deviator s [Pa] before and after it; returns the plastic work
/// [J/m^3], of the stresses of the new surface at the most.
template <PorousLaw Law>
Real PorousReturn<Law>::step_part(Point& at, const Real (&trial)[6], Real (&s)[6]) const {
  const Real q_old = equivalent_of(s), q_trial = equivalent_of(trial), p_old = at.pressure;
  at.q = q_trial, at.increment = at.plastic_volume = 0;
  law_.step(at);
  const Real scale = at.q < q_trial ? at.q / q_trial : 1.0;
  for (std::size_t c = 0; c < 6; ++c) s[c] = scale * trial[c];
  return 0.5 * (vmin(q_old, at.q) + at.q) * at.increment -
         0.5 * (p_old + at.pressure) * at.plastic_volume;
}

template <PorousLaw Law>
void PorousReturn<Law>::update_point(MaterialTile& tile, int i, Real inverse_dt) const {
  MaterialState& state = *tile.state;
  const std::size_t k = tile.first + slot_of(i);
  Point at = point(state, k);
  at.ratio = tile.ratio[i];
  const Real third = (tile.strain[xx][i] + tile.strain[yy][i] + tile.strain[zz][i]) * (1.0 / 3.0);
  Real s[6], trial[6], strain_square = 0;
  const auto set_trial = [&](Real part) {
    for (std::size_t c = 0; c < 6; ++c) {
      const Real mean = c < 3 ? third : 0.0;
      trial[c] = trial_stress(s[c], part * tile.strain[c][i], part * mean, inputs_.shear);
    }
  };
  for (std::size_t c = 0; c < 6; ++c) {
    const Real strain = tile.strain[c][i] - (c < 3 ? third : 0.0);
    strain_square += (c < 3 ? 1.0 : 2.0) * (strain * strain);
    s[c] = state.deviator[c][k];
  }
  set_trial(1);
  at.rate = std::sqrt(strain_square * (2.0 / 3.0)) * inverse_dt;
  at.q = equivalent_of(trial);
  const int n = law_.parts(at, equivalent_of(s));
  Real work = 0, increment = 0;
  for (int part = 1; part <= n; ++part) {
    if (n > 1) {
      set_trial(1.0 / n);
      const Real left = static_cast<Real>(n - part) / n;
      at.ratio = tile.ratio[i] * vexp(left * vlog(tile.ratio_old[i] / tile.ratio[i]));
    }
    work += step_part(at, trial, s);
    increment += at.increment;
  }
  for (std::size_t c = 0; c < 6; ++c) state.deviator[c][k] = s[c];
  state.pressure[k] = at.pressure;
  state.bulk[k] = at.bulk;
  state.eps_p[k] = at.eps_p + increment;
  state.strain_rate[k] = increment * inverse_dt;
  state.damage[k] = at.damage;
  state.tensile_strength[k] = at.tension;
  if (Law::kPores) state.porosity[k] = at.porosity;
  for (std::size_t o = 0; o < Law::kOwn; ++o) state.own[o][k] = at.own[o];
  if (!state.heat.empty()) add_plastic_heat<Real>(inputs_, tile, i, work);
}

}  // namespace brunt
// Tested by tests/unit/core/concrete_cap_test.cpp.
