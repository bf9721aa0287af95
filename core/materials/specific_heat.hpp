#pragma once
#include <span>
#include <vector>

#include "core/schema.hpp"
#include "core/types.hpp"

namespace brunt {

/// Specific heat over temperature, linear between the points of a table and constant outside, with
/// its enthalpy h(T) = int cp dT, piecewise quadratic, and the exact inverse of that.
class SpecificHeat {
 public:
  SpecificHeat() = default;
  /// [J/kg/K], the same at any temperature
  explicit SpecificHeat(Real constant) : cp_{constant} {}
  /// [J/kg/K] a constant, or a table over temperature; all values positive.
  explicit SpecificHeat(const Varying& given);
  /// Of a mixture: sum share_k cp_k(T), where the shares [1] of the mass add up to 1.
  static SpecificHeat of_mixture(std::span<const SpecificHeat* const> parts,
                                 std::span<const Real> shares);

  bool operator==(const SpecificHeat&) const = default;
  bool varies() const { return cp_.size() > 1; }
  /// [J/kg/K] at T [K]
  Real at(Real T) const;
  /// [J/kg] from the first temperature of the table to T [K]; below it negative.
  Real enthalpy(Real T) const;
  /// [K] where the enthalpy is h [J/kg]: its inverse, closed form in each interval.
  Real temperature(Real h) const;
  /// [J/kg/K] least between two temperatures [K], in any order
  Real least_between(Real a, Real b) const;
  /// [J/kg/K] least at any temperature
  Real least() const;

 private:
  void integrate();

  std::vector<Real> T_;        // [K] ascending; of a constant one or none
  std::vector<Real> cp_{0.0};  // [J/kg/K] there
  std::vector<Real> h_;        // [J/kg] there; 0 at the first
};

}  // namespace brunt
