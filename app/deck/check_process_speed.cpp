#include <algorithm>
#include <cmath>

#include "app/deck/checks.hpp"
#include "app/deck/flow_stress.hpp"

namespace brunt::deck {

namespace {
/// Speed [m/s] at time 0 of a prescribed velocity, at the origin where it is of place.
Real first_speed(const std::vector<std::optional<Varying>>& velocity) {
  Real squared = 0;
  for (const auto& component : velocity) {
    if (!component) continue;
    const bool expression = component->is_expression();
    const Real v = expression ? component->evaluate({0, 0, 0, 0}) : component->at(0);
    squared += v * v;
  }
  return std::sqrt(squared);
}

Real speed_of(const std::vector<Real>& velocity) {
  Real squared = 0;
  for (const Real v : velocity) squared += std::isnan(v) ? 0 : v * v;
  return std::sqrt(squared);
}

/// What a sudden speed [m/s] does to a body at first: a wave of stress sqrt(E rho) v.
struct Jump {
  std::string path;
  Real speed = 0;
};

void warn_of_jump(const Deck& deck, const Named<Body>& body, const Jump& jump, Findings& findings) {
  const auto material =
      std::find_if(deck.materials.begin(), deck.materials.end(),
                   [&](const auto& one) { return one.name == body.value.material; });
  if (material == deck.materials.end() || !findings.sound("materials")) return;
  const Real speed = deck.time.process_speed * jump.speed;
  const Real bulk = material->value.bulk_modulus(), shear = material->value.shear_modulus();
  const Real young = 9 * bulk * shear / (3 * bulk + shear);
  const Real stress = std::sqrt(young * material->value.density) * speed;
  const Real flow = slow_flow_stress(material->value.strength, 0);
  constexpr Real kMuch = 0.2;
  if (!(stress > kMuch * flow)) return;
  findings.warn(jump.path, "begins at once with " + short_text(speed) +
                               " m/s as it is stepped (time.process_speed): the wave that it sends "
                               "through " +
                               body.name + " has " + short_text(1e-6 * stress) +
                               " MPa, where it yields at " + short_text(1e-6 * flow) +
                               " MPa; let the velocity grow from 0, or lower process_speed");
}

/// Velocities that begin with a jump, each against what it acts on: of rigid tools on any body.
void warn_of_jumps(const Deck& deck, Findings& findings) {
  std::vector<Jump> tools;
  for (const auto& [name, body] : deck.bodies) {
    if (!body.rigid || !body.motion) continue;
    const auto& motion = *body.motion;
    const Real speed = motion.velocity.empty() ? 0 : speed_of(motion.velocity);
    if (speed > 0) tools.push_back({"bodies." + name + ".motion.velocity", speed});
  }
  for (const auto& body : deck.bodies) {
    if (body.value.rigid) continue;
    for (const auto& tool : tools) warn_of_jump(deck, body, tool, findings);
    for (const auto& [name, boundary] : deck.boundaries) {
      const auto& motion = boundary.of<PrescribedMotion>();
      if (boundary.body != body.name || !motion.velocity) continue;
      const Real speed = first_speed(*motion.velocity);
      if (speed > 0) {
        warn_of_jump(deck, body, {"boundaries." + name + ".velocity", speed}, findings);
      }
    }
  }
}
}  // namespace

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
  if (deck.has_gravity()) {
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
  warn_of_jumps(deck, findings);
}

}  // namespace brunt::deck
// Tested by tests/unit/app/process_speed_test.cpp.
