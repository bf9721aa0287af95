#include "core/geometry/brick_wall.hpp"

#include <cmath>

#include "core/geometry/grid.hpp"
#include "core/geometry/placement.hpp"

namespace brunt {

template <int Dim>
std::vector<Brick<Dim>> bricks_of(const BrickWall& wall) {
  const auto& n = *wall.bricks;
  const Vec<Dim> size = to_vector<Dim>(wall.brick), origin = to_vector<Dim>(wall.origin);
  // Courses run along the axis nearest to `course`, and are stacked along the last other one.
  std::size_t along = 0;
  for (std::size_t c = 1; c < Dim; ++c) {
    if (std::fabs(wall.course[c]) > std::fabs(wall.course[along])) along = c;
  }
  const std::size_t up = along == Dim - 1 ? Dim - 2 : Dim - 1, deep = 3 - along - up;
  std::vector<Brick<Dim>> bricks;
  const auto add = [&](std::array<int, Dim> cell, Real start, Real length) {
    Brick<Dim> brick;
    for (std::size_t c = 0; c < Dim; ++c) {
      const auto k = static_cast<int>(c);
      const Real low = c == along ? start : cell[c] * (size[k] + wall.gap);
      brick.low[k] = origin[k] + low;
      brick.high[k] = origin[k] + low + (c == along ? length : size[k]);
      brick.name += (c ? "." : "") + std::to_string(cell[c]);
    }
    bricks.push_back(brick);
  };
  const int across = Dim == 3 ? n[deep] : 1;
  const Real full = size[static_cast<int>(along)];
  for (int course = 0; course < n[up]; ++course) {
    const bool shifted = wall.bond == Bond::running && course % 2 == 1;
    for (int j = 0; j < across; ++j) {
      for (int i = 0; i < n[along] + (shifted ? 1 : 0); ++i) {
        std::array<int, Dim> cell{};
        cell[along] = i;
        if constexpr (Dim == 3) cell[deep] = j;
        cell[up] = course;
        if (!shifted) {
          add(cell, i * (full + wall.gap), full);
        } else {
          // Half a brick, whole ones, half a brick: the course ends flush with its neighbours.
          const Real half = 0.5 * (full - wall.gap);
          const bool end = i == 0 || i == n[along];
          add(cell, i == 0 ? 0 : half + wall.gap + (i - 1) * (full + wall.gap), end ? half : full);
        }
      }
    }
  }
  return bricks;
}

template <int Dim>
Mesh<Dim> wall_mesh(const BrickWall& wall, const Sizing& sizing) {
  Mesh<Dim> mesh;
  for (const auto& brick : bricks_of<Dim>(wall)) {
    std::array<Layers, Dim> layers;
    for (std::size_t c = 0; c < Dim; ++c) {
      const int at = static_cast<int>(c);
      layers[c].n = sizing.count(c, brick.high[at] - brick.low[at]);
    }
    const Mesh<Dim> one = box_grid<Dim>(brick.low, brick.high, layers);
    const int first = static_cast<int>(mesh.nodes.size());
    mesh.nodes.insert(mesh.nodes.end(), one.nodes.begin(), one.nodes.end());
    for (auto corners : one.elements) {
      for (auto& corner : corners) corner += first;
      mesh.elements.push_back(corners);
      mesh.piece.push_back(static_cast<Label>(mesh.piece_names.size()));
    }
    mesh.piece_names.push_back(brick.name);
  }
  return mesh;
}

template std::vector<Brick<2>> bricks_of<2>(const BrickWall&);
template std::vector<Brick<3>> bricks_of<3>(const BrickWall&);
template Mesh<2> wall_mesh<2>(const BrickWall&, const Sizing&);
template Mesh<3> wall_mesh<3>(const BrickWall&, const Sizing&);

}  // namespace brunt
// Tested by tests/unit/core/shapes_test.cpp.
