#include "app/deck/probes.hpp"

namespace brunt::deck {

void describe(Schema& s, Probe& probe) {
  s.text({"body", "name of a body, or of a piece of one: wall.1.0", Need::required}, probe.body);
  s.list({"at", "a place at time 0", Need::required}, probe.at, {"m"}, Schema::kVector);
  s.names(
      {"fields",
       "fields there, between points or of the element: temperature, stress.xx, velocity.magnitude",
       Need::required},
      probe.fields, 0);
  for (const std::string& field : probe.fields) {
    s.require(unit_of_field(field) != nullptr, "fields", field_problem(field));
  }
}

void describe(Schema& s, Section& section) {
  s.text({"body", "name of a body", Need::required}, section.body);
  s.object({"plane", "a plane of the material at time 0", Need::required}, section.plane);
}

}  // namespace brunt::deck
