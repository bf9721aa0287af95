#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/points_state.hpp"
#include "core/rigid/velocity_table.hpp"
#include "core/solid.hpp"

namespace brunt {

/// How a rigid body moves: it is held where both are zero.
template <int Dim>
struct RigidMotion {
  Label body = 0;
  Vec<Dim> velocity = Vec<Dim>::Zero();  ///< [m/s] of the centre of the spin, where it is constant
  Vec3 axis = Vec3::UnitZ();             ///< unit vector; in 2D out of the plane
  Real spin = 0;                         ///< [rad/s] about the axis
  Vec<Dim> center = Vec<Dim>::Zero();    ///< [m] at time 0
  /// Components of the velocity that change; none: constant.
  std::array<std::optional<VelocityTable>, static_cast<std::size_t>(Dim)> over_time{};

  /// Where the centre is at time t [m], and its velocity then [m/s].
  Vec<Dim> center_at(Real t) const;
  Vec<Dim> center_velocity(Real t) const;
  /// Position at time t of a point that was at `start` at time 0.
  Vec<Dim> position(const Vec<Dim>& start, Real t) const;
  /// [m/s] its velocity then.
  Vec<Dim> velocity_at(const Vec<Dim>& start, Real t) const;
};

/// The group of all rigid surfaces: points without mass that others move, and their facets.
/// It updates no elements and bounds no step.
template <int Dim>
class RigidSurfaces final : public Solid<Dim> {
 public:
  /// Points of all rigid bodies, at time 0, with their facets (stiffness 0 where they are held or
  /// have a prescribed motion).
  RigidSurfaces(Points<Dim> points, std::vector<Facet<Dim>> facets);
  RigidSurfaces(const RigidSurfaces&) = delete;
  RigidSurfaces& operator=(const RigidSurfaces&) = delete;

  /// Masses [kg] that means over points of free bodies weigh them by; none: there are no such
  /// bodies. The points themselves have no mass.
  void set_shares(std::vector<Real> shares) { shares_ = std::move(shares); }

  std::unique_ptr<Solid<Dim>> part(const Partition& partition,
                                   const Communicator& ranks) const override;
  Points<Dim>& points() override { return points_; }
  const Points<Dim>& points() const override { return points_; }
  Surface<Dim>& surface() override { return surface_; }
  void update_state(Real) override {}
  void add_internal_forces(Real) override {}
  StepLimit stable_step() const override { return {}; }
  void rearrange() override {}
  void add_totals(Totals<Dim>&) const override {}
  void check(Real, const std::vector<std::string>&) const override {}
  using Solid<Dim>::view;
  BodyView view(Label body, const WantedFields& wanted) const override;
  const GhostPlan& ghosts() const override { return ghosts_; }
  std::size_t n_elements() const override { return 0; }
  std::size_t n_particles() const override { return 0; }
  std::vector<Real> point_work() const override { return std::vector<Real>(points_.owned(), 0.0); }
  void save_state(std::vector<StateTable>& tables) const override { save_points(points_, tables); }
  void load_state(const StateTables& tables) override { load_points(points_, tables); }

 private:
  Points<Dim> points_;
  Surface<Dim> surface_;
  std::vector<Real> shares_;
  bool shows_facets_ = true;  // one rank writes all of them, in their order
  GhostPlan ghosts_;          // none: every rank moves all rigid points
};

}  // namespace brunt
// Tested by tests/verification/rigid_test.cpp.
