#include "io/mesh/ls_dyna_keyword.hpp"

#include <algorithm>

#include "io/mesh/card.hpp"

namespace brunt {

namespace {
constexpr DynaColumns kStandard{8, 16, 10, ""},
    kI10{10, 16, 10, ": the format I10 (I10=Y or %) has numbers of 10 columns"},
    kLong{20, 20, 20, ": the long format (LONG=Y or +) has numbers of 20 columns"};

/// The columns that a letter behind a keyword asks for; null: it is no such letter.
const DynaColumns* columns_by(char letter) {
  switch (letter) {
    case '%':
      return &kI10;
    case '+':
      return &kLong;
    case '-':
      return &kStandard;
    default:
      return nullptr;
  }
}

struct Refusal {
  std::string_view start;  ///< of the keyword
  const char* instead;
};
constexpr const char* kWriteAll = "write the nodes and elements themselves, in one file";
constexpr const char* kWriteSolid =
    "write *ELEMENT_SOLID with nodes at corners; directions of a material belong to the deck";
constexpr const char* kMoveIt =
    "write the nodes where they are, or use `translate` and `rotate` of the deck";
constexpr const char* kMeshIt = "write its mesh as *NODE and *ELEMENT_SOLID";
constexpr Refusal kRefusals[] = {{"*INCLUDE", kWriteAll},
                                 {"*NODE_TRANSFORM", kMoveIt},
                                 {"*NODE_MERGE", kWriteAll},
                                 {"*NODE_RIGID_SURFACE", "write *NODE and *ELEMENT_SHELL"},
                                 {"*NODE_TO_TARGET_VECTOR", kMoveIt},
                                 {"*DEFINE_TRANSFORMATION", kMoveIt},
                                 {"*PARAMETER_DUPLICATION", kWriteAll},
                                 {"*PART_DUPLICATE", kWriteAll},
                                 {"*PART_MOVE", kMoveIt},
                                 {"*PART_STACKED_ELEMENTS", kWriteAll},
                                 {"*ELEMENT_GENERALIZED", kWriteAll},
                                 {"*ELEMENT_INTERPOLATION", kMeshIt},
                                 {"*ELEMENT_SOLID_", kWriteSolid},
                                 {"*ELEMENT_TSHELL", kWriteSolid},
                                 {"*ALE_STRUCTURED_MESH", kMeshIt},
                                 {"*COMPONENT_", kMeshIt},
                                 {"*IGA_", kMeshIt},
                                 {"*MESH_", kMeshIt}};
}  // namespace

DynaKeyword dyna_keyword(std::string_view line, const DynaColumns& usual) {
  const std::size_t end = std::min(line.find_first_of(" \t("), line.size());
  DynaKeyword keyword{upper(line.substr(0, end)), usual};
  std::string& name = keyword.name;
  while (!name.empty() && columns_by(name.back())) {
    keyword.columns = *columns_by(name.back());
    name.pop_back();
  }
  std::string_view rest = trimmed(line.substr(end));
  if (rest.starts_with('(')) rest = trimmed(rest.substr(std::min(rest.find(')') + 1, rest.size())));
  if (!rest.empty() && columns_by(rest.front())) keyword.columns = *columns_by(rest.front());
  return keyword;
}

DynaColumns columns_of_file(std::string_view keyword_line) {
  std::string line;
  for (const char c : upper(keyword_line)) {
    if (c != ' ' && c != '\t') line += c;
  }
  const auto has = [&](const char* text) { return line.find(text) != std::string::npos; };
  // LONG=S is standard columns, and long ones of another file that LS-DYNA writes; K the reverse.
  if (has("LONG=Y") || has("LONG=K")) return kLong;
  return has("I10=Y") ? kI10 : kStandard;
}

const char* instead_of_dyna(std::string_view keyword) {
  for (const Refusal& one : kRefusals) {
    if (keyword.starts_with(one.start)) return one.instead;
  }
  ShellLines lines;
  if (keyword.starts_with("*ELEMENT_SHELL") && !find_shell_lines(keyword, lines)) {
    return "write *ELEMENT_SHELL, or leave it out of the file: no body is made of shells";
  }
  // *NODE_SCALAR and *NODE_THICKNESS make no node with a place.
  if (keyword.starts_with("*NODE_") && !keyword.starts_with("*NODE_SCALAR") &&
      !keyword.starts_with("*NODE_THICKNESS")) {
    return kWriteAll;
  }
  return nullptr;
}

bool find_shell_lines(std::string_view keyword, ShellLines& lines) {
  std::string_view options = keyword.substr(std::string_view("*ELEMENT_SHELL").size());
  lines = {};
  bool has_thickness_line = false;
  while (!options.empty()) {
    if (options.front() != '_') return false;
    options.remove_prefix(1);
    const std::string_view one = options.substr(0, options.find('_'));
    options.remove_prefix(one.size());
    if (one == "THICKNESS") lines.higher = 1;
    if (one == "THICKNESS" || one == "BETA" || one == "MCID") {
      has_thickness_line = true;
    } else if (one == "OFFSET" || one == "DOF") {
      ++lines.always;
    } else {
      return false;
    }
  }
  lines.always += has_thickness_line;
  return true;
}

}  // namespace brunt
// Tested by tests/unit/io/ls_dyna_test.cpp.
