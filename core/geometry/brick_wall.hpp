#pragma once
#include "core/geometry/mesh.hpp"

namespace brunt {

/// One brick of a wall: opposite corners [m] and its name "wall.i.j(.k)" without the wall's.
template <int Dim>
struct Brick {
  Vec<Dim> low, high;
  std::string name;
};

/// All bricks of a wall. Courses are stacked along the last axis, or the last but one where they
/// run along the last; running bond shifts every second course by half a brick and closes its ends
/// with half bricks.
template <int Dim>
std::vector<Brick<Dim>> bricks_of(const BrickWall& wall);

/// Each brick with nodes of its own and a piece label.
template <int Dim>
Mesh<Dim> wall_mesh(const BrickWall& wall, const Sizing& sizing);

}  // namespace brunt
