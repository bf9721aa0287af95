#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/boundaries/function.hpp"
#include "core/boundaries/patch.hpp"
#include "core/ledger.hpp"

namespace brunt {

template <int Dim>
struct MotionSupport;

/// The deck's `fix` and `velocity`: components of the velocity of points that are prescribed.
struct PrescribedMotion {
  static constexpr const char* deck_keys = "fix, velocity";
  template <int Dim>
  using Acting = MotionSupport<Dim>;

  std::vector<std::string> fix;  ///< "x", "y", "z"; empty: none
  /// [m/s] by component; absent: free
  std::optional<std::vector<std::optional<Varying>>> velocity;

  bool given() const { return !fix.empty() || velocity; }
  bool pushes() const { return velocity.has_value(); }  ///< it may set a body in motion
};
void describe(Schema& s, PrescribedMotion& motion);

/// Holds points or prescribes their motion: docs/theory/integration.md (I8), (I9).
template <int Dim>
struct MotionSupport {
  static constexpr const char* kTable = "support.";
  Patch<Dim> patch;
  std::array<std::optional<FunctionOfTimeAndPlace>, Dim> velocity;  ///< [m/s]; empty: free
  std::vector<Vec<Dim>> reaction;                                   ///< [N] at the last full step
  std::vector<Real> work;                                           ///< [J] done on the scene

  MotionSupport() = default;
  MotionSupport(const PrescribedMotion& motion, Patch<Dim> on);
  template <class Support, class F>
  static void visit_fields(Support& support, const F& f) {
    f(support.reaction, kSaved);
    f(support.work, kSaved);
  }
  template <class F>
  void visit_reports(const F& f) const {
    f("reaction", reaction);
  }
  template <class F>
  void visit_functions(const F& f) const {
    for (std::size_t c = 0; c < Dim; ++c) {
      if (velocity[c]) f("velocity." + std::to_string(c), *velocity[c]);
    }
  }

  /// visit(k, c, v) for each component c of the points among[k] that it holds or moves at a time,
  /// with the velocity v [m/s] that they then have. among  ascends
  template <class Visit>
  void visit_prescribed(Real time, const std::vector<LocalIndex>& among, const Visit& visit) const {
    if (!patch.acts(time)) return;
    std::size_t at = 0;
    for (std::size_t k = 0; k < patch.size(); ++k) {
      while (at < among.size() && among[at] < patch.chosen[k]) ++at;
      if (at == among.size()) return;
      if (among[at] != patch.chosen[k]) continue;
      const Vec3 place = patch.place(k);
      for (int c = 0; c < Dim; ++c) {
        if (velocity[c]) visit(at, c, (*velocity[c])(time, place));
      }
    }
  }

  /// Gives points their velocities at time 0, before the first energy is taken.
  void start();
  /// After predict: overrides x and v; time is that of the end of the step. The acceleration at its
  /// start becomes the one that makes the prescribed velocity.
  void impose(Real time, Real dt);
  /// After all forces: takes what held points carry; books 1/2 (R(n) + R(n+1)).dx.
  void take_reactions(Real time, Real dt);
  void add_totals(Totals<Dim>& totals) const;
};

}  // namespace brunt
// Tested by tests/unit/app/supports_test.cpp.
