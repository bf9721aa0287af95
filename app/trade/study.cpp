#include "app/trade/study.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <thread>

#include "app/loop/signals.hpp"
#include "app/trade/processes.hpp"
#include "app/watch/progress.hpp"
#include "core/errors.hpp"
#include "io/file.hpp"

namespace brunt {

namespace fs = std::filesystem;

namespace {
/// One run of a study.
struct Task {
  std::size_t variant = 0;
  int round = 0;
  fs::path folder, words;
  int status = -1;  ///< none yet
};

std::vector<Task> tasks_of(const std::vector<Variant>& variants, const StudyOptions& options) {
  std::vector<Task> tasks;
  const fs::path words = options.words.empty() ? options.out : options.words;
  for (int round = 0; round < options.repeat; ++round) {
    for (std::size_t v = 0; v < variants.size(); ++v) {
      std::string name = variants[v].folder;
      // No value ends like that: "damping-0.3" is a variant, and was the third run of "damping-0".
      if (round > 0) name += ".repeat-" + std::to_string(round + 1);
      const std::string leaf = fs::path(name).filename().string() + ".txt";
      tasks.push_back({v, round, options.out / name, words / leaf});
    }
  }
  return tasks;
}

std::vector<std::string> command_of(const Task& task, const Variant& variant,
                                    const StudyOptions& options) {
  std::vector<std::string> command = {own_program(), "run", options.deck};
  for (const auto& change : variant.overrides) {
    command.insert(command.end(), {"--set", change});
  }
  if (!options.checkpoint.empty() && !variant.loaded.places.has("output.checkpoint")) {
    command.insert(command.end(), {"--set", "output.checkpoint=" + options.checkpoint});
  }
  command.insert(command.end(), {"--out", task.folder.string(), "--quiet"});
  command.insert(command.end(), options.flags.begin(), options.flags.end());
  if (options.resume) command.emplace_back("--resume");
  if (options.force) command.emplace_back("--force");
  return command;
}

/// One line for all runs: rewritten on a terminal, else a line a run that has ended.
class StudyProgress {
 public:
  StudyProgress(const StudyOptions& options, std::size_t all)
      : quiet_(options.quiet), title_(options.title), all_(all) {}

  void ended(const std::string& label, int status) {
    ++done_;
    if (status != 0) ++failed_;
    if (quiet_ || terminal_) return;
    std::fprintf(stderr, "%s %s: %s\n", head().c_str(), label.c_str(), status_word(status).c_str());
  }
  void show(const std::string& running) {
    const auto now = std::chrono::steady_clock::now();
    if (quiet_ || !terminal_ || now - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = now;
    std::fprintf(stderr, "\r\x1b[K%s %.60s", head().c_str(), running.c_str());
  }
  void finish() const {
    if (!quiet_ && terminal_) std::fprintf(stderr, "\r\x1b[K");
  }

 private:
  std::string head() const {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    std::string text = title_ + " [" + std::to_string(done_) + " of " + std::to_string(all_) +
                       " runs] " + duration_text(elapsed.count());
    if (failed_ > 0) text += ", " + std::to_string(failed_) + " failed";
    if (done_ > 0 && done_ < all_) {
      const double left = elapsed.count() * static_cast<double>(all_ - done_) / done_;
      text += ", about " + duration_text(left) + " left";
    }
    return text;
  }
  bool quiet_, terminal_ = isatty(STDERR_FILENO) != 0;
  std::string title_;
  std::size_t all_, done_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now(), shown_{};
};

/// Runs all tasks; false where a signal stopped it.
bool run_tasks(std::vector<Task>& tasks, const std::vector<Variant>& variants,
               const StudyOptions& options) {
  Processes processes;
  StudyProgress progress(options, tasks.size());
  std::vector<bool> fails(variants.size(), false);
  std::size_t next = 0;
  bool stopping = false;
  while (next < tasks.size() || !processes.running().empty()) {
    const bool room = static_cast<int>(processes.running().size()) < options.jobs;
    if (!stopping && room && next < tasks.size()) {
      Task& task = tasks[next];
      if (fails[task.variant]) {
        progress.ended(variants[task.variant].label, task.status = kPhysicsBroke);
      } else {
        processes.start(next, command_of(task, variants[task.variant], options), task.words,
                        options.threads);
      }
      ++next;
      continue;
    }
    if (const auto ended = processes.take_ended()) {
      Task& task = tasks[ended->id];
      task.status = ended->status;
      fails[task.variant] = fails[task.variant] || (task.status != kDone && !stopping);
      stopping = stopping || task.status == kStopped;
      progress.ended(variants[task.variant].label, task.status);
      continue;
    }
    if (take_requests().stop && !stopping) {
      stopping = true;
      processes.stop();
    }
    if (stopping && processes.running().empty()) break;
    std::string running;
    for (const auto id : processes.running()) {
      running += (running.empty() ? "" : " | ") + variants[tasks[id].variant].label;
    }
    progress.show(running);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  progress.finish();
  return !stopping;
}

/// What a run said last, or how it ended.
std::string reason_of(const Task& task) {
  std::string words;
  try {
    words = read_file(task.words);
  } catch (const MachineError&) {
    words.clear();
  }
  while (!words.empty() && words.back() == '\n') words.pop_back();
  const auto line = words.rfind('\n');
  if (line != std::string::npos) words = words.substr(line + 1);
  return words.empty() ? status_word(task.status) : words;
}

bool same_answer(const RunSummary& a, const RunSummary& b) {
  if (a.steps != b.steps || a.measures.size() != b.measures.size()) return false;
  for (std::size_t m = 0; m < a.measures.size(); ++m) {
    const Real one = a.measures[m].value, other = b.measures[m].value;
    if (one != other && !(std::isnan(one) && std::isnan(other))) return false;
  }
  return true;
}

VariantRuns collect_runs(const std::vector<Task>& tasks, std::size_t variant) {
  VariantRuns runs;
  std::vector<Real> processor, memory, partial;
  for (const Task& task : tasks) {
    if (task.variant != variant) continue;
    if (task.status != kDone) {
      if (task.round == 0) runs.problem = reason_of(task);
      continue;
    }
    const RunSummary summary = read_summary(task.folder);
    if (task.round == 0) runs.done = true, runs.summary = summary;
    runs.same = runs.same && runs.done && same_answer(runs.summary, summary);
    memory.push_back(summary.peak_memory);
    if (summary.first_step == 0) {
      processor.push_back(summary.cpu_seconds);
    } else if (summary.steps > summary.first_step) {
      const auto ran = static_cast<Real>(summary.steps - summary.first_step);
      partial.push_back(summary.cpu_seconds * static_cast<Real>(summary.steps) / ran);
    }
  }
  runs.whole_cost = !processor.empty();
  if (processor.empty()) processor = partial;
  if (processor.empty()) processor.push_back(std::numeric_limits<Real>::quiet_NaN());
  runs.processor = repeated(processor);
  if (!memory.empty()) runs.memory = repeated(memory);
  return runs;
}
}  // namespace

StudyResult run_study(const std::vector<Variant>& variants, const StudyOptions& options) {
  auto tasks = tasks_of(variants, options);
  create_folder(options.words.empty() ? options.out : options.words);
  StudyResult result;
  result.stopped = !run_tasks(tasks, variants, options);
  for (std::size_t v = 0; v < variants.size(); ++v) {
    result.runs.push_back(collect_runs(tasks, v));
  }
  return result;
}

}  // namespace brunt
// Tested by tests/cli/trade.sh.
