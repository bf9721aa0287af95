#pragma once
/// The list of models. A new one: its file, its name in a list here, and make_* in catalog.cpp if
/// neither return serves it (docs/adding.md).
#include <variant>

#include "core/materials/damage_laws.hpp"
#include "core/materials/drucker_prager.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/eos_linear.hpp"
#include "core/materials/j2.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/mie_gruneisen.hpp"
#include "core/materials/pressure_return.hpp"
#include "core/materials/radial_return.hpp"
#include "core/materials/steinberg_guinan.hpp"
#include "core/materials/zerilli_armstrong.hpp"

namespace brunt {

/// The deck's `strength` and `eos`, in the order of the manual; the first is the default.
using StrengthLaw =
    std::variant<NoStrength, J2, JohnsonCook, ZerilliArmstrong, SteinbergGuinan, DruckerPrager>;
using EosLaw = std::variant<LinearEos, MieGruneisen>;

/// The deck's `damage`.
using DamageChoice = std::variant<NoDamage, JohnsonCookDamage, StrainDamage, CockcroftLatham,
                                  PrincipalStressDamage, MeanTensionDamage>;

std::unique_ptr<Strength> make_strength(const StrengthLaw& law, const StrengthInputs& inputs);

/// Null where nothing fails.
std::unique_ptr<Damage> make_damage(const DamageChoice& law, const DamageInputs& inputs);

/// What an equation of state takes from its material.
struct EosInputs {
  Real density = 0;  ///< [kg/m^3] rho0
  Real bulk = 0;     ///< [Pa] K of the elastic constants; laws with a sound speed have their own
};
std::unique_ptr<EquationOfState> make_eos(const LinearEos& law, const EosInputs& inputs);
std::unique_ptr<EquationOfState> make_eos(const MieGruneisen& law, const EosInputs& inputs);
std::unique_ptr<EquationOfState> make_eos(const EosLaw& law, const EosInputs& inputs);

}  // namespace brunt
