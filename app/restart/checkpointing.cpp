#include "app/restart/checkpointing.hpp"

#include <utility>

#include "app/ranks/agreed.hpp"

namespace brunt {

namespace {
constexpr std::size_t kKept = 2;
}  // namespace

template <int Dim>
Checkpointing<Dim>::Checkpointing(const LoadedDeck& loaded, std::filesystem::path folder,
                                  Monitor<Dim>& monitor, Restart* restart,
                                  std::function<Requests()> requests)
    : loaded_(loaded),
      folder_(std::move(folder)),
      monitor_(monitor),
      restart_(restart),
      requests_(std::move(requests)),
      last_(std::chrono::steady_clock::now()) {}

template <int Dim>
void Checkpointing<Dim>::begin(Scene<Dim>& scene, Clock& clock) {
  if (restart_ == nullptr) return monitor_.begin(scene, clock);
  monitor_.prepare(scene);
  go_on(scene, clock);
  first_step_ = clock.step();
}

/// A complete load makes the scene whole again after one that failed half way.
template <int Dim>
void Checkpointing<Dim>::go_on(Scene<Dim>& scene, Clock& clock) {
  do {
    const RestartPoint& point = restart_->point();
    try {
      scene.load_state(*point.state);
      clock.load_state(*point.state);
      monitor_.load_state(*point.state, point.texts, clock, point.folder());
      if (restart_->lies_in(folder_)) forget_later(*scene.ranks);
      return;
    } catch (const StateError& error) {
      restart_->refuse(error.what());
    }
  } while (restart_->next());
  throw MachineError("there is no checkpoint that is good");
}

/// What comes after where this run goes on is of a run that this one replaces: --resume must not
/// go on from there.
template <int Dim>
void Checkpointing<Dim>::forget_later(const Communicator& ranks) {
  kept_.push_back(restart_->point().header.step);
  agreed(ranks, [&] {
    if (ranks.is_root()) remove_checkpoints_after(restart_->first());
  });
}

/// A run takes one step at least: before that nothing is asked for or written.
template <int Dim>
Requests Checkpointing<Dim>::requests(const Scene<Dim>& scene, const Clock& clock) {
  if (clock.step() == first_step_) return {};
  Requests mine = requests_();
  const auto& every = loaded_.deck.output.checkpoint;
  const std::chrono::duration<Real> since = std::chrono::steady_clock::now() - last_;
  if (every && scene.ranks->is_root() && since.count() >= *every) mine.checkpoint = true;
  return mine;
}

template <int Dim>
void Checkpointing<Dim>::answer(const StepHead& head, Scene<Dim>& scene, Clock& clock) {
  if (clock.step() == first_step_) return;
  const bool stopped = stop_if_requested(head.requests, clock);
  const bool last = is_before_end(head.step_limit, clock);
  if (folder_.empty()) return;
  if (stopped || last || head.requests.checkpoint || is_due(clock)) write(scene, clock);
}

/// The step that `end` shortens is of this run alone: the checkpoint before it serves longer ones,
/// and none is written after it. One that `stop` makes the last is like any other, and no head of a
/// step follows it.
template <int Dim>
void Checkpointing<Dim>::step_done(Scene<Dim>& scene, Clock& clock) {
  monitor_.step_done(scene, clock);
  if (!clock.finished() || clock.time() >= clock.end() || folder_.empty()) return;
  if (loaded_.deck.output.checkpoint || is_due(clock)) write(scene, clock);
}

/// True if the run ends here on request; its state is a whole step like any other.
template <int Dim>
bool Checkpointing<Dim>::stop_if_requested(const Requests& requests, Clock& clock) {
  if (requests.stop) {
    interrupted_ = true;
    monitor_.stop(clock, "stopped by a signal");
    return true;
  }
  const auto& until = loaded_.deck.time.until;
  if (!until || clock.time() < *until) return false;
  monitor_.stop(clock, "stopped at time.until");
  return true;
}

template <int Dim>
bool Checkpointing<Dim>::is_due(const Clock& clock) const {
  const auto every = loaded_.deck.output.checkpoint_steps;
  return every > 0 && clock.step() % every == 0;
}

/// True once, where checkpoints are written and `end` shortens the step to come.
template <int Dim>
bool Checkpointing<Dim>::is_before_end(const StepLimit& step_limit, const Clock& clock) {
  if (!loaded_.deck.output.checkpoint || before_end_) return false;
  before_end_ = clock.shortens(step_limit);
  return before_end_;
}

template <int Dim>
void Checkpointing<Dim>::write(Scene<Dim>& scene, const Clock& clock) {
  const PhaseTimer timer(scene.phases, Phase::output);
  const Communicator& ranks = *scene.ranks;
  // What has broken already must not take the place of a good one; when one is written must not
  // decide when a run breaks.
  if (!scene.is_sound(clock.time())) return;
  CheckpointContent content;
  scene.save_state(content.tables);
  if (ranks.is_root()) {
    clock.save_state(content.tables);
    monitor_.save_state(content.tables, content.texts);
    content.texts["deck"] = loaded_.resolved;
  }
  const CheckpointHeader header{BRUNT_VERSION, loaded_.hash, clock.real_time(),
                                static_cast<std::uint64_t>(clock.step()),
                                static_cast<std::uint64_t>(ranks.size())};
  CheckpointPart part;
  agreed(ranks, [&] {
    part = write_checkpoint_part(folder_, header, static_cast<std::uint64_t>(ranks.rank()),
                                 std::move(content));
  });
  Packer mine;
  mine << part;
  std::vector<CheckpointPart> parts;
  for (const Bytes& bytes : ranks.gather(mine.take())) Unpacker(bytes) >> parts.emplace_back();
  kept_.push_back(header.step);
  if (kept_.size() > kKept) kept_.erase(kept_.begin());
  agreed(ranks, [&] {
    if (!ranks.is_root()) return;
    write_checkpoint_manifest(folder_, header, parts);
    remove_checkpoints_but(folder_, kept_);
  });
  last_ = std::chrono::steady_clock::now();
}

template class Checkpointing<2>;
template class Checkpointing<3>;

}  // namespace brunt
