#pragma once
#include <memory>
#include <string>
#include <vector>

#include "core/ledger.hpp"
#include "core/parallel/ghosts.hpp"
#include "core/parallel/partition.hpp"
#include "core/search/pair_count.hpp"
#include "core/state.hpp"
#include "core/step_limit.hpp"
#include "core/surface.hpp"
#include "core/view.hpp"

namespace brunt {

/// What mass scaling added to a body.
struct AddedMass {
  Real added = 0, material = 0;     ///< [kg]
  std::size_t n_scaled = 0, n = 0;  ///< elements
};

/// A group of material points with its blocks of elements or particles: what FE, SPH and rigid
/// surfaces have in common. Virtual calls are per group per step, never per point.
template <int Dim>
class Solid {
 public:
  virtual ~Solid() = default;
  /// The part of this group, which is whole and at time 0, that the calling rank computes;
  /// partition and ranks outlive it. Collective.
  virtual std::unique_ptr<Solid> part(const Partition& partition,
                                      const Communicator& ranks) const = 0;
  virtual Points<Dim>& points() = 0;
  virtual const Points<Dim>& points() const = 0;
  /// Facets and particles that may touch other bodies; stays valid between rearrangements.
  virtual Surface<Dim>& surface() = 0;
  /// After any motion, before update_state: rebuilds lists that may miss a pair at these positions.
  /// FE: nothing. Collective where the group is.
  virtual void renew_lists() {}
  /// After any motion of a step of dt [s], before anything reads the surface: elements that have
  /// failed go, and what they covered comes to the surface. Collective where some may.
  virtual void erode(Real /*dt*/) {}
  /// Recomputes what neighbours will read, at x(n+1) with v(n+1/2). FE: nothing.
  virtual void update_state(Real dt) = 0;
  /// Adds internal forces to points().f and books each channel's energy to its entity.
  virtual void add_internal_forces(Real dt) = 0;
  /// Adds the heat that neighbours conduct and plastic work gives to the points' heat_rate, and to
  /// their conductance. Groups without temperature: nothing. Collective where the group is.
  virtual void add_conduction(Real) {}
  /// The group's own bound, without `safety`. Called at the head of a step.
  virtual StepLimit stable_step() const = 0;
  /// Rebuilds lists at the present positions. Reads and writes lists and places, nothing else.
  virtual void rearrange() = 0;
  /// The same before the first step: lists of the building stay where they hold.
  virtual void begin_lists() { rearrange(); }
  /// Adds internal energies of entities, by column and body, and their state hash.
  /// Kinetic energy, mass and momentum of points are added by the scene.
  virtual void add_totals(Totals<Dim>& totals) const = 0;
  /// Every 100 steps and at frames: throws PhysicsError on NaN or inversion (with time 0; the
  /// loop fills in time and body's name from label).
  virtual void check(Real time, const std::vector<std::string>& body_names) const = 0;
  /// What may help where an element is crushed, sheared or torn, as options of its body leave it
  /// open; empty where it is not owned here.
  virtual std::string advice(GlobalId) const { return {}; }
  /// Positions, connectivity and the wanted fields of one body.
  virtual BodyView view(Label body, const WantedFields& wanted) const = 0;
  BodyView view(Label body) const { return view(body, {}); }
  /// How the motion of copies of points follows their owners; empty where there are none.
  virtual const GhostPlan& ghosts() const = 0;
  /// Brings to the copies what update_state published. Collective.
  virtual void refresh_state() {}
  /// True where its points are those of another group, which carries, moves and loads them.
  virtual bool rides() const { return false; }
  /// What mass scaling added to the elements of a body that this rank counts.
  virtual AddedMass added_mass(Label) const { return {}; }
  /// Elements and particles that this rank counts.
  virtual std::size_t n_elements() const = 0;
  virtual std::size_t n_particles() const = 0;
  /// Pairs of the present neighbour lists that this rank counts.
  virtual PairCount pair_count() const { return {}; }
  /// Cost of each owned point, in a unit of the group's own; points() order.
  virtual std::vector<Real> point_work() const = 0;
  /// Adds tables of all that the group carries from step to step, owned points and all elements.
  virtual void save_state(std::vector<StateTable>& tables) const = 0;
  /// Takes every point and element back to a saved state, by id; lists are as old as before. Throws
  /// StateError where a row is missing; then only a complete load makes the group whole.
  virtual void load_state(const StateTables& tables) = 0;
};

}  // namespace brunt
