#pragma once
#include <set>
#include <span>
#include <vector>

#include "contact/geometry/common_plane.hpp"
#include "contact/law/pair_table.hpp"
#include "contact/surfaces/face_side.hpp"
#include "contact/surfaces/nodes.hpp"
#include "contact/surfaces/ranks.hpp"
#include "core/step_limit.hpp"

namespace brunt {

struct FourPlanes;

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
  bool owned = true;                ///< pairs in which it is the lower face are evaluated here
  bool born = false;                ///< in the step under way
  Real stiffness = 0;               ///< [Pa/m] M/h
  Real areal_mass = 0;              ///< [kg/m^2]
  Real depth = 0;                   ///< [m]
  Real half_thickness = kInfinity;  ///< [m] before which particles have to turn; infinite: none
  Real element_step = 0;            ///< [s] h/c of what is behind
  Real area_start = 0;              ///< [m^2] at time 0
  Real phi = 0;                     ///< largest stiffness option with which anything may touch it
  Real phi_always = 0;              ///< that which bounds steps where nothing is near
  Real zeta = 0;                    ///< largest damping option
  Real recoil = 0;     ///< of free rigid bodies that may touch it (contact/law/springs.hpp)
  Real footprint = 0;  ///< [m^2] of the largest particle that may touch it
  Real capacity = 0;   ///< [J/m^2/K] or [kg/m^2] behind it, as of Facet; 0: takes no heat
  std::int32_t specific_heat = -1;  ///< among those of its surface's points, where it varies
  Real effusivity = 0;              ///< [J/m^2/K/s^(1/2)]
  Real compliance = 0;       ///< [1/kg] of the free rigid body behind it; 0: its nodes move each
  Real mean_compliance = 0;  ///< [1/kg] as of Facet
  bool held = false;         ///< bounds no step
  bool rigid() const { return stiffness == 0; }  ///< held or in prescribed motion
  bool deforms() const { return stiffness > 0 && compliance == 0; }
  /// Its springs bound the step.
  bool bounds_step() const { return deforms() && !held && area_start > 0; }
  bool everywhere = false;         ///< it stands on every rank
  bool open = false;               ///< of a surface with a rim, which has two sides for particles
  std::uint8_t borders = 0;        ///< as of Facet
  Real sharpness = kBoxSharpness;  ///< as of Facet
  LocalIndex facet = -1;           ///< its place in its surface; -1: only another rank has it
};

/// A quad that is in no list: what of it bounds the step and says how long the lists hold.
struct UnlistedQuad {
  std::array<LocalIndex, 4> node{};  ///< in ContactNodes
  LocalIndex face = 0;
  // Numbers in a row, which are read together.
  Real warp = 0;             ///< [m] when the lists were built
  Real wide_square = 0;      ///< [m^4] of twice an area up to which it allows `least`
  Real least = 0;            ///< [s] no longer than what it allows at this area or a smaller one
  Real area_start = 1;       ///< [m^2] at time 0
  Real footprint = 0;        ///< [m^2] as of its ContactFace
  Real phi = 0, zeta = 0;    ///< stiffness that bounds the step always, and damping
  Real longest = kInfinity;  ///< [s] h/c of what is behind; infinite: it bounds no step
};

/// What is asked of such a quad in each step, next to always for the last time: rounded so that
/// what it says of the others surely holds.
struct UnlistedSigns {
  std::array<LocalIndex, 4> node{};
  std::array<float, 4> limit{};  ///< `warp`, `wide_square` and `least`, rounded down; the last is 0
};

/// A quad in a list: what of it is read in each step and stays the same as long as the list does.
struct ListedQuad {
  std::array<LocalIndex, 4> node{};  ///< in ContactNodes
  LocalIndex face = 0;
  // Numbers in three rows of four, each of which is read together.
  Real area_start = 1;             ///< [m^2] at time 0
  Real footprint = 0;              ///< [m^2] as of its ContactFace
  Real phi = 0, zeta = 0;          ///< stiffness that bounds the step always, and damping
  Real longest = kInfinity;        ///< [s] h/c of what is behind; infinite: it bounds no step
  Real warp = 0;                   ///< [m] when the lists were built
  Real by_normal = 0, by_gap = 0;  ///< [m] how far its reach is wider than its box, beside its warp
  std::array<Real, 4> normal{};    ///< when the lists were built; the last is not used
};

/// The friction that a face carried at the last evaluation, which a new contact beside inherits.
template <int Dim>
struct FaceTraction {
  Real area = 0;                      ///< [m^2] that carries it
  Vec<Dim> force = Vec<Dim>::Zero();  ///< [N] on this face
  Real growth = 1;                    ///< [1] of its area in the last step
};

/// What faces carried, by id, ascending.
template <int Dim>
struct CarriedTractions {
  std::vector<GlobalId> face;
  std::vector<FaceTraction<Dim>> traction;
};

/// What of a face's plane says how it turned and warped.
template <int Dim>
struct FaceShape {
  Vec<Dim> normal;
  Real warp;  ///< [m]
};

/// What the springs of free rigid bodies say of steps, from their whole scene: constant.
struct RigidSprings {
  StepLimit step_limit;  ///< their own
  Real recoil = 0;       ///< largest (frequency)^2 dt^2/4 of them in the longest step of others
  std::set<Label> neighbours;  ///< bodies that deform, or of particles, and may touch them
  Real recoil_beside(Label body) const { return neighbours.count(body) != 0 ? recoil : 0.0; }
};

struct ContactParticle {
  LocalIndex node = 0;
  LocalIndex surface = 0;
  GlobalId id = 0;
  Label body = 0;
  Label piece = 0;
  Real radius = 0;                         ///< [m]
  const ParticleMatter* matter = nullptr;  ///< one of Entities::matters
  std::int32_t specific_heat = -1;         ///< among those of its surface's points, where it varies
  bool held = false;                       ///< bounds no step
  bool owned = true;                       ///< its row of candidates is evaluated here
  bool born = false;                       ///< in the step under way
};
static_assert(sizeof(ContactParticle) == 48, "there may be millions");

/// Penetration at which faces of one piece let go, in depths: there, what is seen from behind is
/// the other side of the material between them, which is thicker unless it is crushed.
inline constexpr Real kDeepestInside = 0.5;

/// How far a face may be penetrated along the normal of a common plane, in each component, per
/// depth: n = (n1 - n2) / |n1 - n2| and |n1 - n2| >= 1.476 where faces oppose each other.
inline constexpr Real kReachPerDepth = 0.68;
/// Corners of a face lie within 1.4 warps of its mean plane along such a normal.
inline constexpr Real kReachPerWarp = 1.4;

/// Bound of a particle on its own spring at a breadth of 1 m; that of a ring grows with its radius,
/// and its spring with it.
struct ParticleLimit {
  LocalIndex node = 0;
  Real radius = 0;  ///< [m] of the particle
  StepLimit of_unit_breadth;
  /// breadth  [m]
  StepLimit at(Real breadth) const {
    StepLimit limit = of_unit_breadth;
    limit.step /= std::sqrt(breadth);
    return limit;
  }
};

/// Everything that can touch, in the order of ids: so that an index stands for its key.
template <int Dim>
struct Entities {
  ContactNodes<Dim> nodes;
  std::vector<ContactFace<Dim>> faces;
  std::vector<ContactParticle> particles;
  std::set<ParticleMatter> matters;       ///< of particles, which point to them
  std::vector<char> near;                 ///< by body; empty: all are (search/near_bodies.hpp)
  std::vector<LocalIndex> near_faces;     ///< faces of near bodies, ascending
  std::vector<LocalIndex> listed_faces;   ///< those of them whose planes are read
  std::vector<ListedQuad> listed_quads;   ///< the quads of these, once lists are built; in fours
  std::vector<LocalIndex> listed_others;  ///< what is no quad
  std::vector<UnlistedQuad> unlisted;     ///< the others
  std::vector<UnlistedSigns>
      unlisted_signs;                   ///< of each; in fours, the last one as often as it takes
  std::vector<FacePlane<Dim>> planes;   ///< at nodes.x, of listed faces
  std::vector<FaceShape<Dim>> shapes;   ///< of each face when its lists were built
  Real warped = 0;                      ///< [m] largest growth of a warp since then
  Real turned = 0;                      ///< largest change of a normal since then
  std::vector<SearchBox<Dim>> boxes;    ///< of planes
  std::vector<SearchBox<Dim>> reaches;  ///< boxes wide enough for any face-on-face contact
  std::vector<FaceTraction<Dim>> tractions;  ///< of each face; empty where nothing has friction
  std::vector<FaceSide<Dim>> sides;   ///< of listed faces that carried friction, as they are now
  std::vector<std::int32_t> side_at;  ///< where each face stands among them; -1: nowhere
  /// Behind each face, as of the step's start; empty where no friction needs it.
  std::vector<SurfaceMaterial> materials;
  std::vector<char> conducts;        ///< by surface: its points keep the temperature
  StepLimit constant_limit;          ///< bound from the springs of particles, but rings
  std::vector<ParticleLimit> rings;  ///< in axisymmetry: particles, whose springs go with x
  StepLimit surface_limit;           ///< the same of faces, at the last planes
  Real deepest = 0;                  ///< [m] largest depth of a face of any rank
  Real shallowest = kInfinity;       ///< [m] smallest half thickness of the faces here
  /// [m] smallest penetration at which faces let go, of all ranks
  Real least_limit = kInfinity;
  Real longest_step = kInfinity;  ///< [s] no step is longer: that of the elements behind all faces
  Real size = 0;                  ///< [m] median size of faces and particles, of all ranks
  std::vector<Real> gaps;         ///< [m] by body, up to which heat passes to it; empty: none
  bool any_particles = false;     ///< on any rank
  bool any_open = false;          ///< faces of surfaces with a rim
  bool any_born = false;          ///< faces or particles in the step under way

  /// Nothing.
  Entities() = default;
  /// Particles point into `matters`.
  Entities(Entities&&) noexcept = default;
  Entities& operator=(Entities&&) noexcept = default;
  Entities(const Entities&) = delete;
  Entities& operator=(const Entities&) = delete;
  ~Entities() = default;
  /// Makes the tables of what this rank has that may touch anything. Collective.
  Entities(const std::vector<Surface<Dim>*>& surfaces, const PairTable& pairs,
           const Section& section, const ContactRanks& ranks, const RigidSprings& rigid);
  /// Takes in faces of other ranks, their nodes already among `nodes`, and sorts again.
  void add_faces(const std::vector<ContactFace<Dim>>& imported);
  /// Takes in particles of other ranks, their nodes already among `nodes`, and sorts again.
  void add_particles(const std::vector<ContactParticle>& imported);
  /// Place of the face or particle with an id; it is there.
  std::size_t face_with(GlobalId id) const;
  std::size_t particle_with(GlobalId id) const;
  /// True where a face with an id is here.
  bool has_face(GlobalId id) const {
    const std::size_t at = face_with(id);
    return at < faces.size() && faces[at].id == id;
  }
  /// Takes what friction needs to know of materials from the groups, for the faces that are here.
  void read_materials(const std::vector<Surface<Dim>*>& surfaces);
  /// What all faces carried at the last evaluation; nothing where nothing has friction.
  CarriedTractions<Dim> carried_tractions() const;
  /// Takes over what the same faces carried.
  void inherit_tractions(const CarriedTractions<Dim>& carried);
  /// What was born in this step has met what it overlaps.
  void end_births();
  /// As made anew where points are now, without what other ranks showed; what is booked and planes'
  /// numbers stay.
  void begin_motion(const std::vector<Surface<Dim>*>& surfaces);
  /// Leaves bodies that touch nothing alone: those with a 0; with no entry there are none.
  void choose(const std::vector<char>& of_bodies);
  bool is_near(Label body) const { return near.empty() || (body < near.size() && near[body] != 0); }
  /// Planes and boxes of listed faces at nodes.x, and what all near faces say of steps and of
  /// motion. Until lists are built all are listed.
  void refresh_planes();
  /// Planes and boxes of the near faces that are not listed, too.
  void refresh_unlisted_planes();
  /// Lists are built now: `shapes` of the planes. Faces that are in no list are left alone.
  /// in_lists  by face
  void mark_planes(const std::vector<char>& in_lists);
  /// `sides` of listed faces that carried friction at the last evaluation. Others may come to.
  void refresh_sides();
  /// That of a face; null where it is not known.
  const FaceSide<Dim>* side_of(std::size_t face) const {
    return side_at[face] < 0 ? nullptr : &sides[slot_of(side_at[face])];
  }
  /// `reaches` of listed faces, once their planes are there; listed quads have theirs with these.
  void refresh_reaches();
  /// Widest opening [m] through which heat passes to a body.
  Real gap(Label body) const { return body < gaps.size() ? gaps[body] : 0.0; }
  /// Bound from the springs of faces and particles at the last planes, before anything touches
  /// (docs/theory/contact.md (C39)).
  StepLimit stiffness_limit() const;
  /// [m/s] mean over the corners of a face.
  Vec<Dim> face_velocity(std::size_t face) const {
    const auto& one = faces[face];
    Vec<Dim> sum = Vec<Dim>::Zero();
    for (std::size_t c = 0; c < slot_of(one.n_nodes); ++c) {
      sum += nodes.v[slot_of(one.node[c])];
    }
    return sum / one.n_nodes;
  }

 private:
  /// What planes say as a whole.
  struct Seen {
    StepLimit step_limit;
    Real warped = 0, turned_square = 0;
    void take(const Seen& other);
  };
  /// Nodes of the corners and particles, which name points until then, and of what has gone.
  void number_nodes(const std::vector<Surface<Dim>*>& surfaces);
  void find_near();
  void drop_imports();
  void take_corners(std::size_t face);
  void refresh_plane(std::size_t face);
  bool are_quads(const LocalIndex* four) const;
  void refresh_four_quads(const LocalIndex* four);
  void refresh_some_planes(std::span<const LocalIndex> some);
  void compare_with_lists(std::size_t face, Seen& seen) const;
  void look_at(std::size_t face, Seen& seen) const;
  void look_at_four(const LocalIndex* face, Seen& seen) const;
  void refresh_listed_quads(std::size_t first, std::size_t last, Seen& seen);
  void look_at_listed(const ListedQuad* four, const FourPlanes& now, Seen& seen);
  SearchBox<Dim> reach_of(std::size_t face) const;
  void look_at_unlisted(std::size_t first, std::size_t last, Seen& seen) const;
  void clear_lists();
  ListedQuad listed_quad(LocalIndex face) const;
  UnlistedQuad unlisted_quad(LocalIndex face) const;

  std::size_t own_nodes_ = 0;  // before those that other ranks showed
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
