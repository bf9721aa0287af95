#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/ledger.hpp"
#include "core/parallel/communicator.hpp"
#include "core/rigid/rigid_body.hpp"
#include "core/rigid/rigid_surfaces.hpp"
#include "core/state.hpp"
#include "core/step_limit.hpp"

namespace brunt {

/// A rigid body of which something follows its forces: all of it, or some components of its
/// velocity, and then it turns as prescribed.
template <int Dim>
struct FreeBody {
  RigidBody state;
  Label body = 0, piece = 0;
  RigidMotion<Dim> prescribed;      ///< of what is not free
  std::array<bool, Dim> free{};     ///< components of its velocity
  bool turns = false;               ///< it turns by its torques, else as prescribed
  Vec3 turns_about = Vec3::Ones();  ///< [1] 1 of axes that torques turn it about, 0 of others
  Vec3 center = Vec3::Zero();       ///< [m] of mass, at time 0
  Vec3 load_force = Vec3::Zero();   ///< [N] accumulated: what acts on it as a whole
  Vec3 load_torque = Vec3::Zero();  ///< [N m] about its centre
  Vec3 force = Vec3::Zero();        ///< [N] of its points and loads, at the last full step
  Vec3 torque = Vec3::Zero();       ///< [N m] about its centre, the same
  Vec3 start_spin = Vec3::Zero();   ///< [rad/s] as this step began and ends
  Vec3 end_spin = Vec3::Zero();
  Vec3 point_force = Vec3::Zero();   ///< [N] of its points alone, at the last full step
  Vec3 point_torque = Vec3::Zero();  ///< [N m]
  Vec3 reaction = Vec3::Zero();      ///< [N] of what prescribes components
  Real integration = 0;              ///< [J] booked since time 0
  Real boundary = 0;                 ///< [J]

  bool is_free(int c) const { return free[c]; }
};

/// All rigid bodies that follow their forces. Every rank has all of them and steps them by the
/// same sums, bit by bit; a force on one of their points is kept by the point's owner.
///
/// Energy: forces at points work along chords, 1/2 (f(n) + f(n+1)).dx, and that is what contact
/// books; the body takes 1/2 dt ((F + F').v + T.omega(n) + T'.omega(n+1)) of it, which is what its
/// own scheme makes of forces and torques. The two differ by the square of the angle of a step:
/// booked to `integration`, or to `boundary` where a support turns the body.
template <int Dim>
class FreeBodies {
 public:
  /// groups  whose points with the `piece` of a body are its own, all of them or those that stand
  ///         here; outlive this
  FreeBodies(const std::vector<Points<Dim>*>& groups, std::vector<FreeBody<Dim>> bodies);

  /// From now on those of their points that were among `old` are those of `now`.
  void follow(const Points<Dim>& old, Points<Dim>& now);
  /// Velocities of the points at time 0.
  void start();
  /// Takes the forces that points have at time 0, of what presses from the start. Collective.
  void press(const Communicator& ranks);
  /// Kicks bodies, moves them and their points, also copies; loads and sums are 0 after it.
  /// time [s] at the end of the step.
  void predict(Real time, Real dt, Real dt_last);
  /// Sums the forces of all points and what loads gave; books their work. Collective: one
  /// reduction.
  void collect_forces(const Communicator& ranks, Real time, Real dt);
  /// The second kick; bodies and points have the velocities of the whole step.
  void correct(Real dt);
  /// What a free body allows of the step: it shall not turn by more than 0.2 rad.
  StepLimit stable_step() const;
  /// Adds what owned points have booked.
  void add_totals(Totals<Dim>& totals) const;
  /// Adds masses, momenta and energies of the bodies, and their state hash: every rank has them,
  /// and one of them adds them.
  void add_body_totals(Real dt, Totals<Dim>& totals) const;
  void save_state(std::vector<StateTable>& tables) const;
  void load_state(const StateTables& tables);  ///< throws StateError

  std::span<const FreeBody<Dim>> all() const { return bodies_; }
  std::span<FreeBody<Dim>> all() { return bodies_; }

 private:
  /// What it keeps of the points of one group.
  struct Group {
    Points<Dim>* points = nullptr;
    std::vector<LocalIndex> chosen = {};    // points of these bodies, copies too
    std::vector<std::size_t> body_of = {};  // of each of them
    std::vector<Vec3> arm = {};             // [m] from the centre, of each of them
    std::vector<Vec<Dim>> last_force = {};  // [N] at the last full step
    std::vector<Real> work = {};            // [J] of its forces along its chords
  };
  struct Sums;
  void find_points(Group& group);
  static void add_forces(Real dt, Group& group, std::vector<Sums>& sums);
  void impose(FreeBody<Dim>& body, Real time, Real dt, Vec3& chords);
  Vec3 prescribed_center(const FreeBody<Dim>& body, const RigidPose<Dim>& pose) const;
  std::vector<Sums> sum_forces(const Communicator& ranks, Real dt);
  static void take_forces(const Sums& sums, FreeBody<Dim>& body);
  void book_forces(const Sums& sums, Real time, Real dt, FreeBody<Dim>& body);
  template <class Velocity>
  void place_points(const Velocity& velocity);

  /// How the points of each body were last placed.
  struct Placed {
    bool at_rest = false;
    Vec3 x = Vec3::Zero();
    Eigen::Quaternion<Real> turn = Eigen::Quaternion<Real>::Identity();
  };
  std::vector<Placed> placed_;
  std::vector<Group> groups_;
  std::vector<FreeBody<Dim>> bodies_;
};

}  // namespace brunt
