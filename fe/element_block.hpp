#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "core/materials/initial_stress.hpp"
#include "core/materials/initial_temperature.hpp"
#include "core/materials/material.hpp"
#include "core/points.hpp"
#include "core/step_limit.hpp"
#include "fe/assumed_strain.hpp"
#include "fe/formulation.hpp"
#include "fe/options.hpp"
#include "fe/shape.hpp"

namespace brunt {

/// The nodes of one element of any kind.
struct ElementCorners {
  std::array<LocalIndex, kMostCorners> node{};
  std::size_t n = 0;

  ElementCorners() = default;
  template <std::size_t N>
  ElementCorners(const std::array<LocalIndex, N>& corners) : n(N) {
    std::copy(corners.begin(), corners.end(), node.begin());
  }
  std::size_t size() const { return n; }
  LocalIndex* begin() { return node.data(); }
  LocalIndex* end() { return node.data() + n; }
  const LocalIndex* begin() const { return node.data(); }
  const LocalIndex* end() const { return node.data() + n; }
  LocalIndex& operator[](std::size_t I) { return node[I]; }
  LocalIndex operator[](std::size_t I) const { return node[I]; }
};

/// Elements of one formulation and one law, over all bodies: what the scene hands in.
template <int Dim>
struct ElementSet {
  std::vector<ElementCorners> corners;  ///< nodes of each element
  std::vector<GlobalId> id;             ///< unique in the scene, below 2^61; blocks sort by it
  std::vector<Label> body;
  std::vector<Label> piece;
  std::vector<char> owned;  ///< 0: another rank counts it; empty: all are owned
  const Material* material = nullptr;
  ElementOptions options;
  Real temperature = 293.15;  ///< [K] at time 0; where it depends on the place, their mean
  bool adiabatic = false;     ///< mechanical work heats the element at once
  bool conducts = false;      ///< nodes have the temperature; mechanical work heats them
  bool held = false;          ///< nothing of it ever moves: only its heat is computed
  bool rigid = false;  ///< as held, without mass, its facets rigid; it has a prescribed motion
  const InitialStress* stress = nullptr;  ///< at time 0; null: none. It outlives the elements
  /// At time 0, over the place; null: one for all. It outlives the elements.
  const InitialTemperature* temperature_field = nullptr;
};

/// What the out-of-plane direction adds: an element of area A about radius r fills A (c + s r).
/// 3d: (1, 0); plane strain: (depth [m], 0); axisymmetric: (0, 2 pi).
struct Thickness {
  Real constant = 1;
  Real radial = 0;
};
Thickness thickness_of(Geometry geometry, Real depth);

/// Nodes on the axis of an axisymmetric scene, ascending: radius below 1e-12 of the largest. They
/// stay there: no radial force acts on them.
template <int Dim>
std::vector<LocalIndex> axis_nodes(const Points<Dim>& points, const Thickness& thickness);

/// Whether a tile lies still (fe/rest.hpp).
enum class Rest : char {
  unknown,     ///< no step has computed it yet
  unstrained,  ///< it had not moved since time 0 when it was computed last
  moved,       ///< it has
};

/// Elements whose points stand side by side: those of Gauss point 0 of all, then of point 1.
inline constexpr int kGroup = 8;

/// The elements of one set with their state, padded to whole tiles of kTile material points by
/// repeating the last element. Point g of element e stands at (e/8) 8G + 8 g + e mod 8, so that
/// eight elements fill a Wide and a tile holds kTile/G elements, G the points of an element.
template <int Dim>
struct ElementBlock {
  static constexpr int kHourglassValues = Shape<Dim>::kHourglass * Dim;

  const Formulation<Dim>* formulation = nullptr;
  const Material* material = nullptr;
  ElementOptions options;  ///< resolved: nothing is automatic
  int corners = 0;         ///< of an element
  int gauss = 1;           ///< material points of an element
  bool adiabatic = false;
  bool conducts = false, held = false, rigid = false;
  Real temperature = 0;                   ///< [K] what the law sees where the state has none
  const InitialStress* stress = nullptr;  ///< at time 0; null: none
  const InitialTemperature* temperature_field = nullptr;  ///< the same; null: `temperature`
  LocalIndex n = 0;                                       ///< elements
  LocalIndex n_padded = 0;
  std::size_t first_corner = 0;        ///< of this block in the buffer of corner forces
  std::vector<LocalIndex> corner;      ///< node of each corner, n_padded x corners
  std::vector<GlobalId> id;            ///< n_padded
  std::vector<Label> body, piece;      ///< n_padded
  std::vector<char> owned;             ///< n; 0: computed here too, counted by another rank
  MaterialState state;                 ///< n_padded x gauss points
  std::vector<Real> reference_volume;  ///< [m^3] of each material point, free of stress
  std::vector<Real> element_volume;    ///< [m^3] of each element, free of stress: V0
  std::vector<Real> reference_size;    ///< [m] volume^(1/3), area^(1/2) in 2D, at time 0
  std::vector<Real> mass;              ///< [kg] of each element, with what scaling added
  std::vector<Real> mass_scale;        ///< [1] mass over that of the material; empty: 1
  /// Where pressure is of volumes about nodes: their mean ratio to those free of stress at n, of
  /// each element.
  std::vector<Real> volume_ratio;
  /// Viscous control: [N] generalised forces Q at n, kHourglassValues x n_padded.
  std::vector<Real> hourglass;
  std::vector<Real> hourglass_stiffness;  ///< [N/m] stiffness control: of each element
  /// Where the material yields: from where on its shape is looked at [m^2], see guard_shapes.
  std::vector<Real> guard_reach;
  BendingModuli bending;               ///< assumed-strain control
  std::vector<Real> viscous_pressure;  ///< [Pa] bulk viscosity q at n
  std::vector<Real> stress_work;       ///< [J] of each element since time 0
  std::vector<Real> hourglass_work;    ///< [J]
  std::vector<Real> viscous_work;      ///< [J]
  std::vector<Real> stable_step;       ///< [s] bound of each element
  std::vector<Rest> rest;              ///< of each tile
  /// Where it conducts: share of its volume [1] that each corner stands for at time 0: of its heat
  /// capacity, and of the mechanical heat; see `heat_share_at`.
  std::vector<Real> heat_share;
  /// [J] plastic and compression heat that nodes have been given; empty where neither arises
  std::vector<Real> heat_given;

  /// To be said where the state is changed by anything but a step.
  void wake() { std::fill(rest.begin(), rest.end(), Rest::unknown); }
  /// [kg] without what scaling added.
  Real material_mass(std::size_t e) const {
    return mass_scale.empty() ? mass[e] : mass[e] / mass_scale[e];
  }
  int elements_per_tile() const { return kTile / gauss; }
  int n_tiles() const { return n_padded / elements_per_tile(); }
  std::size_t point(LocalIndex e, int g) const {
    return slot_of(e / kGroup) * kGroup * gauss + kGroup * g + e % kGroup;
  }
  /// Where corner I of element e stands in `heat_share`: those of kGroup elements side by side.
  std::size_t heat_share_at(std::size_t e, std::size_t I) const {
    return ((e / kGroup) * slot_of(corners) + I) * kGroup + e % kGroup;
  }
  std::span<const LocalIndex> corners_of(LocalIndex e) const {
    const auto n_corners = slot_of(corners);
    return {corner.data() + slot_of(e) * n_corners, n_corners};
  }
};

/// Builds the state of a set at the positions of its points; forces are zero.
/// Throws PhysicsError where an element has no positive volume, and InitialStressError or
/// InitialTemperatureError where its material cannot begin with those of the set.
template <int Dim>
ElementBlock<Dim> make_block(const ElementSet<Dim>& set, const Points<Dim>& points,
                             const Thickness& thickness);

/// Writes the mass [kg] that each corner of element e carries: equal shares, and in axisymmetry
/// with several Gauss points the row sums rho int N_I dV, with which alone a plane wave along the
/// axis stays plane.
template <int Dim>
void corner_masses(const ElementBlock<Dim>& block, LocalIndex e, const Points<Dim>& points,
                   const Thickness& thickness, Real* share);

/// The part of an element's volume that each corner stands for, int N_I dV / V, in the places of
/// ElementBlock::heat_share_at: so its heat capacity is shared.
template <int Dim>
std::vector<Real> corner_shares(const ElementBlock<Dim>& block, const Points<Dim>& points,
                                const Thickness& thickness);

/// Positions of the corners of one element [m].
template <int Dim>
struct CornerPositions {
  std::array<Vec<Dim>, kMostCorners> x;
  std::size_t n = 0;

  const Vec<Dim>* data() const { return x.data(); }
  std::size_t size() const { return n; }
  const Vec<Dim>* begin() const { return x.data(); }
  const Vec<Dim>* end() const { return x.data() + n; }
  Vec<Dim>& operator[](std::size_t I) { return x[I]; }
  const Vec<Dim>& operator[](std::size_t I) const { return x[I]; }
};
template <int Dim>
CornerPositions<Dim> corner_positions(const ElementBlock<Dim>& block, LocalIndex element,
                                      const Points<Dim>& points) {
  CornerPositions<Dim> places;
  for (const LocalIndex node : block.corners_of(element)) places.x[places.n++] = points.x[node];
  return places;
}

}  // namespace brunt
