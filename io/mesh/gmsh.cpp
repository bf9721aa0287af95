#include "io/mesh/gmsh.hpp"

#include <array>
#include <cmath>
#include <map>

#include "io/mesh/mesh_text.hpp"

namespace brunt {

namespace {
/// An element type of Gmsh: what brunt calls it, and its number of nodes.
struct GmshType {
  CellKind kind;
  int nodes;
};

/// By Gmsh's number; null where it is none of those that meshers write for solids and faces.
const GmshType* gmsh_type(std::int64_t number) {
  using enum CellKind;
  static constexpr std::array<GmshType, 20> kTypes = {
      {{line2, 2},    {tri3, 3},     {quad4, 4},    {tet4, 4},     {hex8, 8},
       {wedge6, 6},   {pyramid5, 5}, {higher1, 3},  {higher2, 6},  {higher2, 9},
       {higher3, 10}, {higher3, 27}, {higher3, 18}, {higher3, 14}, {point1, 1},
       {higher2, 8},  {higher3, 20}, {higher3, 15}, {higher3, 13}, {higher2, 9}}};
  static constexpr GmshType kCubicTriangle{higher2, 10}, kCubicLine{higher1, 4},
      kQuarticLine{higher1, 5}, kCubicTetrahedron{higher3, 20}, kCubicHexahedron{higher3, 64};
  switch (number) {
    case 21:
      return &kCubicTriangle;
    case 26:
      return &kCubicLine;
    case 27:
      return &kQuarticLine;
    case 29:
      return &kCubicTetrahedron;
    case 92:
      return &kCubicHexahedron;
    default:
      break;
  }
  if (number < 1 || number > static_cast<std::int64_t>(kTypes.size())) return nullptr;
  return &kTypes[slot_of(number - 1)];
}

class GmshReader {
 public:
  explicit GmshReader(const std::string& path) : text_(path) { mesh_.path = path; }

  MeshFile read() {
    if (!text_.skip_to_line("$MeshFormat")) {
      text_.wrong(
          "there is no $MeshFormat: no file of Gmsh, or one of format 1 (Gmsh: "
          "Mesh.MshFileVersion = 4.1)");
    }
    read_format();
    while (!text_.at_end()) {
      const std::string_view section = text_.word();
      if (section.empty() || section[0] != '$') {
        text_.wrong("expects a section such as $Nodes, got '" + std::string(section.substr(0, 40)) +
                    "'");
      }
      const std::string name(section.substr(1));
      text_.rest_of_line();
      read_section(name);
      if (!text_.skip_to_line("$End" + name)) text_.wrong("there is no $End" + name);
    }
    if (mesh_.nodes.empty()) text_.wrong("the file has no $Nodes");
    if (mesh_.n_cells() == 0) text_.wrong("the file has no $Elements");
    mesh_.resolve_corners();
    return std::move(mesh_);
  }

 private:
  void read_format() {
    const std::string version(text_.word());
    binary_ = text_.integer("0 or 1 for ASCII or binary") == 1;
    const std::int64_t size = text_.integer("the size of a number");
    if (version != "2.2" && version != "4.1") {
      text_.wrong("is of format " + version.substr(0, 20) +
                  ": write it as 4.1 or 2.2 (Gmsh: Mesh.MshFileVersion = 4.1)");
    }
    is_new_ = version == "4.1";
    if (size != 8) text_.wrong("has numbers of " + std::to_string(size) + " bytes; 8 are read");
    text_.rest_of_line();
    if (binary_) {
      std::int32_t one = 0;
      text_.raw(&one, sizeof one);
      if (one != 1)
        text_.wrong("was written by a machine of another byte order: write it as ASCII");
    }
    if (!text_.skip_to_line("$EndMeshFormat")) text_.wrong("there is no $EndMeshFormat");
  }

  void read_section(const std::string& name) {
    // Elements of a partition belong to entities of its own, which physical groups do not name.
    if (name == "PartitionedEntities") {
      text_.wrong("the mesh is cut into partitions: write it whole (Gmsh: Mesh, Unpartition)");
    }
    if (name == "PhysicalNames") read_names();
    if (name == "Entities" && is_new_) read_entities();
    if (name == "Nodes") is_new_ ? read_nodes() : read_old_nodes();
    if (name == "Elements") is_new_ ? read_elements() : read_old_elements();
  }

  // Numbers of a section, in either form.
  std::int64_t int32(const char* what) {
    if (!binary_) return text_.integer(what);
    std::int32_t value = 0;
    text_.raw(&value, sizeof value);
    return value;
  }
  std::int64_t int64(const char* what) {
    if (!binary_) return text_.integer(what);
    std::int64_t value = 0;
    text_.raw(&value, sizeof value);
    return value;
  }
  Real real(const char* what) {
    if (!binary_) return text_.real(what);
    Real value = 0;
    text_.raw(&value, sizeof value);
    return value;
  }
  /// A number of things of at least so many bytes.
  std::size_t checked(std::int64_t n, const char* what) {
    const std::size_t bytes = binary_ ? 4 : 2;
    if (n < 0 || static_cast<std::uint64_t>(n) > text_.left() / bytes + 1) {
      text_.wrong(std::string(what) + " is " + std::to_string(n) + ", and " +
                  std::to_string(text_.left()) + " bytes are left of the file");
    }
    return slot_of(n);
  }
  std::size_t count(const char* what) { return checked(int64(what), what); }
  int line() const { return binary_ ? 0 : text_.line(); }

  void read_names() {
    const std::size_t n = text_.count("the number of physical names", 5);
    for (std::size_t i = 0; i < n; ++i) {
      const std::int64_t dim = text_.integer("the dimension of a physical group");
      const std::int64_t tag = text_.integer("the number of a physical group");
      std::string_view name = text_.rest_of_line();
      if (name.size() < 2 || name.front() != '"' || name.back() != '"') {
        text_.wrong("expects the name of a physical group in quotes");
      }
      name_of_[{dim, tag}] = name.substr(1, name.size() - 2);
    }
  }

  /// Reads which physical groups each point, curve, surface and volume belongs to.
  void read_entities() {
    std::array<std::size_t, 4> n{};
    for (std::size_t& each : n) each = count("a number of entities");
    for (std::int64_t dim = 0; dim < 4; ++dim) {
      for (std::size_t i = 0; i < n[slot_of(dim)]; ++i) {
        const std::int64_t tag = int32("the number of an entity");
        for (int c = 0; c < (dim == 0 ? 3 : 6); ++c) real("a corner of an entity's box");
        std::vector<std::int64_t>& groups = groups_of_[{dim, tag}];
        const std::size_t n_groups = count("the number of an entity's physical groups");
        for (std::size_t k = 0; k < n_groups; ++k) {
          groups.push_back(std::abs(int32("the number of a physical group")));
        }
        const std::size_t n_sides = dim == 0 ? 0 : count("the number of an entity's sides");
        for (std::size_t k = 0; k < n_sides; ++k) int32("the number of a side");
      }
    }
  }

  void read_nodes() {
    const std::size_t blocks = count("the number of blocks of nodes");
    for (int skipped = 0; skipped < 3; ++skipped) int64("the number of nodes");
    std::vector<std::int64_t> ids;
    std::vector<int> lines;
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int64_t dim = int32("the dimension of a block of nodes");
      int32("the entity of a block of nodes");
      const bool parametric = int32("0 or 1 for parametric nodes") != 0;
      const std::size_t n = count("the number of nodes of a block");
      ids.clear(), lines.clear();
      for (std::size_t i = 0; i < n; ++i) {
        ids.push_back(int64("the number of a node"));
        lines.push_back(line());
      }
      for (std::size_t i = 0; i < n; ++i) {
        const Vec3 x = place();
        for (std::int64_t c = 0; parametric && c < dim; ++c) real("a parameter of a node");
        mesh_.add_node(ids[i], x, lines[i]);
      }
    }
  }

  Vec3 place() {
    const Real x = real("a coordinate"), y = real("a coordinate"), z = real("a coordinate");
    return Vec3(x, y, z);
  }

  void read_elements() {
    const std::size_t blocks = count("the number of blocks of elements");
    for (int skipped = 0; skipped < 3; ++skipped) int64("the number of elements");
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int64_t dim = int32("the dimension of a block of elements");
      const std::int64_t entity = int32("the entity of a block of elements");
      const GmshType& type = type_of(int32("the type of a block of elements"));
      const std::size_t n = count("the number of elements of a block");
      const auto groups = groups_of_.find({dim, entity});
      for (std::size_t i = 0; i < n; ++i) {
        const std::int64_t id = int64("the number of an element");
        const int at = line();
        add(type, id, at, [&] { return int64("a node of an element"); });
        if (groups == groups_of_.end()) continue;
        for (const std::int64_t group : groups->second) put_in_group(dim, group);
      }
    }
  }

  void read_old_nodes() {
    const std::size_t n = text_.count("the number of nodes", binary_ ? 28 : 8);
    if (binary_) text_.rest_of_line();
    for (std::size_t i = 0; i < n; ++i) {
      const std::int64_t id = int32("the number of a node");
      const int at = line();
      mesh_.add_node(id, place(), at);
    }
  }

  void read_old_elements() {
    const std::size_t n = text_.count("the number of elements", 8);
    if (binary_) text_.rest_of_line();
    for (std::size_t i = 0; i < n;) {
      // In binary files elements of one type stand in blocks.
      std::int64_t id = 0, type_number = 0, tags = 0;
      std::size_t together = 1;
      if (!binary_) id = text_.integer("the number of an element");
      const int at = line();
      type_number = int32("the type of an element");
      if (binary_) together = checked(int32("the number of elements of a block"), "it");
      tags = static_cast<std::int64_t>(
          checked(int32("the number of tags of an element"), "the number of tags"));
      const GmshType& type = type_of(type_number);
      for (std::size_t k = 0; k < together; ++k, ++i) {
        if (binary_) id = int32("the number of an element");
        std::int64_t group = 0;
        for (std::int64_t t = 0; t < tags; ++t) {
          const std::int64_t tag = int32("a tag of an element");
          if (t == 0) group = tag;
        }
        add(type, id, at, [&] { return int32("a node of an element"); });
        if (group != 0) put_in_group(info(type.kind).dim, std::abs(group));
      }
    }
  }

  const GmshType& type_of(std::int64_t number) {
    const GmshType* type = gmsh_type(number);
    if (!type) {
      text_.wrong("elements of Gmsh's type " + std::to_string(number) +
                  " are not known: write first order (Mesh.ElementOrder = 1)");
    }
    return *type;
  }

  template <class Next>
  void add(const GmshType& type, std::int64_t id, int at, const Next& next) {
    std::array<std::int64_t, 64> nodes{};
    const auto n = slot_of(type.nodes);
    for (std::size_t k = 0; k < n; ++k) nodes[k] = next();
    mesh_.add_cell(type.kind, id, {nodes.data(), n}, at);
  }

  /// Puts the cell read last into a physical group.
  void put_in_group(std::int64_t dim, std::int64_t tag) {
    const auto [place, is_new] = set_of_.try_emplace({dim, tag}, mesh_.sets.size());
    if (is_new) {
      static constexpr const char* kNames[] = {"point", "curve", "surface", "volume"};
      const auto named = name_of_.find({dim, tag});
      const std::string name = named != name_of_.end() ? named->second
                               : dim >= 0 && dim < 4
                                   ? std::string(kNames[dim]) + " " + std::to_string(tag)
                                   : std::to_string(tag);
      mesh_.set(name);
      for (std::size_t s = 0; s < mesh_.sets.size(); ++s) {
        if (mesh_.sets[s].name == name) place->second = s;
      }
    }
    mesh_.sets[place->second].cells.push_back(static_cast<int>(mesh_.n_cells()) - 1);
  }

  using Key = std::pair<std::int64_t, std::int64_t>;  // dimension and number
  MeshText text_;
  MeshFile mesh_;
  bool binary_ = false, is_new_ = false;
  std::map<Key, std::string> name_of_;                  // physical groups
  std::map<Key, std::vector<std::int64_t>> groups_of_;  // entities
  std::map<Key, std::size_t> set_of_;
};
}  // namespace

MeshFile read_gmsh(const std::string& path) { return GmshReader(path).read(); }

}  // namespace brunt
