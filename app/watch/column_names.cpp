#include "app/watch/column_names.hpp"

#include "app/deck/columns.hpp"
#include "app/watch/rigid_reports.hpp"

namespace brunt {

namespace {
using deck::ColumnPattern;

/// Fills patterns of columns one after another.
class Filler {
 public:
  void add(ColumnPattern pattern, const std::string& name = {}) { append(*pattern.info, name, ""); }
  /// One column for each component from first to before last.
  void add_components(ColumnPattern pattern, int first, int last, const std::string& name = {}) {
    for (int c = first; c < last; ++c) append(*pattern.info, name, kAxes[c]);
  }
  /// A column of the table whose name is made of parts: those of the ledger.
  void add_text(const std::string& pattern) { append(deck::column_of_pattern(pattern), "", ""); }
  /// What an entity reports, which has a place in the table: a number, or a vector.
  template <int Dim>
  void add_report(const std::string& pattern, bool vector, const std::string& name) {
    for (int c = 0; vector && c < Dim; ++c) {
      append(deck::column_of_pattern(pattern + ".AXIS"), name, kAxes[c]);
    }
    if (!vector) append(deck::column_of_pattern(pattern), name, "");
  }
  void add_probe(const Probe& probe) {
    for (std::size_t f = 0; f < probe.fields.size(); ++f) {
      columns_.names.push_back(column_of(probe, f));
    }
  }
  ColumnNames take() { return std::move(columns_); }

 private:
  void append(const deck::ColumnInfo& info, const std::string& name, const char* axis) {
    std::string text = info.pattern;
    if (const auto at = text.find("AXIS"); at != std::string::npos) text.replace(at, 4, axis);
    if (const auto at = text.find("NAME"); at != std::string::npos) text.replace(at, 4, name);
    if (info.whole) columns_.whole.push_back(columns_.names.size());
    columns_.names.push_back(std::move(text));
  }

  ColumnNames columns_;
};

template <int Dim>
void add_scene(Filler& to) {
  for (const ColumnPattern column : {ColumnPattern("time"), ColumnPattern("step"),
                                     ColumnPattern("dt"), ColumnPattern("dt_body")}) {
    to.add(column);
  }
  for (int c = 0; c < kColumns; ++c) {
    to.add_text("energy." + std::string(column_name(static_cast<Column>(c))));
  }
  to.add("energy.total"), to.add("energy.drift"), to.add("energy.created");
  to.add_components("momentum.AXIS", 0, Dim);
}

/// report  null: the body is not rigid
/// torque  the first component of torques
template <int Dim>
void add_body(const std::string& name, bool erodes, const RigidReport* report, int torque,
              Filler& to) {
  to.add("body.NAME.mass", name);
  to.add_components("body.NAME.position.AXIS", 0, Dim, name);
  to.add_components("body.NAME.velocity.AXIS", 0, Dim, name);
  to.add("body.NAME.kinetic", name), to.add("body.NAME.internal", name);
  to.add("body.NAME.hourglass", name), to.add("body.NAME.heat", name);
  if (erodes) to.add("body.NAME.eroded", name), to.add("body.NAME.eroded_mass", name);
  if (report == nullptr) return;
  const int turning = report->one_piece ? torque : 3;
  to.add_components("body.NAME.rotation.AXIS", turning, 3, name);
  to.add_components("body.NAME.spin.AXIS", turning, 3, name);
  to.add_components("body.NAME.force.AXIS", 0, Dim, name);
  to.add_components("body.NAME.torque.AXIS", torque, 3, name);
}

template <int Dim>
void add_pair(const std::string& name, bool conducts, int torque, Filler& to) {
  to.add_components("contact.NAME.force.AXIS", 0, Dim, name);
  to.add_components("contact.NAME.torque.AXIS", torque, 3, name);
  to.add("contact.NAME.area", name), to.add("contact.NAME.heat_rate", name);
  to.add("contact.NAME.friction_heat", name), to.add("contact.NAME.max_penetration", name);
  to.add("contact.NAME.planes", name);
  if (!conducts) return;
  to.add("contact.NAME.temperature.max", name), to.add("contact.NAME.temperature.mean", name);
}

void add_heat(Filler& to) {
  to.add("heat.stored"), to.add("heat.plastic"), to.add("heat.compression");
  to.add("heat.friction"), to.add("heat.boundary"), to.add("heat.drift");
}
}  // namespace

template <int Dim>
ColumnNames column_names(const Scene<Dim>& scene) {
  const int torque = first_torque(scene);
  Filler to;
  add_scene<Dim>(to);
  const auto rigid = rigid_reports(scene, 0);
  Label label = 0;
  for (const auto& body : scene.body_names) {
    const bool erodes = label < scene.erodes.size() && scene.erodes[label] != 0;
    const auto found = rigid.find(label++);
    add_body<Dim>(body, erodes, found == rigid.end() ? nullptr : &found->second, torque, to);
  }
  if (scene.contact) {
    for (const auto& pair : scene.contact->reports()) {
      add_pair<Dim>(pair.name, scene.conducts(), torque, to);
    }
  }
  scene.boundaries.each([&](const auto& boundary) {
    if constexpr (requires { boundary.visit_reports([](const char*, const auto&) {}); }) {
      boundary.visit_reports([&](const char* what, const auto& values) {
        const bool vector = !std::is_same_v<decltype(values), const std::vector<Real>&>;
        to.add_report<Dim>(std::string("boundary.NAME.") + what, vector, boundary.patch.name);
        if (!is_reaction(what)) return;
        to.add_components("boundary.NAME.torque.AXIS", torque, 3, boundary.patch.name);
      });
    }
  });
  for (const auto& probe : scene.probes) to.add_probe(probe);
  for (const auto& section : scene.sections.all()) {
    to.add_components("section.NAME.force.AXIS", 0, Dim, section.name);
    to.add_components("section.NAME.moment.AXIS", torque, 3, section.name);
  }
  if (scene.conducts()) add_heat(to);
  to.add("state_hash");
  return to.take();
}

template ColumnNames column_names<2>(const Scene<2>&);
template ColumnNames column_names<3>(const Scene<3>&);

}  // namespace brunt
