#include "app/watch/frame_check.hpp"

#include <atomic>
#include <cmath>
#include <limits>

#include "core/errors.hpp"
#include "core/view_fields.hpp"

namespace brunt {

namespace {
/// True where all are numbers that a frame can hold.
bool all_finite(std::span<const Real> values) {
  constexpr Real kMost = std::numeric_limits<float>::max();
  bool all = true;  // without a way out in between, several at a time
  for (const Real value : values) all &= std::fabs(value) <= kMost;
  return all;
}

bool all_finite(const Field& field) {
  std::atomic<bool> all = true;
  for_parts(field, [&all](std::size_t, std::span<const Real> part) {
    if (!all_finite(part)) all = false;
  });
  return all;
}
}  // namespace

void refuse_no_numbers(const std::vector<BodyView>& views, const ContactView& contact,
                       const Communicator& ranks) {
  std::string body, field;
  for (const auto& view : views) {
    if (!all_finite(view.position)) body = view.body, field = "position";
    for (const auto* fields : {&view.point_fields, &view.cell_fields}) {
      for (const auto& one : *fields) {
        if (!all_finite(one)) body = view.body, field = one.name;
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
