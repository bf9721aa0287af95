#include "core/boundaries/boundaries.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace brunt {

namespace {
/// Rows of a checkpoint are found by the name of their table and of the boundary.
template <class... Kind>
constexpr bool tables_differ(const std::tuple<Kind...>*) {
  std::array<std::string_view, sizeof...(Kind)> names{Kind::template Acting<3>::kTable...};
  std::sort(names.begin(), names.end());
  return std::adjacent_find(names.begin(), names.end()) == names.end();
}
static_assert(tables_differ(static_cast<const BoundaryKinds*>(nullptr)),
              "two kinds of boundaries have one kTable");
}  // namespace

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
bool Boundaries<Dim>::switches_heat(Real before, Real after) const {
  bool any = false;
  each([&]<class A>(const A& one) {
    if constexpr (
        requires { &A::add_heat; } || requires { &A::hold_temperature; }) {
      any = any || one.patch.acts(before) != one.patch.acts(after);
    }
  });
  return any;
}

template <int Dim>
void Boundaries<Dim>::start() {
  change_each([]<class A>(A& one) {
    if constexpr (requires { &A::start; }) one.start();
  });
  add_heat(0, 0);
  change_each([]<class A>(A& one) {
    auto& points = *one.patch.points;
    if constexpr (requires { &A::add_heat; }) {
      if (points.conducts) std::fill(points.heat_rate.begin(), points.heat_rate.end(), 0.0);
    }
  });
}

template <int Dim>
void Boundaries<Dim>::impose(Real time, Real dt) {
  change_each([&]<class A>(A& one) {
    if constexpr (requires { &A::impose; }) one.impose(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::add_forces(Real time, Real dt) {
  change_each([&]<class A>(A& one) {
    if constexpr (requires { &A::add_forces; }) one.add_forces(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::add_heat(Real time, Real dt) {
  change_each([&]<class A>(A& one) {
    if constexpr (requires { &A::add_heat; }) one.add_heat(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::hold_temperatures(Real time, Real dt) {
  change_each([&]<class A>(A& one) {
    if constexpr (requires { &A::hold_temperature; }) one.hold_temperature(time, dt);
  });
}

template <int Dim>
void Boundaries<Dim>::take_reactions(Real time, Real dt) {
  change_each([&]<class A>(A& one) {
    if constexpr (requires { &A::complete_forces; }) {
      one.complete_forces(time, dt, all_of<PrescribedMotion>());
    }
  });
  change_each([&]<class A>(A& one) {
    if constexpr (requires { &A::take_reactions; }) one.take_reactions(time, dt);
  });
}

template <int Dim>
StepLimit Boundaries<Dim>::stable_step() const {
  StepLimit step_limit;
  each([&]<class A>(const A& one) {
    if constexpr (requires { &A::stable_step; }) step_limit.take(one.stable_step());
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
