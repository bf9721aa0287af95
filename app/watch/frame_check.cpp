#include "app/watch/frame_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/errors.hpp"

namespace brunt {

namespace {
bool all_finite(const std::vector<Real>& values) {
  return std::all_of(values.begin(), values.end(), [](Real value) {
    return std::fabs(value) <= static_cast<Real>(std::numeric_limits<float>::max());
  });
}
}  // namespace

void refuse_no_numbers(const std::vector<BodyView>& views, const ContactView& contact,
                       const Communicator& ranks) {
  std::string body, field;
  for (const auto& view : views) {
    if (!all_finite(view.position)) body = view.body, field = "position";
    for (const auto* fields : {&view.point_fields, &view.cell_fields}) {
      for (const auto& one : *fields) {
        if (!all_finite(one.values)) body = view.body, field = one.name;
      }
    }
  }
  for (const auto* values : {&contact.position, &contact.normal, &contact.pressure,
                             &contact.penetration, &contact.force}) {
    if (!all_finite(*values)) field = "contact";
  }
  if (!ranks.any(!field.empty())) return;
  throw PhysicsError({0, body, "a frame", field.empty() ? "a field" : field,
                      std::numeric_limits<Real>::quiet_NaN(),
                      "the frame is not written; try a smaller time.safety, and look at the last "
                      "rows of history.csv for what grows"});
}

}  // namespace brunt
