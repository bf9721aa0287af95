#pragma once
#include <vector>

#include "core/boundaries/patch.hpp"
#include "core/field_use.hpp"
#include "core/ledger.hpp"

namespace brunt {

/// What a load keeps of each of its points, and how its work is booked: docs/theory/ledger.md (L1).
template <int Dim>
struct LoadBooks {
  std::vector<Vec<Dim>> last;  ///< [N] at the last full step
  std::vector<Real> work;      ///< [J] done on the scene

  template <class Books, class F>
  static void visit_fields(Books& books, const F& f) {
    f(books.last, kSaved);
    f(books.work, kSaved);
  }
  /// Adds a force [N] of the end of the step to point i, the k-th of the load; books 1/2 (f(n) +
  /// f(n+1)).dx.
  void push(std::size_t k, std::size_t i, const Vec<Dim>& now, Real dt, Points<Dim>& points) {
    points.f[i] += now;
    work[k] += 0.5 * dt * points.v[i].dot(now + last[k]);
    last[k] = now;
  }
  /// The same of all points of a patch.
  void push(const Patch<Dim>& patch, Real dt, const std::vector<Vec<Dim>>& now) {
    for (std::size_t k = 0; k < now.size(); ++k) push(k, patch.point(k), now[k], dt, *patch.points);
  }
  void add_totals(Totals<Dim>& totals) const {
    for (const Real one : work) totals.add(Column::boundary, -one);
  }
};

}  // namespace brunt
// Tested by tests/unit/app/loads_test.cpp.
