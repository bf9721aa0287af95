#pragma once
/// Stress at time 0 as the deck gives it over the place, and the state of a material point that
/// begins with it. docs/theory/materials.md (M46), (M47)
#include <array>
#include <functional>
#include <stdexcept>

#include "core/materials/material.hpp"

namespace brunt {

/// Cauchy stress at a place.
struct PlacedStress {
  Vec3 place;                   ///< [m] absolute
  std::array<Real, 6> value{};  ///< [Pa] tension positive, SymmetricIndex

  Real pressure() const { return -(value[xx] + value[yy] + value[zz]) / 3; }  ///< [Pa]
  /// The same deviator about another pressure [Pa].
  PlacedStress with_pressure(Real wanted) const;
};

/// Cauchy stress of one body at time 0.
struct InitialStress {
  Label body = 0;
  Vec3 origin = Vec3::Zero();  ///< [m] to which positions are relative
  /// [Pa] over the absolute place [m], tension positive, SymmetricIndex; one that is empty is 0
  std::array<std::function<Real(const Vec3&)>, 6> component;

  /// At a position [m], what a plane scene leaves out 0. Throws InitialStressError where it is no
  /// number.
  PlacedStress at(const Vec3& position) const;
};

/// Says why a material cannot begin with a stress, and where.
class InitialStressError : public std::domain_error {
 public:
  InitialStressError(Label of, const std::string& message) : std::domain_error(message), body(of) {}
  Label body;
};

/// Why no point of a material can be given a stress at time 0; empty where it can.
std::string initial_stress_problem(const Material& material);

/// Gives material points of one material their stress at time 0. The pressure is that of the
/// equation of state at a volume V = r V0: the point counts as one that was compressed from rest.
class StressedStart {
 public:
  /// stress  whose points are begun; it outlives this, as the material does
  /// temperature [K], adiabatic  as of Material::initial_state
  StressedStart(const InitialStress& stress, const Material& material, Real temperature,
                bool adiabatic);

  const InitialStress& stress() const { return stress_; }
  /// The ratio r [1] of the volume to that free of stress. (M46) Throws InitialStressError where
  /// the equation of state has no such pressure.
  Real ratio(const PlacedStress& at);
  /// Makes point k of `state`, which is at rest, one with the deviator of `at` at the ratio r.
  /// Returns its energy [J/m^3 reference] (M47). Throws InitialStressError where the material
  /// cannot hold the stress.
  Real begin(const PlacedStress& at, Real r, MaterialState& state, std::size_t k);

 private:
  Real compress(Real r, Real deviatoric_energy);
  void take_temperature(Real temperature);
  Real deviatoric_energy(const PlacedStress& at) const;
  void require_bearable(const PlacedStress& at) const;
  void require_held(const PlacedStress& at, Real r);
  [[noreturn]] void refuse(const PlacedStress& at, const std::string& why) const;

  const InitialStress& stress_;
  const Material& material_;
  Real temperature_;  // [K]
  // A tile at rest; the one whose pressure is asked for; the same after a step without strain.
  MaterialState rest_, scratch_, asked_;
};

}  // namespace brunt
// Tested by tests/verification/initial_stress_test.cpp.
