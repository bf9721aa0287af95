#include "io/vtk/vtp_writer.hpp"

#include <algorithm>
#include <array>

#include "io/vtk/grid.hpp"

namespace brunt {

namespace {

/// Contacts of one kind: their corners, and where those of each end.
struct ContactCells {
  std::vector<std::int64_t> connectivity, offsets;
};

/// Vertices, lines (planes in 2D), polygons, as polydata_order has them.
using ContactKinds = std::array<ContactCells, 3>;

ContactKinds kinds_of(const ContactView& view) {
  ContactKinds kinds;
  std::int64_t point = 0;
  for (const int n : view.polygon_size) {
    if (n < 1) misfit("polygon_size");
    ContactCells& kind = kinds[slot_of(std::min(n, 3) - 1)];
    for (int c = 0; c < n; ++c) kind.connectivity.push_back(point++);
    kind.offsets.push_back(static_cast<std::int64_t>(kind.connectivity.size()));
  }
  if (view.position.size() != 3 * slot_of(point)) misfit("polygon_size");
  return kinds;
}

VtkFileArray label_array(const char* name, const std::vector<Label>& labels,
                         const std::vector<std::size_t>& order) {
  if (labels.size() != order.size()) misfit(name);
  const auto fill = [&labels, &order](std::int32_t* to) {
    for (const std::size_t i : order) *to++ = static_cast<std::int32_t>(labels[i]);
  };
  return {"Int32", name, 1, [&order, fill](std::string& room) {
            return made<std::int32_t>(room, order.size(), fill);
          }};
}

VtkFileArray numbers(const char* name, const std::vector<std::int64_t>& values) {
  const std::span<const std::int64_t> all = values;
  return {"Int64", name, 1, [all](std::string&) { return bytes_of_values(all); }};
}

VtkFileArray key_array(const ContactView& view, const std::vector<std::size_t>& order) {
  if (view.key.size() != order.size()) misfit("key");
  const auto fill = [&view, &order](std::int64_t* to) {
    for (const std::size_t i : order) {
      for (const GlobalId number : view.key[i]) *to++ = static_cast<std::int64_t>(number);
    }
  };
  return {"Int64\" IdType=\"1", "key", 4, [&order, fill](std::string& room) {
            return made<std::int64_t>(room, 4 * order.size(), fill);
          }};
}

/// What the file says of each contact. The view has to stay.
class OfContacts {
 public:
  explicit OfContacts(const ContactView& view)
      : view_(view),
        order_(polydata_order(view)),
        fields_{reordered("normal", 3, view.normal, order_),
                reordered("pressure", 1, view.pressure, order_),
                reordered("penetration", 1, view.penetration, order_),
                reordered("bonded", 1, view.bonded, order_),
                reordered("max_closure", 1, view.max_closure, order_),
                reordered("force", 3, view.force, order_)} {}
  OfContacts(const OfContacts&) = delete;
  OfContacts& operator=(const OfContacts&) = delete;

  /// They point into this.
  std::vector<VtkFileArray> arrays(bool piece) const {
    std::vector<VtkFileArray> arrays;
    for (const Field& field : fields_) arrays.push_back(singles(field));
    arrays.push_back(label_array("body_a", view_.body_a, order_));
    arrays.push_back(label_array("body_b", view_.body_b, order_));
    if (piece) arrays.push_back(key_array(view_, order_));
    return arrays;
  }

 private:
  const ContactView& view_;
  std::vector<std::size_t> order_;
  std::array<Field, 6> fields_;
};

}  // namespace

void write_vtp(const std::filesystem::path& path, const ContactView& view, Real time, bool piece,
               VtkFileMemory& memory) {
  const ContactKinds kinds = kinds_of(view);
  const OfContacts of_contacts(view);
  auto arrays = of_contacts.arrays(piece);
  const auto count = [](std::size_t n) { return "\"" + std::to_string(n) + "\""; };
  constexpr std::array kNames{"Verts", "Lines", "Polys"};
  VtkFile file(path, "PolyData", time);
  std::string head = "    <Piece NumberOfPoints=" + count(view.position.size() / 3);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    head += std::string(" NumberOf") + kNames[k] + "=" + count(kinds[k].offsets.size());
  }
  file.text(head +
            " NumberOfStrips=\"0\">\n      <PointData>\n      </PointData>\n      <CellData>\n");
  for (auto& array : arrays) file.declare(std::move(array));
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

FramePiece listed_arrays(const ContactView& view) {
  FramePiece piece;
  for (const auto& array : OfContacts(view).arrays(true)) piece.cell_arrays += joined_line(array);
  return piece;
}

}  // namespace brunt
// Tested by tests/unit/io/pieces_test.cpp.
