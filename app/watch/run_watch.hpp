#pragma once
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/loop/clock.hpp"
#include "app/watch/energy_watch.hpp"
#include "io/summary.hpp"

namespace brunt {

/// What the watch reads at one step.
struct RunLook {
  const EnergyLook& energies;
  const std::vector<CreatedEnergy>& created;
  const EnergyWatch& watch;
  const std::string& deepest_pair;  ///< of bodies in contact; empty: none touch
};

/// Warns, once each, of what goes wrong slowly: energy that nobody put in, hourglass energy, and a
/// step that shrinks far below the plan. Looks at fixed steps; what it says is a function of the
/// deck.
class RunWatch {
 public:
  /// Energy that nobody put in, over the largest, from which on it warns.
  static constexpr Real kCreatedWarning = 0.01;
  /// Hourglass energy over the work of a body's stresses from which on it warns.
  static constexpr Real kHourglassWarning = 0.1;
  /// Steps left over the steps of the plan from which on it warns.
  static constexpr Real kStepsWarning = 10;

  explicit RunWatch(const Deck& deck) : deck_(deck), hourglass_warned_(deck.bodies.size(), 0) {}

  /// What is to be reported now. Throws PhysicsError above time.max_created.
  std::vector<RunWarning> look(const RunLook& now, const Clock& clock);
  /// What is to be reported of boundaries whose whole time has passed within the last step.
  std::vector<RunWarning> missed(const Clock& clock);
  /// All that has been reported.
  const std::vector<RunWarning>& warned() const { return warned_; }
  /// Largest share of energy that nobody put in, of all looks.
  Real worst_created() const { return worst_created_; }

  void save_state(std::vector<StateTable>& tables, std::map<std::string, std::string>& texts) const;
  void load_state(const StateTables& tables, const std::map<std::string, std::string>& texts);

 private:
  template <class Row, class Watch>
  static void visit(Row& row, Watch& watch) {
    row(watch.created_warned_), row(watch.steps_warned_), row(watch.worst_created_);
    row(watch.last_time_), row(watch.last_step_);
    for (auto& reported : watch.hourglass_warned_) row(reported);
  }
  void look_at_created(const RunLook& now, const Clock& clock, std::vector<RunWarning>& warnings);
  void look_at_hourglass(const RunLook& now, const Clock& clock, std::vector<RunWarning>& warnings);
  void look_at_steps(const Clock& clock, std::vector<RunWarning>& warnings);
  std::string whose_text(const Clock& clock) const;
  std::string created_text(const RunLook& now, const CreatedShare& worst) const;
  std::string remedy(const CreatedEnergy& worst, const std::string& pair) const;

  const Deck& deck_;
  std::vector<RunWarning> warned_;
  std::vector<std::uint64_t> hourglass_warned_;
  std::uint64_t created_warned_ = 0, steps_warned_ = 0;
  Real worst_created_ = 0;
  Real last_time_ = 0;  // [s] of the last look
  std::int64_t last_step_ = 0;
};

/// What the end of a run says of energies: of what appeared, and of hourglass energy; in percent.
std::vector<std::string> energy_lines(const EnergyShares& energy);

}  // namespace brunt
