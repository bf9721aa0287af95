#pragma once
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/materials/specific_heat.hpp"
#include "core/schema.hpp"
#include "core/types.hpp"

namespace brunt {

/// State of the material points of a block (Gauss points of elements, or particles),
/// component-contiguous and padded to whole tiles; padding repeats a harmless unstrained point.
/// Fields that the block's material does not need are empty.
struct MaterialState {
  std::array<std::vector<Real>, 6> deviator;  ///< [Pa] deviatoric Cauchy stress, SymmetricIndex
  std::vector<Real> pressure;                 ///< [Pa] positive in compression, without viscosity
  std::vector<Real> eps_p;                    ///< equivalent plastic strain; empty: elastic
  std::vector<Real> strain_rate;              ///< [1/s] last plastic strain rate; empty: elastic
  std::vector<Real> temperature;  ///< [K]; empty where heat is off and the start has one
  std::vector<Real> heat;         ///< [J/m^3 reference] plastic work become heat
  /// [J/m^3 reference] rho0 cp dT of compression and viscosity, and so lost again on release; empty
  /// unless the EOS has an energy and the point a temperature
  std::vector<Real> compression_heat;
  std::vector<Real> energy;  ///< [J/m^3 reference] internal energy; empty unless the EOS reads it
  /// [1] plastic volume over that at time 0, and, apart from it, what has opened in tension and
  /// closes again: V/V0 over both is that of the elastic volume; empty unless flow changes volume
  std::vector<Real> plastic_volume, opening;
  /// [1] V/V0 of the point free of stress at its temperature; empty unless the material expands
  std::vector<Real> expansion;
  std::vector<Real> expansion_work;  ///< [J/m^3 reference] of the pressure on it; as long
  /// [K] at time 0, from which it expands; empty unless it expands and depends on the place
  std::vector<Real> start_temperature;
  std::vector<Real> bulk;  ///< [Pa] current tangent bulk modulus K_t
  /// Of materials that fail: how far the way to failure is gone, 1 where it begins; the share of
  /// the stress that is lost; and where softening takes energy the work since it began, that at
  /// which nothing is left, the largest elastic energy [J/m^3], and the size of the element or
  /// particle [m], which its owner sets. docs/theory/materials.md (M21)
  std::vector<Real> damage_index, damage;
  std::vector<Real> softening_work, softening_limit, softening_energy, length;
  /// Of laws of porous solids: share of pores, largest tension that is left [Pa], and what else the
  /// law keeps, [variable][point]
  std::vector<Real> porosity, tensile_strength;
  std::vector<std::vector<Real>> own;
  std::size_t size() const { return pressure.size(); }
};

/// Points first .. first+count of a state, with what has happened to them in this step.
/// The caller has rotated the deviator into the new configuration (Hughes-Winget) already.
/// count is a multiple of kLanes. Arrays are indexed from 0 within the tile.
inline constexpr int kTile = 64;
struct MaterialTile {
  MaterialState* state = nullptr;
  std::size_t first = 0;
  int count = 0;
  Real fixed_temperature = 0;         ///< [K] what laws see where the state has none
  bool adiabatic = false;             ///< plastic work and compression heat the point at once
  alignas(32) Real strain[6][kTile];  ///< D dt at the mid-configuration, tensor components, full
  alignas(32) Real ratio_old[kTile];  ///< V/V0 before the step
  alignas(32) Real ratio[kTile];      ///< V/V0 after the step
  alignas(32) Real
      viscous_work[kTile];  ///< [J/m^3 reference] of this step, heats an EOS with energy
};

/// The strength of a material: updates the deviator of a tile. One virtual call a tile.
class Strength {
 public:
  virtual ~Strength() = default;
  /// deviator += 2 G dev(strain), then the return to the yield surface; eps_p, strain_rate,
  /// temperature (adiabatic) and heat with it.
  virtual void update(MaterialTile& tile, Real dt) const = 0;
  virtual bool yields() const = 0;
  virtual bool needs_temperature() const = 0;
  /// True where `update` wants the pressure and the bulk modulus of the step in the state, before
  /// plastic flow.
  virtual bool sees_pressure() const { return false; }
  /// True where plastic flow changes the volume, which sees_pressure then: `update` moves
  /// plastic_volume and opening, and the pressure by what they do to it at that modulus.
  virtual bool changes_volume() const { return false; }
  /// True where pressure and deviator come from one law, which sees_pressure then: `update` sets
  /// pressure and bulk modulus too, and no equation of state is asked.
  virtual bool gives_pressure() const { return false; }
  /// Makes the fields of a state that only this law has, at rest. size: points, whole tiles
  virtual void add_fields(MaterialState&, std::size_t) const {}
  /// Flow stress [Pa] of point k as the last step left it: at its plastic strain, last plastic rate
  /// and temperature; infinite where the material never yields.
  /// fixed_temperature [K] what the law sees where the state has none
  virtual Real flow_stress(const MaterialState& state, std::size_t k,
                           Real fixed_temperature) const = 0;
};

/// What an equation of state takes from its material.
struct EosInputs {
  Real density = 0;  ///< [kg/m^3] rho0
  Real bulk = 0;     ///< [Pa] K of the elastic constants; laws with a sound speed have their own
};

/// The equation of state: updates pressure, tangent bulk modulus and energy of a tile.
class EquationOfState {
 public:
  virtual ~EquationOfState() = default;
  /// deviatoric_work [J/m^3 reference]: the deviator's work in this step, tile-indexed.
  virtual void update(MaterialTile& tile, const Real* deviatoric_work) const = 0;
  virtual bool needs_energy() const = 0;
  virtual Real bulk_modulus() const = 0;  ///< [Pa] at the reference state
  /// [J/m^3] and [Pa] at the reference state, in which points start.
  virtual Real initial_energy() const { return 0; }
  virtual Real initial_pressure() const { return 0; }
  /// V/V0 below which the law is held and no longer resists as printed; 0: never.
  virtual Real densest_ratio() const { return 0; }
  /// Writes ln(T_new/T_old) [1] of the step at constant entropy, tile-indexed; asked only of laws
  /// with an energy, after the cut-off. cutoff [Pa] of the tension: what opens there expands
  /// nothing.
  virtual void isentropic_heating(const MaterialTile&, Real cutoff, Real* logarithm) const = 0;
  /// Writes V/V0 at which points bear a tension [Pa] at their energy [J/m^3 reference], where they
  /// would pull by more, and else their own; asked only of laws with an energy.
  virtual void held_ratio(Real tension, const Real* ratio, const Real* energy, int count,
                          Real* held) const = 0;
};

struct BeforeDamage;
struct BeforeHeating;

/// How a material fails: around what an intact one does with a tile.
class Damage {
 public:
  virtual ~Damage() = default;
  /// Makes the deviator of a tile the effective one, and keeps what the step changes.
  virtual void begin(MaterialTile& tile, BeforeDamage& before) const = 0;
  /// After the strength: plastic work is done by what still carries, and so is its heat.
  virtual void scale_heat(MaterialTile& tile, const BeforeDamage& before) const = 0;
  /// After pressure and its cut-off: index, softening, nominal stress, and the energy of an
  /// equation of state that has one.
  virtual void end(MaterialTile& tile, const BeforeDamage& before) const = 0;
  virtual bool needs_temperature() const = 0;
  /// True where softening depends on the size of elements (MaterialState::length).
  virtual bool regularised() const = 0;
};

/// A material as the kernels see it: density, elastic constants, strength, equation of state.
struct Material {
  std::string name;
  Real density = 0;                 ///< [kg/m^3] reference
  Real shear = 0;                   ///< [Pa] G
  Real bulk = 0;                    ///< [Pa] K at the reference state
  Real tensile_cutoff = kInfinity;  ///< [Pa] pressure never below minus this
  bool thermal = false;
  SpecificHeat specific_heat;  ///< [J/kg/K] a constant, or a table over temperature
  Varying conductivity;        ///< [W/m/K] a constant, or a table over temperature
  Real expansion = 0;          ///< [1/K] linear, from the temperature at time 0
  std::unique_ptr<Strength> strength;
  std::unique_ptr<EquationOfState> eos;
  std::unique_ptr<Damage> damage;  ///< null: it never fails

  Real modulus() const { return bulk + 4.0 / 3.0 * shear; }  ///< [Pa] M = K + 4G/3
  bool yields() const { return strength->yields(); }
  /// sqrt(k rho cp) [J/m^2/K/s^(1/2)] at a temperature [K]: how heat of a surface shares itself.
  Real effusivity(Real temperature) const {
    return std::sqrt(conductivity.at(temperature) * density * specific_heat.at(temperature));
  }

  /// Fields for n points at rest, padded to whole tiles. Where `adiabatic` and the material is
  /// thermal they have temperature [K], and heat if it yields; a block that conducts asks for the
  /// same and leaves MaterialTile::adiabatic false, so that the point's temperature is the
  /// caller's.
  MaterialState initial_state(std::size_t n, Real temperature, bool adiabatic) const;
  /// True where compression changes the temperature of points that have one.
  bool heats_by_compression() const { return thermal && eos->needs_energy(); }
  /// True where a point's temperature is part of its state: it changes or moves the stress.
  bool keeps_temperature() const { return yields() || heats_by_compression() || expansion != 0; }
  /// One step of a tile: strength, then equation of state, then cut-off, then what compression and
  /// viscosity do to the temperature. A strength that sees the pressure comes after it.
  void update(MaterialTile& tile, Real dt) const;

 private:
  /// What `update` does but for expansion: laws see the volume ratio over that of the point free of
  /// stress. docs/theory/materials.md (M44)
  void update_unexpanded(MaterialTile& tile, Real dt) const;
  /// What `update` does but for damage and heat of compression. before  null without damage
  void find_stress(MaterialTile& tile, Real dt, const BeforeDamage* before) const;
  /// The order of a strength that sees the pressure: equation of state without plastic flow,
  /// strength, equation of state. docs/theory/materials.md (M13)
  void find_stress_after_pressure(MaterialTile& tile, Real dt, const BeforeDamage* before) const;
  /// dT = gamma0 T d(eta) + dw/(rho0 cp), eta = 1 - V/V0 and w the viscous work, where gamma rho
  /// is constant: T_new = (T_old g + w/(rho0 cp)) g, g = exp(gamma0 (eta_new - eta_old)/2), so that
  /// release returns what compression gave. A shock stands within some five steps: with w after all
  /// of the compression instead of in its middle, aluminium at 2000 m/s was 5 % too cold. Plastic
  /// heat the strength has added before.
  ///   McQueen et al., in Kinslow (ed.), High-Velocity Impact Phenomena, 1970, ch. VII
  void add_compression_heat(MaterialTile& tile, const BeforeHeating& before) const;
  void keep_before_heating(const MaterialTile& tile, BeforeHeating& before) const;
  /// ln(T_new/T_old) at constant entropy of the volumes that bear pressure: what has opened expands
  /// nothing. docs/theory/materials.md (M48)
  void find_isentropic_heating(MaterialTile& tile, const BeforeHeating& before,
                               Real* logarithm) const;
  /// ratio  V/V0 of points, and then of what of them bears pressure; lost  their damage
  void find_bearing_ratio(const Real* energy, const Real* lost, int count, Real* ratio) const;
};

}  // namespace brunt
