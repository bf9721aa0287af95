#include "fe/outer_facets.hpp"

#include <algorithm>

#include "core/open_surface.hpp"
#include "fe/conduction.hpp"

namespace brunt {
namespace {

template <int Dim>
struct Face {
  std::array<LocalIndex, Facet<Dim>::kNodes> sorted;  ///< the key: which nodes
  LocalIndex block = 0, element = 0;
  int number = 0;
};

template <int Dim>
std::vector<Face<Dim>> all_faces(const std::vector<ElementBlock<Dim>>& blocks) {
  std::vector<Face<Dim>> faces;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (LocalIndex e = 0; e < blocks[b].n; ++e) {
      const LocalIndex* corner =
          blocks[b].corner.data() + static_cast<std::size_t>(e) * Shape<Dim>::kCorners;
      for (int k = 0; k < static_cast<int>(Shape<Dim>::kFace.size()); ++k) {
        Face<Dim> face;
        for (int i = 0; i < Facet<Dim>::kNodes; ++i) {
          face.sorted[i] = corner[Shape<Dim>::kFace[k][i]];
        }
        std::sort(face.sorted.begin(), face.sorted.end());
        face.block = static_cast<LocalIndex>(b);
        face.element = e;
        face.number = k;
        faces.push_back(face);
      }
    }
  }
  std::sort(faces.begin(), faces.end(),
            [](const Face<Dim>& a, const Face<Dim>& b) { return a.sorted < b.sorted; });
  return faces;
}

/// Area [m^2] of a quad by its diagonals; length [m] of an edge.
Real face_area(const std::array<LocalIndex, 4>& node, const std::vector<Vec<3>>& x) {
  return 0.5 * (x[node[2]] - x[node[0]]).cross(x[node[3]] - x[node[1]]).norm();
}
Real face_area(const std::array<LocalIndex, 2>& node, const std::vector<Vec<2>>& x) {
  return (x[node[1]] - x[node[0]]).norm();
}

/// Least width of a face [m]: its area over its longest edge.
Real face_width(const std::array<LocalIndex, 4>& node, const std::vector<Vec<3>>& x) {
  Real longest = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    longest = std::max(longest, (x[node[(c + 1) % 4]] - x[node[c]]).norm());
  }
  return face_area(node, x) / longest;
}
Real face_width(const std::array<LocalIndex, 2>& node, const std::vector<Vec<2>>& x) {
  return face_area(node, x);
}

template <int Dim>
Facet<Dim> facet_of(const ElementBlock<Dim>& block, const Face<Dim>& face,
                    const Points<Dim>& points, const std::vector<const Material*>& varying) {
  const LocalIndex e = face.element;
  Facet<Dim> facet;
  for (int i = 0; i < Facet<Dim>::kNodes; ++i) {
    facet.node[i] = block.corner[static_cast<std::size_t>(e) * Shape<Dim>::kCorners +
                                 Shape<Dim>::kFace[face.number][i]];
  }
  facet.id = block.id[e] << 3 | static_cast<GlobalId>(face.number);
  facet.body = block.body[e];
  facet.piece = block.piece[e];
  const Real size = element_volume<Dim>(corner_positions(block, e, points), true, Thickness{1, 0});
  facet.depth = size / face_area(facet.node, points.x);
  facet.stiffness =
      block.material->modulus() / std::min(facet.depth, face_width(facet.node, points.x));
  facet.temperature = block.temperature;
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

/// An element between two outer faces is a plate one element thick: each face lets go at its
/// middle, or a body that has come in from one side would be pushed out of the other. No face holds
/// what is deeper than it is wide.
template <int Dim>
void limit_depths(std::vector<Facet<Dim>>& facets, const std::vector<Vec<Dim>>& x) {
  const auto opposite = [](GlobalId id) {
    const int other = Shape<Dim>::kOpposite[static_cast<std::size_t>(id & 7)];
    return (id & ~GlobalId{7}) | static_cast<GlobalId>(other);
  };
  std::vector<GlobalId> ids;
  ids.reserve(facets.size());
  for (const auto& facet : facets) ids.push_back(facet.id);
  for (auto& facet : facets) {
    if (std::binary_search(ids.begin(), ids.end(), opposite(facet.id))) facet.depth *= 0.5;
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
  const std::vector<Face<Dim>> faces = all_faces(blocks);
  const auto varying = materials_that_vary(blocks);
  std::vector<Facet<Dim>> facets;
  for (std::size_t k = 0; k < faces.size();) {
    std::size_t end = k + 1;
    while (end < faces.size() && faces[end].sorted == faces[k].sorted) ++end;
    const auto on_axis = [&axis](LocalIndex node) {
      return std::binary_search(axis.begin(), axis.end(), node);
    };
    const bool inner = std::all_of(faces[k].sorted.begin(), faces[k].sorted.end(), on_axis);
    if (end == k + 1 && !inner) {
      facets.push_back(facet_of(blocks[faces[k].block], faces[k], points, varying));
    }
    k = end;
  }
  std::sort(facets.begin(), facets.end(),
            [](const Facet<Dim>& a, const Facet<Dim>& b) { return a.id < b.id; });
  limit_depths<Dim>(facets, points.x);
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
