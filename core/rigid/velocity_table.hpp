#pragma once
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// A velocity over time, linear between the times of a table and held outside, with its integral in
/// closed form: where a body is does not depend on the steps that led there.
class VelocityTable {
 public:
  /// time [s], increasing;  velocity [m/s] at each
  VelocityTable(std::vector<Real> time, std::vector<Real> velocity);
  Real velocity(Real t) const;  ///< [m/s]
  /// [m] from time 0 to t
  Real travel(Real t) const { return integral(t) - at_zero_; }

 private:
  /// Which row t follows; none before the first.
  std::size_t rows_until(Real t) const;
  Real integral(Real t) const;  // [m] from the first row on

  std::vector<Real> time_, velocity_;
  std::vector<Real> sum_;  // [m] integral up to each row
  Real at_zero_ = 0;       // [m] integral at time 0
};

}  // namespace brunt
