#include "io/vtk/vtu_writer.hpp"

#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <span>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/vtk/grid.hpp"
#include "io/vtk/pieces.hpp"

namespace brunt {

namespace {

constexpr std::size_t kPackedBlock = 1 << 15;  // [byte] VTK's own; a multiple of all numbers
constexpr std::size_t kPackedAtOnce = 64;      // blocks
constexpr std::size_t kOffsetRoom = 32;        // characters of ` offset="..."`

/// One array of the file. Its bytes are made when it is written, and gone again after that.
struct VtuArray {
  std::string type;  ///< "Float64", with further attributes behind it
  std::string name;
  int components = 1;
  std::size_t n_values = 0;  ///< of all components
  std::function<std::string_view(std::string& room)> bytes;
};

template <class T>
std::string_view bytes_of_values(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// n numbers of another type, made in the room by fill(To* first).
template <class To, class Fill>
std::string_view made(std::string& room, std::size_t n, const Fill& fill) {
  room.resize(n * sizeof(To));
  fill(reinterpret_cast<To*>(room.data()));
  return room;
}

/// Whole numbers, the largest of which is given: in 32 bits where it fits, half as many to pack.
template <class Fill>
VtuArray whole_numbers(const char* name, std::size_t n, std::size_t largest, const Fill& fill) {
  if (largest <= std::numeric_limits<std::int32_t>::max()) {
    return {"Int32", name, 1, n,
            [n, fill](std::string& room) { return made<std::int32_t>(room, n, fill); }};
  }
  return {"Int64", name, 1, n,
          [n, fill](std::string& room) { return made<std::int64_t>(room, n, fill); }};
}

/// In double: places, which may be far from the origin, and the time.
VtuArray reals(const std::string& name, int components, const std::vector<Real>& values) {
  return {"Float64", name, components, values.size(),
          [&values](std::string&) { return bytes_of_values(values); }};
}

VtuArray singles(const std::string& name, int components, const std::vector<Real>& values) {
  const auto fill = [&values](float* to) {
    std::transform(values.begin(), values.end(), to, [](Real value) { return single_of(value); });
  };
  return {"Float32", name, components, values.size(),
          [&values, fill](std::string& room) { return made<float>(room, values.size(), fill); }};
}

VtuArray array_of(const Field& field) {
  if (!is_whole_field(field.name)) return singles(field.name, field.components, field.values);
  const auto& values = field.values;
  const auto fill = [&values](std::int64_t* to) { std::copy(values.begin(), values.end(), to); };
  return {"Int64\" IdType=\"1", field.name, field.components, values.size(),
          [&values, fill](std::string& r) { return made<std::int64_t>(r, values.size(), fill); }};
}

/// How many corners each cell has: all that a cell of the view may, but for triangles among quads.
std::size_t corners_in(const BodyView& view, std::size_t first, std::size_t corners) {
  const bool may_be_triangle = corners == 4 && view.cell_dimension != 3;
  const auto* cell = &view.connectivity[first];
  return may_be_triangle && (cell[3] < 0 || cell[3] == cell[2]) ? 3 : corners;
}

/// connectivity, offsets and types; particles are one vertex a point.
std::vector<VtuArray> cell_arrays(const BodyView& view, std::size_t n_points) {
  const auto corners = slot_of(std::max(view.corners, 1));
  const std::size_t n = view.corners == 0 ? n_points : view.connectivity.size() / corners;
  const auto size = [&view, corners](std::size_t c) {
    return view.corners == 0 ? std::size_t{1} : corners_in(view, c * corners, corners);
  };
  std::size_t n_corners = 0;
  for (std::size_t c = 0; c < n; ++c) n_corners += size(c);
  const auto fill_corners = [&view, n, size, corners](auto* to) {
    using To = std::remove_pointer_t<decltype(to)>;
    if (view.corners == 0) return std::iota(to, to + n, To{0});
    for (std::size_t c = 0; c < n; ++c) {
      const std::int64_t* cell = &view.connectivity[c * corners];
      to = std::transform(cell, cell + size(c), to, [](auto at) { return static_cast<To>(at); });
    }
  };
  const auto fill_ends = [n, size](auto* to) {
    std::size_t end = 0;
    for (std::size_t c = 0; c < n; ++c) to[c] = static_cast<decltype(+*to)>(end += size(c));
  };
  const auto fill_types = [&view, n, size](std::uint8_t* to) {
    for (std::size_t c = 0; c < n; ++c) {
      to[c] = vtk_cell_type(static_cast<int>(size(c)), view.cell_dimension);
    }
  };
  return {whole_numbers("connectivity", n_corners, n_points, fill_corners),
          whole_numbers("offsets", n, n_corners, fill_ends),
          {"UInt8", "types", 1, n,
           [n, fill_types](std::string& room) { return made<std::uint8_t>(room, n, fill_types); }}};
}

[[noreturn]] void refuse(const std::string& what) {
  throw std::invalid_argument("view: " + what + " has the wrong length");
}

void check_lengths(const BodyView& view, std::size_t n_points, std::size_t n_cells) {
  if (view.position.size() % 3 != 0) refuse("position");
  const auto corners = slot_of(std::max(view.corners, 1));
  if (view.connectivity.size() % corners != 0) refuse("connectivity");
  for (std::size_t c = 0; c < view.connectivity.size(); ++c) {
    const auto point = view.connectivity[c];
    const bool left_out = point < 0 && c % corners == 3 && corners == 4 && view.cell_dimension != 3;
    if (!left_out && (point < 0 || point >= static_cast<std::int64_t>(n_points))) {
      refuse("connectivity");
    }
  }
  const auto check = [](const std::vector<Field>& fields, std::size_t n) {
    for (const auto& field : fields) {
      if (field.values.size() != n * slot_of(field.components)) {
        refuse("field " + field.name);
      }
    }
  };
  check(view.point_fields, n_points), check(view.cell_fields, n_cells);
  if (!view.point_radius.empty() && view.point_radius.size() != n_points) refuse("radius");
}

/// A file while it is written: tags first, with room for the places of arrays that are known last.
class VtuFile {
 public:
  explicit VtuFile(const std::filesystem::path& path) : path_(path), file_(path) {}

  void text(const std::string& tags) { file_.append(tags); }
  void declare(VtuArray array, const std::string& indent, const std::string& more = "") {
    std::string tag =
        indent + "<DataArray type=\"" + array.type + "\" Name=\"" + escaped(array.name) + "\"";
    if (array.components > 1) {
      tag += " NumberOfComponents=\"" + std::to_string(array.components) + "\"";
      for (int c = 0; c < array.components && array.name != "Points"; ++c) {
        tag += " ComponentName" + std::to_string(c) + "=\"" + component_name(array.components, c) +
               "\"";
      }
    }
    tag += more + " format=\"appended\"";
    file_.append(tag);
    places_.push_back(file_.size());
    file_.append(std::string(kOffsetRoom, ' ') + "/>\n");
    arrays_.push_back(std::move(array));
  }

  /// Writes the arrays, and where each of them is.
  void finish() {
    file_.append("  <AppendedData encoding=\"raw\">\n   _");
    const std::size_t start = file_.size();
    std::string room;
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
      std::string offset = " offset=\"" + std::to_string(file_.size() - start) + "\"";
      file_.overwrite(places_[a], offset);
      append_packed(arrays_[a].bytes(room));
    }
    file_.append("\n  </AppendedData>\n</VTKFile>\n");
    file_.finish();
  }

 private:
  /// Number of blocks, bytes of each and of the last one where that is shorter, packed bytes of
  /// each; then the blocks.
  void append_packed(std::string_view bytes) {
    const std::size_t whole = bytes.size() / kPackedBlock, last = bytes.size() % kPackedBlock;
    std::vector<std::uint64_t> head{whole + (last > 0 ? 1 : 0), kPackedBlock, last};
    const std::size_t at = file_.size(), n_blocks = head[0];
    head.resize(3 + n_blocks);
    file_.append(bytes_of_values(head));
    for (std::size_t b = 0; b < n_blocks; b += kPackedAtOnce) {
      const std::size_t n = std::min(kPackedAtOnce, n_blocks - b);
      pack(bytes.substr(b * kPackedBlock), {&head[3 + b], n});
      for (std::size_t k = 0; k < n; ++k) {
        file_.append(std::string_view(packed_).substr(k * room_, head[3 + b + k]));
      }
    }
    file_.overwrite(at, bytes_of_values(head));
  }

  /// Packs the first blocks of the bytes side by side. size  [byte] out
  void pack(std::string_view bytes, std::span<std::uint64_t> size) {
    const std::size_t n = size.size();
    packed_.resize(n * room_);
#pragma omp parallel if (n > 1)
    {
      vtkNew<vtkLZ4DataCompressor> lz4;
#pragma omp for schedule(static)
      for (std::size_t k = 0; k < n; ++k) {
        const std::string_view block = bytes.substr(k * kPackedBlock, kPackedBlock);
        size[k] = lz4->Compress(reinterpret_cast<const unsigned char*>(block.data()), block.size(),
                                reinterpret_cast<unsigned char*>(&packed_[k * room_]), room_);
      }
    }
    if (std::find(size.begin(), size.end(), 0) != size.end()) {
      throw MachineError("cannot write '" + path_.string() + "': no room to pack");
    }
  }

  std::filesystem::path path_;
  ReplacedFile file_;
  std::size_t room_ = vtkNew<vtkLZ4DataCompressor>()->GetMaximumCompressionSpace(kPackedBlock);
  std::string packed_;  // blocks, `room_` apart
  std::vector<VtuArray> arrays_;
  std::vector<std::size_t> places_;  // in the file, of the room for offsets
};

}  // namespace

void write_vtu(const std::filesystem::path& path, const BodyView& view) {
  const std::size_t n_points = view.position.size() / 3;
  const auto corners = slot_of(std::max(view.corners, 1));
  const std::size_t n_cells = view.corners == 0 ? n_points : view.connectivity.size() / corners;
  check_lengths(view, n_points, n_cells);
  const std::vector<Real> time{view.time};
  VtuFile file(path);
  file.text(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\" "
      "compressor=\"vtkLZ4DataCompressor\">\n  <UnstructuredGrid>\n    <FieldData>\n");
  file.declare(reals("TimeValue", 1, time), "      ", " NumberOfTuples=\"1\"");
  file.text("    </FieldData>\n    <Piece NumberOfPoints=\"" + std::to_string(n_points) +
            "\" NumberOfCells=\"" + std::to_string(n_cells) + "\">\n      <PointData>\n");
  for (const auto& field : view.point_fields) file.declare(array_of(field), "        ");
  if (!view.point_radius.empty()) file.declare(singles("radius", 1, view.point_radius), "        ");
  file.text("      </PointData>\n      <CellData>\n");
  for (const auto& field : view.cell_fields) file.declare(array_of(field), "        ");
  file.text("      </CellData>\n      <Points>\n");
  file.declare(reals("Points", 3, view.position), "        ");
  file.text("      </Points>\n      <Cells>\n");
  for (auto& array : cell_arrays(view, n_points)) file.declare(std::move(array), "        ");
  file.text("      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n");
  file.finish();
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
