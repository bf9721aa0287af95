#pragma once
#include <string>
#include <vector>

#include "core/view.hpp"

namespace brunt {

/// Makes of what is stepped faster (time.process_speed) what the process is: the one place where
/// results become real. Each value goes by the power of time in its unit: times are multiplied by
/// the speed, velocities, rates, powers and momenta divided, accelerations twice. Forces, stresses,
/// temperatures and energies, the kinetic one among them, are as they were stepped.
class RealValues {
 public:
  explicit RealValues(Real speed) : speed_(speed) {}

  /// Names of the columns of the rows to come; one that is no column stays as it is.
  void set_columns(const std::vector<std::string>& columns);
  void make_real(std::vector<Real>& row) const;
  /// Its fields, and the time.
  void make_real(BodyView& view) const;

 private:
  void make_real(Real& value, int power) const;

  Real speed_;
  std::vector<int> powers_;  // of time, by column
};

}  // namespace brunt
// Tested by tests/unit/app/process_speed_test.cpp.
