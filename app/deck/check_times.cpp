#include <algorithm>

#include "app/deck/checks.hpp"

namespace brunt::deck {

namespace {

std::string end_text(const Deck& deck) {
  return "the run ends at " + time_text(deck.time.end) + " (time.end)";
}

void check_output(const Deck& deck, Findings& findings) {
  const Output& output = deck.output;
  if (!findings.sound("output")) return;
  const auto longer = [&](const std::optional<Real>& interval) {
    return interval && *interval > deck.time.end;
  };
  if (longer(output.every)) {
    findings.warn("output.every", "only the first and the last frame: " + end_text(deck));
  }
  if (longer(output.history)) {
    findings.warn("output.history", "only the first and the last row: " + end_text(deck));
  }
  if (output.from && output.to && *output.from > *output.to) {
    findings.wrong("output.to", "is before output.from: " + time_text(*output.to) + " and " +
                                    time_text(*output.from));
  } else if (output.from && *output.from > deck.time.end) {
    findings.warn("output.from", "only the first and the last frame: " + end_text(deck));
  }
}

/// A component cannot be held and moved, and something must be prescribed before the end.
void check_boundary(const Deck& deck, const Named<Boundary>& entry, Findings& findings) {
  const std::string path = "boundaries." + entry.name;
  const Boundary& boundary = entry.value;
  if (!findings.sound(path)) return;
  const auto& [fix, velocity] = boundary.of<PrescribedMotion>();
  bool moves = false;
  for (std::size_t c = 0; velocity && c < velocity->size(); ++c) {
    if (!(*velocity)[c]) continue;
    moves = true;
    const std::string axis(1, static_cast<char>('x' + c));
    if (std::find(fix.begin(), fix.end(), axis) != fix.end()) {
      findings.wrong(path + ".velocity", "moves " + axis + ", and `fix` holds it: take " + axis +
                                             " out of fix, or write free for it");
    }
  }
  int given = 0;
  visit_given(boundary, [&](const auto&) { ++given; });
  if (velocity && !moves && fix.empty() && given == 1) {
    findings.wrong(path + ".velocity",
                   "all components are free: give one a speed, or take the boundary out");
  }
  // A run that is ended early, with --until, is no wrong deck.
  if (findings.sound("time") && boundary.from >= deck.time.end) {
    findings.warn(path + ".from",
                  "acts from " + time_text(boundary.from) + " only, and " + end_text(deck));
  }
}

void check_measure(const Deck& deck, const Named<Measure>& entry, Findings& findings) {
  const std::string path = "measures." + entry.name;
  if (!findings.sound(path)) return;
  if (entry.value.at && *entry.value.at > deck.time.end) {
    findings.wrong(path + ".at", "is after time.end: it would never be taken; " + end_text(deck));
  }
  const auto* history = std::get_if<HistoryMeasure>(&entry.value.kind);
  if (history && history->from && *history->from > deck.time.end) {
    findings.warn(path + ".history.from", "no row is that late: " + end_text(deck));
  }
}

}  // namespace

void check_times(const Deck& deck, Findings& findings) {
  for (const auto& boundary : deck.boundaries) check_boundary(deck, boundary, findings);
  if (!findings.sound("time")) return;
  const Time& time = deck.time;
  if (time.min_step && time.max_step && *time.min_step > *time.max_step) {
    findings.wrong("time.min_step", "is longer than time.max_step = " + time_text(*time.max_step) +
                                        ": no step would do");
  }
  check_output(deck, findings);
  for (const auto& measure : deck.measures) check_measure(deck, measure, findings);
  const auto& rest = deck.stop.at_rest;
  if (rest && findings.sound("stop") && rest->duration > time.end) {
    findings.warn("stop.at_rest.for",
                  "is longer than the run, which it never ends; " + end_text(deck));
  }
}

}  // namespace brunt::deck
