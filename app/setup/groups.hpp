#pragma once
#include <memory>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/setup/bodies.hpp"
#include "app/setup/heat.hpp"

namespace brunt {

/// Next free ids of the scene: points, and elements with rigid facets; and the ids that points of
/// named sets have got.
struct NextIds {
  GlobalId point = 0;
  GlobalId element = 0;
  std::vector<PointSet> sets;
};

/// Puts all bodies of one kind into one group: points and elements along a space-filling curve at
/// time 0, ids ascending along it. `none` where the deck has no such body. The bodies forget their
/// meshes.
template <int Dim>
std::unique_ptr<Solid<Dim>> make_elements(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                          std::vector<BodyGeometry<Dim>>& bodies, GroupKind kind,
                                          NextIds& next);
template <int Dim>
std::unique_ptr<Solid<Dim>> make_particles(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                           std::vector<BodyGeometry<Dim>>& bodies, GroupKind kind,
                                           NextIds& next);
/// Rigid bodies that do not conduct: those whose surfaces are held at a temperature, or the others.
template <int Dim>
std::unique_ptr<RigidSurfaces<Dim>> make_rigid(const LoadedDeck& loaded, const Scene<Dim>& scene,
                                               const std::vector<BodyGeometry<Dim>>& bodies,
                                               bool heated, NextIds& next);

}  // namespace brunt
