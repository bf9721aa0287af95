#include "io/vtk/vtk_file.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

#include "core/simd.hpp"
#include "core/view_fields.hpp"
#include "io/vtk/grid.hpp"
#include "io/vtk/pieces.hpp"

namespace brunt {

namespace {

constexpr std::size_t kOffsetRoom = 32;     // characters of ` offset="..."`
constexpr std::size_t kHeldRoom = 1 << 20;  // [byte] that stays between files

using FourSingles = float __attribute__((vector_size(16)));

/// Makes numbers single, the largest there is where they are larger (single_of). Returns true where
/// all are finite ones in single precision.
bool make_singles(std::span<const Real> values, float* to) {
  const Pack most = broadcast<Pack>(std::numeric_limits<float>::max());
  std::size_t k = 0;
  PackMask beyond = {};
  for (; k + kLanes <= values.size(); k += kLanes) {
    const Pack value = load(&values[k]);
    beyond |= ~(vabs(value) <= most);
    const Pack within = vmax(-most, vmin(most, value));  // of not-a-number itself
    const auto four = __builtin_convertvector(within, FourSingles);
    std::memcpy(to + k, &four, sizeof four);
  }
  const auto rest = values.subspan(k);
  std::transform(rest.begin(), rest.end(), to + k, single_of);
  return are_singles(rest) && !any(beyond);
}

/// The same as whole numbers, of which there are none beyond.
bool make_whole(std::span<const Real> values, std::int64_t* to) {
  std::transform(values.begin(), values.end(), to,
                 [](Real value) { return static_cast<std::int64_t>(value); });
  return are_singles(values);
}

/// Values of a field, made numbers of another type by make(values, to). Those of a field that waits
/// nobody has seen yet: they are looked at here, where they are in the cache.
template <class To, class Make>
std::string_view made_of(std::string& room, const Field& field, const Make& make) {
  std::atomic<bool> all_finite = true;
  const auto bytes = made<To>(room, field.size(), [&](To* to) {
    for_parts(field, [&, to](std::size_t at, std::span<const Real> part) {
      if (!make(part, to + at) && field.fill) all_finite = false;
    });
  });
  if (!all_finite) throw NoNumberError("", field.name);
  return bytes;
}

/// What a tag says of an array.
std::string attributes_of(const VtkFileArray& array) {
  std::string text = " type=\"" + array.type + "\" Name=\"" + escaped(array.name) + "\"";
  if (array.components == 1) return text;
  text += " NumberOfComponents=\"" + std::to_string(array.components) + "\"";
  const bool named = array.components == 3 || array.components == 6;
  for (int c = 0; c < array.components && named && array.name != "Points"; ++c) {
    text +=
        " ComponentName" + std::to_string(c) + "=\"" + component_name(array.components, c) + "\"";
  }
  return text;
}

/// Of an array of a body, which what it cannot hold is said of.
std::string_view bytes_of(const VtkFileArray& array, const std::string& body, std::string& room) {
  try {
    return array.bytes(room);
  } catch (const NoNumberError& error) {
    throw NoNumberError(body, error.field);
  }
}

}  // namespace

std::string joined_line(const VtkFileArray& array) {
  return "      <PDataArray" + attributes_of(array) + "/>\n";
}

VtkFileArray reals(const std::string& name, int components, std::span<const Real> values) {
  return {"Float64", name, components, [values](std::string&) { return bytes_of_values(values); }};
}

VtkFileArray singles(const Field& field) {
  return {"Float32", field.name, field.components,
          [&field](std::string& room) { return made_of<float>(room, field, make_singles); }};
}

VtkFileArray array_of(const Field& field, const std::string& list) {
  if (!is_whole_field(field.name)) return singles(field);
  const auto bytes = [&field](std::string& room) {
    return made_of<std::int64_t>(room, field, make_whole);
  };
  return {"Int64\" IdType=\"1", field.name, field.components, bytes, list + field.name};
}

VtkFile::VtkFile(const std::filesystem::path& path, const std::string& kind, const Real& time)
    : kind_(kind), file_(path) {
  text("<?xml version=\"1.0\"?>\n<VTKFile type=\"" + kind +
       "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
       "compressor=\"vtkLZ4DataCompressor\">\n  <" +
       kind + ">\n    <FieldData>\n");
  declare(reals("TimeValue", 1, {&time, 1}), "      ", " NumberOfTuples=\"1\"");
  text("    </FieldData>\n");
}

void VtkFile::declare(VtkFileArray array, const std::string& indent, const std::string& more) {
  file_.append(indent + "<DataArray" + attributes_of(array) + more + " format=\"appended\"");
  places_.push_back(file_.size());
  file_.append(std::string(kOffsetRoom, ' ') + "/>\n");
  arrays_.push_back(std::move(array));
}

void VtkFile::finish(VtkFileMemory& memory, const std::string& body) {
  file_.append("  </" + kind_ + ">\n  <AppendedData encoding=\"raw\">\n   _");
  KeptArrays& kept = memory.kept[body];
  const std::size_t start = file_.size();
  for (std::size_t a = 0; a < arrays_.size(); ++a) {
    file_.overwrite(places_[a], " offset=\"" + std::to_string(file_.size() - start) + "\"");
    const std::string_view bytes = bytes_of(arrays_[a], body, memory.room);
    if (arrays_[a].kept_as.empty()) {
      memory.packer.append(bytes, file_);
    } else {
      memory.packer.append_kept(arrays_[a].kept_as, bytes, kept, file_);
    }
  }
  file_.append("\n  </AppendedData>\n</VTKFile>\n");
  file_.finish();
  if (memory.room.size() > kHeldRoom) std::string().swap(memory.room);
}

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
