#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "core/parallel/communicator.hpp"
#include "core/solid.hpp"

namespace brunt {

/// A plane of the material of a body at time 0.
template <int Dim>
struct MaterialSection {
  std::string name;
  /// The groups of the body, by their places in the scene: its elements or particles, and the
  /// particles that its elements become.
  std::vector<std::size_t> solids;
  Label body = 0;
  int axis = 0;
  Real at = 0;  ///< [m] points with a larger coordinate at time 0 are beyond it; as x_start is
};

/// What a section carries: the force [N] that the material beyond it exerts on the material before
/// it, so that tension is positive along the axis, and its moment [N m] about the origin of the
/// deck's coordinates.
struct SectionForce {
  std::array<Real, 3> force{}, moment{};
};

/// Forces through sections. Internal forces of elements and of pairs of particles are balanced, so
/// that their sum over all points beyond a plane is what passes through it: of finite elements what
/// those that the plane cuts give to their corners beyond it, of particles the forces of pairs
/// across it, each with all its channels. Moments of particles are as good as their pairs' forces
/// are central.
template <int Dim>
class Sections {
 public:
  void add(MaterialSection<Dim> section) { all_.push_back(std::move(section)); }
  /// The points of group `riders` act for those of group `solid`, on which they ride.
  void join(std::size_t solid, std::size_t riders);
  const std::vector<MaterialSection<Dim>>& all() const { return all_; }

  /// Before and after the internal forces of a group in a step: what they add to its points.
  void before_internal(std::size_t solid, const Points<Dim>& points);
  void after_internal(std::size_t solid, const Points<Dim>& points);
  /// Of the last step; 0 before the first. Exact sums. Collective.
  SectionForce force(const MaterialSection<Dim>& section,
                     const std::vector<std::unique_ptr<Solid<Dim>>>& solids, const Vec<Dim>& origin,
                     const Communicator& ranks) const;

 private:
  bool cuts(std::size_t solid) const;
  std::vector<MaterialSection<Dim>> all_;
  std::vector<std::vector<Vec<Dim>>> internal_;  // [N] by group that a section cuts, by owned point
};

}  // namespace brunt
