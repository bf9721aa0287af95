#include "app/watch/monitor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "app/watch/frame_check.hpp"
#include "app/watch/frame_piece.hpp"
#include "app/watch/output_steps.hpp"
#include "core/fields.hpp"

namespace brunt {

namespace {
constexpr std::int64_t kCheckEvery = 100;  // steps; a check of every value costs 2 ns each
constexpr std::int64_t kFirstEvery = 10;   // steps, among the first kCheckEvery: a run may be short

/// The steps at which values and energies are looked at, whatever is written.
bool is_looked_at(std::int64_t step) {
  return step % kCheckEvery == 0 || (step < kCheckEvery && step % kFirstEvery == 0);
}

}  // namespace

std::vector<HistoryValue> history_values(const std::vector<Real>& row, std::uint64_t hash,
                                         const std::vector<std::size_t>& whole) {
  std::vector<HistoryValue> values(row.begin(), row.end());
  for (const std::size_t i : whole) values[i] = static_cast<std::int64_t>(row[i]);
  values.emplace_back(hash);
  return values;
}

template <int Dim>
Monitor<Dim>::Monitor(const Deck& deck, HistoryWriter* history, FrameSink* frames, bool quiet,
                      Warn warn)
    : deck_(deck),
      history_(history),
      frames_(frames),
      progress_(quiet),
      measured_(deck.measures.size(), false),
      lost_contacts_(Dim),
      watch_(deck),
      stops_(deck),
      inertia_(deck.bodies.size()),
      real_(deck.time.process_speed),
      warn_(std::move(warn)),
      row_times_(deck.output.history, deck.time.end),
      frame_times_(deck.output.every, deck.time.end) {
  for (const auto& body : deck.bodies) body_names_.push_back(body.name);
}

template <int Dim>
void Monitor<Dim>::prepare(Scene<Dim>& scene) {
  collector_ = std::make_unique<HistoryColumns<Dim>>(scene);
  columns_ = collector_->names();
  real_.set_columns(columns_);
  const OutputWork work = output_work(scene, columns_.size());
  row_times_.keep_apart(steps_between_rows(work), sure_rows(work));
  frame_times_.keep_apart(steps_between_frames(work));
  keep_start(scene);
  stops_.begin(scene, columns_);
}

template <int Dim>
void Monitor<Dim>::begin(Scene<Dim>& scene, Clock& clock) {
  prepare(scene);
  write_row(scene, clock);
  write_frame(scene, clock.time());
  take_measures(scene, clock, false);
  check_step(scene, clock);
  begun_ = std::chrono::steady_clock::now();
}

template <int Dim>
void Monitor<Dim>::stop(Clock& clock, std::string reason) {
  reason_ = std::move(reason);
  clock.stop();
}

template <int Dim>
std::vector<RunWarning> Monitor<Dim>::body_warnings() const {
  std::vector<RunWarning> warnings = shear_bands_;
  for (const auto& [body, text] : artificial_tension_.all()) {
    warnings.push_back({artificial_stress_path(body), text});
  }
  for (const auto& [body, text] : thin_.all()) {
    if (!text.empty()) warnings.push_back({thin_body_path(body), text});
  }
  return warnings;
}

template <int Dim>
void Monitor<Dim>::warn(const RunWarning& warning) {
  progress_.finish();
  if (warn_) warn_(warning);
}

/// A row, and its warnings.
template <int Dim>
typename Monitor<Dim>::HistoryRow Monitor<Dim>::collect(Scene<Dim>& scene, const Clock& clock,
                                                        bool hashes) {
  auto row = collector_->collect(scene, clock, is_looked_at(clock.step()), hashes);
  refuse_row(scene, row, clock);
  real_.make_real(row.values);
  for (auto& pair : row.lost) pair.lost.time = clock.real(pair.lost.time);
  for (const auto& text : lost_contacts_.take(row.lost)) warn({"contact", text});
  energies_ = row.energies, created_ = row.created;
  // Half of a step less is left in the kinetic energy where `end` shortens it: that is no error.
  if (clock.shortened()) {
    std::erase_if(created_,
                  [](const auto& one) { return one.source == EnergySource::integration; });
  }
  for (const auto& body :
       artificial_tension_.take(clock.real_time(), row.artificial_share, body_names_)) {
    warn({artificial_stress_path(body), artificial_tension_.all().at(body)});
  }
  for (const auto& body : thin_.take(clock.real_time(), row.thin_share, body_names_)) {
    warn({thin_body_path(body), thin_.all().at(body)});
  }
  return row;
}

/// No row with a value that is no finite number is written: the run ends there, and says what broke
/// where elements or particles know, else which column. A probe in what has gone has none.
template <int Dim>
void Monitor<Dim>::refuse_row(Scene<Dim>& scene, const HistoryRow& row, const Clock& clock) const {
  const bool erodes =
      std::any_of(scene.erodes.begin(), scene.erodes.end(), [](char one) { return one != 0; });
  std::size_t k = 0;
  while (k < row.values.size() &&
         (std::isfinite(row.values[k]) || (erodes && columns_[k].starts_with("probe.")))) {
    ++k;
  }
  if (k == row.values.size()) return;
  scene.check(clock.time());
  const std::string& column = columns_[k];
  throw PhysicsError({clock.time(), "", "step " + std::to_string(clock.step()),
                      "step [s] in which column '" + column + "' is no finite number",
                      clock.real(clock.dt()),
                      "this row is not written; try a smaller time.safety, and look at the last "
                      "rows for what grows"});
}

/// Looks at what goes wrong slowly. At fixed steps, whatever is written.
template <int Dim>
void Monitor<Dim>::watch(const HistoryRow& row, const Clock& clock) {
  const RunLook look{row.energies, created_, collector_->energies(), row.deepest_pair};
  for (const auto& warning : watch_.look(look, clock)) warn(warning);
  if (deck_.time.process_speed != 1 && is_looked_at(clock.step())) {
    inertia_.look(row.energies, clock.time());
  }
}

template <int Dim>
std::vector<InertiaShare> Monitor<Dim>::inertia() const {
  if (deck_.time.process_speed == 1) return {};
  return inertia_.shares(body_names_, energies_);
}

template <int Dim>
EnergyShares Monitor<Dim>::energy_shares() const {
  EnergyShares shares;
  if (!collector_ || energies_.bodies.empty()) return shares;  // it ended before its first row
  const auto& watch = collector_->energies();
  shares.largest = watch.largest(energies_);
  shares.created = std::max(watch_.worst_created(), watch.share(energies_, created_).share);
  const auto share = [&](Real energy) { return shares.largest > 0 ? energy / shares.largest : 0; };
  for (const auto& one : created_) {
    const std::string body = one.body ? body_names_[*one.body] + "." : "";
    shares.sources.emplace_back(body + std::string(source_name(one.source)), share(one.energy));
  }
  for (std::size_t b = 0; b < energies_.bodies.size(); ++b) {
    const Real part = watch.hourglass_share(energies_, static_cast<Label>(b));
    if (part > 0) shares.hourglass.emplace_back(body_names_[b], part);
  }
  for (const Column column : {Column::artificial_stress, Column::contact_pairs}) {
    const Real taken = share(energies_.column(column));
    if (taken > 0) shares.taken.emplace_back(column_name(column), taken);
  }
  return shares;
}

template <int Dim>
void Monitor<Dim>::write_row(Scene<Dim>& scene, const Clock& clock) {
  const PhaseTimer timer(scene.phases, Phase::ledger);
  const HistoryRow row = collect(scene, clock, wants_hash(clock));
  rows_.push_back(row.values);
  hashes_.push_back(row.state_hash);
  if (history_) history_->write_row(history_values(row.values, row.state_hash, row.whole));
  row_times_.written(clock.time(), clock.step());
  drift_ = row.drift;
  worst_drift_ = std::max(worst_drift_, std::fabs(drift_));
  if (!(std::fabs(drift_) <= deck_.time.max_drift)) {
    throw PhysicsError({clock.time(), "", "step " + std::to_string(clock.step()), "energy drift",
                        drift_,
                        "the energy balance no longer closes (time.max_drift): an instability; try "
                        "a smaller time.safety or a lower contact stiffness"});
  }
  if (is_looked_at(clock.step()) || clock.finished()) watch(row, clock);
}

/// True for rows with a hash of the state: the first, those of frames, that of the end, or all.
template <int Dim>
bool Monitor<Dim>::wants_hash(const Clock& clock) const {
  return deck_.output.state_hash || rows_.empty() || clock.time() >= deck_.time.end ||
         frame_times_.due(clock.time(), clock.step());
}

/// What this rank writes of a view.
template <int Dim>
BodyView Monitor<Dim>::frame_part(const Scene<Dim>& scene, BodyView view, Real time) const {
  view.time = time;
  const auto& asked = deck_.output.fields;
  if (std::find(asked.begin(), asked.end(), kOwnerField.name) != asked.end()) {
    add_owner(view, scene.ranks->rank());
  }
  real_.make_real(view);
  if (scene.ranks->alone()) return view;
  return frame_piece(std::move(view), *scene.partition, *scene.ranks);
}

template <int Dim>
void Monitor<Dim>::write_frame(Scene<Dim>& scene, Real time) {
  last_frame_ = time;
  if (!frames_) return;
  const PhaseTimer timer(scene.phases, Phase::output);
  std::vector<BodyView> views;
  const auto& wanted = deck_.output.bodies;
  WantedFields fields;
  if (!deck_.output.fields.empty()) fields.names = deck_.output.fields;
  fields.may_wait = scene.ranks->alone();
  for (std::size_t b = 0; b < body_names_.size(); ++b) {
    const bool left_out =
        !wanted.empty() && std::find(wanted.begin(), wanted.end(), body_names_[b]) == wanted.end();
    if (left_out) continue;
    const auto body = static_cast<Label>(b);
    views.push_back(frame_part(scene, scene.own_view(body, fields), time));
    if (scene.converts[b] != 0) {
      views.push_back(frame_part(scene, scene.own_converted(body, fields), time));
    }
  }
  ContactView contact;
  if (scene.contact) contact = scene.own_contacts();
  refuse_no_numbers(views, contact, *scene.ranks);
  frames_->write(deck_.time.real(time), views, scene.contact ? &contact : nullptr);
}

template <int Dim>
void Monitor<Dim>::step_done(Scene<Dim>& scene, Clock& clock) {
  if (is_looked_at(clock.step())) scene.check(clock.time());
  for (const auto& warning : watch_.missed(clock)) warn(warning);
  if (row_times_.due(clock.time(), clock.step())) {
    write_row(scene, clock);
  } else if (is_looked_at(clock.step())) {
    const HistoryRow row = collect(scene, clock, false);
    drift_ = row.drift;
    if (!(std::fabs(drift_) <= deck_.time.max_drift)) write_row(scene, clock);
    watch(row, clock);
  }
  if (frame_times_.pass(clock.time(), clock.step())) {
    const bool wanted = clock.time() >= deck_.output.from.value_or(0) &&
                        clock.time() <= deck_.output.to.value_or(kInfinity);
    if (wanted) {
      scene.check(clock.time());
      write_frame(scene, clock.time());
    }
  }
  take_measures(scene, clock, false);
  check_step(scene, clock);
  const bool has_row = row_times_.last_step() == clock.step();
  const std::string why = stops_.look(
      scene, clock, has_row ? std::span<const Real>(rows_.back()) : std::span<const Real>{});
  if (!why.empty()) stop(clock, why);
  const auto& whose = clock.whose();
  progress_.show(clock, body_names_.empty() ? "" : body_names_[whose.body] + ": " + whose.reason,
                 drift_);
}

/// Warns where a group has a step limit at which it is unstable.
template <int Dim>
void Monitor<Dim>::check_step(Scene<Dim>& scene, const Clock& clock) {
  const int every = deck_.time.check_step;
  if (every == 0 || clock.step() % every != 0) return;
  for (const auto& warning : step_check_.take(find_step_margins(scene))) warn(warning);
}

template <int Dim>
std::vector<std::pair<std::string, Real>> Monitor<Dim>::eroded() const {
  std::vector<std::pair<std::string, Real>> eroded;
  for (std::size_t c = 0; c < columns_.size() && !rows_.empty(); ++c) {
    for (const auto& body : body_names_) {
      if (columns_[c] == "body." + body + ".eroded") eroded.emplace_back(body, rows_.back()[c]);
    }
  }
  return eroded;
}

template <int Dim>
void Monitor<Dim>::end(Scene<Dim>& scene, const Clock& clock) {
  progress_.finish();
  scene.check(clock.time());
  if (row_times_.last() != clock.time()) write_row(scene, clock);
  if (last_frame_ != clock.time()) write_frame(scene, clock.time());
  take_measures(scene, clock, true);
  shear_bands_ = find_shear_bands(scene, deck_);
  for (const auto& warning : shear_bands_) warn(warning);
  end_hash_ = scene.totals(clock.dt(), true).state_hash;
  if (history_) history_->flush();
}

template <int Dim>
void Monitor<Dim>::write_last_frame(Scene<Dim>& scene, const Clock& clock) {
  progress_.finish();
  try {
    if (collector_ && last_frame_ != clock.time()) write_frame(scene, clock.time());
  } catch (const PhysicsError&) {  // reported already, of what the frame would show
  }
  if (history_) history_->flush();
}

template class Monitor<2>;
template class Monitor<3>;

}  // namespace brunt
