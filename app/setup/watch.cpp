#include "app/setup/watch.hpp"

#include <algorithm>
#include <cmath>

#include "app/scene/place.hpp"

namespace brunt {

namespace {
std::string names_of(const BodyView& view) {
  std::string list;
  for (const auto* fields : {&view.point_fields, &view.cell_fields}) {
    for (const auto& field : *fields) list += (list.empty() ? "" : ", ") + field.name;
  }
  return list;
}

GlobalId id_at(const std::vector<Field>& fields, std::size_t place) {
  return static_cast<GlobalId>(field_named(fields, "id")->values[place]);
}

/// Returns what is wrong, "" where nothing is.
std::string find_probe(const deck::Probe& given, const BodyView& view, Probe& probe) {
  for (const auto& field : given.fields) {
    const std::string name = field.substr(0, field.find('.'));
    const bool at_point = field_named(view.point_fields, name) != nullptr;
    const bool in_cell = field_named(view.cell_fields, name) != nullptr;
    if (!at_point && !in_cell) {
      return "'" + given.body + "' has no field '" + name + "'; it has " + names_of(view);
    }
    probe.fields.push_back(field);
    probe.of_cell.push_back(at_point ? 0 : 1);
  }
  const Place place = find_place(view, given.at);
  for (const std::size_t point : place.points) {
    probe.points.push_back(id_at(view.point_fields, point));
  }
  probe.weights = place.weights, probe.reflected = place.reflected;
  probe.point_distance = place.point_distance;
  const auto& of_cell = probe.of_cell;
  if (std::find(of_cell.begin(), of_cell.end(), 1) != of_cell.end()) {
    probe.cell = id_at(view.cell_fields, place.cell), probe.cell_distance = place.cell_distance;
  }
  return "";
}

/// Points within a tenth of the body's size behind the plane lie on it, and before the section.
Real tolerance_of(Real size, Real at) {
  constexpr Real kRounding = 1e-9;
  return size > 0 ? 0.1 * size : kRounding * std::fabs(at);
}

template <int Dim>
std::string find_section(const deck::Section& given, const deck::Body& body, Real size,
                         const Scene<Dim>& scene, MaterialSection<Dim>& section) {
  if (body.rigid) return "'" + given.body + "' is rigid: no stress of it is known";
  section.axis = static_cast<int>(given.plane.axis);
  section.at = given.plane.at + tolerance_of(size, given.plane.at) - scene.origin[section.axis];
  std::size_t before = 0, beyond = 0;
  for (std::size_t s = 0; s < scene.solids.size(); ++s) {
    const auto& points = scene.solids[s]->points();
    for (std::size_t i = 0; i < points.x_start.size(); ++i) {
      if (points.body[i] != section.body) continue;
      section.solids = {s};
      ++(points.x_start[i][section.axis] > section.at ? beyond : before);
    }
  }
  if (before == 0 || beyond == 0) return "does not cut '" + given.body + "' at time 0";
  return "";
}
}  // namespace

template <int Dim>
void add_watches(const LoadedDeck& loaded, Scene<Dim>& scene, std::vector<DeckProblem>& problems) {
  const Deck& deck = loaded.deck;
  const auto refuse = [&](const std::string& path, const std::string& wrong) {
    if (!wrong.empty()) problems.push_back(loaded.places.problem(path, wrong));
    return !wrong.empty();
  };
  for (const auto& [name, given] : deck.probes) {
    if (refuse("probes." + name + ".body",
               piece_problem(scene.body_names, scene.pieces, given.body))) {
      continue;
    }
    const auto part = part_named(scene.body_names, scene.pieces, given.body);
    if (!part) continue;  // reported by the deck's own checks
    Probe probe;
    probe.name = name, probe.body = part->body;
    const BodyView view = scene.own_part_view(given.body);
    if (refuse("probes." + name + ".fields", find_probe(given, view, probe))) continue;
    scene.probes.push_back(std::move(probe));
  }
  for (const auto& [name, given] : deck.sections) {
    const auto body = label_of(deck, given.body);
    if (!body) continue;  // reported by the deck's own checks
    MaterialSection<Dim> section;
    section.name = name, section.body = *body;
    const auto wrong =
        find_section(given, deck.bodies[*body].value, scene.body_size[*body], scene, section);
    if (refuse("sections." + name + ".plane", wrong)) continue;
    scene.sections.add(std::move(section));
  }
}

template void add_watches<2>(const LoadedDeck&, Scene<2>&, std::vector<DeckProblem>&);
template void add_watches<3>(const LoadedDeck&, Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
