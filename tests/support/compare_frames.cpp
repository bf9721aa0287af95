/// Compares the frames of a run with those of others, each body and the contacts whole: the same
/// times, parts, arrays and bits, on whatever ranks they were written. Prints the first difference
/// of each; status 1.
///   compare_frames FOLDER FOLDER...
#include <algorithm>
#include <bit>
#include <cstdio>

#include "core/errors.hpp"
#include "io/vtk/frame_reader.hpp"

namespace brunt {
namespace {

struct Difference {
  std::string text;
};

/// Compares arrays of `width` values a row; ids name the rows, where there are any.
template <class Value>
void compare(const std::string& where, const std::vector<Value>& a, const std::vector<Value>& b,
             std::size_t width, const std::vector<Real>& ids) {
  const auto same = [](Value x, Value y) {
    if constexpr (std::is_same_v<Value, Real>) {
      return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    }
    return x == y;
  };
  const auto [x, y] = std::mismatch(a.begin(), a.end(), b.begin(), b.end(), same);
  if (x == a.end() && y == b.end()) return;
  if (x == a.end() || y == b.end()) {
    throw Difference{where + ": " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                     " values"};
  }
  const std::size_t row = static_cast<std::size_t>(x - a.begin()) / width;
  std::string text = where + ": row " + std::to_string(row);
  if (row < ids.size()) text += " (id " + std::to_string(static_cast<GlobalId>(ids[row])) + ")";
  std::array<char, 64> values;
  std::snprintf(values.data(), values.size(), ": %.17g and %.17g", static_cast<double>(*x),
                static_cast<double>(*y));
  throw Difference{text + values.data()};
}

void compare(const std::string& where, const std::vector<Field>& a, const std::vector<Field>& b) {
  std::string in_a, in_b;
  for (const auto& field : a) in_a += " " + field.name + ":" + std::to_string(field.components);
  for (const auto& field : b) in_b += " " + field.name + ":" + std::to_string(field.components);
  if (in_a != in_b) throw Difference{where + ": fields" + in_a + " and" + in_b};
  std::vector<Real> ids;
  for (const auto& field : a) {
    if (field.name == "id") ids = field.values;
  }
  for (std::size_t f = 0; f < a.size(); ++f) {
    compare(where + ", " + a[f].name, a[f].values, b[f].values,
            static_cast<std::size_t>(a[f].components), ids);
  }
}

void compare(const std::string& where, const BodyView& a, const BodyView& b) {
  if (a.position.empty() && b.position.empty()) return;  // without pieces there are no fields
  if (a.corners != b.corners) throw Difference{where + ": cells of other corners"};
  compare(where + ", points", a.point_fields, b.point_fields);
  compare(where + ", cells", a.cell_fields, b.cell_fields);
  compare(where + ", position", a.position, b.position, 3, {});
  compare(where + ", radius", a.point_radius, b.point_radius, 1, {});
  const auto corners = static_cast<std::size_t>(std::max(a.corners, 1));
  compare(where + ", connectivity", a.connectivity, b.connectivity, corners, {});
}

void compare(const std::string& where, const ContactView& a, const ContactView& b) {
  compare(where + ", polygon_size", a.polygon_size, b.polygon_size, 1, {});
  compare(where + ", position", a.position, b.position, 3, {});
  compare(where + ", normal", a.normal, b.normal, 3, {});
  compare(where + ", pressure", a.pressure, b.pressure, 1, {});
  compare(where + ", penetration", a.penetration, b.penetration, 1, {});
  compare(where + ", bonded", a.bonded, b.bonded, 1, {});
  compare(where + ", max_closure", a.max_closure, b.max_closure, 1, {});
  compare(where + ", force", a.force, b.force, 3, {});
  compare(where + ", body_a", a.body_a, b.body_a, 1, {});
  compare(where + ", body_b", a.body_b, b.body_b, 1, {});
}

void compare_folders(const std::string& first, const std::string& second) {
  const auto a = read_frame_index(first), b = read_frame_index(second);
  if (a.size() != b.size() || a.empty()) {
    throw Difference{std::to_string(a.size()) + " and " + std::to_string(b.size()) + " frames"};
  }
  for (std::size_t f = 0; f < a.size(); ++f) {
    const std::string where = "frame " + std::to_string(f);
    if (a[f].time != b[f].time) throw Difference{where + ": at other times"};
    if (a[f].parts.size() != b[f].parts.size()) throw Difference{where + ": other parts"};
    for (std::size_t p = 0; p < a[f].parts.size(); ++p) {
      if (a[f].parts[p].name != b[f].parts[p].name) throw Difference{where + ": other parts"};
    }
    const auto bodies_a = read_frame(first, a[f]), bodies_b = read_frame(second, b[f]);
    if (bodies_a.size() != bodies_b.size()) throw Difference{where + ": other bodies"};
    for (std::size_t k = 0; k < bodies_a.size(); ++k) {
      compare(where + ", " + bodies_a[k].body, bodies_a[k], bodies_b[k]);
    }
    compare(where + ", contact", read_contacts(first, a[f]), read_contacts(second, b[f]));
  }
}

}  // namespace
}  // namespace brunt

int main(int argc, char** argv) {
  if (argc < 3) return std::fputs("compare_frames FOLDER FOLDER...\n", stderr), 2;
  int status = 0;
  for (int other = 2; other < argc; ++other) {
    try {
      brunt::compare_folders(argv[1], argv[other]);
      continue;
    } catch (const brunt::Difference& difference) {
      std::printf("%s, %s: %s\n", argv[1], argv[other], difference.text.c_str());
    } catch (const brunt::MachineError& error) {
      std::printf("%s\n", error.what());
    }
    status = 1;
  }
  return status;
}
