#pragma once
#include <optional>

#include "contact/contacts/record.hpp"
#include "core/errors.hpp"

namespace brunt {

/// Coefficients of friction come from expressions, which may give anything: a step in which one is
/// below 0 or not finite is the last.
template <int Dim>
class FrictionCheck {
 public:
  /// Before an evaluation's frictions are seen.
  void clear() { failure_.reset(); }
  /// Remembers the first coefficient that is no number at least 0.
  void see(const PairTable& pairs, const ContactRecord<Dim>& record,
           const Friction<Dim>& friction) {
    const bool right = friction.coefficient >= 0 && friction.coefficient < kInfinity;
    if (!right && !failure_) refuse(pairs, record, friction);
  }
  /// No step where there was one.
  StepLimit step_limit() const;
  /// Throws PhysicsError where there was one. origin  [m] of the positions
  void check(Real time, const Vec<Dim>& origin) const;

 private:
  void refuse(const PairTable& pairs, const ContactRecord<Dim>& record,
              const Friction<Dim>& friction);

  std::optional<PhysicsFailure> failure_;
  Vec<Dim> at_ = Vec<Dim>::Zero();  // [m]
};

}  // namespace brunt
// Tested by tests/unit/contact/friction_law_test.cpp.
