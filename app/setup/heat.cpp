#include "app/setup/heat.hpp"

#include <algorithm>

#include "app/setup/bonds.hpp"

namespace brunt {

bool acts_on_heat(const deck::Boundary& boundary) {
  bool heats = false;
  visit_given(boundary, [&](const auto& kind) {
    heats = heats || brunt::heats<std::remove_cvref_t<decltype(kind)>>();
  });
  return heats;
}

namespace {
/// Names of the bodies of one sum with this one, itself among them.
std::vector<std::string> names_of_sum(const Deck& deck, const std::string& name) {
  std::vector<std::string> names;
  for (const Label b : bonded_with(deck, *label_of(deck, name))) {
    names.push_back(deck.bodies[b].name);
  }
  return names;
}

/// True where a body that never moves has stresses all the same: those of time 0, or of what heat
/// makes it press on what holds it.
bool has_stress_at_rest(const Deck& deck, const std::string& name) {
  const auto& body = deck.bodies[*label_of(deck, name)].value;
  const auto* material = deck.material_named(body.material);
  const bool expands =
      material != nullptr && material->thermal && material->thermal->expansion != 0;
  return body.stress.has_value() || expands;
}

/// True where all bodies of its sum never move, and have no mechanics for that.
bool is_held_with_its_sum(const Deck& deck, const std::string& name) {
  const auto names = names_of_sum(deck, name);
  return std::all_of(names.begin(), names.end(), [&](const std::string& one) {
    return is_held(deck, one) && !has_stress_at_rest(deck, one);
  });
}

/// A rigid body whose motion says its temperature.
bool has_held_temperature(const deck::Body& body) {
  return body.rigid && body.motion && body.motion->temperature;
}
}  // namespace

HeatMode heat_mode(const Deck& deck, const deck::Body& body, const std::string& name) {
  const auto* material = deck.material_named(body.material);
  if (deck.heat == deck::Heat::off || material == nullptr) return HeatMode::none;
  // What is held at a temperature as a whole has nothing to conduct: its surface is enough.
  if (has_held_temperature(body)) return HeatMode::none;
  const auto& thermal = material->thermal;
  if (!thermal) return HeatMode::none;
  const auto names = names_of_sum(deck, name);
  const auto in_sum = [&](const std::string& other) {
    return std::find(names.begin(), names.end(), other) != names.end();
  };
  const auto heats = [&](const auto& boundary) {
    return in_sum(boundary.value.body) && acts_on_heat(boundary.value);
  };
  const auto& contact = deck.contact;
  const auto touches = [&](const auto& pair) {
    const auto& between = pair.value.between;
    return pair.value.options.passes_heat() && std::any_of(between.begin(), between.end(), in_sum);
  };
  const bool passes_heat = contact.fallback.passes_heat() ||
                           std::any_of(contact.pairs.begin(), contact.pairs.end(), touches);
  const bool uneven = std::any_of(names.begin(), names.end(), [&](const std::string& one) {
    return deck::has_temperature_field(deck.bodies[*label_of(deck, one)].value);
  });
  const bool driven = deck.heat == deck::Heat::conduct ||
                      (deck.heat == deck::Heat::automatic && (passes_heat || uneven)) ||
                      (deck.heat == deck::Heat::automatic &&
                       std::any_of(deck.boundaries.begin(), deck.boundaries.end(), heats));
  if (thermal->k && driven) return HeatMode::conducts;
  if (body.rigid) return HeatMode::none;
  // What neither yields nor has an energy in its pressure is never heated: it keeps no temperature.
  return material->heats_itself() ? HeatMode::adiabatic : HeatMode::none;
}

bool is_held(const Deck& deck, const std::string& name) {
  const std::size_t axes = deck.geometry == Geometry::three_d ? 3 : 2;
  bool held = false;
  for (const auto& [unused, boundary] : deck.boundaries) {
    if (boundary.body != name) continue;
    const auto& motion = boundary.of<PrescribedMotion>();
    if (motion.velocity) return false;  // it may take over from what is fixed
    const bool all = std::holds_alternative<deck::WhereAll>(boundary.where) && boundary.from == 0 &&
                     boundary.to == kInfinity && motion.fix.size() == axes;
    held = held || all;
  }
  return held;
}

std::string heat_problem(const deck::Body& body, const std::string& name) {
  if (!deck::follows_forces(body) || !has_held_temperature(body)) return "";
  return "'" + name +
         "' moves freely, and only a body that has a prescribed motion is held at a temperature: "
         "give it "
         "all components of `motion.velocity`, or take `motion.temperature` out";
}

bool is_heated_surface(const Deck& deck, const deck::Body& body) {
  const bool asked = deck.heat == deck::Heat::automatic || deck.heat == deck::Heat::conduct;
  return asked && has_held_temperature(body);
}

GroupKind group_kind(const Deck& deck, const deck::Body& body, const std::string& name) {
  const bool conducts = heat_mode(deck, body, name) == HeatMode::conducts;
  const bool held = conducts && (body.rigid || is_held_with_its_sum(deck, name));
  return {conducts, held, body.rigid, conducts && deck::follows_forces(body)};
}

void check_anything_is_computed(const LoadedDeck& loaded, std::vector<DeckProblem>& problems) {
  const Deck& deck = loaded.deck;
  const bool any = std::any_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& one) {
    const auto& [name, body] = one;
    return !body.rigid || deck::follows_forces(body) || group_kind(deck, body, name).conducts;
  });
  if (any) return;
  problems.push_back(loaded.places.problem(
      "bodies",
      "all bodies are rigid, none is free and none conducts heat, and nothing is left to compute: "
      "one that deforms has `material` and `size`, and no rigid: true; one that is free has a "
      "`material` and no motion"));
}

}  // namespace brunt
