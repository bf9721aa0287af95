#pragma once
/// Quantities with units: UDUNITS-2 converts and checks the dimension. An angle counts as a
/// dimension of its own, so that Hz is no rate of spin.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace brunt {

/// Exponents of m, kg, s, K, A, mol, cd, rad.
struct Dimension {
  static constexpr int kBases = 8;
  static constexpr int kAngle = 7;
  std::array<int, kBases> exponent{};
  bool operator==(const Dimension&) const = default;
  bool is_number() const { return *this == Dimension{}; }
  /// The same with the angle left out: what an expression can know.
  Dimension without_angle() const;
  /// "kg m^-1 s^-2", or "1".
  std::string text() const;
  /// As UDUNITS reads it: "kg.m-1.s-2".
  std::string unit() const;
};

/// A number, perhaps with a unit, as it stands in a deck.
struct QuantityValue {
  Real value = 0;       ///< SI
  Dimension dimension;  ///< of a number without unit: none
  bool has_unit = false;
  std::string problem;  ///< not empty: why it is refused
};

/// The UDUNITS-2 database with `deg` and `rev`. Making one takes some milliseconds.
class Units {
 public:
  Units();  ///< throws MachineError where the database cannot be read
  ~Units();
  Units(const Units&) = delete;
  Units& operator=(const Units&) = delete;

  /// Reads "139 m/s", "0.2mm", "1 1/s", "5 %", "20 degC"; without a unit it is SI.
  QuantityValue read(std::string_view given) const;
  /// The dimension of an SI unit of the schema: "kg/m^3", "rad/s", "1". Must be known.
  Dimension dimension_of(const std::string& unit) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// What a unit of the schema measures: "a density (kg/m^3)", "a length (m)", "a number".
std::string describe_unit(const std::string& unit);

}  // namespace brunt
