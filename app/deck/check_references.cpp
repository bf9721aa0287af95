#include <algorithm>
#include <map>
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

/// The names in a section, bodies or materials. One that is not there may be missed in many places
/// and is reported once.
class KnownNames {
 public:
  KnownNames(const char* section, const char* kind, Names known, Findings& findings)
      : section_(section), kind_(kind), known_(std::move(known)), findings_(findings) {}

  /// Looks a name up that stands at `path`; "" could not be read, and is reported already.
  /// also  a word that may stand instead
  void look_up(const std::string& path, const std::string& name, const char* also = "") {
    if (name.empty() || name == also || contains(known_, name)) return;
    // What could not be read is there, and reported at its own place; so may be its whole section.
    if (!findings_.sound(section_ + "." + name)) return;
    missed_[name].push_back(path);
  }
  bool missed_any() const { return !missed_.empty(); }

  void report() const {
    for (const auto& [name, paths] : missed_) {
      std::string message = std::string("there is no ") + kind_ + " '" + name + "'" +
                            (is_piece(name)   ? "; pieces stand for bodies in measures and probes"
                             : known_.empty() ? ""
                                              : suggestion(name, known_));
      std::set<int> lines;
      for (const auto& path : paths) {
        if (path != paths.front()) findings_.also_wrong(path);
        lines.insert(findings_.line(path));
      }
      lines.erase(findings_.line(paths.front()));
      std::string list;
      for (const int line : lines) list += (list.empty() ? "" : ", ") + std::to_string(line);
      if (!list.empty()) message += "; it is named in line " + list + " too";
      findings_.wrong(paths.front(), message);
    }
  }

 private:
  /// wall.1.0, of a body
  bool is_piece(const std::string& name) const {
    return section_ == "bodies" && name.find('.') != std::string::npos &&
           contains(known_, name.substr(0, name.find('.')));
  }

  std::string section_;
  const char* kind_;
  Names known_;
  Findings& findings_;
  std::map<std::string, std::vector<std::string>> missed_;  ///< paths, by name
};

void check_materials_of_bodies(const Deck& deck, Findings& findings) {
  KnownNames materials("materials", "material", names_of(deck.materials), findings);
  for (const auto& [name, body] : deck.bodies) {
    const std::string path = "bodies." + name;
    if (name == "any") findings.wrong(path, "'any' means all bodies; give it another name");
    materials.look_up(path + ".material", body.material);
  }
  materials.report();
  // A material that no body is made of may be the one that a body misses.
  if (materials.missed_any() || !findings.sound("bodies")) return;
  for (const auto& material : deck.materials) {
    const auto uses = [&](const auto& body) { return body.value.material == material.name; };
    if (std::none_of(deck.bodies.begin(), deck.bodies.end(), uses)) {
      findings.warn("materials." + material.name, "no body is made of it");
    }
  }
}

/// True for a rigid body whose motion is prescribed whole.
bool has_prescribed_motion(const Deck& deck, const std::string& name) {
  return std::any_of(deck.bodies.begin(), deck.bodies.end(), [&](const auto& body) {
    return body.name == name && body.value.rigid && !follows_forces(body.value);
  });
}

void check_pairs(const Deck& deck, KnownNames& bodies, Findings& findings) {
  std::set<std::pair<std::string, std::string>> seen;
  for (const auto& [name, pair] : deck.contact.pairs) {
    const std::string path = "contact.pairs." + name + ".between";
    if (pair.between.size() != 2) continue;
    const std::string &first = pair.between[0], &second = pair.between[1];
    bodies.look_up(path, first, "any");
    if (second != first) bodies.look_up(path, second, "any");
    const auto [low, high] = std::minmax(first, second);
    if (!seen.emplace(low, high).second) {
      findings.wrong(path, "another pair names the same bodies; keep one of them");
    } else if (first == "any") {
      findings.wrong(path, second == "any"
                               ? "[any, any] are all pairs: write contact.default instead"
                               : "the named body comes first: [" + second + ", any]");
    } else if (has_prescribed_motion(deck, first) && has_prescribed_motion(deck, second)) {
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

/// Friction that needs the flow stress of bodies that have none.
void check_flow_stress(const Deck& deck, const std::string& path, const PairOptions& pair,
                       const Names& bodies, Findings& findings) {
  const auto yielding = [&](const std::string& name) { return yields(deck, name); };
  if (!findings.sound("materials") || std::any_of(bodies.begin(), bodies.end(), yielding)) return;
  const std::string who = bodies.size() == 1 ? "no body" : "neither body";
  const bool needs = pair.coulomb.friction &&
                     pair.coulomb.friction->over == Varying::Over::sliding &&
                     pair.coulomb.friction->depends[1];
  if (needs && findings.stands(path + ".friction")) {
    findings.warn(path + ".friction", "`yield` is infinite: " + who + " has a `strength`");
  }
  if (pair.coulomb.shear_limit && findings.stands(path + ".shear_limit")) {
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

/// Particles that a pair names, which no face's bond or joint holds.
void check_holding(const Deck& deck, Findings& findings) {
  for (const auto& [name, pair] : deck.contact.pairs) {
    const auto particles =
        std::find_if(deck.bodies.begin(), deck.bodies.end(), [&, &pair = pair](const auto& body) {
          return body.value.method == deck::Method::sph && !body.value.rigid &&
                 contains(pair.between, body.name);
        });
    if (particles == deck.bodies.end()) continue;
    const std::string path = "contact.pairs." + name, who = "'" + particles->name + "'";
    if (!pair.options.tied && findings.stands(path + ".joint")) {
      findings.warn(path + ".joint", "faces of elements close as a joint: the particles of " + who +
                                         " touch as without it");
    }
    for (const char* key : {".cohesion", ".tension"}) {
      if (pair.options.holds() || !findings.stands(path + key)) continue;
      findings.warn(path + key, "holds faces of elements: the particles of " + who +
                                    " are not held (tied holds them on faces, up to this)");
    }
  }
}

/// The bodies in the name of a column: body.NAME.x, contact.NAME-NAME.x where no pair has the name.
Names bodies_in(const std::string& column, const Deck& deck) {
  const auto dot = column.find('.');
  const std::string head = column.substr(0, dot);
  if (dot == std::string::npos || (head != "body" && head != "contact")) return {};
  const std::string name = column.substr(dot + 1, column.find('.', dot + 1) - dot - 1);
  if (head == "body") return {name};
  const auto dash = name.find('-');
  // With more dashes than one, where a name ends is not known.
  if (contains(names_of(deck.contact.pairs), name) || dash == std::string::npos ||
      name.find('-', dash + 1) != std::string::npos) {
    return {};
  }
  return {name.substr(0, dash), name.substr(dash + 1)};
}

/// Which pieces a body has is known once it is built.
void check_names_of_bodies(const Deck& deck, KnownNames& bodies) {
  for (const auto& [name, boundary] : deck.boundaries) {
    bodies.look_up("boundaries." + name + ".body", boundary.body);
  }
  for (const auto& [name, measure] : deck.measures) {
    const std::string path = "measures." + name;
    std::visit(
        [&](const auto& kind) {
          if constexpr (requires { kind.body; }) {
            bodies.look_up(path + "." + std::remove_cvref_t<decltype(kind)>::deck_name + ".body",
                           body_of_part(kind.body));
          }
          if constexpr (requires { kind.column; }) {
            for (const auto& body : bodies_in(kind.column, deck)) {
              bodies.look_up(path + ".history.column", body);
            }
          }
        },
        measure.kind);
  }
  for (const auto& [name, probe] : deck.probes) {
    bodies.look_up("probes." + name + ".body", body_of_part(probe.body));
  }
  for (const auto& [name, section] : deck.sections) {
    bodies.look_up("sections." + name + ".body", section.body);
  }
  if (deck.stop.at_rest) {
    bodies.look_up("stop.at_rest.body", deck.stop.at_rest->body);
  }
  if (deck.stop.beyond) {
    bodies.look_up("stop.beyond.body", deck.stop.beyond->body);
  }
  for (const std::string& name : deck.output.bodies) {
    bodies.look_up("output.bodies", name);
  }
}

/// An expression reads values that are there: it cannot be taken before a measure that it uses.
void check_time_of_expression(const Deck& deck, const Named<Measure>& entry,
                              const std::string& used, Findings& findings) {
  const std::string path = "measures." + entry.name;
  const auto measure = std::find_if(deck.measures.begin(), deck.measures.end(),
                                    [&](const auto& one) { return one.name == used; });
  if (!entry.value.at || !findings.sound(path) || measure == deck.measures.end()) return;
  const auto& at = measure->value.at;
  if (at && *at <= *entry.value.at) return;
  findings.wrong(path + ".at", "it uses '" + used + "', which is taken " +
                                   (at ? "later: write at: " + time_text(*at) + " or later"
                                       : std::string("at the end: take `at` out")));
}

/// An expression knows the measures above it.
void check_expressions(const Deck& deck, Findings& findings) {
  Names above;
  for (const auto& entry : deck.measures) {
    const auto& name = entry.name;
    const std::string path = "measures." + name + ".expression";
    const auto* expression = std::get_if<ExpressionMeasure>(&entry.value.kind);
    if (expression && findings.sound(path)) {
      bool known = true;
      for (const std::string& used : names_in(expression->formula)) {
        if (!findings.sound("measures." + used)) continue;
        if (contains(above, used)) {
          check_time_of_expression(deck, entry, used, findings);
          continue;
        }
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
  KnownNames bodies("bodies", "body", names_of(deck.bodies), findings);
  check_pairs(deck, bodies, findings);
  check_names_of_bodies(deck, bodies);
  bodies.report();
  check_friction(deck, findings);
  check_holding(deck, findings);
  check_expressions(deck, findings);
}

void check_deck(const Deck& deck, Findings& findings) {
  check_references(deck, findings);
  check_materials(deck, findings);
  check_bodies(deck, findings);
  check_times(deck, findings);
  check_process_speed(deck, findings);
}

}  // namespace brunt::deck
