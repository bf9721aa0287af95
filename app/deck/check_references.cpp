#include <algorithm>
#include <set>
#include <stdexcept>

#include "app/deck/checks.hpp"
#include "io/deck/expression.hpp"
#include "io/deck/suggest.hpp"

namespace brunt::deck {

namespace {

using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

template <class T>
Names names_of(const std::vector<Named<T>>& entries) {
  Names names;
  for (const auto& entry : entries) names.push_back(entry.name);
  return names;
}

/// A name that could not be read is empty, and told already.
void check_name(const std::string& path, const char* kind, const std::string& name,
                const Names& known, Findings& findings) {
  if (name.empty() || contains(known, name)) return;
  findings.wrong(path, std::string("there is no ") + kind + " '" + name + "'" +
                           (known.empty() ? "" : suggestion(name, known)));
}

void check_materials_of_bodies(const Deck& deck, Findings& findings) {
  const Names materials = names_of(deck.materials);
  for (const auto& [name, body] : deck.bodies) {
    const std::string path = "bodies." + name;
    if (name == "any") findings.wrong(path, "'any' means all bodies; give it another name");
    // One that could not be read is there, and told at its own place.
    if (findings.sound("materials." + body.material)) {
      check_name(path + ".material", "material", body.material, materials, findings);
    }
  }
  for (const auto& material : deck.materials) {
    const auto uses = [&](const auto& body) { return body.value.material == material.name; };
    if (std::none_of(deck.bodies.begin(), deck.bodies.end(), uses)) {
      findings.warn("materials." + material.name, "no body is made of it");
    }
  }
}

/// True for a rigid body that nothing moves but what it is told.
bool is_told(const Deck& deck, const std::string& name) {
  return std::any_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
    return body.name == name && body.value.rigid && !follows_forces(body.value);
  });
}

void check_pairs(const Deck& deck, Findings& findings) {
  Names known = names_of(deck.bodies);
  known.emplace_back("any");
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& [name, pair] : deck.contact.pairs) {
    const std::string path = "contact.pairs." + name + ".between";
    if (pair.between.size() != 2) continue;
    const std::string &first = pair.between[0], &second = pair.between[1];
    check_name(path, "body", first, known, findings);
    if (second != first) check_name(path, "body", second, known, findings);
    const auto [low, high] = std::minmax(first, second);
    if (!seen.emplace(low, high).second) {
      findings.wrong(path, "another pair names the same bodies; keep one of them");
    } else if (first == "any") {
      findings.wrong(path, second == "any"
                               ? "[any, any] are all pairs: write contact.default instead"
                               : "the named body comes first: [" + second + ", any]");
    } else if (is_told(deck, first) && is_told(deck, second)) {
      findings.warn(
          path, "rigid bodies that follow no forces do not push each other: the pair does nothing");
    }
  }
}

/// True where some body of that name, or of any, is of a material that yields.
bool yields(const Deck& deck, const std::string& name) {
  return std::any_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
    if (body.value.rigid || (name != "any" && body.name != name)) return false;
    return std::any_of(deck.materials.begin(), deck.materials.end(), [&](const auto& material) {
      return material.name == body.value.material &&
             !std::holds_alternative<NoStrength>(material.value.strength);
    });
  });
}

/// Friction that asks for the flow stress of bodies that have none.
void check_flow_stress(const Deck& deck, const std::string& path, const PairOptions& pair,
                       const Names& bodies, Findings& findings) {
  const auto yielding = [&](const std::string& name) { return yields(deck, name); };
  if (!findings.sound("materials") || std::any_of(bodies.begin(), bodies.end(), yielding)) return;
  const std::string who = bodies.size() == 1 ? "no body" : "neither body";
  const bool asks =
      pair.friction && pair.friction->over == Varying::Over::sliding && pair.friction->depends[1];
  if (asks && findings.stands(path + ".friction")) {
    findings.warn(path + ".friction", "`yield` is infinite: " + who + " has a `strength`");
  }
  if (pair.shear_limit && findings.stands(path + ".shear_limit")) {
    findings.warn(path + ".shear_limit", "limits nothing: " + who + " has a `strength`");
  }
}

void check_friction(const Deck& deck, Findings& findings) {
  check_flow_stress(deck, "contact.default", deck.contact.fallback, {"any"}, findings);
  for (const auto& [name, pair] : deck.contact.pairs) {
    if (pair.between.size() != 2) continue;
    check_flow_stress(deck, "contact.pairs." + name, pair.options, pair.between, findings);
  }
}

void check_names_of_bodies(const Deck& deck, Findings& findings) {
  const Names bodies = names_of(deck.bodies);
  for (const auto& [name, boundary] : deck.boundaries) {
    check_name("boundaries." + name + ".body", "body", boundary.body, bodies, findings);
  }
  for (const auto& [name, measure] : deck.measures) {
    const std::string path = "measures." + name;
    std::visit(
        [&](const auto& kind) {
          if constexpr (requires { kind.body; }) {
            check_name(path + "." + std::remove_cvref_t<decltype(kind)>::deck_name + ".body",
                       "body", kind.body, bodies, findings);
          }
        },
        measure.kind);
  }
  for (const auto& [name, probe] : deck.probes) {
    check_name("probes." + name + ".body", "body", probe.body, bodies, findings);
  }
  for (const auto& [name, section] : deck.sections) {
    check_name("sections." + name + ".body", "body", section.body, bodies, findings);
  }
  if (deck.stop.at_rest) {
    check_name("stop.at_rest.body", "body", deck.stop.at_rest->body, bodies, findings);
  }
  if (deck.stop.beyond) {
    check_name("stop.beyond.body", "body", deck.stop.beyond->body, bodies, findings);
  }
  for (const std::string& name : deck.output.bodies) {
    check_name("output.bodies", "body", name, bodies, findings);
  }
}

/// An expression knows the measures above it.
void check_expressions(const Deck& deck, Findings& findings) {
  Names above;
  for (const auto& [name, measure] : deck.measures) {
    const std::string path = "measures." + name + ".expression";
    const auto* expression = std::get_if<ExpressionMeasure>(&measure.kind);
    if (expression && findings.sound(path)) {
      bool known = true;
      for (const std::string& used : names_in(expression->formula)) {
        if (contains(above, used)) continue;
        known = false;
        findings.wrong(path, "there is no measure '" + used + "' above it" +
                                 (above.empty() ? "" : suggestion(used, above)));
      }
      try {
        // Only the form is looked at: values are known at the end of a run.
        if (known) evaluate_formula(expression->formula, [](const std::string&) { return 1.0; });
      } catch (const std::invalid_argument& error) {
        findings.wrong(path, "'" + expression->formula + "': " + error.what());
      }
    }
    above.push_back(name);
  }
}

}  // namespace

void check_references(const Deck& deck, Findings& findings) {
  check_materials_of_bodies(deck, findings);
  check_pairs(deck, findings);
  check_friction(deck, findings);
  check_names_of_bodies(deck, findings);
  check_expressions(deck, findings);
}

void check_deck(const Deck& deck, Findings& findings) {
  check_references(deck, findings);
  check_materials(deck, findings);
  check_bodies(deck, findings);
  check_times(deck, findings);
}

}  // namespace brunt::deck
