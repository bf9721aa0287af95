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
  void element(const std::array<int, 1 << Dim>& corners) {
    mesh.elements.push_back(corners);
    mesh.piece.push_back(0);
  }
  Mesh<Dim> mesh;

 private:
  std::map<Key, int> index_;
};

/// A box of n[0] x n[1] (x n[2]) cells from min to max.
template <int Dim>
Mesh<Dim> box_grid(const Vec<Dim>& min, const Vec<Dim>& max, const std::array<int, Dim>& n);

/// A disc about the origin as an O-grid: a square core with rounded sides and rings about it;
/// n_radius cells from centre to rim.
Mesh<2> disc_grid(Real radius, int n_radius);

/// A ring between two radii.
Mesh<2> ring_grid(Real inner, Real outer, int n_radius, int n_around);

/// A ball about the origin: a cube with rounded sides and six blocks about it.
Mesh<3> ball_grid(Real radius, int n_radius);

/// A plane mesh extended along z from 0 to length in n layers.
Mesh<3> extrude(const Mesh<2>& plane, Real length, int n);

/// The quadrilateral between four sides, each a polyline [m]; n[0] cells along sides 0 and 2.
Mesh<2> transfinite_grid(const std::array<std::vector<Vec<2>>, 4>& sides,
                         const std::array<int, 2>& n);

}  // namespace brunt
