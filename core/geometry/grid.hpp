#pragma once
/// Building blocks of meshes: boxes, discs, balls, in a local frame.
#include <map>
#include <tuple>

#include "core/geometry/mesh.hpp"

namespace brunt {

/// Nodes by a key of whole numbers: the same key is the same node.
template <int Dim>
class KeyedMesh {
 public:
  using Key = std::tuple<int, int, int, int>;
  int node(const Key& key, const Vec<Dim>& x) {
    const auto [found, fresh] = index_.emplace(key, static_cast<int>(mesh.nodes.size()));
    if (fresh) mesh.nodes.push_back(x);
    return found->second;
  }
  void element(const std::array<int, Shape<Dim>::kCorners>& corners) {
    mesh.elements.push_back(corners);
    mesh.piece.push_back(0);
  }
  Mesh<Dim> mesh;

 private:
  std::map<Key, int> index_;
};

/// Layers of cells along one axis: evenly thick, or graded.
struct Layers {
  int n = 1;
  std::vector<Real> at;  ///< n + 1 fractions from 0 to 1 where they are graded; empty: even

  /// Layer k of nodes between two places [m]; the ends are met exactly, so that bodies which share
  /// a plane touch without a gap.
  Real between(Real low, Real high, int k) const {
    if (k == n) return high;
    return at.empty() ? low + (high - low) * k / n : low + (high - low) * at[k];
  }
};

/// Layers of cells along axis c of a shape that is `length` [m] long there.
Layers layers_along(const Sizing& sizing, std::size_t c, Real length,
                    const std::optional<Grading>& grading);
/// With the sizing's own grading along that axis.
Layers layers_along(const Sizing& sizing, int axis, Real length);

/// A box of layers from min to max.
template <int Dim>
Mesh<Dim> box_grid(const Vec<Dim>& min, const Vec<Dim>& max, const std::array<Layers, Dim>& layers);

/// A disc about the origin as an O-grid: a square core with rounded sides and rings about it;
/// n_radius cells from centre to rim.
Mesh<2> disc_grid(Real radius, int n_radius);

/// A ring between two radii.
Mesh<2> ring_grid(Real inner, Real outer, int n_radius, int n_around);

/// A ball about the origin: a cube with rounded sides and six blocks about it.
Mesh<3> ball_grid(Real radius, int n_radius);

/// A plane mesh extended along z from 0 to length.
Mesh<3> extrude(const Mesh<2>& plane, Real length, const Layers& layers);

/// The quadrilateral between four sides, each a polyline [m]; layers[0] along sides 0 and 2.
Mesh<2> transfinite_grid(const std::array<std::vector<Vec<2>>, 4>& sides,
                         const std::array<Layers, 2>& layers);

/// A polygon between its four corners. Of its two directions each grading takes the one that runs
/// along its axis. Throws as mesh_shape does.
Mesh<2> polygon_grid(const PolygonShape& polygon, const Sizing& sizing);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
