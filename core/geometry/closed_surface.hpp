#pragma once
#include <array>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// The room that a closed surface of triangles bounds, such as an STL file holds.
class ClosedSurface {
 public:
  /// nodes [m]; triangles run counter-clockwise seen from outside, or all of them clockwise.
  /// cell [m]  width of the columns in which triangles are looked up: about the distance of points
  /// Throws std::invalid_argument where the surface is open, where neighbouring triangles face
  /// opposite ways, or where it bounds no volume.
  ClosedSurface(std::vector<Vec3> nodes, std::vector<std::array<int, 3>> triangles, Real cell);

  /// How often the surface goes round a point: 1 inside and 0 outside, 2 where two shells overlap.
  /// Counts the triangles below it by the sides that they show. A vertical line through an edge or
  /// a corner is taken for one beside it, the same one for all triangles (Edelsbrunner & Muecke
  /// 1990, Simulation of simplicity): it meets each triangle or does not, and what is closed is
  /// counted right.
  int winding(const Vec3& x) const;

  /// The rooms that it bounds: what hangs together at nodes and faces outwards, with the hollows in
  /// it. What lies free in a hollow is a room of its own.
  std::size_t n_rooms() const { return n_rooms_; }
  /// The room, from 0 as their first triangles come, that holds a point of winding 1.
  Label room_at(const Vec3& x) const;

  Real volume() const { return volume_; }   ///< [m^3]
  const Vec3& low() const { return low_; }  ///< [m] of the box that holds it
  const Vec3& high() const { return high_; }

 private:
  void require_closed() const;
  void sort_into_columns(Real cell);
  std::size_t column_of(Real x, int axis) const;
  void find_rooms();
  Label shell_round(const Vec3& x, const std::vector<Real>& volume) const;
  template <class Visit>
  void visit_below(const Vec3& x, const Visit& visit) const;

  std::vector<Vec3> nodes_;
  std::vector<std::array<int, 3>> triangles_;
  Real volume_ = 0;
  Vec3 low_, high_;
  std::array<Real, 2> width_{};            ///< [m] of a column
  std::array<std::size_t, 2> count_{};     ///< columns along x and y
  std::vector<std::vector<int>> columns_;  ///< triangles that reach into each
  std::vector<Label> room_;                ///< of each triangle
  std::size_t n_rooms_ = 1;
};

}  // namespace brunt
