#include "app/deck/materials.hpp"

#include <array>
#include <cassert>

namespace brunt::deck {

Real ElasticConstants::bulk_modulus() const { return K ? *K : *E / (3 * (1 - 2 * *nu)); }

Real ElasticConstants::shear_modulus() const { return G ? *G : *E / (2 * (1 + *nu)); }

Real Material::bulk_modulus() const {
  if (elastic) return elastic->bulk_modulus();
  if (const auto own = own_constants(strength)) return own->bulk;
  return make_eos(eos, {density, 0})->bulk_modulus();
}

Real Material::shear_modulus() const {
  if (elastic) return elastic->shear_modulus();
  const auto own = own_constants(strength);
  return own ? own->shear : 0;
}

StrengthLaw Material::melting_strength() const {
  StrengthLaw law = strength;
  auto* melts = std::get_if<JohnsonCook>(&law);
  if (melts && !melts->T_melt && thermal) melts->T_melt = thermal->T_melt;
  return law;
}

DamageChoice Material::melting_damage() const {
  DamageChoice law = damage;
  auto* melts = std::get_if<JohnsonCookDamage>(&law);
  const StrengthLaw melting = melting_strength();
  const auto* flows = std::get_if<JohnsonCook>(&melting);
  if (melts && !melts->T_melt && thermal) melts->T_melt = thermal->T_melt;
  if (melts && !melts->T_melt && flows) melts->T_melt = flows->T_melt;
  return law;
}

bool Material::heats_itself() const {
  if (!thermal) return false;
  return !std::holds_alternative<NoStrength>(strength) ||
         make_eos(eos, {density, 0})->needs_energy();
}

void describe(Schema& s, ElasticConstants& elastic) {
  constexpr Quantity kModulus{"Pa", positive(), between(1e3, 2e12)};
  s.real({"E", "Young's modulus"}, elastic.E, kModulus);
  s.real({"nu", "Poisson's ratio"}, elastic.nu, {"1", {-1, 0.5, true, true}, between(0, 0.4999)});
  s.real({"K", "bulk modulus"}, elastic.K, kModulus);
  s.real({"G", "shear modulus; 0: a fluid"}, elastic.G, {"Pa", at_least(0), between(0, 2e12)});
  const bool technical = elastic.E && elastic.nu && !elastic.K && !elastic.G;
  const bool theoretical = elastic.K && elastic.G && !elastic.E && !elastic.nu;
  s.require(technical || theoretical, "", "needs E and nu, or K and G, and not both pairs");
}

void describe(Schema& s, Thermal& thermal) {
  static constexpr std::array kOver{Varying::Over::temperature};
  s.varying({"cp", "specific heat; a peak holds latent heat", Need::required}, thermal.cp,
            {"J/kg/K", positive(), between(50, 1e6)}, kOver);
  s.varying({"k", "conductivity; without it heat stays where it is"}, thermal.k,
            {"W/m/K", at_least(0), between(0, 5000)}, kOver);
  s.real({"taylor_quinney", "share of plastic work that becomes heat"}, thermal.taylor_quinney,
         {"1", between(0, 1)});
  s.real(
      {"expansion",
       "linear thermal expansion: free of stress it is as long as its heat since time 0 makes it"},
      thermal.expansion, {"1/K", between(-1e-3, 1e-3)});
  s.real({"T_melt", "temperature of melting, of johnson-cook's laws that do not say it themselves"},
         thermal.T_melt, {"K", positive(), between(200, 5000)});
}

void describe(Schema& s, Material& material) {
  s.real({"density", "mass density at rest", Need::required}, material.density,
         {"kg/m^3", positive(), between(1, 3e4)});
  s.object(
      {"elastic", "E and nu, or K and G; fluids with an eos of their own and concrete need none"},
      material.elastic);
  s.one_of({"strength", "what limits the stress"}, material.strength);
  s.one_of({"eos", "pressure from volume"}, material.eos);
  s.one_of({"damage", "how it fails"}, material.damage);
  s.real({"tensile_cutoff", "pressure never falls below minus this"}, material.tensile_cutoff,
         {"Pa", at_least(0), between(0, 1e11)});
  s.object({"thermal", "heat capacity and what plastic work gives"}, material.thermal);
  const bool whole = own_constants(material.strength).has_value();
  s.require(material.elastic || whole || is_fluid(material.eos), "elastic",
            "is missing: E and nu, or K and G");
  if (whole) {
    s.require(!material.elastic, "elastic",
              "is not for this strength, which has its own elastic constants: K and G of "
              "concrete-cap, p_crush/mu_crush and G of hjc");
    s.require(std::holds_alternative<LinearEos>(material.eos), "eos",
              "is not for this strength, which gives the pressure itself");
    s.require(std::holds_alternative<NoDamage>(material.damage), "damage",
              "is not for this strength, which has its own");
    s.require(!material.tensile_cutoff, "tensile_cutoff",
              "is not for this strength, which has its own: ft of concrete-cap, T of hjc");
  }
  s.require(!material.elastic || !material.elastic->complete() ||
                material.elastic->shear_modulus() > 0 ||
                std::holds_alternative<NoStrength>(material.strength),
            "strength", "takes a shear modulus above 0: a fluid has no strength");
  s.require(material.elastic || whole || std::holds_alternative<NoStrength>(material.strength),
            "strength",
            "takes a shear modulus: add `elastic`, or take the strength out of a fluid");
}

}  // namespace brunt::deck
