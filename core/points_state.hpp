#pragma once
/// The state of points as rows of the table "points", by point id, which is unique in a scene.
#include "core/points.hpp"
#include "core/state.hpp"

namespace brunt {

/// Rows of the owned points, and of their heat in the table "points.heat".
template <int Dim>
void save_points(const Points<Dim>& points, std::vector<StateTable>& tables) {
  save_rows(
      "points", points.owned(), [&](std::size_t i) { return points.id[i]; },
      [&](auto& row, std::size_t i) { Points<Dim>::visit_mechanical(points, saved_in(row, i)); },
      tables);
  if (!points.conducts) return;
  save_rows(
      "points.heat", points.owned(), [&](std::size_t i) { return points.id[i]; },
      [&](auto& row, std::size_t i) { Points<Dim>::visit_thermal(points, saved_in(row, i)); },
      tables);
}

/// Every point takes its row, ghosts too. Throws StateError.
template <int Dim>
void load_points(Points<Dim>& points, const StateTables& tables) {
  load_rows(
      "points", points.x.size(), [&](std::size_t i) { return points.id[i]; },
      [&](auto& row, std::size_t i) { Points<Dim>::visit_mechanical(points, saved_in(row, i)); },
      tables);
  if (!points.conducts) return;
  load_rows(
      "points.heat", points.x.size(), [&](std::size_t i) { return points.id[i]; },
      [&](auto& row, std::size_t i) { Points<Dim>::visit_thermal(points, saved_in(row, i)); },
      tables);
}

/// Rows of what somebody keeps about chosen points, those of them that are owned.
/// visit(row, k)  hands what is kept about point chosen[k] to row
template <int Dim, class Visit>
void save_chosen(const std::string& name, const Points<Dim>& points,
                 const std::vector<LocalIndex>& chosen, const Visit& visit,
                 std::vector<StateTable>& tables) {
  std::vector<std::size_t> owned;
  for (std::size_t k = 0; k < chosen.size(); ++k) {
    if (chosen[k] < points.n_owned) owned.push_back(k);
  }
  save_rows(
      name, owned.size(), [&](std::size_t k) { return points.id[chosen[owned[k]]]; },
      [&](auto& row, std::size_t k) { visit(row, owned[k]); }, tables);
}

/// Reads back what save_chosen wrote, for all chosen points. Throws StateError.
template <int Dim, class Visit>
void load_chosen(const std::string& name, const Points<Dim>& points,
                 const std::vector<LocalIndex>& chosen, const Visit& visit,
                 const StateTables& tables) {
  load_rows(
      name, chosen.size(), [&](std::size_t k) { return points.id[chosen[k]]; }, visit, tables);
}

}  // namespace brunt
// Tested by tests/unit/core/state_test.cpp.
