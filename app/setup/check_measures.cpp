#include <algorithm>
#include <map>
#include <stdexcept>

#include "app/setup/scene_checks.hpp"
#include "app/watch/history_columns.hpp"
#include "app/watch/parts.hpp"
#include "io/deck/column_expression.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {
using Names = std::vector<std::string>;

bool contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The columns that begin like the one that is not there.
std::string columns_like(const std::string& column, const Names& columns) {
  const std::string near = nearest_word(column, columns);
  if (!near.empty()) return "; did you mean '" + near + "'?";
  const auto dot = column.find('.');
  const std::string head = column.substr(0, dot) + ".";
  std::string list;
  for (const auto& name : columns) {
    if (dot == std::string::npos ? name.find('.') == std::string::npos : name.starts_with(head)) {
      list += (list.empty() ? "" : ", ") + name;
    }
  }
  return list.empty() ? "; brunt plan lists the columns" : "; there are " + list;
}

template <int Dim>
bool is_part(const Scene<Dim>& scene, const std::string& name) {
  return part_named(scene.body_names, scene.pieces, name).has_value();
}

/// The fields that a body has: those of one of its elements or particles, for all are of one
/// material.
template <int Dim>
Names fields_of(const Scene<Dim>& scene, const std::string& body) {
  const BodyView view = scene.view(part_named(scene.body_names, scene.pieces, body)->body,
                                   WantedFields{.names = {}, .most = 1});
  Names names;
  for (const auto* fields : {&view.point_fields, &view.cell_fields}) {
    for (const auto& field : *fields) {
      if (!contains(names, field.name)) names.push_back(field.name);
    }
  }
  return names;
}

std::string joined(const Names& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Bodies without mass have no speed of their own, and no means over points, which masses weigh.
template <int Dim>
bool has_mass(const LoadedDeck& loaded, const Scene<Dim>& scene, const std::string& name) {
  const auto& bodies = loaded.deck.bodies;
  const auto body = std::find_if(bodies.begin(), bodies.end(), [&](const auto& named) {
    return named.name == body_of_part(name);
  });
  if (body == bodies.end() || !body->value.rigid || follows_forces(body->value)) return true;
  const auto view = scene.part_view(name, kNoFields);
  return std::any_of(view.point_mass.begin(), view.point_mass.end(),
                     [](Real mass) { return mass > 0; });
}

/// True where a body is at rest at time 0, and no boundary could move it from then on.
template <int Dim>
bool rests_at_start(const LoadedDeck& loaded, const Scene<Dim>& scene, const std::string& name) {
  for (const auto& boundary : loaded.deck.boundaries) {
    if (boundary.value.body == body_of_part(name)) return false;
  }
  const auto view = scene.part_view(name, WantedFields{{{"velocity"}}});
  return deck::SpeedMeasure::speed_of(view) == 0;
}

/// What is wrong with a measure of a body whose masses it weighs by; "": nothing.
template <class Kind, int Dim>
std::string weights_problem(const LoadedDeck& loaded, const Scene<Dim>& scene, const Kind& kind,
                            bool wrong_elsewhere) {
  constexpr bool rebound = std::is_same_v<Kind, deck::RestitutionMeasure>;
  constexpr bool mean = std::is_same_v<Kind, deck::MeanMeasure>;
  constexpr bool speed = std::is_same_v<Kind, deck::SpeedMeasure>;
  if constexpr (rebound || mean || speed) {
    if (!is_part(scene, kind.body)) return "";
    const std::string who = "'" + kind.body + "' ";
    if (!has_mass(loaded, scene, kind.body)) {
      const std::string why = who + "has no mass, for it is rigid and follows no forces; ";
      if (mean) return why + "write min, max or point instead";
      return why + "the velocity of its centre is {history: {column: body." +
             body_of_part(kind.body) + ".velocity.x, reduce: last}}";
    }
    if (rebound && !wrong_elsewhere && rests_at_start(loaded, scene, kind.body)) {
      return who +
             "is at rest at time 0, and this is its speed over that of then; write speed: "
             "{body: " +
             kind.body + "} instead";
    }
  }
  return "";
}

/// True where the rest of a wrong deck, once right, may bring the column: it is of something that
/// stands in the deck, or in a section that could not be read, and was not built.
bool may_come(const std::string& column, const Names& columns, const LoadedDeck& loaded) {
  struct Head {
    const char* name;
    const char* section;
  };
  static constexpr Head kHeads[] = {{"body", "bodies"},
                                    {"contact", "contact.pairs"},
                                    {"boundary", "boundaries"},
                                    {"probe", "probes"},
                                    {"section", "sections"}};
  const auto dot = column.find('.');
  const std::string head = column.substr(0, dot);
  if (head == "heat") return true;  // of a scene that conducts
  const auto* const known = std::find_if(std::begin(kHeads), std::end(kHeads),
                                         [&](const Head& one) { return one.name == head; });
  if (known == std::end(kHeads)) return false;
  const std::string name = column.substr(dot + 1, column.find('.', dot + 1) - dot - 1);
  const std::string start = head + "." + name + ".";
  const bool built = std::any_of(columns.begin(), columns.end(), [&](const std::string& other) {
    return other.starts_with(start);
  });
  if (built) return column.starts_with(start + "temperature.");  // of a scene that conducts
  const std::string section = known->section;
  if (loaded.places.has(section + "." + name)) return true;
  if (head == "contact") {  // "a-b" where the deck names no pair
    for (auto dash = name.find('-'); dash != std::string::npos; dash = name.find('-', dash + 1)) {
      if (loaded.places.has("bodies." + name.substr(0, dash)) &&
          loaded.places.has("bodies." + name.substr(dash + 1))) {
        return true;
      }
    }
  }
  const std::string top = section.substr(0, section.find('.'));
  return std::any_of(loaded.wrong.begin(), loaded.wrong.end(), [&](const std::string& wrong) {
    return wrong == top || (wrong.empty() && !loaded.places.has(top));
  });
}

/// Why a body lacks a field that others have.
std::string reason_for(const std::string& field) {
  if (field == "temperature") return " (it is not heated: see `thermal` and `heat`)";
  if (field == "eps_p" || field == "strain_rate") return " (its material does not yield)";
  if (field == "plastic_volume" || field == "opening") {
    return " (plastic flow of its material keeps the volume)";
  }
  if (field == "damage") return " (its material has no `damage`)";
  if (field == "porosity" || field == "tensile_strength") return " (its material is no concrete)";
  return "";
}

/// What is wrong with a part of a body that nothing of it is in; "": nothing.
template <class Kind, int Dim>
std::string part_problem(const Scene<Dim>& scene, const Kind& kind) {
  if (std::holds_alternative<deck::WhereAll>(kind.where)) return "";
  if (!is_part(scene, kind.body)) return "";
  const std::string name = kind.field.substr(0, kind.field.find('.'));
  const BodyView view = scene.part_view(kind.body, WantedFields{{{name}}});
  const bool cells = field_named(view.point_fields, name) == nullptr && view.n_cells() > 0;
  const auto held = held_at_start(kind.where, view, cells);
  if (std::find(held.begin(), held.end(), 1) != held.end()) return "";
  return std::string("holds no ") + (cells ? "centre of an element" : "point") + " of '" +
         kind.body + "' at time 0";
}

/// Columns that `stop.when` names and history.csv does not have, and its form.
void check_stop(const LoadedDeck& loaded, const Names& columns, bool wrong_elsewhere,
                std::vector<DeckProblem>& problems) {
  const auto& when = loaded.deck.stop.when;
  if (when.empty()) return;
  const auto unknown = unknown_columns_in(when, columns);
  for (const auto& column : unknown) {
    if (wrong_elsewhere && may_come(column, columns, loaded)) continue;
    problems.push_back(loaded.places.problem(
        "stop.when", "there is no column '" + column + "'" + columns_like(column, columns)));
  }
  if (!unknown.empty()) return;
  try {
    ColumnExpression(when, columns);
  } catch (const std::invalid_argument& error) {
    problems.push_back(loaded.places.problem("stop.when", "'" + when + "': " + error.what()));
  }
}
}  // namespace

template <int Dim>
void check_measures(const LoadedDeck& loaded, const Scene<Dim>& scene,
                    std::vector<DeckProblem>& problems) {
  if (loaded.deck.measures.empty() && loaded.deck.stop.when.empty()) return;
  Names columns = HistoryColumns<Dim>(scene).names();
  columns.pop_back();  // the hash is not a number
  const bool wrong_elsewhere = !problems.empty() || !loaded.wrong.empty();
  check_stop(loaded, columns, wrong_elsewhere, problems);
  std::map<std::string, Names> fields;
  const auto check_field = [&](const std::string& path, const auto& kind) {
    const std::string name = kind.field.substr(0, kind.field.find('.'));
    if (!is_part(scene, kind.body) || name.empty()) return;
    auto [known, fresh] = fields.try_emplace(kind.body);
    if (fresh) known->second = fields_of(scene, kind.body);
    if (contains(known->second, name)) return;
    if (wrong_elsewhere && name == "temperature") return;  // something may heat it yet
    problems.push_back(loaded.places.problem(
        path + ".field", "'" + kind.body + "' has no field '" + name + "'" + reason_for(name) +
                             "; it has " + joined(known->second)));
  };
  for (const auto& named : loaded.deck.measures) {
    std::visit(
        [&](const auto& kind) {
          const std::string path =
              "measures." + named.name + "." + std::remove_cvref_t<decltype(kind)>::deck_name;
          if constexpr (requires { kind.body; }) {
            const auto wrong = piece_problem(scene.body_names, scene.pieces, kind.body);
            if (!wrong.empty()) problems.push_back(loaded.places.problem(path + ".body", wrong));
          }
          if constexpr (requires { kind.field; }) check_field(path, kind);
          if constexpr (requires { kind.where; }) {
            const auto part = part_problem(scene, kind);
            if (!part.empty()) problems.push_back(loaded.places.problem(path + ".where", part));
          }
          const auto problem = weights_problem(loaded, scene, kind, wrong_elsewhere);
          if (!problem.empty()) problems.push_back(loaded.places.problem(path + ".body", problem));
          if constexpr (requires { kind.column; }) {
            if (contains(columns, kind.column)) return;
            if (wrong_elsewhere && may_come(kind.column, columns, loaded)) return;
            std::string text = "there is no column '" + kind.column + "'";
            if (kind.column.starts_with("contact.") && scene.contact &&
                scene.contact->n_pairs() > kMostReportedPairs) {
              text += "; with over " + std::to_string(kMostReportedPairs) +
                      " pairs of bodies only those that `contact: {pairs: ...}` names have columns";
            }
            problems.push_back(
                loaded.places.problem(path + ".column", text + columns_like(kind.column, columns)));
          }
        },
        named.value.kind);
  }
}

template void check_measures<2>(const LoadedDeck&, const Scene<2>&, std::vector<DeckProblem>&);
template void check_measures<3>(const LoadedDeck&, const Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
