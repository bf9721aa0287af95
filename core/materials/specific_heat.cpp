#include "core/materials/specific_heat.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace brunt {

namespace {
/// The interval k .. k + 1 of ascending values that s lies in; s is between the first and the last.
std::size_t interval_of(const std::vector<Real>& values, Real s) {
  const auto next = std::upper_bound(values.begin() + 1, values.end() - 1, s);
  return slot_of(next - values.begin()) - 1;
}
}  // namespace

SpecificHeat::SpecificHeat(const Varying& given) {
  assert(!given.is_expression());
  if (given.is_constant() || given.abscissa.size() < 2) {
    cp_ = {given.is_constant() ? given.constant : given.ordinate.front()};
    return;
  }
  T_ = given.abscissa, cp_ = given.ordinate;
  integrate();
}

void SpecificHeat::integrate() {
  h_ = {0.0};
  for (std::size_t k = 1; k < T_.size(); ++k) {
    h_.push_back(h_.back() + 0.5 * (cp_[k - 1] + cp_[k]) * (T_[k] - T_[k - 1]));
  }
}

SpecificHeat SpecificHeat::of_mixture(std::span<const SpecificHeat* const> parts,
                                      std::span<const Real> shares) {
  assert(parts.size() == shares.size());
  const auto at = [&](Real T) {
    Real sum = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) sum += shares[k] * parts[k]->at(T);
    return sum;
  };
  std::vector<Real> T;
  for (const auto* part : parts) {
    if (part->varies()) T.insert(T.end(), part->T_.begin(), part->T_.end());
  }
  std::sort(T.begin(), T.end());
  T.erase(std::unique(T.begin(), T.end()), T.end());
  if (T.empty()) return SpecificHeat(at(0));
  SpecificHeat mixture;
  mixture.cp_.clear();
  for (const Real one : T) mixture.cp_.push_back(at(one));
  mixture.T_ = std::move(T);
  mixture.integrate();
  return mixture;
}

Real SpecificHeat::at(Real T) const {
  if (!varies() || T <= T_.front()) return cp_.front();
  if (T >= T_.back()) return cp_.back();
  const std::size_t k = interval_of(T_, T);
  return cp_[k] + (T - T_[k]) / (T_[k + 1] - T_[k]) * (cp_[k + 1] - cp_[k]);
}

Real SpecificHeat::enthalpy(Real T) const {
  if (!varies()) return cp_.front() * T;
  if (T <= T_.front()) return cp_.front() * (T - T_.front());
  if (T >= T_.back()) return h_.back() + cp_.back() * (T - T_.back());
  const std::size_t k = interval_of(T_, T);
  return h_[k] + 0.5 * (cp_[k] + at(T)) * (T - T_[k]);
}

Real SpecificHeat::temperature(Real h) const {
  if (!varies()) return h / cp_.front();
  if (h <= 0) return T_.front() + h / cp_.front();
  if (h >= h_.back()) return T_.back() + (h - h_.back()) / cp_.back();
  // cp d + slope d^2/2 = h - h_k, by the form of the root that does not cancel. The root's
  // argument is cp^2 at that temperature: positive.
  const std::size_t k = interval_of(h_, h);
  const Real rest = h - h_[k], slope = (cp_[k + 1] - cp_[k]) / (T_[k + 1] - T_[k]);
  const Real there = std::sqrt(std::max(cp_[k] * cp_[k] + 2 * slope * rest, 0.0));
  return T_[k] + 2 * rest / (cp_[k] + there);
}

Real SpecificHeat::least_between(Real a, Real b) const {
  if (!varies()) return cp_.front();
  const Real low = std::min(a, b), high = std::max(a, b);
  Real least = std::min(at(low), at(high));
  for (std::size_t k = interval_of(T_, std::clamp(low, T_.front(), T_.back()));
       k < T_.size() && T_[k] < high; ++k) {
    if (T_[k] > low) least = std::min(least, cp_[k]);
  }
  return least;
}

Real SpecificHeat::least() const { return *std::min_element(cp_.begin(), cp_.end()); }

}  // namespace brunt
