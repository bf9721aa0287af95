#pragma once
/// What elements that become particles hand over: plain data between groups that do not know each
/// other. docs/theory/elements.md, section 9.
#include <vector>

#include "core/surface.hpp"

namespace brunt {

/// The part of an element that has failed which one of its nodes takes over.
struct ConvertedShare {
  GlobalId point = 0;       ///< the node
  GlobalId element = 0;     ///< where it comes from
  Real volume = 0;          ///< [m^3] at time 0
  Real ratio = 1;           ///< [1] of its present volume to that
  Real work = 0;            ///< [J] of stresses since time 0, plastic heat included
  std::vector<Real> state;  ///< of its material point, in the order of visit_material_point
};

/// A group of nodes that particles ride on once their elements have failed: the nodes keep mass,
/// motion and heat, and take the forces and the heat of the particles.
template <int Dim>
class ParticleCarrier {
 public:
  virtual ~ParticleCarrier() = default;
  virtual Points<Dim>& carrying_points() = 0;
  /// What owned nodes took over in this step, by node and then by element.
  virtual const std::vector<ConvertedShare>& converted() const = 0;
  /// True where nodes of any rank took over something in this step.
  virtual bool any_converted() const = 0;
  /// What contact sees of the material of each owned node that is a particle, which riders know
  /// better; null where it does not ask.
  virtual std::vector<SurfaceMaterial>* shown_materials() = 0;
};

}  // namespace brunt
