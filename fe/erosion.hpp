#pragma once
/// Elements that go while a run is under way: docs/theory/elements.md, section 9.
#include <map>
#include <memory>

#include "core/surface.hpp"
#include "fe/element_block.hpp"

namespace brunt {

/// What is kept of an element that has gone, by ascending id, the same on all ranks.
struct ErodedElement {
  GlobalId id = 0;
  Label body = 0;
  bool conducts = false;
  Real mass = 0;                              ///< [kg]
  Real energy = 0;                            ///< [J] that left: work of stresses less plastic heat
  Real heat = 0, compression = 0;             ///< [J] plastic heat, and that of compression
  Real hourglass_work = 0, viscous_work = 0;  ///< [J]
};

/// What is kept of a point that went with its elements.
struct GonePoint {
  GlobalId id = 0;
  Real energy = 0;  ///< [J] kinetic
};

/// True where the state of an element says that it goes; its shape is not looked at.
template <int Dim>
bool has_failed(const ElementBlock<Dim>& block, LocalIndex e);

/// The particle that a node becomes about which no element is left.
struct FreePoint {
  Real radius = 0;                        ///< [m]
  Real modulus = 0;                       ///< [Pa]
  Real conductivity = 0, effusivity = 0;  ///< [W/m/K], [J/m^2/K/s^(1/2)]
  SurfaceMaterial material;               ///< of its body at time 0: what has failed has no state
};

/// The whole mesh of a group, on every rank, without the state of its elements; which of them have
/// gone; and what a rank needs to take its part anew.
template <int Dim>
struct ErosionState {
  Points<Dim> start;                      ///< id and x [m] alone, at time 0
  std::vector<ElementBlock<Dim>> blocks;  ///< all elements there ever were, without state
  std::vector<Facet<Dim>> facets;         ///< outer ones of the whole, as it is now
  std::vector<LocalIndex> axis;           ///< of the whole
  std::vector<FreePoint> free;            ///< by point of the whole
  std::map<Label, ErodeTo> to;            ///< of bodies that erode
  std::vector<ErodedElement> eroded;
  std::vector<GonePoint> gone;
  std::size_t n_alive = 0;
  StepLimit start_step;           ///< of all elements at time 0
  std::vector<int> owner;         ///< rank of each point of the whole
  std::vector<LocalIndex> place;  ///< here, of each point of the whole; -1: elsewhere
  int rank = 0;
  bool any_born = false;

  bool has_gone(GlobalId element) const;
  /// The blocks of what is left.
  std::vector<ElementBlock<Dim>> left() const;
  /// A step for free points, where no element bounds one any more.
  StepLimit when_all_have_gone() const { return n_alive == 0 ? start_step : StepLimit{}; }
};

/// The state of erosion at time 0 of a whole group; null where nothing erodes.
template <int Dim>
std::unique_ptr<ErosionState<Dim>> erosion_at_start(const std::vector<ElementBlock<Dim>>& blocks,
                                                    const Points<Dim>& points,
                                                    const Surface<Dim>& surface);

}  // namespace brunt
// Tested by tests/unit/fe/erosion_test.cpp.
