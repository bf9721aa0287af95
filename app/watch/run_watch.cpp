#include "app/watch/run_watch.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app/deck/findings.hpp"
#include "core/errors.hpp"

namespace brunt {

namespace {
constexpr const char* kTold = "watch";

std::string percent(Real share) {
  std::ostringstream out;
  out.precision(3);
  out << 100 * share << " %";
  return out.str();
}

std::string at_time(const Clock& clock) {
  return "at t = " + deck::time_text(clock.real_time()) + ", step " + std::to_string(clock.step());
}

/// What lets fewer hourglass modes grow than the body's elements do now.
std::string hourglass_remedy(const deck::Body& body) {
  if (body.method == deck::Method::sph) {
    return "a smaller `size` or `smoothing`, or, for what flows, `formulation: updated`";
  }
  const bool stiff = std::holds_alternative<StiffnessHourglass>(body.element.hourglass);
  std::string text = "finer elements, or `element: {integration: q1p0}`, which has no such modes";
  if (stiff) text += ", or, where the material yields, `hourglass: {viscous: 0.1}`";
  return text;
}
}  // namespace

std::string RunWatch::remedy(const CreatedEnergy& worst, const std::string& pair) const {
  const deck::Body* body = worst.body ? &deck_.bodies[*worst.body].value : nullptr;
  switch (worst.source) {
    case EnergySource::artificial_stress:
      return "set `artificial_stress: 0` there";
    case EnergySource::hourglass:
      return body ? hourglass_remedy(*body) : "";
    case EnergySource::integration:
      return "steps change too much from one to the next: try a `time.max_step` that keeps them "
             "even, or a smaller `time.safety`";
    case EnergySource::contact_pairs:
      return (pair.empty() ? "" : "deepest now is " + pair + "; ") +
             std::string(
                 "try finer elements, a smaller `time.safety` or a higher contact "
                 "`stiffness`");
    case EnergySource::stress_work:
      return body && body->method == deck::Method::sph
                 ? "try a smaller `time.safety`, `viscosity: {alpha: 1, beta: 2}`, or a wider "
                   "`smoothing`"
                 : "try a smaller `time.safety` or finer elements";
    default:
      return "try a smaller `time.safety`";
  }
}

/// What bounds the step: "tube, element 12".
std::string RunWatch::whose_text(const Clock& clock) const {
  const auto& whose = clock.whose();
  const std::string body =
      whose.body < deck_.bodies.size() ? deck_.bodies[whose.body].name + ", " : "";
  return body + whose.reason + " " + std::to_string(whose.entity);
}

std::string RunWatch::created_text(const RunLook& now, const CreatedShare& worst) const {
  const auto found =
      std::find_if(now.created.begin(), now.created.end(),
                   [&](const CreatedEnergy& one) { return !worst.body || one.body == worst.body; });
  std::ostringstream out;
  out.precision(3);
  out << source_name(found->source) << " gave " << found->energy << " J";
  if (found->body) out << " to " << deck_.bodies[*found->body].name;
  return out.str() + "; " + remedy(*found, now.deepest_pair);
}

void RunWatch::look_at_created(const RunLook& now, const Clock& clock,
                               std::vector<RunWarning>& warnings) {
  const CreatedShare worst = now.watch.share(now.energies, now.created);
  worst_created_ = std::max(worst_created_, worst.share);
  const std::string body = worst.body ? deck_.bodies[*worst.body].name : "";
  if (worst.share > deck_.time.max_created) {
    throw PhysicsError(
        {clock.time(), body,
         "step " + std::to_string(clock.step()) + " (bounded by " + whose_text(clock) + ")",
         "energy that nobody put in, over the largest", worst.share,
         created_text(now, worst) + " (time.max_created)"});
  }
  if (created_warned_ != 0 || worst.share <= kCreatedWarning) return;
  created_warned_ = 1;
  warnings.push_back({"energy", "energy that nobody put in is " + percent(worst.share) +
                                    " of the largest" + (body.empty() ? "" : " of " + body) + " " +
                                    at_time(clock) + ": " + created_text(now, worst)});
}

void RunWatch::look_at_hourglass(const RunLook& now, const Clock& clock,
                                 std::vector<RunWarning>& warnings) {
  for (std::size_t b = 0; b < hourglass_warned_.size(); ++b) {
    if (hourglass_warned_[b] != 0) continue;
    const Real share = now.watch.hourglass_share(now.energies, static_cast<Label>(b));
    if (share <= kHourglassWarning) continue;
    hourglass_warned_[b] = 1;
    warnings.push_back({"hourglass", deck_.bodies[b].name + ": hourglass energy is " +
                                         percent(share) + " of the work of its stresses " +
                                         at_time(clock) + "; try " +
                                         hourglass_remedy(deck_.bodies[b].value)});
  }
}

/// The mean of the steps since the last look, so that one short step is not taken for all.
void RunWatch::look_at_steps(const Clock& clock, std::vector<RunWarning>& warnings) {
  const Real passed = clock.time() - last_time_;
  const auto steps = static_cast<Real>(clock.step() - last_step_);
  last_time_ = clock.time(), last_step_ = clock.step();
  if (steps_warned_ != 0 || !(clock.planned_step() > 0) || steps <= 0) return;
  const Real plan = clock.end() / clock.planned_step();
  const Real left = (clock.end() - clock.time()) * steps / passed;
  if (left <= kStepsWarning * plan) return;
  steps_warned_ = 1;
  std::ostringstream out;
  out.precision(3);
  out << "the step has shrunk to " << clock.real(passed / steps) << " s " << at_time(clock)
      << ", by " << whose_text(clock) << ": " << left
      << " steps are left where the first step made it " << plan << " in all; below "
      << clock.real(clock.least_step()) << " s the run stops (time.min_step)";
  warnings.push_back({"step", out.str()});
}

std::vector<RunWarning> RunWatch::look(const RunLook& now, const Clock& clock) {
  std::vector<RunWarning> warnings;
  look_at_hourglass(now, clock, warnings);
  look_at_steps(clock, warnings);
  look_at_created(now, clock, warnings);
  warned_.insert(warned_.end(), warnings.begin(), warnings.end());
  return warnings;
}

/// Boundaries act as it is at the ends of steps, forces not at time 0.
std::vector<RunWarning> RunWatch::missed(const Clock& clock) {
  const Real now = clock.time(), before = now - clock.dt();
  std::vector<RunWarning> warnings;
  for (const auto& [name, boundary] : deck_.boundaries) {
    if (boundary.to >= now || boundary.to <= before) continue;
    bool pushes = false;
    deck::visit_given(boundary, [&]<class Kind>(const Kind&) { pushes |= is_force<Kind>(); });
    if (boundary.from <= before && !(pushes && clock.step() == 1)) continue;
    warnings.push_back(
        {"boundaries." + name,
         "never acts: all of its time, from " + deck::time_text(clock.real(boundary.from)) +
             " to " + deck::time_text(clock.real(boundary.to)) +
             ", lies between the ends of two steps, " + deck::time_text(clock.real(clock.dt())) +
             " apart; try a `time.max_step` far below it"});
  }
  warned_.insert(warned_.end(), warnings.begin(), warnings.end());
  return warnings;
}

void RunWatch::save_state(std::vector<StateTable>& tables,
                          std::map<std::string, std::string>& texts) const {
  save_row(
      "watch", [&](auto& row) { visit(row, *this); }, tables);
  auto& text = texts[kTold];
  for (const auto& [id, said] : warned_) {
    text.append(id).push_back('\0');
    text.append(said).push_back('\0');
  }
}

void RunWatch::load_state(const StateTables& tables,
                          const std::map<std::string, std::string>& texts) {
  load_row(
      "watch", [&](auto& row) { visit(row, *this); }, tables);
  warned_.clear();
  const auto found = texts.find(kTold);
  if (found == texts.end()) throw StateError("the text 'watch' is missing");
  std::istringstream text(found->second);
  for (RunWarning one; std::getline(text, one.id, '\0') && std::getline(text, one.text, '\0');) {
    warned_.push_back(one);
  }
}

std::vector<std::string> energy_lines(const EnergyShares& energy) {
  static constexpr std::size_t kNamed = 3;
  const auto listed = [](const auto& shares) {
    std::string text;
    for (std::size_t k = 0; k < std::min(kNamed, shares.size()); ++k) {
      text += (k == 0 ? "" : ", ") + shares[k].first + " " + percent(shares[k].second);
    }
    return text;
  };
  std::vector<std::string> lines;
  std::string first =
      "energy that nobody put in: at most " + percent(energy.created) + " of the largest";
  if (!energy.sources.empty()) first += "; at the end " + listed(energy.sources);
  lines.push_back(first);
  if (!energy.taken.empty()) lines.push_back("energy held or lost there: " + listed(energy.taken));
  if (!energy.hourglass.empty()) {
    lines.push_back("hourglass energy over the work of stresses: " + listed(energy.hourglass));
  }
  return lines;
}

}  // namespace brunt
