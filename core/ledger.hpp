#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "core/exact_sum.hpp"
#include "core/types.hpp"

namespace brunt {

/// Energy columns [J]. Each is integrated from its own force and velocity; their sum is constant.
/// internal: stress work that has not become heat; plastic_heat: the part that has.
/// boundary: minus the work that supports and loads do on the scene.
/// integration: what a change of the time step leaves in the kinetic energy of the scheme.
enum class Column : int {
  kinetic,
  internal,
  plastic_heat,
  hourglass,
  viscosity,
  artificial_stress,
  contact_spring,
  contact_damping,
  contact_friction,
  contact_pairs,
  boundary,
  damping,
  eroded,
  integration,
};
inline constexpr int kColumns = 14;
std::string_view column_name(Column column);  ///< as in history.csv: "contact.spring", ...

/// Exact sums of one body; what history.csv prints in body.NAME.*.
template <int Dim>
struct BodySums {
  ExactSum mass, kinetic, internal, hourglass, heat;
  std::array<ExactSum, Dim> mass_position, momentum;
};

/// Totals of one row, by order-free exact sums over the columns that entities carry.
template <int Dim>
struct Totals {
  std::array<ExactSum, kColumns> columns;
  std::vector<BodySums<Dim>> bodies;
  std::uint64_t state_hash = 0;  ///< sum modulo 2^64 of the mixed bits of each entity's state

  void add(Column column, Real value) { columns[static_cast<int>(column)].add(value); }
  Real value(Column column) const { return columns[static_cast<int>(column)].value(); }
};

/// Mixes the bits of one value into the hash of one entity (splitmix64 finaliser).
inline std::uint64_t mix(std::uint64_t hash, std::uint64_t bits) {
  hash ^= bits + 0x9e3779b97f4a7c15ULL + (hash << 6) + (hash >> 2);
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
  return hash ^ (hash >> 31);
}
std::uint64_t mix(std::uint64_t hash, Real value);

}  // namespace brunt
