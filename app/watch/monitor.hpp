#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/loop/step_check.hpp"
#include "app/loop/time_loop.hpp"
#include "app/watch/artificial_tension.hpp"
#include "app/watch/frame_times.hpp"
#include "app/watch/history_columns.hpp"
#include "app/watch/inertia_watch.hpp"
#include "app/watch/lost_contacts.hpp"
#include "app/watch/measures.hpp"
#include "app/watch/progress.hpp"
#include "app/watch/real_values.hpp"
#include "app/watch/row_times.hpp"
#include "app/watch/run_watch.hpp"
#include "app/watch/shear_bands.hpp"
#include "app/watch/stops.hpp"
#include "app/watch/thin_bodies.hpp"
#include "io/history.hpp"

namespace brunt {

/// Where frames go: VTK files, or nowhere.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// bodies, contact: what this rank has of them. Collective; all ranks throw what one throws.
  /// Throws PhysicsError where a field that waits has a value that no file can hold.
  virtual void write(Real time, const std::vector<BodyView>& bodies,
                     const ContactView* contact) = 0;
  /// Which frames there are, for a checkpoint.
  virtual std::string index() const = 0;
  /// Goes on after the frames of an index, which lie in the folder `from`; later ones go away.
  virtual void resume(const std::string& index, const std::filesystem::path& from) = 0;
};

/// A row as history.csv has it: the values at the indices `whole` stay whole, the hash comes last.
std::vector<HistoryValue> history_values(const std::vector<Real>& row, std::uint64_t hash,
                                         const std::vector<std::size_t>& whole);

/// The id of warnings of measures that have no value.
inline constexpr const char* kMeasureWarning = "measure";

/// Watches a run: history rows, frames, checks of the state and of the ledger, measures, stop
/// conditions, progress. Reads the scene and changes nothing.
template <int Dim>
class Monitor final : public Observer<Dim> {
 public:
  using Warn = std::function<void(const RunWarning& warning)>;
  /// history may be null, frames may be null. warn  what is to be reported while the run goes on
  Monitor(const Deck& deck, HistoryWriter* history, FrameSink* frames, bool quiet, Warn warn = {});

  void begin(Scene<Dim>& scene, Clock& clock) override;
  /// When what stands before the first step was done; none: it was not.
  std::optional<std::chrono::steady_clock::time_point> begun() const { return begun_; }
  /// What begin does before it writes: all that measures and stops remember of the scene at time 0.
  void prepare(Scene<Dim>& scene);
  void step_done(Scene<Dim>& scene, Clock& clock) override;
  /// The last row and frame where they are not written yet, and the measures of the end.
  void end(Scene<Dim>& scene, const Clock& clock);
  /// A last frame after a failure; what does not work any more is left out.
  void write_last_frame(Scene<Dim>& scene, const Clock& clock);
  /// Ends the run after this step.
  void stop(Clock& clock, std::string reason);

  /// History, measures and what stops wait for; after a whole step.
  void save_state(std::vector<StateTable>& tables, std::map<std::string, std::string>& texts) const;
  /// After prepare: takes them back and writes the history anew. frames: the folder that holds the
  /// frames written so far. Throws StateError; MachineError where history or frames fail.
  void load_state(const StateTables& tables, const std::map<std::string, std::string>& texts,
                  const Clock& clock, const std::filesystem::path& frames);

  const std::vector<MeasureValue>& measures() const { return measures_; }
  /// Of measures that have no value.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// What was lost of contacts as of the last row or check of drift, by pair of bodies.
  std::map<std::string, std::string> lost_contacts() const { return lost_contacts_.all(); }
  /// What was reported of energies and of the step.
  const std::vector<RunWarning>& warned() const { return watch_.warned(); }
  /// Where the energy went that is neither physics nor dissipation, as of the last row.
  EnergyShares energy_shares() const;
  /// Of artificial stress that carries too much, of bodies that became thin, of shear bands.
  std::vector<RunWarning> body_warnings() const;
  const StepCheck& step_check() const { return step_check_; }
  /// How much inertia takes part, as of the last row; none where the process is not made faster.
  std::vector<InertiaShare> inertia() const;
  /// Elements that have eroded as of the last row, by body, of those that may.
  std::vector<std::pair<std::string, Real>> eroded() const;
  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<std::vector<Real>>& rows() const { return rows_; }
  /// Of each row; 0 where none was wanted.
  const std::vector<std::uint64_t>& hashes() const { return hashes_; }
  /// Of the end; none before it.
  std::optional<std::uint64_t> end_hash() const { return end_hash_; }
  Real worst_drift() const { return worst_drift_; }
  const std::string& reason() const { return reason_; }  ///< why it stopped before its end

 private:
  template <class Row, class AnyMonitor>
  static void visit(Row& row, AnyMonitor& monitor);
  using HistoryRow = typename HistoryColumns<Dim>::Row;
  HistoryRow collect(Scene<Dim>& scene, const Clock& clock, bool hashes);
  void warn(const RunWarning& warning);
  void keep_start(Scene<Dim>& scene);
  void watch(const HistoryRow& row, const Clock& clock);
  void refuse_row(Scene<Dim>& scene, const HistoryRow& row, const Clock& clock) const;
  void write_row(Scene<Dim>& scene, const Clock& clock);
  void write_frame(Scene<Dim>& scene, Real time);
  bool wants_hash(const Clock& clock) const;
  BodyView frame_part(const Scene<Dim>& scene, BodyView view, Real time) const;
  void check_step(Scene<Dim>& scene, const Clock& clock);
  void take_measures(Scene<Dim>& scene, const Clock& clock, bool at_end);
  MeasureValue measured(const Named<deck::Measure>& entry, const MeasureSource& source, Real time);

  const Deck& deck_;
  HistoryWriter* history_;
  FrameSink* frames_;
  Progress progress_;
  std::unique_ptr<HistoryColumns<Dim>> collector_;
  std::vector<std::string> body_names_;
  std::vector<std::string> columns_;
  std::vector<std::vector<Real>> rows_;
  std::vector<std::uint64_t> hashes_;
  std::optional<std::uint64_t> end_hash_;
  std::map<std::string, BodyView> start_;
  std::vector<MeasureValue> measures_;
  std::vector<bool> measured_;
  std::vector<std::string> warnings_;
  LostContactWarnings lost_contacts_;
  RunWatch watch_;
  StopConditions<Dim> stops_;
  EnergyLook energies_;  // of the last row
  std::vector<CreatedEnergy> created_;
  ArtificialTensionWarnings artificial_tension_;
  ThinBodyWarnings thin_;
  std::vector<RunWarning> shear_bands_;  // of the end
  InertiaWatch inertia_;
  RealValues real_;
  StepCheck step_check_;
  Warn warn_;
  std::optional<std::chrono::steady_clock::time_point> begun_;
  std::string reason_;
  // Times of the run [s], as it is stepped; rows and frames are in real time.
  RowTimes row_times_;
  FrameTimes frame_times_;
  Real last_frame_ = -1;
  Real drift_ = 0, worst_drift_ = 0;
};

}  // namespace brunt
