#pragma once
#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "core/points.hpp"

namespace brunt {

/// Sharpness of a box: the sine of half a right angle.
inline constexpr Real kBoxSharpness = 0.70710678118654752440;

/// One outer face: an edge in 2D; in 3D a quad, or a triangle whose fourth node is -1.
/// Nodes run so that the normal points out of the body: in 3D by the right-hand rule, in 2D the
/// body lies to the left of the edge from node 0 to node 1 (normal = (dy, -dx)).
template <int Dim>
struct Facet {
  static constexpr int kNodes = Dim == 2 ? 2 : 4;
  std::array<LocalIndex, kNodes> node{};
  GlobalId id = 0;  ///< element id << 3 | face; unique in the scene
  Label body = 0;
  Label piece = 0;
  /// [Pa/m] M over h, the depth of the element behind it, or the width of the face where that is
  /// less, M = K + 4G/3; 0: rigid. A slender element's width bounds its step anyway, so that its
  /// spring may be as stiff, and overlaps have to be shallow against the width of a face.
  Real stiffness = 0;
  Real areal_mass = 0;  ///< [kg/m^2] rho h / 2 of the element behind; 0: rigid
  /// [m] penetration at which it lets go: at the birth of the face h, half of it where the
  /// element's other face is free too, or the width of the face where that is less; rigid: 0
  Real depth = 0;
  /// [m] of a closed rigid body: to the middle between the facet and what lies opposite; infinite:
  /// thick, open or no rigid body (core/rigid/half_thickness.hpp)
  Real half_thickness = kInfinity;
  /// [J/m^2/K] rho cp h / 2 of the element behind; [kg/m^2] rho h / 2 where its cp varies; 0: takes
  /// no heat
  Real capacity = 0;
  std::int32_t specific_heat = -1;  ///< of those of its points, where cp varies
  Real effusivity = 0;              ///< [J/m^2/K/s^(1/2)] sqrt(k rho cp) at time 0
  Real temperature = 0;  ///< [K] of its body at time 0, which lasts where nothing heats it
  /// [1/kg] the most with which a free rigid body gives way to a force at one of its corners, of
  /// all directions, turning too; 0: its points move by themselves, or as prescribed
  Real compliance = 0;
  /// [1/kg] the same of the whole body, by area, on springs of all of its surface at once
  Real mean_compliance = 0;
  bool open = false;  ///< of a surface with a rim: both of its sides can be touched
  /// Bit c: the surface ends at its edge from corner c to the next (2D: at c); 4 + c: as a blade
  std::uint8_t borders = 0;
  /// [1] sine of half the sharpest angle of the body at one of its corners; as of a box where that
  /// is blunter
  Real sharpness = kBoxSharpness;
  bool owned = true;  ///< this rank evaluates the pairs in which it is the lower face
  bool born = false;  ///< in this step: contact takes no notice of what it overlaps by then
  int n_nodes() const { return Dim == 3 && node[kNodes - 1] < 0 ? 3 : kNodes; }
  bool rigid() const { return stiffness == 0; }  ///< held or in prescribed motion
};

/// The mean of the corners of a facet [m]. x  positions of points
template <int Dim>
Vec<Dim> facet_center(const Facet<Dim>& facet, const std::vector<Vec<Dim>>& x) {
  Vec<Dim> sum = Vec<Dim>::Zero();
  for (int c = 0; c < facet.n_nodes(); ++c) sum += x[slot_of(facet.node[c])];
  return sum / facet.n_nodes();
}

/// What particles are made of, as contact sees it: the same of all particles of a body but those
/// that eroded elements of several materials leave.
struct ParticleMatter {
  Real modulus = 0;       ///< [Pa] M = K + 4G/3
  Real conductivity = 0;  ///< [W/m/K] at time 0; 0: takes no heat
  Real effusivity = 0;    ///< [J/m^2/K/s^(1/2)] at time 0
  auto operator<=>(const ParticleMatter&) const = default;
};

/// A particle that can touch faces.
struct SurfaceParticle {
  LocalIndex point = 0;
  bool born : 1 = false;          ///< as that of a facet
  std::uint32_t matter : 31 = 0;  ///< place among those of its surface
  Real radius = 0;                ///< [m] half its spacing
};
static_assert(sizeof(SurfaceParticle) == 16, "there may be millions");

/// What friction needs to know of the material behind a facet, or of a particle.
struct SurfaceMaterial {
  Real temperature = 0;          ///< [K]; not read where the points of the surface conduct
  Real flow_stress = kInfinity;  ///< [Pa] infinite: it never yields
};

/// What a group shows to contact: plain data.
template <int Dim>
struct Surface {
  Points<Dim>* points = nullptr;
  std::vector<Facet<Dim>> facets;
  std::vector<SurfaceParticle> particles;
  std::vector<ParticleMatter> matters;  ///< of its particles; few
  std::vector<LocalIndex> axis;         ///< points on the axis of an axisymmetric scene, ascending
  bool held = false;                    ///< its points never move: it bounds no step
  bool everywhere = false;              ///< all of its facets stand on every rank
  /// Bodies of elements whose nodes become particles where these erode.
  std::vector<Label> may_free;
  /// One more particle.
  /// radius [m]; born  in the step under way
  void add_particle(LocalIndex point, Real radius, const ParticleMatter& matter,
                    bool born = false) {
    particles.push_back({point, born, place_of(matter), radius});
  }
  /// Place among `matters` of one that is sought there, or added.
  std::uint32_t place_of(const ParticleMatter& matter) {
    const auto at = std::find(matters.rbegin(), matters.rend(), matter);
    if (at != matters.rend()) return static_cast<std::uint32_t>(matters.rend() - at - 1);
    matters.push_back(matter);
    return static_cast<std::uint32_t>(matters.size() - 1);
  }
  /// Owned points that went with their elements: contact keeps what it has booked to them.
  std::vector<LocalIndex> gone;
  /// Facets or particles have come or gone since contact last read them, on all ranks alike.
  bool changed = false;
  bool erodes = false;         ///< facets may go, on any rank
  std::vector<GlobalId> died;  ///< of the facets those that went in this step, ascending
  bool needs_spin = false;     ///< contact reads `spin`
  /// [rad/s] of the material about each owned point of a group of particles, half the curl of its
  /// velocity at mid-step; in 2D z alone. Empty where it is not asked for.
  std::vector<Vec3> spin;
  bool needs_material = false;  ///< contact reads what follows
  /// Of each facet, as the last update_state found it; empty where nothing yields or is heated.
  std::vector<SurfaceMaterial> facet_material;
  /// Of each owned point of a group of particles; empty where it is not asked for.
  std::vector<SurfaceMaterial> particle_material;
};

}  // namespace brunt
