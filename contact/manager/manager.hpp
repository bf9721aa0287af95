#pragma once
#include <memory>
#include <string>
#include <vector>

#include "contact/contacts/lost.hpp"
#include "contact/law/options.hpp"
#include "contact/manager/reach.hpp"
#include "core/ledger.hpp"
#include "core/parallel/partition.hpp"
#include "core/solid.hpp"
#include "core/step_limit.hpp"
#include "core/surface.hpp"
#include "core/view.hpp"

namespace brunt {

/// What history.csv prints of one pair of bodies; sums are exact. "The first body" is the one that
/// the pair's `between` names first, without a name of its own the first of the deck.
struct PairReport {
  std::string name;             ///< the deck's, or "a-b"
  std::array<Real, 3> force{};  ///< [N] on the first body
  /// [N m] on the first body; in 2D z alone, and none where the section is axisymmetric.
  std::array<Real, 3> torque{};
  Real area = 0;           ///< [m^2] of planes under pressure, or dp^(Dim-1) a particle contact
  Real heat_rate = 0;      ///< [W] across the contact into the first body, without friction
  Real friction_heat = 0;  ///< [W] over the last step
  /// [K] of both sides, by the area of each contact, of all through which heat passes, or where
  /// none does of all that carry force: of faces there, of particles at their centres. 0 where
  /// there is none, or none keeps a temperature.
  Real temperature_max = 0, temperature_mean = 0;
  Real max_penetration = 0;  ///< [m]
  std::int64_t planes = 0;   ///< common planes and particle contacts that carry force
};

/// A pair of bodies with contacts that did not hold.
struct LostPair {
  std::string name;  ///< as in PairReport
  LostReport lost;
};

/// Contacts of a pair of bodies that overlap at time 0 and are not felt until they have opened.
struct InitialOverlaps {
  std::string name;          ///< of the pair, as in PairReport
  std::size_t contacts = 0;  ///< pairs of faces, and particles on surfaces
  Real deepest = 0;          ///< [m]
};

struct OneSidedPair {
  std::string name;  ///< of the pair, as in PairReport
  Label open;        ///< body of the surface
};

/// A pair that is tied or a joint.
struct HeldPair {
  std::string name;        ///< as in PairReport
  std::size_t places = 0;  ///< that are held
  /// [Pa/m] the slope from which a joint goes on along a line, where its curve or its own stiffness
  /// would soon be steeper; 0: it would not.
  Real stiffest = 0;
  Real times_elements = 0;  ///< [1] that slope over the elements of both sides in series
};

/// How much work the contact lists were; it says nothing about the answer.
struct ContactWork {
  std::size_t builds = 0;      ///< of the lists, since time 0
  std::size_t candidates = 0;  ///< in the present lists
  std::size_t contacts = 0;    ///< that carry force now
  Real skin = 0;               ///< [m]
  std::size_t near_faces = 0;  ///< of bodies that may touch others soon
};

/// The one contact manager: automatic pairing of all surfaces, common planes for face on face, the
/// corrected penalty for particle on face. Adds nodal forces in the order of keys.
template <int Dim>
class ContactManager {
 public:
  /// surfaces stay owned by their solids and outlive the manager; body_names by label.
  /// depth [m] is that of a plane strain deck; axisymmetric forces are those of the whole ring.
  ContactManager(ContactOptions options, Geometry geometry, std::vector<Surface<Dim>*> surfaces,
                 std::vector<std::string> body_names, Real depth = 1);
  /// The part of a whole, at time 0, that this rank evaluates: pairs whose lower face or whose
  /// particle it owns. surfaces  this rank's, in the order of the whole's. partition and ranks
  /// outlive the manager. From here on rearrange, add_forces and reports are collective.
  ContactManager(const ContactManager& whole, std::vector<Surface<Dim>*> surfaces,
                 const Partition& partition, const Communicator& ranks);
  ~ContactManager();

  /// Step limits before the step, from each face's own spring and from near pairs
  /// (docs/theory/contact.md (C39) to (C44)).
  StepLimit stable_step() const;
  /// Reads the surfaces anew and rebuilds the lists; what is booked stays with the points' ids.
  void rearrange();
  /// Before the first step: where bodies press at time 0, accelerations of their points and the
  /// energy of their springs. True where they do: what moves rigid bodies takes the forces on their
  /// points. Collective.
  bool start();
  /// Reads x(n+1) and v(n+1/2), and rebuilds lists that may miss a contact there. Collective.
  void renew_lists(Real dt);
  /// Forces at x(n+1) with v(n+1/2); books contact.spring and contact.damping. Renews the lists
  /// first where nobody has for this step. time  [s] of x(n+1), for reports of lost contacts
  void add_forces(Real dt, Real time = 0);
  /// Heat of the contacts of this step, after all other heat but that which holds temperatures.
  /// Collective among neighbours.
  void add_heat(Real dt);
  /// Throws PhysicsError where the last evaluation found a coefficient of friction below 0 or not
  /// finite; it has also allowed no step. origin  [m] of the positions. Not collective.
  void check(Real time, const Vec<Dim>& origin) const;
  void add_totals(Totals<Dim>& totals) const;
  /// Forces and energies of the owned points that contact moves.
  void save_state(std::vector<StateTable>& tables) const;
  /// Takes contact back to a saved state; the surfaces are there already. Lists are built, records
  /// and step limits evaluated anew at the positions and mid-step velocities of the last
  /// evaluation. Throws StateError where a row is missing.
  void load_state(const StateTables& tables);
  /// One for each pair with columns in history.csv (PairTable::reported), in ascending order.
  /// origin  [m] of the positions, in the coordinates about whose origin torques are taken
  std::vector<PairReport> reports(const Vec<Dim>& origin = Vec<Dim>::Zero()) const;
  /// Pairs in which contacts did not hold since time 0, in ascending order. Collective.
  std::vector<LostPair> lost_pairs(const Vec<Dim>& origin = Vec<Dim>::Zero()) const;
  /// How many pairs of bodies may touch.
  std::size_t n_pairs() const;
  /// What of the overlaps of time 0 is left, of the contacts evaluated here; pairs without are left
  /// out. Not collective.
  std::vector<InitialOverlaps> initial_overlaps() const;
  /// Pairs in which faces of elements may touch a surface with a rim: they meet its front alone,
  /// where particles meet both sides. Not collective.
  std::vector<OneSidedPair> one_sided_pairs() const;
  /// Pairs that the deck names, and that are tied or a joint. Not collective.
  std::vector<HeldPair> held_pairs() const;
  /// Contacts of the last evaluation; positions relative to the scene's origin; normal from
  /// body_a to body_b, force on body_b.
  ContactView view() const;
  std::size_t n_facets() const;
  ContactWork work() const;
  /// Cost of each owned point of each surface here, about [ns].
  std::vector<std::vector<Real>> point_work() const;
  /// Where each face and particle may touch, and what touches: what a partition would have to
  /// carry.
  ContactReaches<Dim> reaches() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace brunt
