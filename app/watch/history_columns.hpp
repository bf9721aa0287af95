#pragma once
#include <string>
#include <vector>

#include "app/loop/clock.hpp"
#include "app/scene/scene.hpp"
#include "app/watch/energy_watch.hpp"

namespace brunt {

/// The columns of history.csv (docs/guide/output.md) and their values at one step.
template <int Dim>
class HistoryColumns {
 public:
  explicit HistoryColumns(const Scene<Dim>& scene);
  const std::vector<std::string>& names() const { return names_; }

  struct Row {
    std::vector<Real> values;            ///< one a column, state_hash aside
    std::vector<std::size_t> whole;      ///< indices of whole numbers: step, planes
    std::uint64_t state_hash = 0;        ///< the last column; 0 where it was not wanted
    Real total = 0;                      ///< [J]
    Real drift = 0;                      ///< (total - total at time 0) / largest column so far
    EnergyLook energies;                 ///< what the watch over created energy read
    std::vector<CreatedEnergy> created;  ///< energy that nobody put in, largest first
    std::string deepest_pair;            ///< of bodies in contact; empty: none touch
    std::vector<LostPair> lost;          ///< pairs of bodies in which contacts did not hold
    /// By label: what artificial stress carries of the body's tension, 0 without it. [1]
    std::vector<Real> artificial_share;
    /// By label: mass of its particles in sheets and rows over the body's. [1]
    std::vector<Real> thin_share;
  };
  /// Collects a row; the first call sets what drift is measured against.
  /// keeps  the watch over energies remembers what is largest here: at fixed steps alone
  /// hashes  with the state hash
  Row collect(const Scene<Dim>& scene, const Clock& clock, bool keeps, bool hashes);
  const EnergyWatch& energies() const { return energies_; }
  /// Indices of whole numbers in a row.
  const std::vector<std::size_t>& whole() const { return whole_; }

  /// What drift is measured against.
  void save_state(std::vector<StateTable>& tables) const;
  void load_state(const StateTables& tables);  ///< throws StateError

 private:
  static void add_bodies(const Scene<Dim>& scene, const Totals<Dim>& totals, Real time, Row& row);
  static void add_pairs(const Scene<Dim>& scene, Row& row);
  static void add_boundaries(const Scene<Dim>& scene, std::vector<Real>& values);
  static void add_watched(const Scene<Dim>& scene, std::vector<Real>& values);
  void add_heat(const Totals<Dim>& totals, std::vector<Real>& values);

  std::vector<std::string> names_;
  std::vector<std::size_t> whole_;
  EnergyWatch energies_;
  bool first_ = true;
  Real total_start_ = 0;
  Real largest_ = 0;
  Real largest_heat_ = 0;  // [J]
};

}  // namespace brunt
