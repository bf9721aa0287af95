#pragma once
#include <string>
#include <utility>
#include <vector>

#include "core/boundaries/catalog.hpp"
#include "core/points_state.hpp"
#include "core/step_limit.hpp"

namespace brunt {

/// False of what would do nothing: an Acting is called in the moments that it names.
template <class A>
constexpr bool acts() {
  if constexpr (requires { &A::impose; }) return true;
  if constexpr (requires { &A::add_forces; }) return true;
  if constexpr (requires { &A::complete_forces; }) return true;
  if constexpr (requires { &A::add_heat; }) return true;
  return requires { &A::hold_temperature; };
}

/// All boundaries of a scene, kind by kind. An Acting of a kind takes part in those moments of a
/// step for which it has a function.
template <int Dim>
class Boundaries {
 public:
  /// Adds what a kind does to a patch, unless something is wrong with it: then it says what.
  template <class Kind>
  std::string add(const Kind& kind, Patch<Dim> patch) {
    using Acting = typename Kind::template Acting<Dim>;
    static_assert(acts<Acting>(),
                  "this boundary would do nothing: it has none of impose, add_forces, "
                  "complete_forces, add_heat, hold_temperature");
    Acting acting(kind, std::move(patch));
    auto& others = all_of<Kind>();
    std::string wrong;
    if constexpr (requires { acting.problem(others); }) {
      wrong = acting.problem(others);
    } else if constexpr (requires { acting.problem(); }) {
      wrong = acting.problem();
    }
    if (!wrong.empty()) return wrong;
    Acting::visit_fields(
        acting, [n = acting.patch.size()](auto& field, FieldUse use) { fit_field(field, use, n); });
    others.push_back(std::move(acting));
    return "";
  }
  /// Those of one kind, in the order of the deck.
  template <class Kind>
  const std::vector<typename Kind::template Acting<Dim>>& of() const {
    return std::get<std::vector<typename Kind::template Acting<Dim>>>(acting_);
  }
  /// Calls f(acting) of all, kind by kind.
  template <class F>
  void each(const F& f) const {
    std::apply([&](const auto&... kind) { (each_of(kind, f), ...); }, acting_);
  }
  /// From now on what acted on `old` points acts on those of them that `now` owns, the same ids.
  void follow(const Points<Dim>& old, Points<Dim>& now);
  /// What acts on facets of this surface acts on those of them that are left.
  void keep_facets(const Surface<Dim>& surface);

  /// At time 0, before the first energy is taken: start(), and conductances for the first step
  /// limit.
  void start();
  /// After predict: impose(time, dt) overrides x and v. time  of the end of the step, as in what
  /// follows
  void impose(Real time, Real dt);
  /// At x(n+1), before internal forces: add_forces(time, dt).
  void add_forces(Real time, Real dt);
  /// add_heat(time, dt), at T(n).
  void add_heat(Real time, Real dt);
  /// After all heat: hold_temperature(time, dt).
  void hold_temperatures(Real time, Real dt);
  /// After all forces: complete_forces(time, dt, supports) of those that follow the velocity at the
  /// end of the step, which supports prescribe in part, then take_reactions(time, dt).
  void take_reactions(Real time, Real dt);
  /// True where one that heats, cools or holds a temperature begins or ends between two times [s].
  bool switches_heat(Real before, Real after) const;
  /// The smallest of stable_step() of the owned points.
  StepLimit stable_step() const;
  /// add_totals(totals): work to the column `boundary`, heat to the books of heat.
  void add_totals(Totals<Dim>& totals) const;
  /// Saved fields of the owned points.
  void save_state(std::vector<StateTable>& tables) const;
  /// Throws StateError where a row is missing.
  void load_state(const StateTables& tables);

 private:
  template <class Kinds>
  struct ActingOf;
  template <class... Kind>
  struct ActingOf<std::tuple<Kind...>> {
    using type = std::tuple<std::vector<typename Kind::template Acting<Dim>>...>;
  };
  template <class All, class F>
  static void each_of(All& all, const F& f) {
    for (auto& one : all) f(one);
  }
  template <class F>
  void change_each(const F& f) {
    std::apply([&](auto&... kind) { (each_of(kind, f), ...); }, acting_);
  }
  template <class Kind>
  auto& all_of() {
    return std::get<std::vector<typename Kind::template Acting<Dim>>>(acting_);
  }

  typename ActingOf<BoundaryKinds>::type acting_;
};

}  // namespace brunt
// Tested by tests/unit/app/supports_test.cpp.
