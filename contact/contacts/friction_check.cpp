#include "contact/contacts/friction_check.hpp"

#include <sstream>

namespace brunt {

namespace {
/// The place of a contact among all that are refused in a step: as keys are ordered, by kind, then
/// by the lower side, whose contacts one rank evaluates. Ids have less than 62 bits.
GlobalId order_of(ContactKind kind, GlobalId first) {
  constexpr int kIdBits = 62;
  return (static_cast<GlobalId>(kind) << kIdBits) | first;
}
}  // namespace

template <int Dim>
StepLimit FrictionCheck<Dim>::step_limit() const {
  return failure_ ? StepLimit{-1, "coefficient of friction", 0, 0} : StepLimit{};
}

template <int Dim>
void FrictionCheck<Dim>::check(Real time, const Vec<Dim>& origin) const {
  if (!failure_) return;
  PhysicsFailure failure = *failure_;
  failure.time = time;
  const Vec<Dim> at = at_ + origin;
  std::ostringstream place;
  for (int c = 0; c < Dim; ++c) place << (c == 0 ? " at (" : ", ") << at[c];
  failure.entity += place.str() + ") m";
  throw PhysicsError(failure);
}

template <int Dim>
void FrictionCheck<Dim>::refuse(const PairTable& pairs, const ContactRecord<Dim>& record,
                                const Friction<Dim>& friction) {
  const auto& at = friction.state;
  std::ostringstream cause;
  cause << "it must be at least 0, and is found at T = " << at.temperature
        << " K, yield = " << at.flow_stress << " Pa, p = " << at.pressure << " Pa, v = " << at.speed
        << " m/s";
  const auto pair = pairs.find(record.lower_body, record.upper_body);
  failure_ = {0,
              "",
              "contact " + pairs.name(pair.value()),
              "coefficient of friction",
              friction.coefficient,
              cause.str()};
  failure_->id = order_of(record.kind, record.first);
  at_ = friction.point;
}

template class FrictionCheck<2>;
template class FrictionCheck<3>;

}  // namespace brunt
// Tested by tests/unit/contact/friction_law_test.cpp.
