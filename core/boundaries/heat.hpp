#pragma once
#include <string>
#include <vector>

#include "core/boundaries/supports.hpp"
#include "core/step_limit.hpp"
#include "core/surface.hpp"

namespace brunt {

/// What one boundary condition does to the heat of chosen points. Values are functions of time and
/// of the place at time 0 (absolute); absent ones are empty.
template <int Dim>
struct HeatBoundary {
  std::string name;
  Points<Dim>* points = nullptr;
  std::vector<LocalIndex> chosen;                 ///< owned points
  std::optional<PrescribedVelocity> temperature;  ///< [K] they are held at
  std::optional<PrescribedVelocity> flux;         ///< [W/m^2] into the body
  std::optional<PrescribedVelocity> film;         ///< [W/m^2/K] h of convection
  std::optional<PrescribedVelocity> film_T;       ///< [K] of the fluid
  Real emissivity = 0;                            ///< [1] of radiation
  std::optional<PrescribedVelocity> radiation_T;  ///< [K] of the surroundings
  Real from = 0, to = kInfinity;                  ///< [s] when it acts
  std::vector<Facet<Dim>> facets;                 ///< all of whose points are chosen, by id
  std::vector<Real> fixed_area;                   ///< [m^2] by chosen point, of particles
  std::vector<Real> rate;                         ///< [W] into the body in the last step
  std::vector<Real> heat;                         ///< [J] into the body since time 0

  bool acts_on_areas() const { return flux || film || emissivity > 0; }
  bool acts(Real time) const { return time >= from && time <= to; }
};

/// All that heats or cools bodies from outside, and the heat that it lets in.
template <int Dim>
class HeatBoundaries {
 public:
  HeatBoundaries(Vec<Dim> origin, Geometry geometry, Real depth);
  void add(HeatBoundary<Dim> boundary);
  bool empty() const { return boundaries_.empty(); }
  /// From now on what acted on `old` points acts on those of them that `now` owns, the same ids.
  void follow(const Points<Dim>& old, Points<Dim>& now);

  /// Gives points their prescribed temperatures at time 0, and conductances for the first step
  /// limit.
  void start();
  /// Flux, convection h A (T_fluid - T) and radiation, at T(n); time is that of the step's end.
  void add_heat(Real time, Real dt);
  /// After all heat: what held points need beside it to have their temperature at the step's end.
  void hold(Real time, Real dt);
  void add_totals(Totals<Dim>& totals) const;
  /// Heat and rates of the owned points.
  void save_state(std::vector<StateTable>& tables) const;
  /// Throws StateError where a row is missing.
  void load_state(const StateTables& tables);
  const std::vector<HeatBoundary<Dim>>& all() const { return boundaries_; }

 private:
  Vec3 place(const HeatBoundary<Dim>& boundary, std::size_t k) const;
  std::vector<Real> areas(const HeatBoundary<Dim>& boundary) const;

  Vec<Dim> origin_;
  Real constant_, radial_;  // an edge at radius r has the width constant + radial r [m]
  std::vector<HeatBoundary<Dim>> boundaries_;
};

/// The longest stable step of conducting points, least capacity/conductance over N =
/// points.conduction_every, and whose it is: the N steps between two evaluations of conduction, a
/// window, are together no longer than a stable step of heat.
///   Step n of a window makes of T_i  (1 - a_n) T_i + a_n T_f + dt_n/C_i sum_j G_ij (T_j0 - T_i0)
/// with T_0 as at its start and a_n = dt_n H_i/C_i, H_i of all else, which draws T_i to T_f. T_i is
/// then a sum of T_i0, the T_j0 and T_f whose weights sum to 1. That of T_i0 is, with G_i = sum_j
/// G_ij, R_n = prod_{m<=n} 1/(1 - a_m) and dt_m (G_i + H_i) <= C_i/N,
///   (1 - sum_{m<=n} R_m dt_m G_i/C_i)/R_n >= (1 - sum R_m (1/N - a_m))/R_n
///                                          = (R_n - (R_1 + .. + R_n)/N)/R_n >= 0
/// since a_m R_m = R_m - R_m-1 and R grows. So no point passes the extremes, whatever H does within
/// the window. Where heat flows from cold to hot in some pairs (G_ij < 0), a window multiplies
/// modes by factors between -1 and 1 still (Gershgorin): it is stable. C_i/(N G_i + H_i) would do
/// while H is steady, but lets points pass T_f. What contact exchanges is no part of H: by backward
/// Euler, it bounds no step (docs/decisions/027-heat-across-contacts.md).
template <int Dim>
StepLimit heat_step(const Points<Dim>& points);

}  // namespace brunt
