/// What a monitor carries over a restart: the history so far, measures, drift and stops. Which rows
/// and frames are due next follows from the time, so that the deck may ask for others.
#include <stdexcept>

#include "app/watch/monitor.hpp"

namespace brunt {

namespace {
constexpr const char* kWarnings = "warnings";
constexpr const char* kArtificial = "artificial_stress";
constexpr const char* kThin = "thin_bodies";
constexpr const char* kFrames = "frames";
constexpr const char* kFrameTimes = "frame_times";
constexpr const char* kStepMargins = "step_margins";
constexpr const char* kMeasureTimes = "measure_times";

GlobalId number(std::size_t k) { return k; }

/// One value of a list in a table.
struct Measured {
  std::uint64_t measure = 0;  // index in the deck
  Real value = 0;
};
template <class Row, class AnyMeasured>
void visit_measured(Row& row, AnyMeasured& measured) {
  row(measured.measure), row(measured.value);
}

std::string text_of(const std::map<std::string, std::string>& texts, const char* name) {
  const auto found = texts.find(name);
  if (found == texts.end()) throw StateError("the text '" + std::string(name) + "' is missing");
  return found->second;
}

/// Texts of which each ends with a zero.
std::vector<std::string> split(std::string rest) {
  std::vector<std::string> texts;
  for (auto end = rest.find('\0'); end != std::string::npos; end = rest.find('\0')) {
    texts.push_back(rest.substr(0, end));
    rest.erase(0, end + 1);
  }
  return texts;
}

/// A text and its key, one after another.
std::string joined(const std::map<std::string, std::string>& texts) {
  std::string all;
  for (const auto& [key, text] : texts) {
    all.append(key).push_back('\0');
    all.append(text).push_back('\0');
  }
  return all;
}
std::map<std::string, std::string> pairs_of(const std::string& all) {
  const auto parts = split(all);
  std::map<std::string, std::string> texts;
  for (std::size_t k = 0; k + 1 < parts.size(); k += 2) texts[parts[k]] = parts[k + 1];
  return texts;
}
}  // namespace

template <int Dim>
template <class Row, class AnyMonitor>
void Monitor<Dim>::visit(Row& row, AnyMonitor& monitor) {
  RowTimes::visit(row, monitor.row_times_), row(monitor.last_frame_);
  row(monitor.drift_), row(monitor.worst_drift_);
  StopConditions<Dim>::visit(row, monitor.stops_);
}

template <int Dim>
void Monitor<Dim>::save_state(std::vector<StateTable>& tables,
                              std::map<std::string, std::string>& texts) const {
  save_row(
      "monitor", [&](auto& row) { visit(row, *this); }, tables);
  save_row(
      kFrameTimes, [&](auto& row) { FrameTimes::visit(row, frame_times_); }, tables);
  collector_->save_state(tables);
  watch_.save_state(tables, texts);
  if (deck_.time.process_speed != 1) inertia_.save_state(tables);
  save_rows(
      "history", rows_.size(), number,
      [&](auto& row, std::size_t r) {
        for (const Real& value : rows_[r]) row(value);
        row(hashes_[r]);
      },
      tables);
  std::vector<Measured> measured;
  for (const auto& measure : measures_) {
    std::uint64_t index = 0;
    while (deck_.measures[index].name != measure.name) ++index;
    measured.push_back({index, measure.value});
  }
  save_rows(
      "measures", measured.size(), number,
      [&](auto& row, std::size_t k) { visit_measured(row, measured[k]); }, tables);
  save_rows(
      kMeasureTimes, measures_.size(), number,
      [&](auto& row, std::size_t k) { row(measures_[k].time); }, tables);
  save_rows(
      "measured", measured_.size(), number,
      [&](auto& row, std::size_t k) { row(std::uint64_t{measured_[k]}); }, tables);
  auto& warnings = texts[kWarnings];
  for (const auto& warning : warnings_) warnings.append(warning).push_back('\0');
  texts[kArtificial] = joined(artificial_tension_.all());
  texts[kThin] = joined(thin_.all());
  if (deck_.time.check_step > 0) texts[kStepMargins] = step_check_.saved();
  if (frames_) texts[kFrames] = frames_->index();
}

template <int Dim>
void Monitor<Dim>::load_state(const StateTables& tables,
                              const std::map<std::string, std::string>& texts, const Clock& clock,
                              const std::filesystem::path& frames) {
  const std::string frame_index = frames_ ? text_of(texts, kFrames) : "";
  load_row(
      "monitor", [&](auto& row) { visit(row, *this); }, tables);
  collector_->load_state(tables);
  watch_.load_state(tables, texts);
  if (deck_.time.process_speed != 1) inertia_.load_state(tables);
  // A row has a value a column and its hash, 0 where none was asked for.
  rows_.assign(tables.rows("history").size(), std::vector<Real>(columns_.size() - 1));
  hashes_.assign(rows_.size(), 0);
  load_rows(
      "history", rows_.size(), number,
      [&](auto& row, std::size_t r) {
        for (Real& value : rows_[r]) row(value);
        row(hashes_[r]);
      },
      tables);
  std::vector<Measured> measured(tables.has("measures") ? tables.rows("measures").size() : 0);
  load_rows(
      "measures", measured.size(), number,
      [&](auto& row, std::size_t k) { visit_measured(row, measured[k]); }, tables);
  measures_.clear();
  for (const auto& [index, value] : measured) {
    if (index >= deck_.measures.size()) throw StateError("the state 'measures' has one too many");
    const auto& [name, measure] = deck_.measures[index];
    measures_.push_back(
        {name, value, deck::shown_unit_of(measure), measure.reference, measure.exact});
  }
  if (tables.has(kMeasureTimes)) {  // states of older programs have none
    load_rows(
        kMeasureTimes, measures_.size(), number,
        [&](auto& row, std::size_t k) { row(measures_[k].time); }, tables);
  }
  std::vector<std::uint64_t> taken(measured_.size());
  load_rows(
      "measured", taken.size(), number, [&](auto& row, std::size_t k) { row(taken[k]); }, tables);
  for (std::size_t k = 0; k < taken.size(); ++k) measured_[k] = taken[k] != 0;
  warnings_ = split(text_of(texts, kWarnings));
  if (const auto found = texts.find(kStepMargins); found != texts.end()) {
    step_check_.restore(found->second);
  }
  artificial_tension_.restore(pairs_of(text_of(texts, kArtificial)));
  thin_.restore(pairs_of(text_of(texts, kThin)));
  // A row that waits for its step is due yet; the step is in the second column.
  const auto step_of_row = rows_.empty() ? 0 : static_cast<std::int64_t>(rows_.back()[1]);
  row_times_.go_on(clock.time(), step_of_row);
  std::optional<FrameTimes> frames_before;
  if (tables.has(kFrameTimes)) {  // states of older programs have none
    auto& saved = frames_before.emplace(frame_times_);
    load_row(
        kFrameTimes, [&](auto& row) { FrameTimes::visit(row, saved); }, tables);
  }
  frame_times_.go_on(frames_before, clock.time(), clock.step());
  for (std::size_t r = 0; history_ && r < rows_.size(); ++r) {
    history_->write_row(history_values(rows_[r], hashes_[r], collector_->whole()));
  }
  if (frames_) frames_->resume(frame_index, frames);
}

template void Monitor<2>::save_state(std::vector<StateTable>&,
                                     std::map<std::string, std::string>&) const;
template void Monitor<3>::save_state(std::vector<StateTable>&,
                                     std::map<std::string, std::string>&) const;
template void Monitor<2>::load_state(const StateTables&, const std::map<std::string, std::string>&,
                                     const Clock&, const std::filesystem::path&);
template void Monitor<3>::load_state(const StateTables&, const std::map<std::string, std::string>&,
                                     const Clock&, const std::filesystem::path&);

}  // namespace brunt
