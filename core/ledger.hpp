#pragma once
#include <omp.h>

#include <array>
#include <string_view>
#include <vector>

#include "core/exact_sum.hpp"
#include "core/state_hash.hpp"
#include "core/types.hpp"

namespace brunt {

/// Energy columns [J]. Each is integrated from its own force and velocity; their sum is constant.
/// internal: stress work that has not become heat; plastic_heat: the part that has.
/// expansion: minus the work of pressures on what heat has made expand, which internal holds.
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
  expansion,
  integration,
};
inline constexpr int kColumns = 15;
std::string_view column_name(Column column);  ///< as in history.csv: "contact.spring", ...

/// Heat [J] of all bodies that conduct, since time 0:
/// stored = plastic + compression + friction + boundary.
struct HeatSums {
  ExactSum stored;       ///< taken up by points
  ExactSum plastic;      ///< plastic work of these bodies that became heat, as elements booked it
  ExactSum compression;  ///< what compression and viscosity gave them, less what release took
  ExactSum friction;     ///< that contacts gave to bodies that conduct
  ExactSum boundary;     ///< that boundaries let in
  ExactSum moved;        ///< sizes of what each point has taken up or given, since time 0
  void add(const HeatSums& part) {
    stored.add(part.stored), plastic.add(part.plastic), compression.add(part.compression);
    friction.add(part.friction), boundary.add(part.boundary), moved.add(part.moved);
  }
};

/// Exact sums of one body; what history.csv prints in body.NAME.*.
/// heat: taken up since time 0, by plastic work, compression and, in bodies that conduct, from
/// elsewhere. stress_work: internal and plastic heat. viscosity, artificial_stress, integration:
/// its share of the columns of that name, for the watch over energy that nobody put in; absorbed:
/// of viscosity, what equations of state take up, whose pressure gives it back.
template <int Dim>
struct BodySums {
  ExactSum mass, kinetic, internal, hourglass, heat;
  ExactSum stress_work, viscosity, absorbed, artificial_stress, integration;
  std::array<ExactSum, Dim> mass_position, momentum;
  ExactSum eroded, eroded_mass;  ///< [1], [kg] elements that have eroded
  /// [J] volume times principal stresses in tension, of particles with artificial stress; and minus
  /// sum x . f of its forces, the same of what these carry.
  ExactSum tension, artificial_tension;
  ExactSum thin_mass;  ///< [kg] of particles whose neighbours lie in one plane or on one line

  void add(const BodySums& part) {
    mass.add(part.mass), kinetic.add(part.kinetic), internal.add(part.internal);
    hourglass.add(part.hourglass), heat.add(part.heat);
    stress_work.add(part.stress_work), viscosity.add(part.viscosity);
    absorbed.add(part.absorbed);
    artificial_stress.add(part.artificial_stress), integration.add(part.integration);
    tension.add(part.tension), artificial_tension.add(part.artificial_tension);
    thin_mass.add(part.thin_mass);
    eroded.add(part.eroded), eroded_mass.add(part.eroded_mass);
    for (std::size_t c = 0; c < momentum.size(); ++c) {
      mass_position[c].add(part.mass_position[c]);
      momentum[c].add(part.momentum[c]);
    }
  }
};

/// Totals of one row, by order-free exact sums over the columns that entities carry.
template <int Dim>
struct Totals {
  std::array<ExactSum, kColumns> columns;
  std::vector<BodySums<Dim>> bodies;
  HeatSums heat;
  std::uint64_t state_hash = 0;  ///< sum modulo 2^64 of the mixed bits of each entity's state
  bool hashes = true;            ///< whether it is wanted: it costs more than all sums

  void add(Column column, Real value) { columns[static_cast<int>(column)].add(value); }
  Real value(Column column) const { return columns[static_cast<int>(column)].value(); }
};

/// Adds one exact sum to another, all columns and bodies.
template <int Dim>
void add_totals(const Totals<Dim>& from, Totals<Dim>& into) {
  for (std::size_t c = 0; c < into.columns.size(); ++c) into.columns[c].add(from.columns[c]);
  for (std::size_t b = 0; b < into.bodies.size(); ++b) into.bodies[b].add(from.bodies[b]);
  into.heat.add(from.heat);
  into.state_hash += from.state_hash;
}

/// add(first, last, part) adds the entities first .. last to a part; exact sums may be cut
/// anywhere, so each thread takes a share of the n entities.
template <int Dim, class Add>
void add_in_shares(std::size_t n, Totals<Dim>& totals, const Add& add) {
  constexpr std::size_t kWorthThreads = 1000;
  if (n < kWorthThreads || omp_get_max_threads() == 1) return add(std::size_t{0}, n, totals);
#pragma omp parallel
  {
    Totals<Dim> part;
    part.hashes = totals.hashes;
    part.bodies.resize(totals.bodies.size());
    const auto threads = slot_of(omp_get_num_threads());
    const auto thread = slot_of(omp_get_thread_num());
    add(n * thread / threads, n * (thread + 1) / threads, part);
#pragma omp critical(brunt_totals)
    add_totals(part, totals);
  }
}

}  // namespace brunt
