#include "io/mesh/abaqus.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "io/mesh/abaqus_elements.hpp"
#include "io/mesh/abaqus_sets.hpp"
#include "io/mesh/card.hpp"

namespace brunt {

namespace {
constexpr std::size_t kNoWidth = 0;  // fields stand between commas

class AbaqusReader {
 public:
  explicit AbaqusReader(const std::string& path) : text_(path) { mesh_.path = path; }

  MeshFile read() {
    while (text_.left() > 0) {
      const std::string_view line = trimmed(text_.next_line());
      if (line.empty() || line.substr(0, 2) == "**") continue;
      if (line[0] == '*') {
        start(line);
      } else {
        read_data(line);
      }
    }
    finish_element();
    if (mesh_.nodes.empty()) text_.wrong("the file has no *NODE");
    if (mesh_.n_cells() == 0) text_.wrong("the file has no *ELEMENT");
    mesh_.resolve_corners();
    sets_.resolve(mesh_);
    for (const auto& [type, what] : without_solids_) {
      mesh_.notes.push_back("elements of TYPE=" + type + " (" + mesh_.place(what.line) + "), " +
                            std::to_string(what.count) +
                            " in all, are passed over: they have no solids");
    }
    return std::move(mesh_);
  }

 private:
  enum class Data { none, node, element, nset, elset, surface, surface_nodes, instance };

  /// A keyword with its parameters, which may go on behind a comma at the end of the line.
  void start(std::string_view first) {
    finish_element();
    std::string line(first);
    while (line.back() == ',' && text_.left() > 0) line += trimmed(text_.next_line());
    keyword_ = AbaqusKeyword(line);
    data_ = Data::none;
    open(keyword_.name());
  }

  const std::string* parameter(const char* name) const { return keyword_.parameter(name); }
  const std::string& needed(const char* name) const {
    const std::string* value = parameter(name);
    if (!value || value->empty()) text_.wrong(keyword_.name() + " needs " + name + "=...");
    return *value;
  }

  void open(const std::string& keyword) {
    if (const std::string instead = instead_of_abaqus(keyword); !instead.empty()) {
      text_.wrong(keyword + " is not read: " + instead);
    }
    if (keyword == "*PART" && ++parts_ > 1) {
      text_.wrong(
          "a second *PART numbers its nodes anew: write the model without parts and "
          "assemblies, or each part to a file");
    }
    if (keyword == "*INSTANCE") open_instance();
    if (keyword == "*ASSEMBLY") of_part_ = sets_.keys();
    if (keyword == "*ENDASSEMBLY") of_part_.clear();
    if (keyword == "*NODE") {
      open_nodes();
    } else if (keyword == "*ELEMENT") {
      open_elements();
    } else if (keyword == "*NSET") {
      data_ = Data::nset;
      set_ = &sets_.nodes(own(needed("NSET")));
      if (const std::string* elements = parameter("ELSET")) {
        set_->of_elements.push_back({local(*elements), text_.line()});
      }
    } else if (keyword == "*ELSET") {
      data_ = Data::elset;
      set_ = &sets_.elements(own(needed("ELSET")));
    } else if (keyword == "*SURFACE") {
      open_surface();
    }
    const std::string* elsewhere = parameter("INPUT");
    if (data_ != Data::none && elsewhere) {
      text_.wrong("INPUT=" + *elsewhere + " of " + keyword +
                  " is not read: write the lines of that file into this one, behind the keyword");
    }
  }

  void open_instance() {
    data_ = Data::instance;
    if (++instances_ > 1) {
      text_.wrong(
          "a second *INSTANCE is a second copy of nodes and elements: write each to a file");
    }
    if (parameter("LIBRARY")) {
      text_.wrong("*INSTANCE with LIBRARY= takes its mesh from results: write the mesh itself");
    }
    if (const std::string* name = parameter("NAME")) instance_ = abaqus_label(*name).key;
  }

  void open_nodes() {
    data_ = Data::node;
    set_ = parameter("NSET") ? &sets_.nodes(own(needed("NSET"))) : nullptr;
    const std::string* system = parameter("SYSTEM");
    const std::string letter = system ? upper(*system) : "R";
    if (letter != "R" && letter != "C") {
      text_.wrong(
          "*NODE in SYSTEM=" + *system +
          " is not read: write the nodes in rectangular (R) or cylindrical (C) coordinates");
    }
    is_cylindrical_ = letter == "C";
  }

  void open_elements() {
    data_ = Data::element;
    const std::string type = upper(needed("TYPE"));
    type_ = abaqus_type(type);
    set_ = parameter("ELSET") ? &sets_.elements(own(needed("ELSET"))) : nullptr;
    if (type_.kind == CellKind::other) mesh_.other_types.emplace_back(mesh_.n_cells(), type);
    passed_over_ = nullptr;
    if (type_.has_no_solid) {
      passed_over_ = &without_solids_.try_emplace(type, PassedOver{text_.line(), 0}).first->second;
    }
  }

  void open_surface() {
    const std::string* written = parameter("TYPE");
    const std::string type = written ? upper(*written) : "ELEMENT";
    const bool is_combined = parameter("COMBINE") || parameter("CROP");
    if ((type != "ELEMENT" && type != "NODE") || is_combined) {
      mesh_.unread_sets.push_back("*SURFACE" + std::string(is_combined ? " of others" : "") +
                                  (written ? ", TYPE=" + type : "") + " (" +
                                  mesh_.place(text_.line()) + ")");
      return;
    }
    surface_ = &sets_.surface(own(needed("NAME")));
    data_ = type == "NODE" ? Data::surface_nodes : Data::surface;
  }

  void read_data(std::string_view line) {
    switch (data_) {
      case Data::none:
        return;
      case Data::instance:
        text_.wrong(
            "an *INSTANCE that is moved: write it where it is, or use `translate` and "
            "`rotate` of the deck");
      case Data::node:
        return read_node(line);
      case Data::element:
        return type_.nodes == 0 ? read_element_as_it_is(line) : read_element(line);
      case Data::nset:
      case Data::elset:
        return read_set(line);
      case Data::surface:
        return read_surface(line);
      case Data::surface_nodes: {
        Card card(text_, line);
        return take_member(card.field(kNoWidth), surface_->nodes);
      }
    }
  }

  void read_node(std::string_view line) {
    Card card(text_, line);
    const std::int64_t id = card.integer(kNoWidth, "the number of a node");
    Vec3 x;
    for (int c = 0; c < 3; ++c) x[c] = card.real(kNoWidth, "a coordinate");
    if (is_cylindrical_) {
      const Real angle = x[1] * (std::numbers::pi / 180);
      x = Vec3(x[0] * std::cos(angle), x[0] * std::sin(angle), x[2]);
    }
    mesh_.add_node(id, x, text_.line());
    if (set_) set_->ids.push_back(id);
  }

  /// Nodes of one element may go on in further lines.
  void read_element(std::string_view line) {
    Card card(text_, line);
    if (element_.empty()) element_line_ = text_.line();
    while (!card.at_end()) {
      element_.push_back(card.integer(kNoWidth, "a number of an element or its nodes"));
      if (element_.size() < slot_of(type_.nodes) + 1) continue;
      if (!card.at_end()) text_.wrong("the element has more nodes than its type");
      mesh_.add_cell(type_.kind, element_[0], {element_.data() + 1, slot_of(type_.nodes)},
                     element_line_);
      if (set_) set_->ids.push_back(element_[0]);
      element_.clear();
    }
  }
  /// Elements of types whose numbers of nodes are not known: those that this line has.
  void read_element_as_it_is(std::string_view line) {
    Card card(text_, line);
    if (goes_on_) {
      goes_on_ = line.back() == ',';
      return;
    }
    const std::int64_t id = card.integer(kNoWidth, "the number of an element");
    std::optional<std::int64_t> node;
    // Nodes of instances, and connectors to the ground, are not all numbers.
    while (!card.at_end() && !node) node = whole_number(card.field(kNoWidth));
    const std::span<const std::int64_t> corners(node ? &*node : nullptr, node ? 1 : 0);
    mesh_.add_cell(type_.kind, id, corners, text_.line());
    if (set_) set_->ids.push_back(id);
    if (passed_over_) ++passed_over_->count;
    goes_on_ = type_.kind == CellKind::other && line.back() == ',';
  }
  void finish_element() {
    goes_on_ = false;
    if (element_.empty()) return;
    text_.wrong("element " + std::to_string(element_[0]) + " has " +
                std::to_string(element_.size() - 1) + " nodes, and its type " +
                std::to_string(type_.nodes));
  }

  void read_set(std::string_view line) {
    Card card(text_, line);
    if (parameter("GENERATE")) {
      const std::int64_t from = card.integer(kNoWidth, "the first of a range");
      const std::int64_t to = card.integer(kNoWidth, "the last of a range");
      const std::int64_t step = card.maybe_integer(kNoWidth, "the step of a range").value_or(1);
      if (step < 1 || from < 0 || to < from) {
        text_.wrong("a range runs from the lower number to the higher, with a step above 0");
      }
      set_->ranges.push_back({from, to, step});
      return;
    }
    while (!card.at_end()) take_member(card.field(kNoWidth), *set_);
  }

  static std::optional<std::int64_t> whole_number(std::string_view text) {
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc{} || stop != text.data() + text.size()) return {};
    return value;
  }

  /// The label of a set that is written here. An assembly may have one of a name that its part has
  /// too: "assembly Top", whose key no label can have.
  AbaqusLabel own(std::string_view written) const {
    AbaqusLabel label = abaqus_label(written);
    if (of_part_.count(label.key) == 0) return label;
    return {"assembly " + label.text, "assembly " + label.key};
  }

  /// The label of a set that is named here: of the assembly, or of the part, which may have the
  /// name of its instance before it, "Plate-1.Top": there is one instance.
  AbaqusLabel local(std::string_view written) const {
    const std::size_t point = written.find('.');
    const bool is_of_instance = !instance_.empty() && point != std::string_view::npos &&
                                abaqus_label(written.substr(0, point)).key == instance_;
    if (is_of_instance) return abaqus_label(written.substr(point + 1));
    AbaqusLabel label = abaqus_label(written);
    if (of_part_.count(label.key) == 0) return label;
    const AbaqusLabel of_assembly = own(written);
    return sets_.keys().count(of_assembly.key) > 0 ? of_assembly : label;
  }

  /// A number or a name, into a set.
  void take_member(std::string_view written, AbaqusSet& set) const {
    if (written.empty()) return;
    if (const auto id = whole_number(written)) {
      set.ids.push_back(*id);
      return;
    }
    const AbaqusLabel label = local(written);
    if (const auto id = whole_number(label.text)) {
      set.ids.push_back(*id);
    } else {
      set.sets.push_back({label, text_.line()});
    }
  }

  void read_surface(std::string_view line) {
    Card card(text_, line);
    const AbaqusLabel of = local(card.field(kNoWidth));
    AbaqusSurface::Face face;
    face.line = text_.line();
    if (const auto id = whole_number(of.text)) {
      face.id = *id;
    } else {
      face.set = of;
    }
    // SPOS and SNEG are sides of shells: all of their nodes.
    const std::string side = upper(card.field(kNoWidth));
    if (side.size() == 2 && side[0] == 'S' && side[1] >= '1' && side[1] <= '6') {
      face.face = side[1] - '0';
    } else if (side != "SPOS" && side != "SNEG") {
      text_.wrong("'" + surface_->name + "' has the side '" + side + "' of '" + of.text +
                  "', which is not read: write S1 to S6 of elements, or SPOS or SNEG of shells");
    }
    if (of.text.empty()) {
      text_.wrong("'" + surface_->name + "' has no elements here: write their number or set");
    }
    surface_->faces.push_back(face);
  }

  struct PassedOver {
    int line;  ///< of their first keyword
    int count;
  };
  MeshText text_;
  MeshFile mesh_;
  AbaqusKeyword keyword_;  // whose data lines come
  Data data_ = Data::none;
  int parts_ = 0, instances_ = 0;
  std::string instance_;           // the key of its label
  std::set<std::string> of_part_;  // keys of sets, in an assembly
  AbaqusType type_;
  std::vector<std::int64_t> element_;  // its number and nodes, as far as they are read
  int element_line_ = 0;
  bool goes_on_ = false;  // an element of a type that is not known, in the next line
  bool is_cylindrical_ = false;
  AbaqusSet* set_ = nullptr;
  AbaqusSurface* surface_ = nullptr;
  PassedOver* passed_over_ = nullptr;
  std::map<std::string, PassedOver> without_solids_;  // by their types
  AbaqusSets sets_;
};
}  // namespace

MeshFile read_abaqus(const std::string& path) { return AbaqusReader(path).read(); }

}  // namespace brunt
