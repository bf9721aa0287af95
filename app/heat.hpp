#pragma once
#include <string>
#include <vector>

#include "app/supports.hpp"
#include "core/step_vote.hpp"
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

  /// Gives points their prescribed temperatures at time 0, and conductances for the first vote.
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

/// The longest stable step of conducting points, least capacity/conductance, and whose it is.
template <int Dim>
StepVote heat_step(const Points<Dim>& points);

}  // namespace brunt
