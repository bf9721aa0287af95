#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt {

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
  std::vector<Vec<Dim>> v;        ///< [m/s] velocity; at the half step between predict and correct
  std::vector<Vec<Dim>> a;        ///< [m/s^2] acceleration at the last full step
  std::vector<Vec<Dim>> f;        ///< [N] force, accumulated
  std::vector<Vec<Dim>> x_start;  ///< [m] position at time 0
  std::vector<Real> integration;  ///< [J] what changes of the step left in the kinetic energy
  bool conducts = false;          ///< the group has what follows
  std::vector<Real> temperature;  ///< [K] start_temperature + heat/capacity
  std::vector<Real> start_temperature;  ///< [K] at time 0
  std::vector<Real> capacity;           ///< [J/K] heat capacity
  std::vector<Real> heat;               ///< [J] taken up since time 0: the state of the point
  std::vector<Real> heat_rate;          ///< [W] accumulated, as forces are
  /// [W/K] accumulated with heat_rate: what the point gives to all around it per degree. A step of
  /// at most capacity/conductance is stable, and makes no new extremes where all pairs exchange
  /// heat from hot to cold.
  std::vector<Real> conductance;

  LocalIndex size() const { return static_cast<LocalIndex>(x.size()); }

  /// Makes room for n points, all owned; fields are zero.
  void resize(LocalIndex n) {
    n_owned = n;
    const auto count = static_cast<std::size_t>(n);
    id.resize(count);
    body.resize(count);
    piece.resize(count);
    mass.assign(count, 0.0);
    integration.assign(count, 0.0);
    for (auto* field : {&x, &v, &a, &f, &x_start}) field->assign(count, Vec<Dim>::Zero());
  }

  /// From now on the points have a temperature, capacities are 0 yet; [K] by point.
  void conduct(const std::vector<Real>& at_start) {
    conducts = true;
    temperature = start_temperature = at_start;
    for (auto* field : {&capacity, &heat, &heat_rate, &conductance}) field->assign(x.size(), 0.0);
  }

  /// The points at `places`, in that order; the first n_owned_then of them are owned.
  Points subset(std::span<const LocalIndex> places, LocalIndex n_owned_then) const {
    Points part;
    const auto copy = [&](auto& to, const auto& from) {
      to.reserve(places.size());
      for (const LocalIndex i : places) to.push_back(from[static_cast<std::size_t>(i)]);
    };
    part.n_owned = n_owned_then;
    copy(part.id, id), copy(part.body, body), copy(part.piece, piece), copy(part.mass, mass);
    copy(part.x, x), copy(part.v, v), copy(part.a, a), copy(part.f, f);
    copy(part.x_start, x_start), copy(part.integration, integration);
    part.conducts = conducts;
    if (!conducts) return part;
    copy(part.temperature, temperature), copy(part.start_temperature, start_temperature);
    copy(part.capacity, capacity), copy(part.heat, heat);
    copy(part.heat_rate, heat_rate), copy(part.conductance, conductance);
    return part;
  }

  /// Adds a copy of a point of another rank; [kg], [m], [m/s]. Its temperature comes later.
  void append_ghost(GlobalId of, Label of_body, Label of_piece, Real m, const Vec<Dim>& at,
                    const Vec<Dim>& velocity) {
    id.push_back(of), body.push_back(of_body), piece.push_back(of_piece), mass.push_back(m);
    x.push_back(at), x_start.push_back(at), v.push_back(velocity);
    a.push_back(Vec<Dim>::Zero()), f.push_back(Vec<Dim>::Zero());
    integration.push_back(0);
    if (!conducts) return;
    for (auto* field :
         {&temperature, &start_temperature, &capacity, &heat, &heat_rate, &conductance}) {
      field->push_back(0);
    }
  }

  /// Ids of what is owned, ascending.
  std::span<const GlobalId> owned_ids() const {
    return {id.data(), static_cast<std::size_t>(n_owned)};
  }

  /// Place of a point that is here, owned or ghost; -1 where it is not.
  LocalIndex find(GlobalId wanted) const {
    const auto begin = id.begin(), middle = begin + n_owned;
    auto at = std::lower_bound(begin, middle, wanted);
    if (at == middle || *at != wanted) at = std::lower_bound(middle, id.end(), wanted);
    return at == id.end() || *at != wanted ? -1 : static_cast<LocalIndex>(at - begin);
  }
};

}  // namespace brunt
