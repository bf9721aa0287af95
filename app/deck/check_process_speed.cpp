#include <algorithm>
#include <cmath>

#include "app/deck/checks.hpp"
#include "app/deck/flow_stress.hpp"

namespace brunt::deck {

namespace {
/// Speed [m/s] that a boundary gives at time 0 to a body beyond its own, at the origin where it is
/// of place.
Real sudden_speed(const std::vector<std::optional<Varying>>& prescribed, const Body& body) {
  const auto own = first_velocity(body);
  Real squared = 0;
  for (std::size_t c = 0; c < std::min(prescribed.size(), own.size()); ++c) {
    const auto& given = prescribed[c];
    if (!given) continue;
    const Real v = given->is_expression() ? given->evaluate({0, 0, 0, 0}) : given->at(0);
    squared += (v - own[c]) * (v - own[c]);
  }
  return std::sqrt(squared);
}

Real relative_speed(const Body& a, const Body& b) {
  const auto v = first_velocity(a), w = first_velocity(b);
  return std::hypot(v[0] - w[0], v[1] - w[1], v[2] - w[2]);
}

/// What a sudden speed [m/s] does to a body at first: a wave of stress sqrt(E rho) v.
/// path, advice: of what is sudden, and what else than a lower process_speed there is
void warn_of_jump(const Deck& deck, const Named<Body>& body, const std::string& path,
                  const std::string& advice, Real speed, Findings& findings) {
  const auto* material = deck.material_named(body.value.material);
  if (material == nullptr || !findings.sound("materials")) return;
  const Real stepped = deck.time.process_speed * speed;
  const Real bulk = material->bulk_modulus(), shear = material->shear_modulus();
  const Real young = 9 * bulk * shear / (3 * bulk + shear);
  const Real stress = std::sqrt(young * material->density) * stepped;
  const Real flow = slow_flow_stress(material->strength, 0);
  constexpr Real kMuch = 0.2;
  if (!(stress > kMuch * flow)) return;
  findings.warn(path, "begins at once with " + short_text(stepped) +
                          " m/s as it is stepped (time.process_speed): the wave that it sends "
                          "through " +
                          body.name + " has " + short_text(1e-6 * stress) +
                          " MPa, where it yields at " + short_text(1e-6 * flow) + " MPa; " +
                          advice + ", or lower process_speed");
}

/// Velocities that begin with a jump, each against what it acts on: of rigid tools on any body.
void warn_of_jumps(const Deck& deck, Findings& findings) {
  for (const auto& body : deck.bodies) {
    if (body.value.rigid || has_velocity_field(body.value)) continue;
    for (const auto& [name, tool] : deck.bodies) {
      if (!tool.rigid || !tool.motion || tool.motion->velocity.empty()) continue;
      warn_of_jump(deck, body, "bodies." + name + ".motion.velocity",
                   "let the velocity grow from 0, give " + body.name +
                       " the `velocity` of its flow at time 0",
                   relative_speed(tool, body.value), findings);
    }
    for (const auto& [name, boundary] : deck.boundaries) {
      const auto& motion = boundary.of<PrescribedMotion>();
      if (boundary.body != body.name || !motion.velocity) continue;
      warn_of_jump(deck, body, "boundaries." + name + ".velocity", "let the velocity grow from 0",
                   sudden_speed(*motion.velocity, body.value), findings);
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
