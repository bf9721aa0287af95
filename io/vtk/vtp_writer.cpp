#include "io/vtk/vtp_writer.hpp"

#include <algorithm>
#include <array>

#include "io/vtk/grid.hpp"

namespace brunt {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("view: " + what + " has the wrong length");
}

/// Contacts of one kind: which they are, their corners, and where those of each end.
struct ContactCells {
  std::vector<std::size_t> contact;
  std::vector<std::int64_t> connectivity, offsets;
};

/// Vertices, lines (planes in 2D), polygons; the order of kinds in a .vtp.
using ContactKinds = std::array<ContactCells, 3>;

ContactKinds kinds_of(const ContactView& view) {
  ContactKinds kinds;
  std::int64_t point = 0;
  for (std::size_t i = 0; i < view.polygon_size.size(); ++i) {
    const int n = view.polygon_size[i];
    if (n < 1) refuse("polygon_size");
    ContactCells& kind = kinds[slot_of(std::min(n, 3) - 1)];
    kind.contact.push_back(i);
    for (int c = 0; c < n; ++c) kind.connectivity.push_back(point++);
    kind.offsets.push_back(static_cast<std::int64_t>(kind.connectivity.size()));
  }
  if (view.position.size() != 3 * slot_of(point)) refuse("polygon_size");
  return kinds;
}

/// Values of contacts in the order of the file.
Field ordered(const char* name, int components, const std::vector<Real>& values,
              const ContactKinds& kinds) {
  const auto n = slot_of(components);
  Field field{name, components, {}};
  field.values.reserve(values.size());
  for (const auto& kind : kinds) {
    for (const std::size_t i : kind.contact) {
      if (values.size() < (i + 1) * n) refuse(std::string("contact field ") + name);
      const Real* const value = &values[i * n];
      field.values.insert(field.values.end(), value, value + n);
    }
  }
  if (field.values.size() != values.size()) refuse(std::string("contact field ") + name);
  return field;
}

VtkFileArray label_array(const char* name, const std::vector<Label>& labels,
                         const ContactKinds& kinds) {
  std::size_t n = 0;
  for (const auto& kind : kinds) n += kind.contact.size();
  if (labels.size() != n) refuse(name);
  const auto fill = [&labels, &kinds](std::int32_t* to) {
    for (const auto& kind : kinds) {
      for (const std::size_t i : kind.contact) *to++ = static_cast<std::int32_t>(labels[i]);
    }
  };
  return {"Int32", name, 1,
          [n, fill](std::string& room) { return made<std::int32_t>(room, n, fill); }};
}

VtkFileArray numbers(const char* name, const std::vector<std::int64_t>& values) {
  const std::span<const std::int64_t> all = values;
  return {"Int64", name, 1, [all](std::string&) { return bytes_of_values(all); }};
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const ContactView& view, Real time,
               VtkFileMemory& memory) {
  const ContactKinds kinds = kinds_of(view);
  const std::array fields{ordered("normal", 3, view.normal, kinds),
                          ordered("pressure", 1, view.pressure, kinds),
                          ordered("penetration", 1, view.penetration, kinds),
                          ordered("bonded", 1, view.bonded, kinds),
                          ordered("max_closure", 1, view.max_closure, kinds),
                          ordered("force", 3, view.force, kinds)};
  const auto body_a = label_array("body_a", view.body_a, kinds);
  const auto body_b = label_array("body_b", view.body_b, kinds);
  const auto count = [](std::size_t n) { return "\"" + std::to_string(n) + "\""; };
  constexpr std::array kNames{"Verts", "Lines", "Polys"};
  VtkFile file(path, "PolyData", time);
  std::string piece = "    <Piece NumberOfPoints=" + count(view.position.size() / 3);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    piece += std::string(" NumberOf") + kNames[k] + "=" + count(kinds[k].contact.size());
  }
  file.text(piece +
            " NumberOfStrips=\"0\">\n      <PointData>\n      </PointData>\n      <CellData>\n");
  for (const Field& field : fields) file.declare(singles(field));
  file.declare(body_a), file.declare(body_b);
  file.text("      </CellData>\n      <Points>\n");
  file.declare(reals("Points", 3, view.position));
  file.text("      </Points>\n");
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    file.text(std::string("      <") + kNames[k] + ">\n");
    file.declare(numbers("connectivity", kinds[k].connectivity));
    file.declare(numbers("offsets", kinds[k].offsets));
    file.text(std::string("      </") + kNames[k] + ">\n");
  }
  file.text("    </Piece>\n");
  file.finish(memory, "");
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
