#include "app/cli/columns_page.hpp"

#include <string_view>

#include "app/deck/columns.hpp"
#include "core/fields.hpp"

namespace brunt {

namespace {

constexpr const char* kIntroduction = R"(# Columns and fields

Printed by `brunt schema --columns`, from the tables that the program itself reads. All in SI units;
1 is a pure number. Plane strain is per `depth`, axisymmetric scenes are the whole ring.

## Columns of `history.csv`

NAME is the deck's name, of a pair of bodies that the deck does not name `a-b`. AXIS is x, y or z:
in two dimensions x and y of vectors, z of torques, moments, rotations and spins. A row is written
at the end of a step.
)";

constexpr const char* kFrames = R"(
## Fields of frames

A vector has components x, y, z; a tensor xx, yy, zz, xy, yz, zx. Measures and probes take
`velocity.z`, `stress.xx` and `velocity.magnitude`.
)";

struct Subject {
  const char* head;  ///< the first word of its columns; "": those of one word
  const char* title;
};
constexpr Subject kSubjects[] = {{"", "The step"},
                                 {"energy", "Energies of the scene"},
                                 {"momentum", "Momentum of the scene"},
                                 {"body", "A body"},
                                 {"contact", "A pair of bodies in contact"},
                                 {"boundary", "A boundary"},
                                 {"probe", "A probe"},
                                 {"section", "A section"},
                                 {"heat", "Heat of the scene, where something conducts"}};

std::string_view head_of(std::string_view pattern) {
  const auto dot = pattern.find('.');
  return dot == std::string_view::npos ? "" : pattern.substr(0, dot);
}

std::string row(const std::string& name, const std::string& unit, const char* meaning) {
  return "| `" + name + "` | " + unit + " | " + meaning + " |\n";
}

std::string column_tables() {
  std::string text;
  for (const Subject& subject : kSubjects) {
    text +=
        std::string("\n### ") + subject.title + "\n\n| column | unit | meaning |\n|---|---|---|\n";
    for (const auto& column : deck::kHistoryColumns) {
      if (head_of(column.pattern) != subject.head) continue;
      const std::string unit = *column.unit != '\0' ? column.unit : "of the field";
      text += row(column.pattern, unit, column.meaning);
    }
  }
  return text;
}

std::string field_row(const FieldInfo& field) {
  const char* kind = field.components == 3 ? ", vector" : field.components == 6 ? ", tensor" : "";
  return row(field.name, std::string(field.unit) + kind, field.meaning);
}

}  // namespace

std::string columns_page() {
  constexpr const char* kHead = "\n| field | unit | meaning |\n|---|---|---|\n";
  std::string text = kIntroduction + column_tables() + kFrames;
  text += std::string("\n### Of a body\n") + kHead;
  for (const FieldInfo& field : kFields) text += field_row(field);
  text += field_row(kRadiusField) + field_row(kOwnerField);
  text += std::string("\n### Of contacts\n") + kHead;
  for (const FieldInfo& field : kContactFields) text += field_row(field);
  text += std::string("\n### Of a run of several ranks\n") + kHead;
  for (const FieldInfo& field : kRankFields) text += field_row(field);
  return text;
}

}  // namespace brunt
