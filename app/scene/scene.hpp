#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/heat_windows.hpp"
#include "app/scene/phases.hpp"
#include "app/scene/pieces.hpp"
#include "app/scene/probes.hpp"
#include "app/scene/sections.hpp"
#include "contact/manager/manager.hpp"
#include "core/boundaries/boundaries.hpp"
#include "core/boundaries/loads.hpp"
#include "core/boundaries/rigid_motions.hpp"
#include "core/errors.hpp"
#include "core/materials/initial_stress.hpp"
#include "core/materials/initial_temperature.hpp"
#include "core/materials/material.hpp"
#include "core/rigid/free_bodies.hpp"
#include "core/solid.hpp"

namespace brunt {

/// Points of a body by the name that its mesh file gives them, ids ascending.
struct PointSet {
  Label body = 0;
  std::string name;
  std::vector<GlobalId> points;
};

/// Everything that moves: groups of points with their blocks, contact, supports and loads.
/// A scene holds only what its deck names.
template <int Dim>
struct Scene {
  Scene(Vec<Dim> at, Geometry of, Real thick) : geometry(of), depth(thick), origin(at) {}

  Geometry geometry;
  Real depth;                           ///< [m] plane strain
  Vec<Dim> origin;                      ///< [m] positions are relative to it
  std::vector<std::string> body_names;  ///< by label
  std::vector<NamedPiece> pieces;       ///< by label of piece
  /// [m] by label: the smallest size of its elements or particles; 0: it has none
  std::vector<Real> body_size;
  std::vector<char> erodes;           ///< by label: elements of the body may go
  std::vector<char> converts;         ///< by label: elements of the body may become particles
  std::vector<MirrorPlanes> mirrors;  ///< [m] by label, absolute
  std::vector<PointSet> point_sets;
  std::vector<Label> sum_of_body;  ///< first of the bodies whose particles share one sum
  std::vector<std::unique_ptr<Material>> materials;
  std::vector<std::unique_ptr<InitialStress>> initial_stress;  ///< by label; null: none
  /// By label; null: one temperature, or none.
  std::vector<std::unique_ptr<InitialTemperature>> initial_temperature;
  std::vector<std::unique_ptr<Solid<Dim>>> solids;
  std::unique_ptr<ContactManager<Dim>> contact;  ///< absent where nothing can touch
  RigidMotions<Dim> rigid_motions;
  /// [m] by label, at time 0: of bodies that are held or have a prescribed motion
  std::map<Label, Vec<Dim>> rigid_centers;
  Boundaries<Dim> boundaries;
  Loads<Dim> loads;
  std::unique_ptr<FreeBodies<Dim>>
      rigid;  ///< absent where all rigid bodies have a prescribed motion
  Sections<Dim> sections;
  std::vector<Probe> probes;
  Phases phases;
  std::vector<std::string> notes;  ///< of its building, for the log
  HeatWindows heat_windows;        ///< of evaluations of conduction
  const Communicator* ranks = &lone_rank();
  std::unique_ptr<const Partition> partition;  ///< whose each point is; none on a lone rank
  WallTime loop;  ///< of all steps, whatever they are spent on; what comes before the first aside

  /// The smallest step limit of this rank, and whose. Not collective.
  StepLimit stable_step(Real time, const StepLimit& of_heat) const;
  /// True where some group has temperatures.
  bool conducts() const;
  /// After the motion of a step of dt [s]: elements that have failed go, and boundaries let go of
  /// what went with them. Collective, as all that follows.
  void erode(Real dt);
  /// Positions, velocities and temperatures of copies, from their owners. Collective, as all that
  /// follows.
  void refresh_motion();
  /// Conduction, and what boundaries do to it, after all other heat of a step; time is that of its
  /// end.
  void add_heat(Real time, Real dt);
  /// The longest step that heat allows of the owned points of this rank, and whose it is; infinite
  /// where none flows.
  StepLimit heat_step() const;
  /// Says whether `step` [1] since time 0 evaluates conduction, and for how many steps it acts.
  /// time   [s] at its begin
  /// bound  [s] the least heat_step of all ranks
  void begin_heat(std::int64_t step, Real time, Real dt, Real bound);
  /// Rebuilds all lists: at the start. In a step solids and contact rebuild their own where they
  /// may miss a pair, after the motion; no answer depends on when.
  void rearrange();
  /// Exact totals of all columns and bodies, and the state hash where it is asked for; dt is that
  /// of the last step.
  Totals<Dim> totals(Real dt, bool hashes) const;
  /// Throws PhysicsError where a state is no longer a number or an element is inverted.
  void check(Real time) const;
  /// True where check would not throw: for checkpoints and repartitions, which come at times of
  /// the machine: they must not decide when a run breaks.
  bool is_sound(Real time) const;
  /// What may help where a step limit has collapsed. Collective.
  std::string advice(const StepLimit& step_limit) const;
  /// The whole body on the root, absolute positions; elsewhere empty. Of several ranks a view has
  /// the fields `id` too, by which it is put together.
  BodyView view(Label body, const WantedFields& wanted = {}) const;
  /// What this rank has of it, copies of points included; absolute positions. Not collective.
  BodyView own_view(Label body, const WantedFields& wanted = {}) const;
  /// The same of a body or one piece of it, by its name; that of no part is empty.
  BodyView part_view(const std::string& name, const WantedFields& wanted = {}) const;
  BodyView own_part_view(const std::string& name, const WantedFields& wanted = {}) const;
  /// The same of the particles that elements of the body have become, with the name
  /// "BODY.particles".
  BodyView own_converted(Label body, const WantedFields& wanted = {}) const;
  ContactView own_contacts() const;
  /// Tables of all that goes on from step to step.
  void save_state(std::vector<StateTable>& tables) const;
  /// Takes the scene back to a saved state and rebuilds its lists there. Throws StateError where a
  /// row is missing; then only a complete load makes the scene whole again.
  void load_state(const StateTables& tables);

  std::size_t n_points() const;
  std::size_t n_elements() const;
  std::size_t n_particles() const;

 private:
  /// What this rank's part of a check finds. Not collective.
  std::optional<PhysicsFailure> own_failure(Real time) const;
  /// Several ranks want `id` besides: views of theirs are merged by it.
  WantedFields with_ids(WantedFields fields) const;
};

}  // namespace brunt
