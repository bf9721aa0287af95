#include "app/deck/checks.hpp"

#include <algorithm>
#include <set>

#include "io/deck/expression.hpp"
#include "io/deck/suggest.hpp"

namespace brunt::deck {

namespace {

class Checks {
 public:
  Checks(const Deck& deck, const DeckPlaces& places, std::vector<DeckProblem>& problems,
         std::vector<DeckProblem>& warnings)
      : deck_(deck), places_(places), problems_(problems), warnings_(warnings) {
    for (const auto& body : deck.bodies) bodies_.push_back(body.name);
    for (const auto& material : deck.materials) materials_.push_back(material.name);
  }

  void bodies() {
    for (const auto& [name, body] : deck_.bodies) {
      const std::string path = "bodies." + name;
      if (name == "any") add(path, "'any' means all bodies; give it another name");
      if (!body.material.empty() && !contains(materials_, body.material)) {
        add(path + ".material",
            "there is no material '" + body.material + "'" + suggestion(body.material, materials_));
      }
    }
    for (const auto& material : deck_.materials) {
      const auto uses = [&](const auto& body) { return body.value.material == material.name; };
      if (std::none_of(deck_.bodies.begin(), deck_.bodies.end(), uses)) {
        warnings_.push_back(places_.problem("materials." + material.name, "no body is made of it"));
      }
    }
  }

  void contact() {
    std::vector<std::string> known = bodies_;
    known.emplace_back("any");
    std::set<std::pair<std::string, std::string>> seen;
    for (const auto& [name, pair] : deck_.contact.pairs) {
      const std::string path = "contact.pairs." + name + ".between";
      if (pair.between.size() != 2) continue;
      for (const auto& body : pair.between) {
        if (!contains(known, body)) {
          add(path, "there is no body '" + body + "'" + suggestion(body, known));
        }
      }
      const auto [low, high] = std::minmax(pair.between[0], pair.between[1]);
      if (!seen.emplace(low, high).second) add(path, "another pair names the same bodies");
    }
  }

  void names_of_bodies() {
    for (const auto& [name, boundary] : deck_.boundaries) {
      body("boundaries." + name + ".body", boundary.body);
    }
    for (const auto& [name, measure] : deck_.measures) {
      const std::string path = "measures." + name;
      std::visit(
          [&](const auto& kind) {
            if constexpr (requires { kind.body; }) {
              body(path + "." + std::remove_cvref_t<decltype(kind)>::deck_name + ".body",
                   kind.body);
            }
          },
          measure.kind);
    }
    if (deck_.stop.at_rest) body("stop.at_rest.body", deck_.stop.at_rest->body);
    if (deck_.stop.beyond) body("stop.beyond.body", deck_.stop.beyond->body);
    for (const std::string& name : deck_.output.bodies) body("output.bodies", name);
  }

  /// An expression knows the measures above it.
  void expressions() {
    std::vector<std::string> above;
    for (const auto& [name, measure] : deck_.measures) {
      if (const auto* expression = std::get_if<ExpressionMeasure>(&measure.kind)) {
        const std::string path = "measures." + name + ".expression";
        for (const std::string& used : names_in(expression->formula)) {
          if (!contains(above, used)) {
            add(path, "there is no measure '" + used + "' above" + suggestion(used, above));
          }
        }
      }
      above.push_back(name);
    }
  }

  void times() {
    for (const auto& [name, measure] : deck_.measures) {
      if (measure.at && *measure.at > deck_.time.end) {
        add("measures." + name + ".at", "is after time.end");
      }
    }
  }

 private:
  static bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  void add(const std::string& path, const std::string& message) {
    problems_.push_back(places_.problem(path, message));
  }
  void body(const std::string& path, const std::string& name) {
    if (!contains(bodies_, name)) {
      add(path, "there is no body '" + name + "'" + suggestion(name, bodies_));
    }
  }

  const Deck& deck_;
  const DeckPlaces& places_;
  std::vector<DeckProblem>& problems_;
  std::vector<DeckProblem>& warnings_;
  std::vector<std::string> bodies_, materials_;
};

}  // namespace

void check_references(const Deck& deck, const DeckPlaces& places,
                      std::vector<DeckProblem>& problems, std::vector<DeckProblem>& warnings) {
  Checks checks(deck, places, problems, warnings);
  checks.bodies();
  checks.contact();
  checks.names_of_bodies();
  checks.expressions();
  checks.times();
}

}  // namespace brunt::deck
