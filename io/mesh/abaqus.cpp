#include "io/mesh/abaqus.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "io/mesh/card.hpp"

namespace brunt {

namespace {
constexpr std::size_t kNoWidth = 0;  // fields stand between commas

/// What an element type is: brunt's kind, and how many nodes its lines have.
struct AbaqusType {
  CellKind kind;
  int nodes;
};

/// The kind of an element of a dimension by its number of nodes.
CellKind kind_of(int dim, int nodes) {
  using enum CellKind;
  if (dim == 1) return nodes == 2 ? line2 : higher1;
  if (dim == 2) return nodes == 3 ? tri3 : nodes == 4 ? quad4 : higher2;
  switch (nodes) {
    case 4:
      return tet4;
    case 5:
      return pyramid5;
    case 6:
      return wedge6;
    case 8:
      return hex8;
    default:
      return higher3;
  }
}

/// C3D8R, CPS4, DC3D4, S4R, B31, ...: a family, and its number of nodes. None where no family is
/// known.
std::optional<AbaqusType> abaqus_type(const std::string& name) {
  struct Family {
    std::string_view start;
    int dim;
  };
  static constexpr Family kFamilies[] = {{"C3D", 3}, {"AC3D", 3}, {"CPE", 2},   {"CPS", 2},
                                         {"CAX", 2}, {"STRI", 2}, {"SFM3D", 2}, {"M3D", 2},
                                         {"R3D", 2}, {"S", 2},    {"DC2D", 2},  {"T3D", 1},
                                         {"T2D", 1}, {"R2D", 1},  {"RAX", 1}};
  static const std::map<std::string_view, int> kBeams = {{"B21", 2}, {"B31", 2}, {"B22", 3},
                                                         {"B32", 3}, {"B23", 2}, {"B33", 2}};
  if (const auto beam = kBeams.find(std::string_view(name).substr(0, 3)); beam != kBeams.end()) {
    return AbaqusType{kind_of(1, beam->second), beam->second};
  }
  // Elements of heat have the nodes of those of stress.
  const std::string_view whole = name;
  for (const std::string_view text : {whole, whole.substr(whole.substr(0, 2) == "DC" ? 1 : 0)}) {
    for (const Family& family : kFamilies) {
      if (text.substr(0, family.start.size()) != family.start) continue;
      const std::string_view rest = text.substr(family.start.size());
      int nodes = 0;
      std::from_chars(rest.data(), rest.data() + rest.size(), nodes);
      if (nodes == 65) nodes = 6;  // STRI65
      if (nodes < 2 || nodes > 27) continue;
      return AbaqusType{kind_of(family.dim, nodes), nodes};
    }
  }
  return std::nullopt;
}

/// Corners of face n (from 1) of an element as Abaqus numbers them.
std::vector<int> face_corners(CellKind kind, int face) {
  static const std::map<CellKind, std::vector<std::vector<int>>> kFaces = {
      {CellKind::hex8,
       {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}},
      {CellKind::tet4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
      {CellKind::quad4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
      {CellKind::tri3, {{0, 1}, {1, 2}, {2, 0}}}};
  const auto found = kFaces.find(kind);
  if (found == kFaces.end() || face < 1 || face > static_cast<int>(found->second.size())) return {};
  return found->second[slot_of(face - 1)];
}

struct IdRange {
  std::int64_t from, to, step;
};
/// A set as it is written: of ids, ranges of them, and other sets.
struct WrittenSet {
  std::vector<std::int64_t> ids;
  std::vector<IdRange> ranges;
  std::vector<std::string> names;
};
struct WrittenFace {
  std::string name;  ///< of a set of elements; empty: of one
  std::int64_t id = 0;
  int face = 0;
  int line = 0;
};

class AbaqusReader {
 public:
  explicit AbaqusReader(const std::string& path) : text_(path) { mesh_.path = path; }

  MeshFile read() {
    while (text_.left() > 0) {
      const std::string_view line = text_.next_line();
      if (line.empty() || line.substr(0, 2) == "**" || trimmed(line).empty()) continue;
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
    resolve_sets();
    return std::move(mesh_);
  }

 private:
  enum class Data { none, node, element, nset, elset, surface, instance };

  /// A keyword with its parameters, which may go on behind a comma at the end of the line.
  void start(std::string_view first) {
    finish_element();
    std::string line(first);
    while (!line.empty() && line.back() == ',' && text_.left() > 0) line += text_.next_line();
    parameters_.clear();
    const std::size_t end = line.find(',');
    const std::string keyword = upper(trimmed(line.substr(0, end)));
    for (std::size_t from = end; from != std::string::npos;) {
      const std::size_t to = line.find(',', from + 1);
      const std::string one = line.substr(from + 1, to == std::string::npos ? to : to - from - 1);
      const std::size_t equals = one.find('=');
      std::string_view value;
      if (equals != std::string::npos) value = trimmed(std::string_view(one).substr(equals + 1));
      if (value.size() > 1 && value.front() == '"') value = value.substr(1, value.size() - 2);
      parameters_[upper(trimmed(one.substr(0, equals)))] = value;
      from = to;
    }
    open(keyword);
  }

  const std::string* parameter(const char* name) const {
    const auto found = parameters_.find(name);
    return found == parameters_.end() ? nullptr : &found->second;
  }
  const std::string& needed(const char* keyword, const char* name) const {
    const std::string* value = parameter(name);
    if (!value || value->empty()) {
      text_.wrong(std::string(keyword) + " needs " + name + "=...");
    }
    return *value;
  }

  void open(const std::string& keyword) {
    static const std::set<std::string> kMakeMore = {
        "*INCLUDE", "*NGEN",   "*NFILL",
        "*NCOPY",   "*NMAP",   "*ELGEN",
        "*ELCOPY",  "*SYSTEM", "*ELEMENT OUTPUT INCLUDE"};
    data_ = Data::none;
    if (kMakeMore.count(keyword) > 0) {
      text_.wrong(keyword + " is not read: write the nodes and elements themselves, in one file");
    }
    if (keyword == "*PART" && ++parts_ > 1) {
      text_.wrong(
          "a second *PART numbers its nodes anew: write the model without parts and "
          "assemblies, or each part to a file");
    }
    if (keyword == "*INSTANCE") data_ = Data::instance;
    if (keyword == "*NODE") {
      data_ = Data::node;
      set_ = parameter("NSET") ? &nsets_[*parameter("NSET")] : nullptr;
    } else if (keyword == "*ELEMENT") {
      const std::string type = upper(needed("*ELEMENT", "TYPE"));
      const auto known = abaqus_type(type);
      if (!known) text_.wrong("elements of TYPE=" + type + " are not known");
      type_ = *known;
      data_ = Data::element;
      set_ = parameter("ELSET") ? &elsets_[*parameter("ELSET")] : nullptr;
    } else if (keyword == "*NSET") {
      data_ = Data::nset;
      set_ = &nsets_[needed("*NSET", "NSET")];
      if (parameter("ELSET")) nodes_of_.emplace_back(*parameter("NSET"), *parameter("ELSET"));
    } else if (keyword == "*ELSET") {
      data_ = Data::elset;
      set_ = &elsets_[needed("*ELSET", "ELSET")];
    } else if (keyword == "*SURFACE") {
      const std::string* type = parameter("TYPE");
      if (!type || upper(*type) == "ELEMENT") {
        data_ = Data::surface;
        faces_ = &surfaces_[needed("*SURFACE", "NAME")];
      }
    }
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
        return read_element(line);
      case Data::nset:
      case Data::elset:
        return read_set(line);
      case Data::surface:
        return read_surface(line);
    }
  }

  void read_node(std::string_view line) {
    Card card(text_, line);
    const std::int64_t id = card.integer(kNoWidth, "the number of a node");
    Vec3 x;
    for (int c = 0; c < 3; ++c) x[c] = card.real(kNoWidth, "a coordinate");
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
  void finish_element() {
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
    while (!card.at_end()) {
      const std::string_view one = card.field(kNoWidth);
      if (one.empty()) continue;
      std::int64_t id = 0;
      const auto [stop, error] = std::from_chars(one.data(), one.data() + one.size(), id);
      if (error == std::errc{} && stop == one.data() + one.size()) {
        set_->ids.push_back(id);
      } else {
        set_->names.emplace_back(one);
      }
    }
  }

  void read_surface(std::string_view line) {
    Card card(text_, line);
    const std::string_view of = card.field(kNoWidth), face = card.field(kNoWidth);
    WrittenFace written;
    written.line = text_.line();
    const auto [stop, error] = std::from_chars(of.data(), of.data() + of.size(), written.id);
    if (error != std::errc{} || stop != of.data() + of.size()) written.name = of;
    // SPOS and SNEG are sides of shells: all of their nodes.
    if (face.size() == 2 && (face[0] == 'S' || face[0] == 's')) written.face = face[1] - '0';
    faces_->push_back(written);
  }

  // Sets, when all nodes and elements are known.

  void resolve_sets() {
    const IdTable nodes(mesh_.node_id), cells(mesh_.cell_id);
    if (cells.repeated() >= 0) {
      const auto again = slot_of(cells.repeated());
      throw std::runtime_error(mesh_.path + ": " + mesh_.cell_name(again) +
                               " has the number of another element");
    }
    for (const auto& [name, set] : elsets_) {
      std::set<std::string> done;
      add(elsets_, mesh_.cell_id, cells, name, mesh_.set(name).cells, done);
    }
    for (const auto& [name, set] : nsets_) {
      std::set<std::string> done;
      add(nsets_, mesh_.node_id, nodes, name, mesh_.set(name).nodes, done);
    }
    for (const auto& [name, elset] : nodes_of_) {
      const MeshSet of = mesh_.set(elset);
      auto& all = mesh_.set(name).nodes;
      for (const int cell : of.cells) {
        const auto corners = mesh_.corners(slot_of(cell));
        all.insert(all.end(), corners.begin(), corners.end());
      }
    }
    for (const auto& [name, faces] : surfaces_) {
      for (const WrittenFace& face : faces) add_face(cells, name, face);
    }
    std::erase_if(mesh_.sets,
                  [](const MeshSet& set) { return set.cells.empty() && set.nodes.empty(); });
    for (MeshSet& set : mesh_.sets) {
      for (auto* list : {&set.cells, &set.nodes}) {
        std::sort(list->begin(), list->end());
        list->erase(std::unique(list->begin(), list->end()), list->end());
      }
    }
  }

  /// Ids that the file has not are left out, as Abaqus does.
  void add(const std::map<std::string, WrittenSet>& all, const std::vector<std::int64_t>& ids,
           const IdTable& table, const std::string& name, std::vector<int>& list,
           std::set<std::string>& done) {
    const auto found = all.find(name);
    if (found == all.end() || !done.insert(name).second) return;
    for (const auto& [from, to, step] : found->second.ranges) {
      for (std::size_t i = 0; i < ids.size(); ++i) {
        if (ids[i] < from || ids[i] > to || (ids[i] - from) % step != 0) continue;
        list.push_back(static_cast<int>(i));
      }
    }
    for (const std::int64_t id : found->second.ids) {
      if (const int at = table[id]; at >= 0) list.push_back(at);
    }
    for (const std::string& other : found->second.names) add(all, ids, table, other, list, done);
  }

  void add_face(const IdTable& table, const std::string& name, const WrittenFace& face) {
    std::vector<int> cells;
    if (face.name.empty()) {
      if (const int at = table[face.id]; at >= 0) cells.push_back(at);
    } else if (const MeshSet* set = mesh_.find(face.name)) {
      cells = set->cells;
    }
    auto& nodes = mesh_.set(name).nodes;
    for (const int cell : cells) {
      const auto corners = mesh_.corners(slot_of(cell));
      if (face.face == 0) {
        nodes.insert(nodes.end(), corners.begin(), corners.end());
        continue;
      }
      for (const int c : face_corners(mesh_.kind[slot_of(cell)], face.face)) {
        nodes.push_back(corners[slot_of(c)]);
      }
    }
  }

  MeshText text_;
  MeshFile mesh_;
  Data data_ = Data::none;
  std::map<std::string, std::string> parameters_;
  int parts_ = 0;
  AbaqusType type_{CellKind::hex8, 8};
  std::vector<std::int64_t> element_;  // its number and nodes, as far as they are read
  int element_line_ = 0;
  WrittenSet* set_ = nullptr;
  std::vector<WrittenFace>* faces_ = nullptr;
  std::map<std::string, WrittenSet> nsets_, elsets_;
  std::map<std::string, std::vector<WrittenFace>> surfaces_;
  std::vector<std::pair<std::string, std::string>> nodes_of_;  // sets of nodes of sets of elements
};
}  // namespace

MeshFile read_abaqus(const std::string& path) { return AbaqusReader(path).read(); }

}  // namespace brunt
