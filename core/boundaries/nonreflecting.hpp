#pragma once
#include <Eigen/Cholesky>
#include <cmath>
#include <limits>
#include <utility>

#include "core/boundaries/load_books.hpp"
#include "core/boundaries/motion.hpp"
#include "core/boundaries/patch.hpp"
#include "core/schema.hpp"

namespace brunt {

template <int Dim>
struct ViscousBoundary;

/// The deck's `nonreflecting`: waves leave through the outer faces all of whose points are chosen.
struct Nonreflecting {
  static constexpr const char* deck_keys = "nonreflecting";
  template <int Dim>
  using Acting = ViscousBoundary<Dim>;

  bool nonreflecting = false;

  bool given() const { return nonreflecting; }
  bool pushes() const { return false; }
};

inline void describe(Schema& s, Nonreflecting& boundary) {
  s.flag({"nonreflecting",
          "waves leave through outer facets all of whose points are chosen; what lies beyond gives "
          "way to loads that stay"},
         boundary.nonreflecting);
}

/// Dashpots of the impedance of the material on its faces: docs/theory/integration.md (I11).
/// Lysmer, J. & Kuhlemeyer, R.L., Finite dynamic model for infinite media, J. Eng. Mech. Div. ASCE
/// 95, 1969.
template <int Dim>
struct ViscousBoundary {
  static constexpr const char* kTable = "viscous.";
  Patch<Dim> patch;
  Real of_pressure = 0;  ///< [kg/m^2/s] rho c_p, along the normal
  Real of_shear = 0;     ///< [kg/m^2/s] rho c_s, across it
  LoadBooks<Dim> books;

  ViscousBoundary(const Nonreflecting&, Patch<Dim> on)
      : patch(std::move(on)),
        of_pressure(std::sqrt(patch.material->density * patch.material->modulus())),
        of_shear(std::sqrt(patch.material->density * patch.material->shear)) {}
  /// What is wrong, "" where nothing is.
  std::string problem() const { return patch.needs_faces("a nonreflecting boundary"); }
  template <class Boundary, class F>
  static void visit_fields(Boundary& boundary, const F& f) {
    boundary.books.visit_fields(boundary.books, f);
  }
  template <class F>
  void visit_reports(const F& f) const {
    f("force", books.last);
  }
  /// After all other forces: those of the dashpots at the velocity that the step ends with, so that
  /// they shorten no step. supports  of the scene: what they hold, the dashpots do not move
  void complete_forces(Real time, Real dt, const std::vector<MotionSupport<Dim>>& supports) {
    const bool acts = patch.acts(time);
    auto& points = *patch.points;
    // [kg/s] of each chosen point
    auto viscosity = patch.integral(Square::Zero().eval(), [&](const FacetPoint<Dim>& at) {
      return acts ? impedance(at) : Square::Zero().eval();
    });
    const auto prescribed = prescribed_velocities(time, supports);
    for (std::size_t k = 0; k < patch.size(); ++k) {
      const std::size_t i = patch.point(k);
      Square& C = viscosity[k];
      if (patch.depth == 0 && points.x[i][0] == 0) C.row(0).setZero(), C.col(0).setZero();  // axis
      // v(n+1) = v(n+1/2) + dt/2 a, with (m + dt/2 C) a = f - C v(n+1/2)
      Square mass = points.mass[i] * Square::Identity() + 0.5 * dt * C;
      Vec<Dim> force = points.f[i] - C * points.v[i];
      for (int c = 0; c < Dim; ++c) {
        const Real v_end = prescribed[k][c];
        if (std::isnan(v_end)) continue;
        const Real a = 2 * (v_end - points.v[i][c]) / dt;
        force -= a * mass.col(c);
        mass.row(c).setZero(), mass.col(c).setZero();
        mass(c, c) = 1, force[c] = a;
      }
      const Vec<Dim> a = mass.llt().solve(force);
      books.push(k, i, -C * (points.v[i] + 0.5 * dt * a), dt, points);
    }
  }
  void add_totals(Totals<Dim>& totals) const { books.add_totals(totals); }

 private:
  using Square = Eigen::Matrix<Real, Dim, Dim>;
  /// [m/s] of each chosen point at the end of the step; free components are no number.
  std::vector<Vec<Dim>> prescribed_velocities(
      Real time, const std::vector<MotionSupport<Dim>>& supports) const {
    constexpr Real kFree = std::numeric_limits<Real>::quiet_NaN();
    std::vector<Vec<Dim>> prescribed(patch.size(), Vec<Dim>::Constant(kFree));
    for (const auto& support : supports) {
      if (support.patch.points != patch.points) continue;
      support.visit_prescribed(time, patch.chosen,
                               [&](std::size_t k, int c, Real v) { prescribed[k][c] = v; });
    }
    return prescribed;
  }
  /// [kg/s] of a part of a face.
  Square impedance(const FacetPoint<Dim>& at) const {
    const Real area = std::sqrt(at.area.dot(at.area));
    if (area == 0) return Square::Zero();
    const Square along = at.area * at.area.transpose() / area;
    return of_pressure * along + of_shear * (area * Square::Identity() - along);
  }
};

}  // namespace brunt
