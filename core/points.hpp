#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "core/field_use.hpp"
#include "core/materials/specific_heat.hpp"
#include "core/types.hpp"

namespace brunt {

/// Moves a component of a position by dx [m]; what rounding leaves out goes with the next move
/// (Kahan, 1965). Volumes are those of x and strains those of v: in 2,000 steps of 1e-8 m at
/// x = 1 m they came apart by 1e-13 m, and a body that was pressed evenly was uneven by 1e-8 of its
/// stress.
inline void move_value(Real dx, Real& x, Real& rest) {
  const Real whole = dx + rest, moved = x + whole;
  rest = whole - (moved - x);
  x = moved;
}

/// Material points of one group: FE nodes, SPH particles or the points of rigid surfaces.
/// Owned points come first, ghosts after them; both along a space-filling curve, ids ascending.
/// Positions are relative to the scene's origin. An absent field is an empty array.
template <int Dim>
struct Points {
  LocalIndex n_owned = 0;
  std::vector<GlobalId> id;
  std::vector<Label> body;
  std::vector<Label> piece;
  std::vector<Real> mass;         ///< [kg]; 0 for points of a rigid surface
  std::vector<Vec<Dim>> x;        ///< [m] position
  std::vector<Vec<Dim>> x_rest;   ///< [m] what of all motion is below the last digit of x
  std::vector<Vec<Dim>> v;        ///< [m/s] velocity; at the half step between predict and correct
  std::vector<Vec<Dim>> a;        ///< [m/s^2] acceleration at the last full step
  std::vector<Vec<Dim>> f;        ///< [N] force, accumulated
  std::vector<Vec<Dim>> x_start;  ///< [m] position at time 0
  std::vector<Real> integration;  ///< [J] what changes of the step left in the kinetic energy
  bool conducts = false;          ///< the group has what follows
  std::vector<Real> temperature;  ///< [K] temperature_with(i, heat)
  std::vector<Real> start_temperature;  ///< [K] at time 0
  std::vector<Real> capacity;           ///< [J/K] heat capacity; where it varies, at time 0
  std::vector<Real> heat;               ///< [J] taken up since time 0: the state of the point
  std::vector<Real> heat_rate;          ///< [W] accumulated, as forces are
  /// [W/K] accumulated with heat_rate: what the point gives to all around it per degree. A step of
  /// at most capacity/conductance is stable, and makes no new extremes where all pairs exchange
  /// heat from hot to cold.
  std::vector<Real> conductance;
  /// Steps that the present evaluation of conduction acts for, and whether this one makes it anew;
  /// where they may be more than one the points keep what follows.
  int conduction_steps = 1;
  bool evaluates_conduction = true;
  bool keeps_conduction = false;
  std::vector<Real> kept_rate;         ///< [W] that the last evaluation gave
  std::vector<Real> kept_conductance;  ///< [W/K] with it
  /// Those of the group that vary with temperature, of single materials first, then of mixtures
  /// where elements share a node; the same on all ranks. What follows is empty where none does.
  std::vector<SpecificHeat> specific_heats;
  std::vector<std::int32_t> specific_heat;  ///< place there; -1: `capacity` is constant
  std::vector<Real> heated_mass;            ///< [kg] that takes heat
  std::vector<Real> start_enthalpy;         ///< [J/kg] of specific_heats at start_temperature

  LocalIndex size() const { return static_cast<LocalIndex>(x.size()); }
  std::size_t owned() const { return slot_of(n_owned); }

  /// Hands each field that the points have to f(field, use). All that is done with every field
  /// reads it here: a new one is declared above and listed here. Rows of a checkpoint have this
  /// order.
  template <class AnyPoints, class F>
  static void visit_fields(AnyPoints& points, const F& f) {
    visit_mechanical(points, f);
    visit_thermal(points, f);
  }
  template <class AnyPoints, class F>
  static void visit_mechanical(AnyPoints& points, const F& f) {
    constexpr FieldUse kMotion{.saved = true, .hashed = true, .copied = true};
    f(points.id, {});
    f(points.body, {});
    f(points.piece, {});
    f(points.mass, kSaved);
    f(points.x, kMotion);
    f(points.v, kMotion);
    f(points.a, kState);
    f(points.f, kSaved);
    f(points.x_start, kSaved);
    f(points.integration, kSaved);
    f(points.x_rest, kSaved);
  }
  /// Temperatures follow from heat only while heat capacities are constant: both are saved.
  template <class AnyPoints, class F>
  static void visit_thermal(AnyPoints& points, const F& f) {
    if (!points.conducts) return;
    f(points.temperature, {.saved = true, .copied = true});
    f(points.start_temperature, {});
    f(points.capacity, {});
    f(points.heat, kState);
    f(points.heat_rate, {});
    f(points.conductance, kSaved);
    if (points.keeps_conduction) f(points.kept_rate, kState), f(points.kept_conductance, kState);
    if (points.specific_heats.empty()) return;
    f(points.specific_heat, {.blank = -1});
    f(points.heated_mass, {});
    f(points.start_enthalpy, {});
  }

  /// Makes room for n points, all owned; what is new is zero.
  void resize(LocalIndex n) {
    n_owned = n;
    fit(slot_of(n));
  }

  /// Moves point i by dx [m], as move_value does.
  void move(std::size_t i, const Vec<Dim>& dx) {
    for (int c = 0; c < Dim; ++c) move_value(dx[c], x[i][c], x_rest[i][c]);
  }

  /// From now on the points have a temperature, capacities are 0 yet; [K] by point.
  void conduct(const std::vector<Real>& at_start) {
    conducts = true;
    fit(x.size());
    temperature = start_temperature = at_start;
  }
  /// From now on an evaluation of conduction may act for several steps.
  void keep_conduction() {
    keeps_conduction = true;
    fit(x.size());
  }
  /// Before heat of a step is added to them, owned points begin with what is kept for it.
  void begin_heat_rates() {
    const auto begin = [this](std::vector<Real>& sum, const std::vector<Real>& kept) {
      if (conduction_steps > 1 && !evaluates_conduction) {
        std::copy_n(kept.begin(), owned(), sum.begin());
      } else {
        std::fill_n(sum.begin(), owned(), 0.0);
      }
    };
    begin(heat_rate, kept_rate), begin(conductance, kept_conductance);
  }
  /// Adds what is kept to the heat rates and conductances of owned points.
  void add_kept_conduction() {
    for (std::size_t i = 0; i < owned(); ++i) {
      heat_rate[i] += kept_rate[i];
      conductance[i] += kept_conductance[i];
    }
  }
  /// From now on heat capacities of points may vary; none does yet.
  void vary_capacities(std::vector<SpecificHeat> varying) {
    specific_heats = std::move(varying);
    fit(x.size());
  }
  /// Point i consists of `of_mass` [kg] with one of specific_heats.
  void vary_capacity(std::size_t i, std::int32_t which, Real of_mass) {
    const auto& cp = specific_heats[which];
    specific_heat[i] = which, heated_mass[i] = of_mass;
    start_enthalpy[i] = cp.enthalpy(start_temperature[i]);
    capacity[i] = of_mass * cp.at(start_temperature[i]);
  }
  bool capacity_varies(std::size_t i) const {
    return !specific_heat.empty() && specific_heat[i] >= 0;
  }
  /// [K] of point i once it has taken up so much heat [J] since time 0: the inverse of its
  /// enthalpy.
  Real temperature_with(std::size_t i, Real taken_up) const {
    if (!capacity_varies(i)) return start_temperature[i] + taken_up / capacity[i];
    const auto& cp = specific_heats[specific_heat[i]];
    return cp.temperature(start_enthalpy[i] + taken_up / heated_mass[i]);
  }
  /// [J] that point i has to take up from now on to be at T [K].
  Real heat_needed(std::size_t i, Real T) const {
    if (!capacity_varies(i)) return capacity[i] * (T - temperature[i]);
    const auto& cp = specific_heats[specific_heat[i]];
    return heated_mass[i] * (cp.enthalpy(T) - start_enthalpy[i]) - heat[i];
  }
  /// [J/K] of point i, least at any temperature: no step with it passes the neighbours'.
  Real least_capacity(std::size_t i) const {
    if (!capacity_varies(i)) return capacity[i];
    return heated_mass[i] * specific_heats[specific_heat[i]].least();
  }

  /// Leaves the points at `places`, in that order; the first n_owned_then of them are owned.
  void keep(std::span<const LocalIndex> places, LocalIndex n_owned_then) {
    n_owned = n_owned_then;
    visit_fields(*this, [&](auto& field, FieldUse) { keep_places(field, places); });
  }
  Points subset(std::span<const LocalIndex> places, LocalIndex n_owned_then) const {
    Points part = *this;
    part.keep(places, n_owned_then);
    return part;
  }

  /// Adds a copy of a point of another rank; [kg], [m], [m/s]. Its temperature comes later.
  void append_ghost(GlobalId of, Label of_body, Label of_piece, Real m, const Vec<Dim>& at,
                    const Vec<Dim>& velocity) {
    fit(x.size() + 1);
    id.back() = of, body.back() = of_body, piece.back() = of_piece, mass.back() = m;
    x.back() = x_start.back() = at, v.back() = velocity;
  }

  /// Ids of what is owned, ascending.
  std::span<const GlobalId> owned_ids() const { return {id.data(), owned()}; }

  /// Place of a point that is here, owned or ghost; -1 where it is not.
  LocalIndex find(GlobalId wanted) const {
    const auto begin = id.begin(), middle = begin + n_owned;
    auto at = std::lower_bound(begin, middle, wanted);
    if (at == middle || *at != wanted) at = std::lower_bound(middle, id.end(), wanted);
    return at == id.end() || *at != wanted ? -1 : static_cast<LocalIndex>(at - begin);
  }

 private:
  void fit(std::size_t n) {
    visit_fields(*this, [n](auto& field, FieldUse use) { fit_field(field, use, n); });
  }
};

}  // namespace brunt
