#pragma once
/// Which volumes heat of compression is of.
#include "core/materials/tile_rows.hpp"

namespace brunt {

/// Of the state before a step, what heat of compression needs of materials that open.
struct BeforeHeating {
  Row energy, damage;  ///< [J/m^3 reference], [1]; of those with damage
  Row plastic;         ///< [1] plastic volume times opening; of those whose flow changes volume
};

/// V/V0 of four points at which they bear the tension [Pa] at their energy, where they would pull
/// by more; else their own: by Newton's method in the density, in which most laws are nearly linear
/// there.
/// pressure  V/V0 -> p [Pa] and -dp/d(V/V0) [Pa], at the energy
template <class Pressure>
BRUNT_INLINE Pack held_ratio_of(Pack ratio, Real tension, const Pressure& pressure) {
  constexpr int kSteps = 8;
  const auto pulls = pressure(ratio).first < broadcast<Pack>(-tension);
  if (!any(pulls)) return ratio;
  Pack held = ratio;
  for (int k = 0; k < kSteps; ++k) {
    const auto [p, stiffness] = pressure(held);
    const Pack density = 1.0 / held;
    const Pack denser = density - (p + tension) / (stiffness * held * held);
    const auto sound = (stiffness > 0.0) & (denser > 0.0);
    held = select(sound, 1.0 / denser, held);
  }
  return select(pulls, vmin(held, ratio), ratio);
}

}  // namespace brunt
// Tested by tests/unit/core/opened_heat_test.cpp.
