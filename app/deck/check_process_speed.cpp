#include <algorithm>

#include "app/deck/checks.hpp"

namespace brunt::deck {

void check_process_speed(const Deck& deck, Findings& findings) {
  const Real speed = deck.time.process_speed;
  if (!findings.sound("time") || speed == 1) return;
  const std::string square = short_text(speed * speed), factor = short_text(speed);
  for (const auto& [name, material] : deck.materials) {
    if (!std::holds_alternative<Jwl>(material.eos)) continue;
    findings.wrong("materials." + name + ".eos",
                   "an explosive drives itself against inertia, and time.process_speed changes "
                   "inertia alone: take process_speed out");
  }
  for (const auto& [name, measure] : deck.measures) {
    if (!std::holds_alternative<RestitutionMeasure>(measure.kind)) continue;
    findings.wrong("measures." + name + ".restitution",
                   "a rebound is a matter of inertia, of which there is " + square +
                       " times too much (time.process_speed): take one of the two out");
  }
  if (std::any_of(deck.gravity.begin(), deck.gravity.end(), [](Real g) { return g != 0; })) {
    findings.warn(
        "gravity",
        "acts with its own force, so that weights are right; what falls or swings takes " + factor +
            " times as long (time.process_speed)");
  }
  for (const auto& [name, boundary] : deck.boundaries) {
    if (!boundary.of<Nonreflecting>().given()) continue;
    findings.warn("boundaries." + name + ".nonreflecting",
                  "resists motion by its speed, " + factor +
                      " times as much as in the process (time.process_speed)");
  }
}

}  // namespace brunt::deck
// Tested by tests/unit/app/process_speed_test.cpp.
