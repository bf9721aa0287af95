#include "core/boundaries/boundaries.hpp"

#include <algorithm>

namespace brunt {

template <int Dim>
void Boundaries<Dim>::follow(const Points<Dim>& old, Points<Dim>& now) {
  change_each([&](auto& one) {
    if (one.patch.points != &old) return;
    const auto kept = one.patch.follow(old, now);
    one.visit_fields(one, [&](auto& field, FieldUse) { keep_places(field, kept); });
  });
}

template <int Dim>
void Boundaries<Dim>::keep_facets(const Surface<Dim>& surface) {
  change_each([&](auto& one) { one.patch.keep_facets(surface); });
}

template <int Dim>
void Boundaries<Dim>::start() {
  change_each([](auto& one) {
    if constexpr (requires { one.start(); }) one.start();
  });
  add_heat(0, 0);
  change_each([](auto& one) {
    auto& points = *one.patch.points;
    if constexpr (requires { one.add_heat(0, 0); }) {
      if (points.conducts) std::fill(points.heat_rate.begin(), points.heat_rate.end(), 0.0);
    }
  });
}

template <int Dim>
void Boundaries<Dim>::impose(Real time, Real dt) {
  change_each([&](auto& one) {
    if constexpr (requires { one.impose(time, dt); }) one.impose(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::add_forces(Real time, Real dt) {
  change_each([&](auto& one) {
    if constexpr (requires { one.add_forces(time, dt); }) one.add_forces(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::add_heat(Real time, Real dt) {
  change_each([&](auto& one) {
    if constexpr (requires { one.add_heat(time, dt); }) one.add_heat(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::hold_temperatures(Real time, Real dt) {
  change_each([&](auto& one) {
    if constexpr (requires { one.hold_temperature(time, dt); }) one.hold_temperature(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::take_reactions(Real time, Real dt) {
  change_each([&](auto& one) {
    if constexpr (requires { one.complete_forces(time, dt); }) one.complete_forces(time, dt);
  });
  change_each([&](auto& one) {
    if constexpr (requires { one.take_reactions(time, dt); }) one.take_reactions(time, dt);
  });
}

template <int Dim>
StepLimit Boundaries<Dim>::stable_step() const {
  StepLimit step_limit;
  each([&](const auto& one) {
    if constexpr (requires { one.stable_step(); }) step_limit.take(one.stable_step());
  });
  return step_limit;
}

template <int Dim>
void Boundaries<Dim>::add_totals(Totals<Dim>& totals) const {
  each([&](const auto& one) { one.add_totals(totals); });
}

template <int Dim>
void Boundaries<Dim>::save_state(std::vector<StateTable>& tables) const {
  each([&](const auto& one) {
    save_chosen(
        one.kTable + one.patch.name, *one.patch.points, one.patch.chosen,
        [&](auto& row, std::size_t k) { one.visit_fields(one, saved_in(row, k)); }, tables);
  });
}

template <int Dim>
void Boundaries<Dim>::load_state(const StateTables& tables) {
  change_each([&](auto& one) {
    load_chosen(
        one.kTable + one.patch.name, *one.patch.points, one.patch.chosen,
        [&](auto& row, std::size_t k) { one.visit_fields(one, saved_in(row, k)); }, tables);
  });
}

template class Boundaries<2>;
template class Boundaries<3>;

}  // namespace brunt
// Tested by tests/unit/app/supports_test.cpp.
