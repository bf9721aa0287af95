#pragma once
#include "core/boundaries/function.hpp"
#include "core/boundaries/load_books.hpp"
#include "core/boundaries/patch.hpp"

namespace brunt {

template <int Dim>
struct PressureLoad;

/// The deck's `pressure`: on the outer faces all of whose points are chosen, along their present
/// normals and over their present areas.
struct FollowerPressure {
  static constexpr const char* deck_keys = "pressure";
  static constexpr bool kIsForce = true;
  template <int Dim>
  using Acting = PressureLoad<Dim>;

  std::optional<Varying> pressure;  ///< [Pa] positive pushes into the body

  bool given() const { return pressure.has_value(); }
};

inline void describe(Schema& s, FollowerPressure& load) {
  s.varying({"pressure",
             "pressure on outer facets all of whose points are chosen, along their present normals "
             "and over their present areas; positive pushes into the body"},
            load.pressure, {"Pa", {}, between(-1e12, 1e12)}, kTimeOrPlace);
}

/// f_k = -int N_k p n dA over the faces as they are at x(n+1): docs/theory/integration.md (I10).
template <int Dim>
struct PressureLoad {
  static constexpr const char* kTable = "pressure.";
  Patch<Dim> patch;
  FunctionOfTimeAndPlace pressure;  ///< [Pa]
  LoadBooks<Dim> books;

  PressureLoad(const FollowerPressure& load, Patch<Dim> on)
      : patch(std::move(on)), pressure(function_of(*load.pressure)) {}
  /// What is wrong, "" where nothing is.
  std::string problem() const { return patch.needs_faces("a pressure"); }
  template <class Load, class F>
  static void visit_fields(Load& load, const F& f) {
    load.books.visit_fields(load.books, f);
  }
  template <class F>
  void visit_reports(const F& f) const {
    f("force", books.last);
  }
  template <class F>
  void visit_functions(const F& f) const {
    f("pressure", pressure);
  }
  /// Adds forces at the end of the step.
  void add_forces(Real time, Real dt) {
    const bool acts = patch.acts(time);
    books.push(patch, dt, patch.integral(Vec<Dim>::Zero().eval(), [&](const FacetPoint<Dim>& at) {
      return acts ? Vec<Dim>(-pressure(time, at.start) * at.area) : Vec<Dim>::Zero().eval();
    }));
  }
  void add_totals(Totals<Dim>& totals) const { books.add_totals(totals); }
};

}  // namespace brunt
