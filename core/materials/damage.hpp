#pragma once
/// Materials that fail. A law says how far a point is on its way: its index is 1 where failure
/// begins. From then on the point softens and keeps (1 - damage) of its stress, pressure excepted
/// that compresses: what has opened closes again. docs/theory/materials.md (M21)
#include "core/materials/principal_stress.hpp"
#include "core/materials/tile_rows.hpp"

namespace brunt {

/// What a law of damage sees of a point at the end of a step. Stresses are effective ones, of what
/// still carries: stress/(1 - damage).
template <class V>
struct DamagePoint {
  V eps_p;        ///< [1] equivalent plastic strain; 0 of what does not yield
  V increment;    ///< [1] of it in this step
  V rate;         ///< [1/s] of it
  V temperature;  ///< [K]
  V pressure;     ///< [Pa] positive in compression
  V von_mises;    ///< [Pa]
  V largest;      ///< [Pa] largest principal stress, where the law needs it
};

/// What Softening needs of a law, a plain struct of parameters.
template <class Law>
concept DamageLaw = requires(const Law& law, const DamagePoint<Real>& at) {
  /// The index after a step that began with another: at least that one.
  { law.index(at, Real{}) } -> std::same_as<Real>;
  /// It reads the largest principal stress, which costs some twenty operations.
  { Law::kNeedsPrincipal } -> std::convertible_to<bool>;
  { law.needs_temperature() } -> std::same_as<bool>;
  /// [J/m^2] taken by a crack of what carries no more, as (M21); 0: it fails in one step.
  { law.energy } -> std::convertible_to<Real>;
};

/// What damage takes from its material.
struct DamageInputs {
  Real shear = 0;  ///< [Pa] G
};

/// Rows that a step of a material with damage keeps: those of the state before it.
struct BeforeDamage {
  DeviatorRows nominal;    ///< [Pa] as forces had it
  DeviatorRows effective;  ///< [Pa]
  Row pressure;            ///< [Pa] nominal
  Row eps_p, heat, temperature;
};

}  // namespace brunt
