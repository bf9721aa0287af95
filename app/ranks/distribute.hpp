#pragma once
#include "app/scene/scene.hpp"

namespace brunt {

/// All points of a whole scene at time 0, by id, with the work that hangs on each.
template <int Dim>
struct WeighedPoints {
  std::vector<Vec<Dim>> x;   ///< [m]
  std::vector<Real> weight;  ///< [hexes], about
};
template <int Dim>
WeighedPoints<Dim> weighed_points(const Scene<Dim>& scene);

/// Turns a whole scene at time 0, which every rank has built, into the part that this rank
/// computes; supports and loads keep what is owned here. Collective; nothing on a lone rank.
template <int Dim>
void distribute(Scene<Dim>& scene, const Communicator& ranks,
                std::unique_ptr<const Partition> partition);

/// The same by a first partition: recursive bisection, weighted by the elements and particles that
/// hang on the points.
template <int Dim>
void distribute(Scene<Dim>& scene, const Communicator& ranks);

}  // namespace brunt
