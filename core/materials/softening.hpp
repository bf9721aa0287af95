#pragma once
#include "core/materials/damage.hpp"
#include "core/materials/law.hpp"

namespace brunt {

/// (M22): 1 - d = m (1 - w/w_f), m = sqrt(psi_0/psi), from the step on in which the index
/// reaches 1. psi [J/m^3] is the largest elastic energy of the intact part since then, psi_0 the
/// one that it had in that step: m holds a stress that still grows at the strength. w = int m s :
/// d(eps) [J/m^3] is the work of what is held so, and w_f = 2 (G_f/L - psi_0), L [m] the size of
/// the element. A crack takes psi_0 L + w_f L/2 = G_f then, whatever the shape of the stress-strain
/// curve and the size of the element (crack band: Bazant & Oh, Mater. Struct. 16, 1983).
template <DamageLaw Law>
class Softening final : public Damage {
 public:
  Softening(const Law& law, const DamageInputs& inputs) : law_(law), inputs_(inputs) {}

  void begin(MaterialTile& tile, BeforeDamage& before) const override;
  void scale_heat(MaterialTile& tile, const BeforeDamage& before) const override;
  void end(MaterialTile& tile, const BeforeDamage& before) const override;
  bool needs_temperature() const override { return law_.needs_temperature(); }
  bool regularised() const override { return law_.energy > 0; }

 private:
  /// Four points of a tile, at the end of a step.
  struct Four {
    std::array<Pack, 6> deviator;  // [Pa] effective
    Pack pressure;                 // [Pa] effective
    Pack shear_work, work;  // [J/m^3 reference] of the effective deviator; with that of tension
  };
  Four effective(const MaterialTile& tile, const BeforeDamage& before, int i) const;
  Pack index_of(const MaterialTile& tile, const BeforeDamage& before, const Four& four,
                int i) const;
  Pack elastic_energy(const Four& four, Pack bulk) const;
  Pack soften(const MaterialTile& tile, const Four& four, Pack index_before, Pack index,
              int i) const;
  void store_nominal(MaterialTile& tile, const BeforeDamage& before, const Four& four, Pack damage,
                     int i) const;

  Law law_;
  DamageInputs inputs_;
};

template <DamageLaw Law>
void Softening<Law>::begin(MaterialTile& tile, BeforeDamage& before) const {
  MaterialState& state = *tile.state;
  before.nominal = copied_deviator(tile);
  before.pressure = copied(state.pressure.data() + tile.first, tile.count);
  const auto keep = [&](const std::vector<Real>& field, Row& row) {
    if (!field.empty()) row = copied(field.data() + tile.first, tile.count);
  };
  keep(state.eps_p, before.eps_p);
  keep(state.heat, before.heat);
  keep(state.temperature, before.temperature);
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack left = 1.0 - load(state.damage.data() + at);
    const Pack inverse =
        select(left > 0.0, 1.0 / vmax(left, broadcast<Pack>(1e-300)), broadcast<Pack>(0.0));
    for (auto& component : state.deviator) {
      store(component.data() + at, inverse * load(component.data() + at));
    }
  }
  before.effective = copied_deviator(tile);
}

template <DamageLaw Law>
void Softening<Law>::scale_heat(MaterialTile& tile, const BeforeDamage& before) const {
  MaterialState& state = *tile.state;
  if (state.heat.empty()) return;
  const bool heats = tile.adiabatic && !state.temperature.empty();
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Pack left = 1.0 - load(state.damage.data() + at);
    const auto scale = [&](std::vector<Real>& field, const Row& old) {
      const Pack was = load(old.at + i);
      store(field.data() + at, was + left * (load(field.data() + at) - was));
    };
    scale(state.heat, before.heat);
    if (heats) scale(state.temperature, before.temperature);
  }
}

template <DamageLaw Law>
void Softening<Law>::end(MaterialTile& tile, const BeforeDamage& before) const {
  MaterialState& state = *tile.state;
  for (int i = 0; i < tile.count; i += kLanes) {
    const std::size_t at = tile.first + slot_of(i);
    const Four four = effective(tile, before, i);
    const Pack index_before = load(state.damage_index.data() + at);
    const Pack index = vmax(index_before, index_of(tile, before, four, i));
    store(state.damage_index.data() + at, index);
    store_nominal(tile, before, four, soften(tile, four, index_before, index, i), i);
  }
}

template <DamageLaw Law>
typename Softening<Law>::Four Softening<Law>::effective(const MaterialTile& tile,
                                                        const BeforeDamage& before, int i) const {
  const MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  Four four;
  for (std::size_t c = 0; c < 6; ++c) four.deviator[c] = load(state.deviator[c].data() + at);
  four.pressure = load(state.pressure.data() + at);
  const Pack zero = broadcast<Pack>(0.0), left = 1.0 - load(state.damage.data() + at);
  const Pack old = vmin(load(before.pressure.at + i), zero);
  const Pack pulled = select(left > 0.0, old / vmax(left, broadcast<Pack>(1e-300)), zero);
  const Pack change = load(tile.ratio + i) - load(tile.ratio_old + i);
  four.shear_work = deviatoric_work(tile, before.effective, i);
  four.work = four.shear_work - 0.5 * (pulled + vmin(four.pressure, zero)) * change;
  return four;
}

template <DamageLaw Law>
Pack Softening<Law>::index_of(const MaterialTile& tile, const BeforeDamage& before,
                              const Four& four, int i) const {
  const MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const Pack zero = broadcast<Pack>(0.0);
  const auto& s = four.deviator;
  const Pack square = 1.5 * (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) +
                      3.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  DamagePoint<Pack> point{
      zero,          zero,          zero, broadcast<Pack>(tile.fixed_temperature),
      four.pressure, vsqrt(square), zero};
  if (!state.eps_p.empty()) {
    point.eps_p = load(state.eps_p.data() + at);
    point.increment = point.eps_p - load(before.eps_p.at + i);
    point.rate = load(state.strain_rate.data() + at);
  }
  if (!state.temperature.empty()) point.temperature = load(state.temperature.data() + at);
  if constexpr (Law::kNeedsPrincipal) point.largest = largest_principal(s) - four.pressure;
  return law_.index(point, load(state.damage_index.data() + at));
}

/// Elastic energy [J/m^3] of four points, that of pressure that compresses left out.
template <DamageLaw Law>
Pack Softening<Law>::elastic_energy(const Four& four, Pack bulk) const {
  const auto& s = four.deviator;
  const Pack square =
      s[0] * s[0] + s[1] * s[1] + s[2] * s[2] + 2.0 * (s[3] * s[3] + s[4] * s[4] + s[5] * s[5]);
  const Pack tension = vmin(four.pressure, broadcast<Pack>(0.0));
  return square * (inputs_.shear > 0 ? 0.25 / inputs_.shear : 0.0) + 0.5 * tension * tension / bulk;
}

/// Damage after the step.
template <DamageLaw Law>
Pack Softening<Law>::soften(const MaterialTile& tile, const Four& four, Pack index_before,
                            Pack index, int i) const {
  MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const Pack zero = broadcast<Pack>(0.0), one = broadcast<Pack>(1.0);
  const auto begun = index >= 1.0, fresh = begun & (index_before < 1.0);
  const Pack damage = load(state.damage.data() + at);
  if (!any(begun)) return damage;
  if (!regularised()) {
    const Pack failed = select(begun, one, damage);
    store(state.damage.data() + at, failed);
    return failed;
  }
  const Pack tiny = broadcast<Pack>(1e-300);
  const Pack whole = law_.energy / load(state.length.data() + at);
  const Pack energy = elastic_energy(four, load(state.bulk.data() + at));
  Real* const limit_at = state.softening_limit.data() + at;
  const Pack limit = select(fresh, vmax(2.0 * (whole - energy), zero), load(limit_at));
  store(limit_at, limit);
  Real* const largest_at = state.softening_energy.data() + at;
  const Pack before = select(fresh, energy, load(largest_at)), largest = vmax(before, energy);
  store(largest_at, select(begun, largest, zero));
  const Pack first = vmax(whole - 0.5 * limit, tiny);
  const auto held = [&](Pack most) { return vsqrt(vmin(first / vmax(most, tiny), one)); };
  Real* const work_at = state.softening_work.data() + at;
  const Pack done = 0.5 * (held(before) + held(largest)) * four.work;
  const Pack work = load(work_at) + select(begun & !fresh, done, zero);
  store(work_at, work);
  const Pack left =
      select(limit > 0.0, vmax(1.0 - vmax(work, zero) / vmax(limit, tiny), zero), zero);
  const Pack after = select(begun, vmax(damage, 1.0 - held(largest) * left), damage);
  store(state.damage.data() + at, after);
  return after;
}

template <DamageLaw Law>
void Softening<Law>::store_nominal(MaterialTile& tile, const BeforeDamage& before, const Four& four,
                                   Pack damage, int i) const {
  MaterialState& state = *tile.state;
  const std::size_t at = tile.first + slot_of(i);
  const Pack left = 1.0 - damage;
  for (std::size_t c = 0; c < 6; ++c) {
    store(state.deviator[c].data() + at, left * four.deviator[c]);
  }
  const Pack pressure = select(four.pressure < 0.0, left * four.pressure, four.pressure);
  store(state.pressure.data() + at, pressure);
  if (state.energy.empty()) return;
  // Equation of state and its energy took the work of the effective stresses.
  const Pack change = load(tile.ratio + i) - load(tile.ratio_old + i);
  const Pack shear = deviatoric_work(tile, before.nominal, i) - four.shear_work;
  const Pack volume = -0.5 * (pressure - four.pressure) * change;
  store(state.energy.data() + at, load(state.energy.data() + at) + shear + volume);
}

}  // namespace brunt
// Tested by tests/unit/core/damage_test.cpp.
