#pragma once
#include <vector>

#include "contact/geometry/motion_bounds.hpp"
#include "contact/surfaces/node_run.hpp"
#include "core/field_use.hpp"
#include "core/parallel/threads.hpp"
#include "core/surface.hpp"

namespace brunt {

/// Entities below which a team of threads costs more than it saves.
inline constexpr std::size_t kWorthThreads = 1000;

/// Bounds over n nodes; take(i, bounds) adds node i.
template <int Dim, class Take>
MotionBounds<Dim> bounds_of(std::size_t n, const Take& take) {
  MotionBounds<Dim> all;
  on_threads(n > kWorthThreads, [&] {
    MotionBounds<Dim> part;
#pragma omp for schedule(static) nowait
    for (std::size_t i = 0; i < n; ++i) take(i, part);
#pragma omp critical(brunt_contact_bounds)
    all.take(part);
  });
  return all;
}

/// The points that contact moves, of all groups, side by side, with what must outlive a step.
/// Corners of imported faces may be points that this rank does not have.
template <int Dim>
struct ContactNodes {
  std::vector<LocalIndex> surface;  ///< whose points
  std::vector<LocalIndex> point;    ///< index there; -1: only another rank has it
  std::vector<char> owned;          ///< this rank sums and books its forces
  std::vector<GlobalId> id;
  std::vector<Real> mass;                 ///< [kg]
  std::vector<Vec<Dim>> x;                ///< [m] at the last evaluation
  std::vector<Vec<Dim>> x_made;           ///< [m] when lists were last built
  std::vector<Vec<Dim>> v;                ///< [m/s] at the last evaluation
  MotionBounds<Dim> motion;               ///< since `x_made`, of the points here, as last read
  std::vector<Vec<Dim>> spring, damping;  ///< [N] forces of the last evaluation
  /// Whether anything gave them a force in it: where nothing did it is 0, friction too.
  std::vector<char> pressed;
  std::vector<Real> spring_work, damping_energy;  ///< [J] booked since time 0
  bool erodes = false;                            ///< faces may go; else `eroded_energy` is empty
  std::vector<Real> eroded_energy;  ///< [J] of springs that went with their faces, since time 0
  bool has_friction = false;        ///< some pair has friction; else the fields below are empty
  std::vector<Vec<Dim>> friction;   ///< [N] of this evaluation
  bool holds = false;               ///< some pair is tied or a joint; else `joint_loss` is empty
  std::vector<Real> joint_loss;     ///< [J] that joints have used up, booked since time 0
  bool turns = false;           ///< particles have friction with particles; else `spin` is empty
  std::vector<Vec3> spin;       ///< [rad/s] of the material, where its surface gives it
  bool needs_material = false;  ///< some friction does; else `material` is empty
  std::vector<SurfaceMaterial> material;  ///< of a particle, where its surface gives it
  bool conduct = false;                   ///< some points conduct; else the fields below are empty
  std::vector<Real> temperature;          ///< [K] at the end of the step, but for contact
  std::vector<Real> capacity;             ///< [J/K], or [kg] where it varies; 0: takes no heat
  std::vector<Real> heat_rate;            ///< [W] of this evaluation
  std::vector<Real> friction_given;       ///< [J] of friction, to any nodes, booked since time 0
  std::vector<Real> friction_heat, friction_stored, friction_damped,
      pair_energy;  ///< [J] booked since time 0

  /// Those that are here: of bodies that may touch something, and of others.
  std::vector<LocalIndex> near, far;
  std::vector<NodeRun> near_runs;  ///< `near`, by runs

  /// Hands each field that outlives a step to f(&ContactNodes::field, use). All that is done with
  /// them reads them here: room, rows of a checkpoint in this order, the hash, a table made anew.
  template <class F>
  void for_carried(const F& f) const {
    f(&ContactNodes::v, kSaved);
    f(&ContactNodes::spring, kState);
    f(&ContactNodes::damping, kState);
    f(&ContactNodes::pressed, FieldUse{});
    f(&ContactNodes::spring_work, kState);
    f(&ContactNodes::damping_energy, kState);
    if (erodes) f(&ContactNodes::eroded_energy, kSaved);
    if (conduct) f(&ContactNodes::friction_given, kSaved);
    if (holds) f(&ContactNodes::joint_loss, kSaved);
    if (!has_friction) return;
    f(&ContactNodes::friction, kSaved);
    f(&ContactNodes::friction_heat, kSaved);
    f(&ContactNodes::friction_stored, kSaved);
    f(&ContactNodes::friction_damped, kSaved);
    f(&ContactNodes::pair_energy, kSaved);
  }
  /// The same of those that are read from the groups, or begin at 0, in every step.
  template <class F>
  void for_renewed(const F& f) const {
    if (turns) f(&ContactNodes::spin);
    if (needs_material) f(&ContactNodes::material);
    if (!conduct) return;
    f(&ContactNodes::temperature);
    f(&ContactNodes::capacity);
    f(&ContactNodes::heat_rate);
  }

  std::size_t size() const { return point.size(); }
  /// Room for n nodes and no more: tables that double take twice what a million particles need.
  void reserve(std::size_t n);
  LocalIndex add(LocalIndex on_surface, LocalIndex at_point, const Points<Dim>& points);
  /// Keeps the first n.
  void shorten(std::size_t n);
  /// A point of another rank; [kg], [m], [m/s].
  LocalIndex add_remote(LocalIndex on_surface, GlobalId of, Real m, const Vec<Dim>& at,
                        const Vec<Dim>& velocity);
  /// Motion is counted from where the points here are now.
  void begin_motion(const std::vector<Surface<Dim>*>& surfaces);
  /// Leaves nodes that touch nothing alone: those with a 0.
  void choose(const std::vector<char>& near);
  /// Takes x, v and spin of the points that are here from the groups, and how they moved; of those
  /// that touch nothing v alone.
  void read_motion(const std::vector<Surface<Dim>*>& surfaces);
  /// `temperature` of owned points now, before heat of this step is known.
  void read_temperatures(const std::vector<Surface<Dim>*>& surfaces);
  /// Temperatures [K] of owned points now, by node; 0 elsewhere, and where none is kept.
  std::vector<Real> present_temperatures(const std::vector<Surface<Dim>*>& surfaces) const;
  /// The temperatures that owned points will have after dt by the heat they have so far; of those
  /// that touch nothing none.
  void predict_temperatures(const std::vector<Surface<Dim>*>& surfaces, Real dt);
  /// Takes over what outlives a step from the same points in an older table.
  void inherit(const ContactNodes& old);

 private:
  void read_matter(const std::vector<Surface<Dim>*>& surfaces);
};

}  // namespace brunt
// Tested by tests/unit/contact/manager_test.cpp.
