#include "fe/outer_facets.hpp"

#include <algorithm>
#include <utility>

#include "core/open_surface.hpp"
#include "fe/conduction.hpp"
#include "fe/formulation.hpp"

namespace brunt {
namespace {

template <int Dim>
struct Face {
  std::array<LocalIndex, Facet<Dim>::kNodes> sorted;  ///< the key: which nodes
  LocalIndex block = 0, element = 0;
  LocalIndex next = -1;  ///< among those with the same last node
  std::uint8_t number = 0;
  bool is_alone = true;  ///< no other element has it
};

/// Nodes of face k of an element; -1 behind those of a triangle.
template <int Dim>
std::array<LocalIndex, Facet<Dim>::kNodes> nodes_of_face(const ElementType& type, int k,
                                                         std::span<const LocalIndex> corner) {
  std::array<LocalIndex, Facet<Dim>::kNodes> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int local = type.face[k][i];
    nodes[i] = local < 0 ? -1 : corner[local];
  }
  return nodes;
}

/// Without the call that an array's own comparison is.
template <std::size_t n>
bool same_nodes(const std::array<LocalIndex, n>& a, const std::array<LocalIndex, n>& b) {
  LocalIndex differing = 0;
  for (std::size_t i = 0; i < n; ++i) differing |= a[i] ^ b[i];
  return differing == 0;
}

void sort_nodes(std::array<LocalIndex, 2>& node) {
  if (node[1] < node[0]) std::swap(node[0], node[1]);
}
void sort_nodes(std::array<LocalIndex, 4>& node) {
  const auto order = [&node](std::size_t a, std::size_t b) {
    const LocalIndex low = std::min(node[a], node[b]), high = std::max(node[a], node[b]);
    node[a] = low, node[b] = high;
  };
  order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
}

/// Faces of the elements so far, by their last nodes: there are few to each.
template <int Dim>
class OpenFaces {
 public:
  explicit OpenFaces(std::size_t n_points) : last_of_(n_points, -1) {}

  void add(const Face<Dim>& face) {
    LocalIndex& last = last_of_[face.sorted.back()];
    LocalIndex same = last;
    while (same >= 0 && !same_nodes(faces_[same].sorted, face.sorted)) same = faces_[same].next;
    if (same >= 0) {
      faces_[same].is_alone = false;
      return;
    }
    const LocalIndex at = place();
    faces_[at] = face;
    faces_[at].next = std::exchange(last, at);
  }
  /// No more elements have this node: appends the faces that one element alone has.
  void close(LocalIndex node, std::vector<Face<Dim>>& alone) {
    for (LocalIndex at = std::exchange(last_of_[node], -1); at >= 0;) {
      if (faces_[at].is_alone) alone.push_back(faces_[at]);
      const LocalIndex next = faces_[at].next;
      faces_[at].next = std::exchange(unused_, at);
      at = next;
    }
  }

 private:
  LocalIndex place() {
    if (unused_ >= 0) return std::exchange(unused_, faces_[unused_].next);
    faces_.emplace_back();
    return static_cast<LocalIndex>(faces_.size() - 1);
  }

  std::vector<Face<Dim>> faces_;
  std::vector<LocalIndex> last_of_;  // the last face of each node
  LocalIndex unused_ = -1;
};

/// The faces that one element alone has. Elements lie along a curve, and so do nodes: those whose
/// elements are not all seen yet are few, and so are their faces.
template <int Dim>
std::vector<Face<Dim>> free_faces(const std::vector<ElementBlock<Dim>>& blocks,
                                  std::size_t n_points) {
  std::vector<LocalIndex> to_come(n_points, 0);  // elements of each node
  for (const auto& block : blocks) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      for (const LocalIndex node : block.corners_of(e)) ++to_come[node];
    }
  }
  OpenFaces<Dim> open(n_points);
  std::vector<Face<Dim>> alone;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const ElementType& type = blocks[b].formulation->type();
    for (LocalIndex e = 0; e < blocks[b].n; ++e) {
      const auto corner = blocks[b].corners_of(e);
      for (int k = 0; k < type.faces; ++k) {
        Face<Dim> face{nodes_of_face<Dim>(type, k, corner), static_cast<LocalIndex>(b), e};
        sort_nodes(face.sorted);
        face.number = static_cast<std::uint8_t>(k);
        open.add(face);
      }
      for (const LocalIndex node : corner) {
        if (--to_come[node] == 0) open.close(node, alone);
      }
    }
  }
  return alone;
}

/// Area [m^2] of a quad by its diagonals, or of a triangle; length [m] of an edge.
Real face_area(const std::array<LocalIndex, 4>& node, const std::vector<Vec<3>>& x) {
  const LocalIndex last = node[3] < 0 ? node[0] : node[3];
  return 0.5 * (x[node[2]] - x[node[0]]).cross(x[last] - x[node[1]]).norm();
}
Real face_area(const std::array<LocalIndex, 2>& node, const std::vector<Vec<2>>& x) {
  return (x[node[1]] - x[node[0]]).norm();
}

/// Least width of a face [m]: its area over its longest edge, of a triangle twice that.
Real face_width(const std::array<LocalIndex, 4>& node, const std::vector<Vec<3>>& x) {
  const std::size_t n = node[3] < 0 ? 3 : 4;
  Real longest = 0;
  for (std::size_t c = 0; c < n; ++c) {
    longest = std::max(longest, (x[node[(c + 1) % n]] - x[node[c]]).norm());
  }
  return face_area(node, x) / longest * (n == 3 ? 2 : 1);
}
Real face_width(const std::array<LocalIndex, 2>& node, const std::vector<Vec<2>>& x) {
  return face_area(node, x);
}

/// An outer face, with what lies across the element from it.
template <int Dim>
struct Outer {
  Facet<Dim> facet;
  GlobalId opposite = 0;        ///< id of the facet there
  std::vector<LocalIndex> far;  ///< the corners there, where it is no face
};

template <int Dim>
Facet<Dim> facet_of(const ElementBlock<Dim>& block, const Face<Dim>& face,
                    const Points<Dim>& points, const std::vector<const Material*>& varying) {
  const LocalIndex e = face.element;
  Facet<Dim> facet;
  const ElementType& type = block.formulation->type();
  facet.node = nodes_of_face<Dim>(type, face.number, block.corners_of(e));
  facet.id = block.id[e] << 3 | static_cast<GlobalId>(face.number);
  facet.body = block.body[e];
  facet.piece = block.piece[e];
  const Real size =
      block.formulation->volume(corner_positions(block, e, points), true, Thickness{1, 0});
  facet.depth = type.depth * size / face_area(facet.node, points.x);
  facet.stiffness =
      block.material->modulus() / std::min(facet.depth, face_width(facet.node, points.x));
  facet.temperature = block.temperature;
  if (block.temperature_field != nullptr) {
    facet.temperature = block.temperature_field->at(in_space<Dim>(facet_center(facet, points.x)));
  }
  facet.areal_mass = 0.5 * block.material->density * facet.depth;
  if (block.conducts) {
    const auto at = std::find(varying.begin(), varying.end(), block.material);
    if (at == varying.end()) {
      facet.capacity = facet.areal_mass * block.material->specific_heat.at(block.temperature);
    } else {
      facet.capacity = facet.areal_mass;
      facet.specific_heat = static_cast<std::int32_t>(at - varying.begin());
    }
    facet.effusivity = block.material->effusivity(block.temperature);
  }
  return facet;
}

template <int Dim>
Outer<Dim> outer_of(const ElementBlock<Dim>& block, const Face<Dim>& face, Facet<Dim> facet) {
  Outer<Dim> outer{facet, facet.id, {}};
  const int across = block.formulation->type().opposite[face.number];
  if (across >= 0) {
    outer.opposite = (facet.id & ~GlobalId{7}) | static_cast<GlobalId>(across);
    return outer;
  }
  for (const LocalIndex node : block.corners_of(face.element)) {
    const bool here = std::binary_search(face.sorted.begin(), face.sorted.end(), node);
    if (!here) outer.far.push_back(node);
  }
  return outer;
}

/// An element between two outer faces, or between one and corners that lie on others, is a plate
/// one element thick: each face lets go at its middle, or a body that has come in from one side
/// would be pushed out of the other. No face holds what is deeper than it is wide.
template <int Dim>
void limit_depths(std::vector<Outer<Dim>>& faces, const std::vector<Vec<Dim>>& x) {
  std::vector<GlobalId> ids;
  std::vector<char> outside(x.size(), 0);
  ids.reserve(faces.size());
  for (const auto& [facet, opposite, far] : faces) {
    ids.push_back(facet.id);
    for (int c = 0; c < facet.n_nodes(); ++c) {
      outside[facet.node[c]] = 1;
    }
  }
  for (auto& [facet, opposite, far] : faces) {
    const bool plate = far.empty() ? std::binary_search(ids.begin(), ids.end(), opposite)
                                   : std::all_of(far.begin(), far.end(), [&](LocalIndex node) {
                                       return outside[node] != 0;
                                     });
    if (plate) facet.depth *= 0.5;
    facet.depth = std::min(facet.depth, face_width(facet.node, x));
  }
}

/// An edge that ends on the axis goes on behind it.
template <int Dim>
void end_at_no_axis(const std::vector<LocalIndex>& axis, std::vector<Facet<Dim>>& facets) {
  if (axis.empty()) return;
  for (auto& facet : facets) {
    for (std::size_t c = 0; c < facet.node.size(); ++c) {
      if (!std::binary_search(axis.begin(), axis.end(), facet.node[c])) continue;
      facet.borders = static_cast<std::uint8_t>(facet.borders & ~(1U << c));
    }
  }
}
}  // namespace

template <int Dim>
std::vector<Facet<Dim>> outer_facets(const std::vector<ElementBlock<Dim>>& blocks,
                                     const Points<Dim>& points,
                                     const std::vector<LocalIndex>& axis) {
  const auto varying = materials_that_vary(blocks);
  const auto on_axis = [&axis](LocalIndex node) {
    return std::binary_search(axis.begin(), axis.end(), node);
  };
  std::vector<Outer<Dim>> outer;
  for (const Face<Dim>& face : free_faces(blocks, points.x.size())) {
    if (std::all_of(face.sorted.begin(), face.sorted.end(), on_axis)) continue;
    const auto& block = blocks[face.block];
    outer.push_back(outer_of(block, face, facet_of(block, face, points, varying)));
  }
  std::sort(outer.begin(), outer.end(),
            [](const auto& a, const auto& b) { return a.facet.id < b.facet.id; });
  limit_depths<Dim>(outer, points.x);
  std::vector<Facet<Dim>> facets;
  facets.reserve(outer.size());
  for (const auto& face : outer) facets.push_back(face.facet);
  mark_borders<Dim>(facets, points.x);
  mark_sharpness<Dim>(facets, points.x);
  end_at_no_axis<Dim>(axis, facets);
  return facets;
}

template std::vector<Facet<2>> outer_facets(const std::vector<ElementBlock<2>>&, const Points<2>&,
                                            const std::vector<LocalIndex>&);
template std::vector<Facet<3>> outer_facets(const std::vector<ElementBlock<3>>&, const Points<3>&,
                                            const std::vector<LocalIndex>&);

}  // namespace brunt
// Tested by tests/unit/fe/surface_materials_test.cpp.
