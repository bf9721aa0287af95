#include "app/watch/frame_check.hpp"

#include <limits>

#include "core/errors.hpp"
#include "core/view_fields.hpp"

namespace brunt {

void refuse_frame(const std::string& body, const std::string& field) {
  throw PhysicsError(
      {0, body, "a frame", field.empty() ? "a field" : field,
       std::numeric_limits<Real>::quiet_NaN(),
       "or beyond the 3.4e38 of a frame's single precision: the frame is not written; "
       "try a smaller time.safety, and look at the last rows of history.csv for what "
       "grows"});
}

void refuse_no_numbers(const std::vector<BodyView>& views, const ContactView& contact,
                       const Communicator& ranks) {
  std::string body, field;
  for (const auto& view : views) {
    if (!are_singles(view.position)) body = view.body, field = "position";
    for (const auto* fields : {&view.point_fields, &view.cell_fields}) {
      for (const auto& one : *fields) {
        if (!one.fill && !are_singles(one.values)) body = view.body, field = one.name;
      }
    }
  }
  for (const auto* values : {&contact.position, &contact.normal, &contact.pressure,
                             &contact.penetration, &contact.force}) {
    if (!are_singles(*values)) field = "contact";
  }
  if (!ranks.any(!field.empty())) return;
  refuse_frame(body, field);
}

}  // namespace brunt
