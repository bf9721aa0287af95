#pragma once
/// The list of models. A new one: its file, its name in a list here, and make in catalog.cpp where
/// it is not made of a printed formula (docs/adding.md).
#include <optional>
#include <variant>

#include "core/materials/concrete_cap.hpp"
#include "core/materials/damage_laws.hpp"
#include "core/materials/drucker_prager.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/eos_linear.hpp"
#include "core/materials/holmquist.hpp"
#include "core/materials/ideal_gas.hpp"
#include "core/materials/j2.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/jwl.hpp"
#include "core/materials/mie_gruneisen.hpp"
#include "core/materials/polynomial.hpp"
#include "core/materials/pressure_return.hpp"
#include "core/materials/radial_return.hpp"
#include "core/materials/steinberg_guinan.hpp"
#include "core/materials/tait.hpp"
#include "core/materials/zerilli_armstrong.hpp"

namespace brunt {

/// The deck's `strength` and `eos`, in the order of the manual; the first is the default.
using StrengthLaw = std::variant<NoStrength, J2, JohnsonCook, ZerilliArmstrong, SteinbergGuinan,
                                 DruckerPrager, ConcreteCap, Holmquist>;
using EosLaw = std::variant<LinearEos, MieGruneisen, Tait, Polynomial, IdealGas, Jwl>;

/// Elastic constants [Pa] that a strength brings with it.
struct OwnConstants {
  Real bulk, shear;
};
/// Those of laws that give the pressure too; none: `elastic` says them.
std::optional<OwnConstants> own_constants(const StrengthLaw& law);

/// True of laws of fluids, which need no elastic constants: `static constexpr bool kFluid = true`.
bool is_fluid(const EosLaw& law);

/// The deck's `damage`.
using DamageChoice = std::variant<NoDamage, JohnsonCookDamage, StrainDamage, CockcroftLatham,
                                  PrincipalStressDamage, MeanTensionDamage>;

std::unique_ptr<Strength> make_strength(const StrengthLaw& law, const StrengthInputs& inputs);

/// Null where nothing fails.
std::unique_ptr<Damage> make_damage(const DamageChoice& law, const DamageInputs& inputs);

std::unique_ptr<EquationOfState> make_eos(const EosLaw& law, const EosInputs& inputs);

}  // namespace brunt
