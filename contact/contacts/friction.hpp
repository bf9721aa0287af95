#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "contact/contacts/keyed_memory.hpp"
#include "contact/geometry/body_turn.hpp"
#include "contact/law/pair_laws.hpp"
#include "contact/surfaces/entities.hpp"

namespace brunt {

/// What the spring-slider of one contact remembers from step to step.
/// A particle counts its forces instead of tractions: its area is its share [1].
template <int Dim>
struct FrictionMemory {
  ContactKey key;
  Label body = 0, piece = 0;  ///< the surface on which a particle slides
  Vec<Dim> normal = Vec<Dim>::Zero();
  Vec<Dim> traction = Vec<Dim>::Zero();  ///< [Pa] on the upper side, in the plane
  Vec<Dim> drag = Vec<Dim>::Zero();      ///< [Pa] of the damper that acts where it sticks
  Real area = 0;                         ///< [m^2] that carries it
  Real stiffness = 0;                    ///< [Pa/m]
  Real heat_share = 0;                   ///< [1] share of its heat that goes to its nodes
  Real taken = 0;      ///< [J] half of what its forces take from the motion of the step under way
  bool slips = false;  ///< in the last step
  LocalIndex book_surface = 0;  ///< the node to which its energies are booked, by its name
  GlobalId book_point = 0;

  Vec<Dim> slider() const { return area * traction; }              ///< [N] on the upper side
  Vec<Dim> resultant() const { return area * (traction + drag); }  ///< [N]
  Real energy() const {                                            ///< [J] in the spring
    return stiffness > 0 ? area * traction.squaredNorm() / (2 * stiffness) : 0.0;
  }
  /// [J] where the contact ends in the step under way: a slip that turns back in it heats nothing.
  Real last_heat() const { return slips ? std::max(taken, 0.0) : 0.0; }
};

/// The friction of one contact: what it remembers, and what it does to the nodes.
template <int Dim>
struct Friction : FrictionMemory<Dim> {
  static constexpr int kNodes = 2 * Facet<Dim>::kNodes;
  /// Written out: else emplace_back sets all bytes to 0 first, one by one.
  Friction() {
    for (auto& one : force) one.setZero();
  }
  Real heat = 0;                      ///< [J] of the last step: -(F(n) + F(n+1))/2 . slip, >= 0
  Real damped = 0;                    ///< [J] by the drag in the last step
  Real stored = 0;                    ///< [J] gained by the spring in the last step
  Real pairs = 0;                     ///< [J] what changes of the contact itself took from motion
  Real coefficient = 0;               ///< [1] of the last step
  ContactState state;                 ///< at which `coefficient` was found
  Vec<Dim> point = Vec<Dim>::Zero();  ///< [m] where the force acts
  int n_nodes = 0;
  std::array<LocalIndex, kNodes> node{};
  std::array<Vec<Dim>, kNodes> force;      ///< [N] on each node
  std::array<Real, kNodes> heat_shares{};  ///< [1] share of its heat that goes to each node

  static constexpr const char* kTable = "contact.friction";
  template <class Visitor, class AnyFriction>
  static void visit(Visitor& visitor, AnyFriction& one) {
    visitor.carry(one.body, one.piece, one.normal, one.point, one.traction, one.drag, one.area,
                  one.stiffness, one.n_nodes, one.slips, one.heat_share, one.heat);
    for (auto& on_node : one.force) visitor.carry(on_node);
    for (auto& share : one.heat_shares) visitor.carry(share);
    visitor.hash(one.area, one.traction);
  }
};

/// Heat of friction that has ended, for one point. By its name: new lists may not have it any more.
struct EndedHeat {
  ContactKey key;
  LocalIndex surface = 0;
  GlobalId point = 0;
  Real heat = 0;  ///< [J]
};

/// What contacts remember from the step before, in the order of keys. Look-ups go in that order
/// too: `from` is where the search begins, 0 at first, then as the last call left it.
template <int Dim>
class FrictionHistory {
 public:
  void clear() { past_.clear(), used_.clear(), heated_.clear(), first_heated_.clear(); }
  /// Takes the friction in, with -dt/2 f . v of its old forces; nodes are still those of its step.
  void add(const Friction<Dim>& friction, const ContactNodes<Dim>& nodes, Real dt);
  /// The past of two faces or particles; none: nullptr. It counts as continued.
  const FrictionMemory<Dim>* of_faces(const ContactKey& key, std::size_t& from);
  /// The past of a particle on a surface: on the same face, else on the one whose normal was
  /// nearest and which no other contact of the particle continues.
  const FrictionMemory<Dim>* of_particle(const ContactKey& key, Label body, Label piece,
                                         const Vec<Dim>& normal, std::size_t& from);
  /// ended(friction) sees what was not continued, in the order of keys.
  template <class Ended>
  void visit_ended(const Ended& ended) const {
    for (std::size_t i = 0; i < past_.size(); ++i) {
      if (!used_[i]) ended(past_[i]);
    }
  }
  /// What was taken by what was slipping and was not continued, for the points that it heated, in
  /// the order of keys.
  std::vector<EndedHeat> ended_heat() const;

 private:
  /// The first that is not before a key; none is before `from` and after it.
  std::size_t place_of(const ContactKey& key, std::size_t from) const;

  std::vector<FrictionMemory<Dim>> past_;
  std::vector<char> used_;
  /// A point that friction heats.
  struct Heated {
    LocalIndex surface;
    GlobalId point;
    Real share;  // [1] of the heat
  };
  std::vector<Heated> heated_;             // by what slipped
  std::vector<std::size_t> first_heated_;  // of each of past_
};

/// One side of a contact: its nodes first .. last in the record. A side that turns shares the
/// couple of friction among its nodes, and its spin moves the point of contact.
struct ContactSide {
  int first = 0, last = 0;
  bool turns = false;
};

template <int Dim>
struct ContactRecord;

/// What friction needs to know of a contact besides its record.
template <int Dim>
struct FrictionStep {
  const PairLaws* laws = nullptr;  ///< with friction
  ContactSide lower, upper;
  /// The faces of these sides, where they are known (Entities::side_of); null: of their nodes.
  const FaceSide<Dim>*lower_face = nullptr, *upper_face = nullptr;
  std::array<Real, Friction<Dim>::kNodes> weight{};  ///< of the nodes, each side's sum to one
  Vec<Dim> point = Vec<Dim>::Zero();                 ///< [m] where the force acts
  Real area = 0;        ///< [m^2] that carries traction; of a particle its share [1]
  Real pressed = 0;     ///< [m^2] area under pressure
  bool bonded = false;  ///< its bond holds
  Real stiffness = 0;   ///< [Pa/m] of the tangential spring; of a particle [N/m]
  Real damping = 0;     ///< [Pa s/m] where it sticks; of a particle [N s/m]
  Real dt = 0;          ///< [s]
  /// Of both sides together: their mean temperature, and the flow stress of the softer one. Set
  /// where the laws need it.
  SurfaceMaterial material;
  const FrictionMemory<Dim>* before = nullptr;
  Real kept = 1;  ///< [1] part of the past traction that is left once its area has changed
  Vec<Dim> inherited = Vec<Dim>::Zero();  ///< [Pa] where there is no past
  /// The turn of the material on both sides, where no plane of the contact gives it.
  const BodyTurn<Dim>* turn = nullptr;
};

/// Finds the friction of a contact at the end of a step. The slip is that of the two points of
/// contact less what the turn of the plane makes of their distance; forces of each side have the
/// couple of a force at `point`, shared as f_a = w_a F + (J^-1 (arm x F)) x r_a
/// (docs/theory/contact.md (C34)), so that the moment of both sides is zero to round-off. friction
/// out; fresh
template <int Dim>
void find_friction(const ContactNodes<Dim>& nodes, const ContactRecord<Dim>& record,
                   const FrictionStep<Dim>& step, Friction<Dim>& friction);

}  // namespace brunt
