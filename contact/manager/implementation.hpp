#pragma once
#include "contact/contacts/memory.hpp"
#include "contact/evaluate/evaluate.hpp"
#include "contact/manager/manager.hpp"
#include "contact/search/near_bodies.hpp"
#include "core/errors.hpp"

namespace brunt {

/// What the manager holds.
template <int Dim>
struct ContactManager<Dim>::Implementation {
  Implementation(const ContactOptions& of_options, const Section& of_section, PairTable of_pairs,
                 std::vector<Surface<Dim>*> of_surfaces, const ContactRanks& of_ranks)
      : options(of_options),
        section(of_section),
        ranks(of_ranks),
        surfaces(std::move(of_surfaces)),
        pairs(std::move(of_pairs)),
        entities(surfaces, pairs, section, ranks, rigid),
        imports(ranks, surfaces),
        candidates(options.search, options.skin) {}

  /// Tables anew with what free rigid bodies say of steps. Collective.
  void take_rigid(const RigidSprings& of_scene);
  /// The longest step that may follow one of dt, 0 for the first: that of the springs, and four
  /// times dt where particles must look ahead.
  StepLimit longest_after(Real dt) const;
  /// How far ahead [s] speed limits look after a step of dt: the same on all ranks.
  Real look_ahead(Real dt, const StepLimit& longest) const;
  /// Finds the bodies that may touch others; true where they are not the same as before.
  /// Collective.
  bool find_near_bodies(Real ahead);
  /// Tables and lists anew at the present positions; what is booked stays with the points' ids.
  /// with_motion: velocities are those of the step under way, else of the last evaluation.
  void renew(Real ahead, bool with_motion);
  /// Records and step limits of the lists at the present motion; friction goes on from its past, or
  /// is left out where there is none: at time 0, and where the last evaluation is repeated.
  void evaluate(Real dt, const StepLimit& longest, Real ahead, FrictionHistory<Dim>* past);
  /// Reads what friction asks of materials at the start of the step. Collective among neighbours.
  void read_materials();
  /// Remembers a coefficient of friction that is no number at least 0, and allows no step.
  void refuse_friction(const ContactRecord<Dim>& record, const Friction<Dim>& friction);
  /// Books what friction did in this step, and what the faces carry from now on. Collective.
  void end_friction();
  /// Where bodies press at time 0: accelerations of their points, and what the springs hold, from
  /// the records. Collective.
  void press_at_start();
  /// Puts together what both sides of each contact of particles leave for heat. Collective among
  /// neighbours.
  void complete_pair_heat();
  /// What each face carries, from the records of all ranks. Collective.
  void sum_tractions();

  ContactOptions options;
  Section section;
  ContactRanks ranks;
  std::vector<Surface<Dim>*> surfaces;
  PairTable pairs;
  RigidSprings rigid;  // of all ranks
  Entities<Dim> entities;
  ContactImports<Dim> imports;
  NearBodies<Dim> near;
  Candidates<Dim> candidates;
  Records<Dim> records;
  std::vector<ParticleLoad> loads;  // by particle; empty where no row of pairs is there
  std::vector<PairSide> sides;      // by candidate of pairs; empty where nothing conducts
  ContactMemory<Dim> memory;
  std::vector<EndedHeat> ended_heat;  // of the step under way
  /// The first coefficient of friction of the last evaluation that is none, with its contact.
  std::optional<PhysicsFailure> wrong_friction;
  Vec<Dim> wrong_friction_at = Vec<Dim>::Zero();  // [m]
  StepLimit step_limit;
  Real dt_last = 0;      // [s] of the last evaluation
  Real ahead_last = 0;   // [s] that the lists had to serve at the last evaluation
  bool started = false;  // forces have been evaluated
  WallTime list_time;    // within add_forces, not taken yet
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
