#pragma once
#include <span>
#include <vector>

#include "contact/common_plane.hpp"
#include "contact/pair_table.hpp"
#include "contact/ranks.hpp"
#include "core/step_vote.hpp"

namespace brunt {

/// The points that contact moves, of all groups, side by side, with what must outlive a step.
/// Corners of imported faces may be points that this rank does not have.
template <int Dim>
struct ContactNodes {
  std::vector<LocalIndex> surface;  ///< whose points
  std::vector<LocalIndex> point;    ///< index there; -1: only another rank has it
  std::vector<char> owned;          ///< this rank sums and books its forces
  std::vector<GlobalId> id;
  std::vector<Real> mass;                           ///< [kg]
  std::vector<Vec<Dim>> x;                          ///< [m] at the last evaluation
  std::vector<Vec<Dim>> v;                          ///< [m/s] at the last evaluation
  std::vector<Vec<Dim>> spring, damping;            ///< [N] forces of this evaluation
  std::vector<Vec<Dim>> spring_last, damping_last;  ///< [N] of the one before
  std::vector<Real> spring_energy, damping_energy;  ///< [J] booked since time 0
  bool rubs = false;                 ///< some pair has friction; else the fields below are empty
  std::vector<Vec<Dim>> friction;    ///< [N] of this evaluation
  bool warm = false;                 ///< some points conduct; else the fields below are empty
  std::vector<Real> temperature;     ///< [K] at the end of the step, but for contact
  std::vector<Real> capacity;        ///< [J/K]; 0: takes no heat
  std::vector<Real> heat_rate;       ///< [W] of this evaluation
  std::vector<Real> ended_heat;      ///< [J] of friction that ended in this step
  std::vector<Real> friction_given;  ///< [J] of friction, to any nodes, booked since time 0
  std::vector<Real> friction_heat, friction_stored, friction_damped,
      pair_energy;  ///< [J] booked since time 0

  std::size_t size() const { return point.size(); }
  LocalIndex add(LocalIndex on_surface, LocalIndex at_point, const Points<Dim>& points);
  /// A point of another rank; [kg], [m], [m/s].
  LocalIndex add_remote(LocalIndex on_surface, GlobalId of, Real m, const Vec<Dim>& at,
                        const Vec<Dim>& velocity);
  /// Takes x and v of the points that are here from the groups.
  void read_motion(const std::vector<Surface<Dim>*>& surfaces);
  /// The temperatures that owned points will have after dt by the heat they have so far.
  void foresee_temperatures(const std::vector<Surface<Dim>*>& surfaces, Real dt);
  /// Takes over what outlives a step from the same points in an older table.
  void inherit(const ContactNodes& old);
};

/// One outer face, by its nodes in ContactNodes.
template <int Dim>
struct ContactFace {
  static constexpr int kCorners = Facet<Dim>::kNodes;
  std::array<LocalIndex, kCorners> node{};
  int n_nodes = kCorners;
  LocalIndex surface = 0;
  GlobalId id = 0;
  Label body = 0;
  Label piece = 0;
  bool owned = true;    ///< pairs in which it is the lower face are evaluated here
  Real stiffness = 0;   ///< [Pa/m] M/h
  Real areal_mass = 0;  ///< [kg/m^2]
  Real depth = 0;       ///< [m]
  Real area_start = 0;  ///< [m^2] at time 0
  Real phi = 0;         ///< largest stiffness option with which anything may touch it
  Real zeta = 0;        ///< largest damping option
  Real footprint = 0;   ///< [m^2] of the largest particle that may touch it
  Real capacity = 0;    ///< [J/m^2/K] behind it; 0: takes no heat
  Real effusivity = 0;  ///< [J/m^2/K/s^(1/2)]
  Real compliance = 0;  ///< [1/kg] of the free rigid body behind it; 0: its nodes move each
  bool held = false;    ///< votes no step
  bool rigid() const { return stiffness == 0; }  ///< held or moved as told
  /// Faces of rigid bodies stand on every rank.
  bool everywhere() const { return rigid() || compliance > 0; }
};

/// The friction that a face carried at the last evaluation, which a new contact beside inherits.
template <int Dim>
struct FaceTraction {
  Real area = 0;                      ///< [m^2] that carries it
  Vec<Dim> force = Vec<Dim>::Zero();  ///< [N] on this face
};

struct ContactParticle {
  LocalIndex node = 0;
  LocalIndex surface = 0;
  GlobalId id = 0;
  Label body = 0;
  Label piece = 0;
  Real radius = 0;        ///< [m]
  Real modulus = 0;       ///< [Pa]
  Real conductivity = 0;  ///< [W/m/K]; 0: takes no heat
  Real effusivity = 0;    ///< [J/m^2/K/s^(1/2)]
  bool held = false;      ///< votes no step
};

/// Entities below which a team of threads costs more than it saves.
inline constexpr std::size_t kWorthThreads = 1000;

/// How far a face may be penetrated along the normal of a common plane, in each component, per
/// depth: n = (n1 - n2) / |n1 - n2| and |n1 - n2| >= 1.476 where faces oppose each other.
inline constexpr Real kReachPerDepth = 0.68;
/// Corners of a face lie within 1.4 warps of its mean plane along such a normal.
inline constexpr Real kReachPerWarp = 1.4;

/// Everything that can touch, in the order of ids: so that an index stands for its key.
template <int Dim>
struct Entities {
  ContactNodes<Dim> nodes;
  std::vector<ContactFace<Dim>> faces;
  std::vector<ContactParticle> particles;
  std::vector<FacePlane<Dim>> planes;        ///< of each face, at nodes.x
  std::vector<Vec<Dim>> face_velocity;       ///< [m/s] mean over the corners
  std::vector<SearchBox<Dim>> boxes;         ///< of planes
  std::vector<SearchBox<Dim>> reaches;       ///< boxes wide enough for any face-on-face contact
  std::vector<FaceTraction<Dim>> tractions;  ///< of each face; empty where nothing rubs
  StepVote constant_vote;      ///< bound from the springs of particles and of free rigid bodies
  Real deepest = 0;            ///< [m] largest depth of a face of any rank
  Real size = 0;               ///< [m] median size of faces and particles, of all ranks
  bool any_particles = false;  ///< on any rank

  /// Makes the tables of what this rank has that may touch anything. Collective.
  Entities(const std::vector<Surface<Dim>*>& surfaces, const PairTable& pairs,
           const Section& section, const ContactRanks& ranks);
  /// Takes in faces of other ranks, their nodes already among `nodes`, and sorts again.
  void add_faces(const std::vector<ContactFace<Dim>>& imported);
  /// Place of the face or particle with an id; it is there.
  std::size_t face_with(GlobalId id) const;
  std::size_t particle_with(GlobalId id) const;
  /// Takes over what the same faces remember in an older table.
  void inherit_tractions(const Entities& old);
  /// Planes, velocities and boxes of all faces at nodes.x, nodes.v.
  void refresh_planes();
  /// Bound from the faces' own springs, before anything touches (physics.md A5).
  StepVote stiffness_vote() const;
};

}  // namespace brunt
