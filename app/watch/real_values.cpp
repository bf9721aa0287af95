#include "app/watch/real_values.hpp"

#include "app/deck/columns.hpp"
#include "app/deck/process_speed.hpp"
#include "core/fields.hpp"
#include "core/view_fields.hpp"

namespace brunt {

namespace {
int power_of_field(const std::string& name) {
  const FieldInfo* info = field_info(name);
  return info == nullptr ? 0 : deck::time_power(info->unit);
}
}  // namespace

void RealValues::make_real(Real& value, int power) const {
  for (int k = 0; k < power; ++k) value *= speed_;
  for (int k = 0; k > power; --k) value /= speed_;
}

void RealValues::set_columns(const std::vector<std::string>& columns) {
  powers_.clear();
  for (const auto& column : columns) {
    const char* unit = deck::unit_of_column(column);
    powers_.push_back(unit == nullptr ? 0 : deck::time_power(unit));
  }
}

void RealValues::make_real(std::vector<Real>& row) const {
  if (speed_ == 1) return;
  for (std::size_t c = 0; c < row.size(); ++c) make_real(row[c], powers_[c]);
}

void RealValues::make_real(BodyView& view) const {
  if (speed_ == 1) return;
  view.time *= speed_;
  for (auto* fields : {&view.point_fields, &view.cell_fields}) {
    for (auto& field : *fields) {
      const int power = power_of_field(field.name);
      if (power == 0) continue;
      make_values(field);
      for (Real& value : field.values) make_real(value, power);
    }
  }
}

}  // namespace brunt
