#pragma once
/// A file of VTK while it is written: tags first, then the arrays that they name (appended raw,
/// packed), each made when its turn comes.
#include <filesystem>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/view.hpp"
#include "io/vtk/array_packer.hpp"

namespace brunt {

/// A field that waited has a value that is no finite number, or none in single precision: its file
/// is not written.
struct NoNumberError : std::runtime_error {
  NoNumberError(std::string of_body, std::string of_field)
      : std::runtime_error(of_body + ": " + of_field + " is no finite number"),
        body(std::move(of_body)),
        field(std::move(of_field)) {}
  std::string body, field;
};

/// One array. Its bytes are made when it is written, and gone again after that.
struct VtkFileArray {
  std::string type;  ///< "Float64", with further attributes behind it
  std::string name;
  int components = 1;
  std::function<std::string_view(std::string& room)> bytes;
  std::string kept_as = {};  ///< its name among kept arrays; empty: it changes from frame to frame
};

/// What a writer keeps from file to file.
struct VtkFileMemory {
  ArrayPacker packer;
  std::string room;                        ///< of the array that is packed
  std::map<std::string, KeptArrays> kept;  ///< of bodies by name
};

class VtkFile {
 public:
  /// kind  "UnstructuredGrid", "PolyData". Throws MachineError, as the others do.
  VtkFile(const std::filesystem::path& path, const std::string& kind, const Real& time);

  void text(const std::string& tags) { file_.append(tags); }
  void declare(VtkFileArray array, const std::string& indent = "        ",
               const std::string& more = "");
  /// Writes the arrays, and where each of them is. body  whose kept arrays they are. Throws
  /// NoNumberError too: the file is not there then.
  void finish(VtkFileMemory& memory, const std::string& body);

 private:
  std::string kind_;
  ReplacedFile file_;
  std::vector<VtkFileArray> arrays_;
  std::vector<std::size_t> places_;  // in the file, of the room for offsets
};

template <class T>
std::string_view bytes_of_values(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// n numbers of another type, made in the room by fill(To* first); the room grows as it must.
template <class To, class Fill>
std::string_view made(std::string& room, std::size_t n, const Fill& fill) {
  const std::size_t size = n * sizeof(To);
  if (room.size() < size) room.resize(size);
  fill(reinterpret_cast<To*>(room.data()));
  return std::string_view(room).substr(0, size);
}

/// Whole numbers, the largest of which is given: in 32 bits where it fits, half as many to pack.
template <class Fill>
VtkFileArray whole_numbers(const char* name, std::size_t n, std::size_t largest, const Fill& fill) {
  VtkFileArray array{"Int64", name, 1, {}, name};
  if (largest <= std::numeric_limits<std::int32_t>::max()) {
    array.type = "Int32";
    array.bytes = [n, fill](std::string& room) { return made<std::int32_t>(room, n, fill); };
  } else {
    array.bytes = [n, fill](std::string& room) { return made<std::int64_t>(room, n, fill); };
  }
  return array;
}

/// The line that lists an array in a file that joins pieces.
std::string joined_line(const VtkFileArray& array);

/// In double: places, which may be far from the origin, and the time. The values have to stay.
VtkFileArray reals(const std::string& name, int components, std::span<const Real> values);

/// In single precision. The field has to stay. Bytes of one that waits throw NoNumberError.
VtkFileArray singles(const Field& field);

/// As singles, or as the whole numbers that they are. The field has to stay.
/// list  "points." or "cells.", for there is an `id` of both
VtkFileArray array_of(const Field& field, const std::string& list);

}  // namespace brunt
// Tested by tests/unit/io/vtk_test.cpp.
