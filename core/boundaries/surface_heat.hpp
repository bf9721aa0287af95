#pragma once
#include <optional>
#include <string>
#include <vector>

#include "core/boundaries/function.hpp"
#include "core/boundaries/patch.hpp"
#include "core/ledger.hpp"

namespace brunt {

/// Heat h (T - T_surface) per area; constants, tables over time or expressions.
struct Convection {
  std::optional<Varying> h;  ///< [W/m^2/K]
  std::optional<Varying> T;  ///< [K]
};
/// Heat emissivity sigma (T^4 - T_surface^4) per area.
struct Radiation {
  Real emissivity = 1;       ///< [1]
  std::optional<Varying> T;  ///< [K]
};
void describe(Schema& s, Convection& convection);
void describe(Schema& s, Radiation& radiation);

template <int Dim>
struct HeatBoundary;

/// The deck's `temperature`, `flux`, `convection` and `radiation`.
struct SurfaceHeat {
  static constexpr const char* deck_keys = "temperature, flux, convection, radiation";
  static constexpr bool kHeats = true;
  template <int Dim>
  using Acting = HeatBoundary<Dim>;

  std::optional<Varying> temperature;  ///< [K] of the chosen points
  std::optional<Varying> flux;         ///< [W/m^2] into the body
  std::optional<Convection> convection;
  std::optional<Radiation> radiation;

  bool given() const { return temperature || flux || convection || radiation; }
  bool pushes() const { return false; }
  /// `time.process_speed`: emissivity has no unit, and heat flows by it.
  void speed_up(Real s) {
    if (radiation) radiation->emissivity *= s;
  }
};
void describe(Schema& s, SurfaceHeat& heat);

/// Heats or cools points from outside: docs/theory/heat.md (H18) to (H21). Absent functions are
/// empty.
template <int Dim>
struct HeatBoundary {
  static constexpr const char* kTable = "heat.";
  Patch<Dim> patch;
  std::optional<FunctionOfTimeAndPlace> temperature;  ///< [K] they are held at
  std::optional<FunctionOfTimeAndPlace> flux;         ///< [W/m^2] into the body
  std::optional<FunctionOfTimeAndPlace> film;         ///< [W/m^2/K] h of convection
  std::optional<FunctionOfTimeAndPlace> film_T;       ///< [K] of the fluid
  Real emissivity = 0;                                ///< [1] of radiation
  std::optional<FunctionOfTimeAndPlace> radiation_T;  ///< [K] of the surroundings
  std::vector<Real> fixed_area;                       ///< [m^2] by chosen point, of particles
  std::vector<Real> rate;                             ///< [W] into the body in the last step
  std::vector<Real> heat;                             ///< [J] into the body since time 0

  HeatBoundary() = default;
  HeatBoundary(const SurfaceHeat& given, Patch<Dim> on);
  /// What is wrong beside the others of the scene, "" where nothing is.
  std::string problem(const std::vector<HeatBoundary>& others) const;
  template <class Boundary, class F>
  static void visit_fields(Boundary& boundary, const F& f) {
    f(boundary.rate, kSaved);
    f(boundary.heat, kSaved);
    if (!boundary.fixed_area.empty()) f(boundary.fixed_area, {});
  }
  template <class F>
  void visit_reports(const F& f) const {
    f("heat_rate", rate);
  }

  /// Gives points their prescribed temperatures at time 0.
  void start();
  /// Flux, convection h A (T_fluid - T) and radiation, at T(n); time is that of the step's end.
  void add_heat(Real time, Real dt);
  /// After all heat: what held points need beside it to have their temperature at the step's end.
  void hold_temperature(Real time, Real dt);
  void add_totals(Totals<Dim>& totals) const;

 private:
  bool acts_on_areas() const { return flux || film || emissivity > 0; }
  std::vector<Real> areas() const;
};

}  // namespace brunt
// Tested by tests/verification/conduction_test.cpp.
