#pragma once
/// Materials as the deck gives them: parameters only, SI.
#include <optional>
#include <string>
#include <variant>

#include "core/schema.hpp"

namespace brunt::deck {

/// E and nu, or K and G: one pair is there.
struct ElasticConstants {
  std::optional<Real> E;       ///< [Pa] Young's modulus
  std::optional<Real> nu;      ///< Poisson's ratio
  std::optional<Real> K;       ///< [Pa] bulk modulus
  std::optional<Real> G;       ///< [Pa] shear modulus
  Real bulk_modulus() const;   ///< [Pa]
  Real shear_modulus() const;  ///< [Pa]
};

/// Elastic for ever.
struct NoStrength {
  static constexpr const char* deck_name = "none";
  static constexpr const char* deck_help = "elastic, never yields";
};

/// von Mises yield with isotropic hardening: sigma_y = yield + h(eps_p).
struct J2Parameters {
  static constexpr const char* deck_name = "j2";
  static constexpr const char* deck_help = "von Mises yield with isotropic hardening";
  Real yield = 0;  ///< [Pa] at no plastic strain
  /// [Pa] A constant is the modulus H: h = H eps_p. A table over eps_p is h itself: the stress
  /// added to yield, linear between its points and held after the last.
  std::optional<Varying> hardening;
};

/// sigma_y = (A + B eps_p^n) (1 + C ln(rate/rate_ref)) (1 - T*^m), T* = (T - T_ref)/(T_melt -
/// T_ref). Johnson & Cook 1983.
struct JohnsonCookParameters {
  static constexpr const char* deck_name = "johnson-cook";
  static constexpr const char* deck_help = "yield with strain, rate and temperature (1983)";
  Real A = 0;                  ///< [Pa] yield stress at no plastic strain
  Real B = 0;                  ///< [Pa] hardening
  Real n = 1;                  ///< hardening exponent
  Real C = 0;                  ///< rate coefficient
  Real rate_ref = 1;           ///< [1/s]
  Real m = 1;                  ///< thermal exponent
  std::optional<Real> T_melt;  ///< [K]; none: heat does not soften
  Real T_ref = 298;            ///< [K]
};

/// p = -K ln(V/V0) or what core's law says; its constants are the elastic ones.
struct LinearEosParameters {
  static constexpr const char* deck_name = "linear";
  static constexpr const char* deck_help = "pressure from the elastic bulk modulus";
};

/// Shock Hugoniot us = c0 + s up with Grueneisen parameter gamma0.
struct MieGruneisenParameters {
  static constexpr const char* deck_name = "mie-gruneisen";
  static constexpr const char* deck_help = "pressure from the shock Hugoniot us = c0 + s up";
  Real c0 = 0;      ///< [m/s]
  Real s = 0;       ///< slope
  Real gamma0 = 0;  ///< Grueneisen parameter
};

struct Thermal {
  Real cp = 0;                ///< [J/kg/K] specific heat
  std::optional<Real> k;      ///< [W/m/K] conductivity; read, and not used before heat is conducted
  Real taylor_quinney = 0.9;  ///< share of plastic work that becomes heat
};

using StrengthParameters = std::variant<NoStrength, J2Parameters, JohnsonCookParameters>;
using EosParameters = std::variant<LinearEosParameters, MieGruneisenParameters>;

struct Material {
  Real density = 0;  ///< [kg/m^3]
  ElasticConstants elastic;
  StrengthParameters strength;
  EosParameters eos;
  std::optional<Real> tensile_cutoff;  ///< [Pa] positive: pressure never below minus this
  std::optional<Thermal> thermal;
};

void describe(Schema& s, ElasticConstants& elastic);
void describe(Schema& s, NoStrength& law);
void describe(Schema& s, J2Parameters& law);
void describe(Schema& s, JohnsonCookParameters& law);
void describe(Schema& s, LinearEosParameters& law);
void describe(Schema& s, MieGruneisenParameters& law);
void describe(Schema& s, Thermal& thermal);
void describe(Schema& s, Material& material);

}  // namespace brunt::deck
