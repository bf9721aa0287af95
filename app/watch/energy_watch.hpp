#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/ledger.hpp"
#include "core/state.hpp"

namespace brunt {

/// Energies [J] of a scene as the watch looks at them.
struct EnergyLook {
  struct Body {
    Real kinetic = 0, stress_work = 0, hourglass = 0, viscosity = 0, artificial_stress = 0;
    Real integration = 0, absorbed = 0;
  };
  std::array<Real, kColumns> columns{};
  std::vector<Body> bodies;

  Real column(Column which) const { return columns[slot_of(which)]; }
};
/// sum_of_body  by label, the body that stands for all whose particles share one sum: what these do
/// to each other is no work of either
template <int Dim>
EnergyLook energy_look(const Totals<Dim>& totals, const std::vector<Label>& sum_of_body);

/// Where energy can appear that nobody put in.
enum class EnergySource : int {
  artificial_stress,
  integration,
  hourglass,
  viscosity,
  stress_work,
  contact_pairs,
  contact_damping,
  contact_friction,
  damping,
};
inline constexpr int kEnergySources = 9;
/// As history.csv calls it: "artificial_stress", "contact.pairs", ...
std::string_view source_name(EnergySource source);

/// Energy [J] that came from one source into one body, or the scene where body is none.
struct CreatedEnergy {
  EnergySource source = EnergySource::artificial_stress;
  std::optional<Label> body;
  Real energy = 0;
};

/// The worst part of the largest energy that has appeared, and where.
struct CreatedShare {
  Real share = 0;
  std::optional<Label> body;  ///< none: all of the scene together
};

/// Sums the energy that nobody put in: neither physics nor dissipation gives it.
/// docs/theory/ledger.md (L7)
///
/// Of each body, and never set off against another body or another source:
///   artificial_stress, hourglass, stress_work  what they are below zero: they have given more than
///     they took; stresses of materials whose pressure depends on energy may give what viscosity
///     has heated them by. What they hold and give back, as springs do, is theirs.
///   viscosity, integration  what they have given since they were largest: they hold nothing that
///     they could give back.
/// Of the scene: contact.pairs, contact.damping, contact.friction and damping, as viscosity.
///
/// Measured against the largest energy so far, of kinetic, internal, plastic_heat, contact.spring,
/// contact.friction, damping and boundary. What is largest is kept at looks alone, which come at
/// fixed steps: all of it is a function of the deck, however often rows are written.
class EnergyWatch {
 public:
  explicit EnergyWatch(std::size_t bodies = 0) : most_(bodies) {}

  /// What is never measured against less [J]: energies of rounding.
  void start(Real floor) { largest_ = floor; }
  /// Remembers what is largest. Called at fixed steps.
  void keep(const EnergyLook& look);

  /// All that has appeared, largest first; sources that gave nothing are left out.
  std::vector<CreatedEnergy> created(const EnergyLook& look) const;
  /// What has appeared over the largest energy, of the scene, or of the body in which that is more.
  /// A body's own largest energy is that of its motion or of its stresses, and no less than a tenth
  /// of the scene's: what hardly takes part is not looked at more closely.
  CreatedShare share(const EnergyLook& look, const std::vector<CreatedEnergy>& created) const;
  /// The largest energy [J] up to this look.
  Real largest(const EnergyLook& look) const;
  /// Hourglass energy of a body over the largest work of its stresses so far; 0 where the body
  /// holds too little to matter, below a hundredth of the largest energy of the scene.
  Real hourglass_share(const EnergyLook& look, Label body) const;

  template <class Row, class Watch>
  static void visit(Row& row, Watch& watch) {
    row(watch.largest_);
    for (auto& value : watch.taken_) row(value);
    for (auto& body : watch.most_) {
      row(body.viscosity), row(body.integration), row(body.stress_work), row(body.kinetic);
    }
  }

 private:
  /// The most that these have taken so far [J].
  struct Most {
    Real viscosity = 0, integration = 0, stress_work = 0, kinetic = 0;
  };
  Real largest_ = 0;             // [J]
  std::array<Real, 4> taken_{};  // [J] the most of the scene's columns that hold nothing
  std::vector<Most> most_;       // of each body
};

/// Sum [J] of what has appeared.
Real sum(const std::vector<CreatedEnergy>& created);

}  // namespace brunt
