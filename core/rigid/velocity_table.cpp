#include "core/rigid/velocity_table.hpp"

#include <algorithm>
#include <utility>

namespace brunt {

VelocityTable::VelocityTable(std::vector<Real> time, std::vector<Real> velocity)
    : time_(std::move(time)), velocity_(std::move(velocity)), sum_{0} {
  for (std::size_t k = 1; k < time_.size(); ++k) {
    const Real mean = 0.5 * (velocity_[k - 1] + velocity_[k]);
    sum_.push_back(sum_.back() + mean * (time_[k] - time_[k - 1]));
  }
  at_zero_ = integral(0);
}

std::size_t VelocityTable::rows_until(Real t) const {
  return static_cast<std::size_t>(std::upper_bound(time_.begin(), time_.end(), t) - time_.begin());
}

Real VelocityTable::velocity(Real t) const {
  const std::size_t next = rows_until(t);
  if (next == 0) return velocity_.front();
  if (next == time_.size()) return velocity_.back();
  const std::size_t k = next - 1;
  const Real slope = (velocity_[next] - velocity_[k]) / (time_[next] - time_[k]);
  return velocity_[k] + slope * (t - time_[k]);
}

Real VelocityTable::integral(Real t) const {
  const std::size_t next = rows_until(t);
  if (next == 0) return velocity_.front() * (t - time_.front());
  const std::size_t k = next - 1;
  return sum_[k] + 0.5 * (velocity_[k] + velocity(t)) * (t - time_[k]);
}

}  // namespace brunt
