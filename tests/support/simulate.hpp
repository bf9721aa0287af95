#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/loop/time_loop.hpp"
#include "core/view.hpp"
#include "io/summary.hpp"

namespace brunt::test {

/// How a run differs from the plain one; none of it may change a bit.
struct RunVariation {
  int threads = 0;  ///< 0: as the environment says
  bool rearrange_every_step = false;
  /// Stops after so many steps with a checkpoint, and goes on from it in a new scene; 0: does not.
  std::int64_t split_at = 0;
};

/// What a test does to a scene of a 3D deck from outside, or sees of any.
struct SceneHooks {
  std::function<void(Scene<3>&)> built;
  std::function<void(Scene<3>&, const Clock&)> step_done;
  /// After each step of any deck: its number, and how the bodies are now, by label.
  std::function<void(std::int64_t, const std::function<BodyView(Label)>&)> moved;
};

/// All that a run of a deck leaves, in memory.
struct Simulation {
  std::vector<std::string> columns;     ///< state_hash is not among them
  std::vector<std::vector<Real>> rows;  ///< one a history row
  std::vector<std::uint64_t> hashes;    ///< state hash of each row
  std::map<std::string, Real> measures;
  std::map<std::string, BodyView> bodies;  ///< at the end
  std::map<std::string, LostReport> lost;  ///< by pair of bodies, where contacts did not hold
  std::vector<std::string> warnings;       ///< of contacts, reported while it ran
  std::vector<RunWarning> reported;        ///< of energies, the step, artificial stress
  std::vector<std::pair<std::string, Real>> step_margins;  ///< by body, of time.check_step
  std::vector<InertiaShare> inertia;                       ///< of a process that is made faster
  Real created = 0;  ///< largest share of energy that nobody put in
  std::int64_t steps = 0;
  std::int64_t steps_here = 0;  ///< without those before a restart
  Real worst_drift = 0;
  std::string failure;  ///< what a PhysicsError said; empty: none
  std::string reason;   ///< why it stopped before its end; empty: it did not

  std::size_t index(const std::string& column) const;
  std::vector<Real> column(const std::string& name) const;
  Real first(const std::string& name) const { return rows.front()[index(name)]; }
  Real last(const std::string& name) const { return rows.back()[index(name)]; }
  /// Largest absolute value of any energy column over the run [J].
  Real largest_energy() const;
};

Simulation simulate(const LoadedDeck& loaded, const RunVariation& variation = {},
                    const SceneHooks& hooks = {});
Simulation simulate_text(const std::string& text, const std::vector<std::string>& overrides = {},
                         const RunVariation& variation = {}, const SceneHooks& hooks = {});
/// A deck that ships, by its folder's name, or as folder/deck where its own name is another.
Simulation simulate_shipped(const std::string& name, const std::vector<std::string>& overrides = {},
                            const RunVariation& variation = {});

}  // namespace brunt::test
