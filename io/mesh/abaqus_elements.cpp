#include "io/mesh/abaqus_elements.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string_view>

namespace brunt {

namespace {
/// The kind of an element of a dimension by its number of nodes.
CellKind kind_of(int dim, int nodes) {
  using enum CellKind;
  if (dim == 1) return nodes == 2 ? line2 : higher1;
  if (dim == 2) return nodes == 3 ? tri3 : nodes == 4 ? quad4 : higher2;
  switch (nodes) {
    case 4:
      return tet4;
    case 5:
      return pyramid5;
    case 6:
      return wedge6;
    case 8:
      return hex8;
    default:
      return higher3;
  }
}

struct Family {
  std::string_view start;
  int dim;
};
constexpr Family kFamilies[] = {{"C3D", 3},   {"AC3D", 3}, {"CPE", 2},  {"CPS", 2},   {"CAX", 2},
                                {"AC2D", 2},  {"ACAX", 2}, {"STRI", 2}, {"SFM3D", 2}, {"M3D", 2},
                                {"R3D", 2},   {"DS", 2},   {"S", 2},    {"DC2D", 2},  {"DC1D", 1},
                                {"T3D", 1},   {"T2D", 1},  {"R2D", 1},  {"RAX", 1},   {"SAX", 1},
                                {"SFMAX", 1}, {"MAX", 1}};

/// Numbers of nodes of beams and pipes.
constexpr Family kBeams[] = {{"B21", 2},    {"B31", 2},    {"B22", 3},    {"B32", 3},
                             {"B23", 2},    {"B33", 2},    {"PIPE21", 2}, {"PIPE31", 2},
                             {"PIPE22", 3}, {"PIPE32", 3}, {"FRAME", 2}};

constexpr std::string_view kWithoutSolids[] = {
    "MASS",   "ROTARYI", "HEATCAP", "SPRING", "DASHPOT", "CONN",  "RB2D", "RB3D",
    "JOINTC", "GAP",     "DGAP",    "DCOUP",  "ITS",     "ITT",   "ISL",  "IRS",
    "ELBOW",  "DRAG",    "PSI",     "FLINK",  "F2D",     "F3D",   "FAX",  "LS3S",
    "LS6",    "FP2D",    "FP3D",    "FPC2D",  "FPC3D",   "TRACER"};

bool starts_with_one_of(std::string_view name, auto& starts) {
  return std::any_of(std::begin(starts), std::end(starts),
                     [&](std::string_view start) { return name.starts_with(start); });
}
}  // namespace

AbaqusType abaqus_type(const std::string& name) {
  if (starts_with_one_of(name, kWithoutSolids)) return {CellKind::point1, 0, true};
  const std::string_view whole = name;
  for (const auto& [start, nodes] : kBeams) {
    if (whole.starts_with(start)) return {kind_of(1, nodes), nodes};
  }
  // Elements of heat have the nodes of those of stress.
  for (const std::string_view text : {whole, whole.substr(whole.substr(0, 2) == "DC" ? 1 : 0)}) {
    for (const Family& family : kFamilies) {
      if (!text.starts_with(family.start)) continue;
      const std::string_view rest = text.substr(family.start.size());
      int nodes = 0;
      std::from_chars(rest.data(), rest.data() + rest.size(), nodes);
      if (nodes == 65) nodes = 6;  // STRI65
      if (family.start == "SAX" || family.start == "MAX" || family.start == "SFMAX") ++nodes;
      if (nodes < 2 || nodes > 27) continue;
      return {kind_of(family.dim, nodes), nodes};
    }
  }
  return {CellKind::other, 0};
}

std::vector<int> abaqus_face(CellKind kind, int face) {
  static const std::map<CellKind, std::vector<std::vector<int>>> kFaces = {
      {CellKind::hex8,
       {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}}},
      {CellKind::wedge6, {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}}},
      {CellKind::pyramid5, {{0, 1, 2, 3}, {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}}},
      {CellKind::tet4, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}},
      {CellKind::quad4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}},
      {CellKind::tri3, {{0, 1}, {1, 2}, {2, 0}}}};
  const auto found = kFaces.find(kind);
  if (found == kFaces.end() || face < 1 || face > static_cast<int>(found->second.size())) return {};
  return found->second[slot_of(face - 1)];
}

}  // namespace brunt
// Tested by tests/unit/io/abaqus_test.cpp.
