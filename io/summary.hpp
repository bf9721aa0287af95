#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/search/pair_count.hpp"
#include "core/types.hpp"

namespace brunt {

/// Exit statuses of the program (docs/guide/running.md).
enum ExitStatus : int {
  kDone = 0,
  kDeckWrong = 2,
  kPhysicsBroke = 3,
  kMachineFailed = 4,
  kStopped = 5,
};

/// A number that the deck asked for.
struct MeasureResult {
  std::string name;
  Real value = 0;                 ///< SI
  std::string unit;               ///< its SI unit, "" for a pure number
  std::optional<Real> reference;  ///< the deck's, SI
  std::optional<Real> error;      ///< (value - reference) / |reference|
  std::optional<Real> exact{};    ///< the deck's closed form, SI
  std::optional<Real> time{};     ///< [s] when it was taken
  std::optional<Real> bound{};    ///< of `run --refine`: what size does to the value, SI
  std::optional<Real> order{};    ///< observed of convergence, where there is one
  std::string convergence{};      ///< "order 1.9", or why there is none; "": not refined
};

/// A warning of the run; the id is stable over versions.
struct RunWarning {
  std::string id;
  std::string text;
};

/// Where energy went that is neither physics nor dissipation, each over the largest energy.
struct EnergyShares {
  Real largest = 0;  ///< [J]
  Real created = 0;  ///< that nobody put in: the largest share at any look
  std::vector<std::pair<std::string, Real>> sources;    ///< "BODY.COLUMN" or "COLUMN": at the end
  std::vector<std::pair<std::string, Real>> taken;      ///< by columns that may give it back
  std::vector<std::pair<std::string, Real>> hourglass;  ///< over the work of a body's stresses
};

/// Kinetic energy over the work of stresses of a body, of a process that is stepped faster.
struct InertiaShare {
  std::string body;
  Real end = 0, mean = 0;  ///< [1] at the end, and of the integrals over time
};

/// What summary.json holds of one run: what a sweep reads. A number that is not known is NaN.
struct RunSummary {
  std::string version;
  std::string deck_hash;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name, text as in the deck
  std::vector<std::string> overrides;                           ///< "KEY=VALUE" of each --set
  int status = 0;      ///< exit status: 0 done, 2 deck, 3 physics, 4 machine, 5 stopped
  std::string reason;  ///< why it ended
  std::int64_t steps = 0;
  std::int64_t planned_steps = 0;  ///< if all were as long as the first that a material bounds
  /// Parts of the steps, by what bounded them: "element of bar", the largest first.
  std::vector<std::pair<std::string, Real>> step_bounds;
  Real planned_memory = 0;      ///< [byte] as `brunt plan` estimates it; 0: several ranks
  std::int64_t first_step = 0;  ///< the step from which this process went on; 0: from the start
  Real wall_seconds = 0;        ///< [s]
  Real start_seconds = 0;       ///< [s] of it to the first step, the first row and frame included
  Real cpu_seconds = 0;         ///< [s] processor time of all threads and ranks of this process
  std::int64_t points = 0;
  std::int64_t elements = 0;
  std::int64_t particles = 0;
  std::vector<std::pair<std::string, Real>> phases;  ///< name, wall time [s]
  Real loop_seconds = 0;                             ///< [s] of all steps, the start aside
  /// [ns] an element and step, a particle and step, of all that the steps took: together with the
  /// counts they make up loop_seconds.
  Real ns_element_step = 0, ns_particle_step = 0;
  PairCount pairs;         ///< of particles at the end, all ranks together
  Real peak_memory = 0;    ///< [byte]
  Real drift = 0;          ///< energy.drift at the end
  std::string state_hash;  ///< of the end; "": the run broke
  EnergyShares energy;
  /// Smallest stable step over the step limit, by body, where the deck asks for it.
  std::vector<std::pair<std::string, Real>> step_margins;
  /// Elements that have eroded, by body, of those that may.
  std::vector<std::pair<std::string, Real>> eroded;
  Real process_speed = 1;  ///< of the deck
  std::string distorts;    ///< what that distorts; "": 1
  std::vector<InertiaShare> inertia;
  std::vector<MeasureResult> measures;
  std::vector<RunWarning> warnings;
  /// How often lists of contacts were made on this rank, since the start or the last repartition.
  std::int64_t contact_lists = 0;
  int ranks = 1;
  int threads = 1;
  std::string instruction_set;
  Real messages_step = 0;    ///< sent from rank to rank in a step, by all ranks together
  Real bytes_step = 0;       ///< [byte] in them
  Real reductions_step = 0;  ///< in which all ranks take part
  Real balance = 1;          ///< largest over mean work of the ranks at the last look
  int repartitions = 0;      ///< how often points were repartitioned
};

/// A word for an exit status: "done", "deck error", "physics error", "machine error", "stopped".
std::string status_word(int status);

/// summary.json as text; maps keep their order, a number that is not finite is null.
std::string to_json(const RunSummary& summary);

/// Reads what to_json wrote; fields that are missing keep their defaults, so that summaries of
/// other versions can be read. Throws MachineError naming `name` where the text is no summary.
RunSummary parse_summary(const std::string& text, const std::string& name);

/// Writes folder/summary.json atomically. Throws MachineError.
void write_summary(const std::filesystem::path& folder, const RunSummary& summary);

/// Reads folder/summary.json. Throws MachineError where it is missing or broken.
RunSummary read_summary(const std::filesystem::path& folder);

}  // namespace brunt
