#pragma once
#include <string>
#include <vector>

#include "app/watch/energy_watch.hpp"
#include "io/summary.hpp"

namespace brunt {

/// How much inertia takes part where a process is stepped faster than it runs: the kinetic energy
/// of each body over the work of its stresses, at the end and as a mean, the integral of the
/// one over time by that of the other. Of bodies whose stresses have done work, and of these
/// together. Looks come at fixed steps: what it says is a function of the deck.
class InertiaWatch {
 public:
  /// Kinetic energy over the work of stresses from which on it warns.
  static constexpr Real kMuchInertia = 0.05;

  explicit InertiaWatch(std::size_t bodies) : sums_(bodies) {}

  /// time [s] as it is stepped
  void look(const EnergyLook& energies, Real time);
  /// By body in the order of the names, then "all" where there are several. end  as it is there
  std::vector<InertiaShare> shares(const std::vector<std::string>& bodies,
                                   const EnergyLook& end) const;

  void save_state(std::vector<StateTable>& tables) const;
  void load_state(const StateTables& tables);

 private:
  struct Sums {
    Real kinetic = 0, work = 0;  // [J s] integrals over time
  };
  template <class Row, class Watch>
  static void visit(Row& row, Watch& watch) {
    row(watch.last_time_);
    for (auto& sums : watch.sums_) {
      row(sums.kinetic), row(sums.work);
    }
  }
  std::vector<Sums> sums_;  // by body
  Real last_time_ = 0;      // [s]
};

/// A warning of each share that is above kMuchInertia at the end or as a mean.
std::vector<RunWarning> inertia_warnings(const std::vector<InertiaShare>& shares, Real speed);
/// "kinetic energy over the work of stresses: block 0.2 % at the end, 0.5 % as a mean".
std::string inertia_line(const std::vector<InertiaShare>& shares);
/// What a process speed distorts, in a sentence; "" for 1.
std::string distortion_text(Real speed);

}  // namespace brunt
// Tested by tests/unit/app/inertia_watch_test.cpp.
