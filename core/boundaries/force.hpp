#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/boundaries/function.hpp"
#include "core/boundaries/load_books.hpp"
#include "core/boundaries/patch.hpp"

namespace brunt {

template <int Dim>
struct ForceLoad;

/// The deck's `force`: in total on all chosen points, shared by mass, or by Patch::weight.
struct AppliedForce {
  static constexpr const char* deck_keys = "force";
  static constexpr bool kIsForce = true;
  template <int Dim>
  using Acting = ForceLoad<Dim>;

  std::optional<std::vector<std::optional<Varying>>> force;  ///< [N] by component

  bool given() const { return force.has_value(); }
};
void describe(Schema& s, AppliedForce& load);

template <int Dim>
struct ForceLoad {
  static constexpr const char* kTable = "force.";
  Patch<Dim> patch;
  std::array<std::optional<FunctionOfTimeAndPlace>, Dim> force;  ///< [N]
  std::vector<Real> share;  ///< [1] fraction of the total that each point takes
  LoadBooks<Dim> books;

  ForceLoad() = default;
  ForceLoad(const AppliedForce& load, Patch<Dim> on);
  template <class Load, class F>
  static void visit_fields(Load& load, const F& f) {
    load.books.visit_fields(load.books, f);
    f(load.share, {});
  }
  template <class F>
  void visit_functions(const F& f) const {
    for (std::size_t c = 0; c < Dim; ++c) {
      if (force[c]) f("force." + std::to_string(c), *force[c]);
    }
  }
  /// Adds forces at the end of the step.
  void add_forces(Real time, Real dt);
  void add_totals(Totals<Dim>& totals) const { books.add_totals(totals); }
};

}  // namespace brunt
// Tested by tests/unit/app/loads_test.cpp.
