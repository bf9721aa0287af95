#pragma once
#include <chrono>
#include <filesystem>
#include <functional>

#include "app/loop/signals.hpp"
#include "app/restart/restart.hpp"
#include "app/watch/monitor.hpp"

namespace brunt {

/// Watches a run besides its monitor: goes on from a checkpoint, writes them, and stops where it is
/// asked to. Each rank writes its own part, the root the manifest. Reads the scene and changes
/// nothing; when it writes changes no bit.
template <int Dim>
class Checkpointing final : public Observer<Dim> {
 public:
  /// folder  where checkpoints go; empty: nowhere
  /// restart  null: the run starts at time 0
  /// requests  asked before every step but the first of this process, on every rank: one that says
  /// yes is enough
  Checkpointing(const LoadedDeck& loaded, std::filesystem::path folder, Monitor<Dim>& monitor,
                Restart* restart, std::function<Requests()> requests);

  void begin(Scene<Dim>& scene, Clock& clock) override;
  /// Signals, and on the root the clock on the wall.
  Requests requests(const Scene<Dim>& scene, const Clock& clock) override;
  /// Writes checkpoints and stops between two steps, where all ranks know that it is due.
  void answer(const StepHead& head, Scene<Dim>& scene, Clock& clock) override;
  void step_done(Scene<Dim>& scene, Clock& clock) override;

  bool interrupted() const { return interrupted_; }
  std::int64_t first_step() const { return first_step_; }  ///< of this process

 private:
  void go_on(Scene<Dim>& scene, Clock& clock);
  void forget_later(const Communicator& ranks);
  bool stop_if_requested(const Requests& requests, Clock& clock);
  bool is_due(const Clock& clock) const;
  bool is_before_end(const StepLimit& step_limit, const Clock& clock);
  void write(Scene<Dim>& scene, const Clock& clock);

  const LoadedDeck& loaded_;
  std::filesystem::path folder_;
  Monitor<Dim>& monitor_;
  Restart* restart_;
  std::function<Requests()> requests_;
  std::vector<std::uint64_t> kept_;  // steps of the checkpoints that stay, the latest last
  std::chrono::steady_clock::time_point last_;
  bool before_end_ = false;  // the one before the last step is written
  bool interrupted_ = false;
  std::int64_t first_step_ = 0;
};

}  // namespace brunt
