#pragma once
/// Materials as the deck gives them: parameters only, SI.
#include <optional>
#include <string>

#include "core/materials/catalog.hpp"
#include "core/schema.hpp"

namespace brunt::deck {

/// E and nu, or K and G: one pair is there.
struct ElasticConstants {
  std::optional<Real> E;   ///< [Pa] Young's modulus
  std::optional<Real> nu;  ///< Poisson's ratio
  std::optional<Real> K;   ///< [Pa] bulk modulus
  std::optional<Real> G;   ///< [Pa] shear modulus
  bool complete() const { return (E && nu) || (K && G); }
  Real bulk_modulus() const;   ///< [Pa]
  Real shear_modulus() const;  ///< [Pa]
};

struct Thermal {
  std::optional<Varying> cp;   ///< [J/kg/K] specific heat, a constant or a table over temperature
  std::optional<Varying> k;    ///< [W/m/K] conductivity, a constant or a table over temperature
  Real taylor_quinney = 0.9;   ///< share of plastic work that becomes heat
  Real expansion = 0;          ///< [1/K] linear
  std::optional<Real> T_melt;  ///< [K] of laws that do not say their own
};

struct Material {
  Real density = 0;                         ///< [kg/m^3]
  std::optional<ElasticConstants> elastic;  ///< none: a fluid
  StrengthLaw strength;                     ///< one of the catalogue
  EosLaw eos;
  DamageChoice damage;
  std::optional<Real> tensile_cutoff;  ///< [Pa] positive: pressure never below minus this
  std::optional<Thermal> thermal;
  StrengthLaw melting_strength() const;  ///< with thermal.T_melt where it has none of its own
  DamageChoice melting_damage() const;   ///< likewise
  Real bulk_modulus() const;   ///< [Pa] of the elastic constants, or of the equation of state
  Real shear_modulus() const;  ///< [Pa] 0: a fluid
  /// It is thermal, and plastic work or an equation of state with an energy raises its temperature.
  bool heats_itself() const;
};

void describe(Schema& s, ElasticConstants& elastic);
void describe(Schema& s, Thermal& thermal);
void describe(Schema& s, Material& material);

}  // namespace brunt::deck
