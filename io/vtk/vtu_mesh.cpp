#include "io/vtk/vtu_mesh.hpp"

#include <vtkCellType.h>

#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>

#include "io/mesh/mesh_text.hpp"
#include "io/vtk/xml_arrays.hpp"

namespace brunt {

namespace {
std::optional<CellKind> vtu_kind(int type) {
  using enum CellKind;
  switch (type) {
    case VTK_VERTEX:
      return point1;
    case VTK_LINE:
      return line2;
    case VTK_TRIANGLE:
      return tri3;
    case VTK_QUAD:
    case VTK_PIXEL:
      return quad4;
    case VTK_TETRA:
      return tet4;
    case VTK_PYRAMID:
      return pyramid5;
    case VTK_WEDGE:
      return wedge6;
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
      return hex8;
    case VTK_QUADRATIC_EDGE:
    case VTK_LAGRANGE_CURVE:
      return higher1;
    case VTK_QUADRATIC_TRIANGLE:
    case VTK_QUADRATIC_QUAD:
    case VTK_BIQUADRATIC_QUAD:
    case VTK_LAGRANGE_TRIANGLE:
    case VTK_LAGRANGE_QUADRILATERAL:
      return higher2;
    case VTK_QUADRATIC_TETRA:
    case VTK_QUADRATIC_HEXAHEDRON:
    case VTK_QUADRATIC_WEDGE:
    case VTK_QUADRATIC_PYRAMID:
    case VTK_TRIQUADRATIC_HEXAHEDRON:
    case VTK_LAGRANGE_TETRAHEDRON:
    case VTK_LAGRANGE_HEXAHEDRON:
    case VTK_LAGRANGE_WEDGE:
      return higher3;
    default:
      return std::nullopt;
  }
}

/// The things of each value of an array; none where it is no array of few whole numbers.
std::map<std::int64_t, std::vector<int>> by_value(const XmlArray& array, std::size_t count) {
  constexpr std::size_t kMost = 256;
  std::map<std::int64_t, std::vector<int>> things;
  if (array.components != 1 || array.values.size() != count) return things;
  for (std::size_t i = 0; i < count; ++i) {
    const Real value = array.values[i];
    if (!(std::fabs(value) < 1e15) || value != std::floor(value)) return {};
    things[static_cast<std::int64_t>(value)].push_back(static_cast<int>(i));
    if (things.size() > kMost) return {};
  }
  return things;
}

/// Takes a grid's arrays into a mesh.
class VtuGrid {
 public:
  explicit VtuGrid(const std::string& path) : arrays_(read_xml_arrays(path)) { mesh_.path = path; }

  MeshFile taken() {
    add_points();
    add_cells();
    mesh_.resolve_corners();
    for (const XmlArray& array : arrays_) {
      const bool of_cells = array.section == "CellData";
      if (!of_cells && array.section != "PointData") continue;
      for (auto& [value, things] : by_value(array, of_cells ? mesh_.n_cells() : n_points_)) {
        MeshSet& set = mesh_.set(array.name + " " + std::to_string(value));
        (of_cells ? set.cells : set.nodes) = std::move(things);
      }
    }
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void wrong(const std::string& what) const {
    throw std::runtime_error(mesh_.path + ": " + what);
  }

  const std::vector<Real>& values(const char* section, const char* name) const {
    for (const XmlArray& array : arrays_) {
      if (array.section == section && (name == nullptr || array.name == name)) return array.values;
    }
    wrong(std::string("there is no array ") + (name ? name : "of coordinates") + " in " + section);
  }

  void add_points() {
    const auto& x = values("Points", nullptr);
    n_points_ = x.size() / 3;
    if (n_points_ == 0 || x.size() % 3 != 0) wrong("its points do not have three coordinates each");
    for (std::size_t i = 0; i < n_points_; ++i) {
      mesh_.add_node(static_cast<std::int64_t>(i), Vec3(x[3 * i], x[3 * i + 1], x[3 * i + 2]));
    }
  }

  void add_cells() {
    const auto& types = values("Cells", "types");
    const auto& offsets = values("Cells", "offsets");
    const auto& connectivity = values("Cells", "connectivity");
    if (types.empty() || types.size() != offsets.size()) {
      wrong("it has " + std::to_string(types.size()) + " types and " +
            std::to_string(offsets.size()) + " offsets of cells");
    }
    const auto most = static_cast<Real>(connectivity.size());
    Real from = 0;
    for (std::size_t c = 0; c < types.size(); ++c) {
      const Real to = offsets[c];
      if (!(to >= from && to <= most) || to != std::floor(to)) {
        wrong("cell " + std::to_string(c) + " ends at " + std::to_string(to) +
              " of the connectivity, of " + std::to_string(connectivity.size()));
      }
      add_cell(c, types[c],
               std::span(connectivity)
                   .subspan(static_cast<std::size_t>(from), static_cast<std::size_t>(to - from)));
      from = to;
    }
  }

  void add_cell(std::size_t c, Real type_value, std::span<const Real> points) {
    const std::string name = "cell " + std::to_string(c);
    const int type = type_value >= 0 && type_value < 256 ? static_cast<int>(type_value) : -1;
    const auto kind = vtu_kind(type);
    if (!kind) {
      wrong(name + " is of VTK's type " + std::to_string(type) +
            ", which is not known: write hexahedra or tetrahedra");
    }
    const auto corners = slot_of(info(*kind).corners);
    if (corners > 0 && points.size() != corners) {
      wrong(name + " has " + std::to_string(points.size()) + " corners, and its type " +
            std::to_string(corners));
    }
    std::array<std::int64_t, 8> corner{};
    for (std::size_t k = 0; k < corners; ++k) {
      if (!(points[k] >= 0 && points[k] < static_cast<Real>(n_points_))) {
        wrong(name + " has point " + std::to_string(std::llround(points[k])) + ", and there are " +
              std::to_string(n_points_));
      }
      corner[k] = static_cast<std::int64_t>(points[k]);
    }
    // Pixels and voxels run along the axes, not round.
    if (type == VTK_PIXEL || type == VTK_VOXEL) std::swap(corner[2], corner[3]);
    if (type == VTK_VOXEL) std::swap(corner[6], corner[7]);
    mesh_.add_cell(*kind, static_cast<std::int64_t>(c), {corner.data(), corners});
  }

  std::vector<XmlArray> arrays_;
  MeshFile mesh_;
  std::size_t n_points_ = 0;
};
}  // namespace

MeshFile read_vtu(const std::string& path) { return VtuGrid(path).taken(); }

}  // namespace brunt
