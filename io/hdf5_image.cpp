#include "io/hdf5_image.hpp"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace brunt {

namespace {

constexpr std::size_t kGrowth = std::size_t{4} << 20;       // [byte] by which an image grows
constexpr std::size_t kChunkValues = std::size_t{1} << 17;  // of 8 bytes: 1 MB
constexpr hsize_t kMost = 1000000;                          // tables or texts of a file

void need(bool holds, const char* what) {
  if (!holds) throw ImageError(what);
}

/// An identifier of HDF5, closed at the end of its scope.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle(hid_t id, Close close, const char* what) : id_(id), close_(close) { need(id >= 0, what); }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: HDF5 takes it as a number
  herr_t close() { return close_(std::exchange(id_, -1)); }

 private:
  hid_t id_;
  Close close_;
};

/// HDF5 prints its errors on stderr unless its handler is removed; callers say what is
/// needed.
class Quiet {
 public:
  Quiet() {
    // At exit HDF5 would look for what a damaged file left open, and may not come to an end.
    H5dont_atexit();
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t function_ = nullptr;
  void* data_ = nullptr;
};

struct Access : Handle {
  Access() : Handle(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "HDF5 does not start") {
    need(H5Pset_fapl_core(*this, kGrowth, false) >= 0 &&
             H5Pset_libver_bounds(*this, H5F_LIBVER_V110, H5F_LIBVER_V110) >= 0,
         "HDF5 has no format 1.10");
  }
};

/// The memory of a file that HDF5 writes, kept when HDF5 closes it: only then is its superblock
/// final (H5Fget_file_image of 1.10 gives one whose checksum is wrong). HDF5 asks for memory as
/// realloc gives it.
// NOLINTBEGIN(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory): see above
class Memory {
 public:
  Memory() = default;
  ~Memory() { std::free(data_); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  bool serve(hid_t access) {
    H5FD_file_image_callbacks_t callbacks = {allocate, copy,  reallocate, release,
                                             same,     leave, this};
    return H5Pset_file_image_callbacks(access, &callbacks) >= 0;
  }

  /// The file: as many bytes as its superblock says.
  FileImage file() {
    constexpr std::size_t kSuperblock = 48, kVersion = 8, kEnd = 28;
    need(size_ >= kSuperblock && data_[kVersion] >= 2, "HDF5 wrote no superblock of format 1.10");
    std::uint64_t end = 0;
    std::memcpy(&end, data_ + kEnd, sizeof end);
    need(end >= kSuperblock && end <= size_, "HDF5 wrote no whole file");
    return {std::exchange(data_, nullptr), end};
  }

 private:
  using Operation = H5FD_file_image_op_t;
  static void* allocate(size_t size, Operation, void* self) {
    return reallocate(nullptr, size, H5FD_FILE_IMAGE_OP_NO_OP, self);
  }
  static void* copy(void* to, const void* from, size_t size, Operation, void*) {
    return std::memcpy(to, from, size);
  }
  static void* reallocate(void* old, size_t size, Operation, void* self) {
    auto& memory = *static_cast<Memory*>(self);
    auto* data = static_cast<char*>(std::realloc(old, size));
    if (data == nullptr) return nullptr;
    // What HDF5 leaves out must not be whatever the memory held before.
    if (size > memory.size_) std::memset(data + memory.size_, 0, size - memory.size_);
    memory.data_ = data, memory.size_ = size;
    return data;
  }
  static herr_t release(void*, Operation, void*) { return 0; }
  static void* same(void* self) { return self; }
  static herr_t leave(void*) { return 0; }

  char* data_ = nullptr;
  std::size_t size_ = 0;
};
// NOLINTEND(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory)

/// How files, groups or arrays are made: without times, so that the same state is the same bytes.
struct Creation : Handle {
  explicit Creation(hid_t of) : Handle(H5Pcreate(of), H5Pclose, "no memory") {
    need(H5Pset_obj_track_times(*this, false) >= 0, "HDF5 cannot leave times out");
  }
};

struct Group : Handle {
  static Group made(hid_t in, const std::string& name) {
    const Creation creation(H5P_GROUP_CREATE);
    return Group(H5Gcreate2(in, name.c_str(), H5P_DEFAULT, creation, H5P_DEFAULT));
  }
  static Group opened(hid_t in, const std::string& name) {
    return Group(H5Gopen2(in, name.c_str(), H5P_DEFAULT));
  }

 private:
  explicit Group(hid_t id) : Handle(id, H5Gclose, "a group is missing") {}
};

/// Writes rows of `width` numbers in chunks with checksums; width 0: a plain list.
void write_array(hid_t in, const char* name, hid_t file_type, hid_t memory_type, const void* data,
                 std::size_t rows, std::size_t width) {
  const int rank = width > 0 ? 2 : 1;
  const std::array<hsize_t, 2> size = {rows, width};
  const std::size_t in_chunk = kChunkValues / std::max<std::size_t>(width, 1);
  const std::array<hsize_t, 2> chunk = {std::clamp<std::size_t>(in_chunk, 1, rows), width};
  const Handle space(H5Screate_simple(rank, size.data(), nullptr), H5Sclose, "no memory");
  const Creation layout(H5P_DATASET_CREATE);
  need(H5Pset_chunk(layout, rank, chunk.data()) >= 0 && H5Pset_fletcher32(layout) >= 0 &&
           H5Pset_fill_time(layout, H5D_FILL_TIME_NEVER) >= 0,
       "an array cannot be laid out");
  const Handle array(H5Dcreate2(in, name, file_type, space, H5P_DEFAULT, layout, H5P_DEFAULT),
                     H5Dclose, "an array cannot be made");
  need(H5Dwrite(array, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0,
       "an array cannot be written");
}

/// A text ends with a byte of its own, since an array is never empty.
void write_text(hid_t in, const char* name, const std::string& text) {
  const std::string ended = text + '\n';
  write_array(in, name, H5T_STD_U8LE, H5T_NATIVE_UINT8, ended.data(), ended.size(), 0);
}

void write_content(hid_t file, CheckpointContent& content) {
  const Group tables = Group::made(file, "tables"), texts = Group::made(file, "texts");
  std::size_t number = 0;
  for (auto& table : content.tables) {
    const auto width = slot_of(table.width);
    need(width > 0 && table.value.size() == width * table.id.size(), "a table has ragged rows");
    if (table.id.empty()) continue;
    const Group group = Group::made(tables, std::to_string(number++));
    write_text(group, "name", table.name);
    write_array(group, "id", H5T_STD_U64LE, H5T_NATIVE_UINT64, table.id.data(), table.id.size(), 0);
    write_array(group, "value", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, table.value.data(),
                table.id.size(), width);
    table = {};
  }
  number = 0;
  for (const auto& [name, text] : content.texts) {
    const Group group = Group::made(texts, std::to_string(number++));
    write_text(group, "name", name);
    write_text(group, "text", text);
  }
}

/// Reads arrays, none of which can be larger than the image: there is no compression.
class ImageReader {
 public:
  explicit ImageReader(std::size_t image_size) : left_(image_size) {}

  template <class Number>
  std::vector<Number> array(hid_t in, const char* name, hid_t file_type, hid_t memory_type,
                            int rank, std::array<hsize_t, 2>& size) {
    const Handle data(H5Dopen2(in, name, H5P_DEFAULT), H5Dclose, "an array is missing");
    const Handle type(H5Dget_type(data), H5Tclose, "an array has no type");
    need(H5Tequal(type, file_type) > 0, "an array is of another type");
    const Handle space(H5Dget_space(data), H5Sclose, "an array has no size");
    need(H5Sget_simple_extent_ndims(space) == rank, "an array has another shape");
    size = {0, 1};
    need(H5Sget_simple_extent_dims(space, size.data(), nullptr) == rank, "an array has no size");
    const std::size_t most = left_ / sizeof(Number);
    need(size[0] > 0 && size[1] > 0 && size[0] <= most && size[1] <= most / size[0],
         "an array is larger than its file, or empty");
    std::vector<Number> values(size[0] * size[1]);
    left_ -= values.size() * sizeof(Number);
    need(H5Dread(data, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0,
         "an array cannot be read or its checksum is wrong");
    return values;
  }

  std::string text(hid_t in, const char* name) {
    std::array<hsize_t, 2> size;
    const auto bytes = array<char>(in, name, H5T_STD_U8LE, H5T_NATIVE_UINT8, 1, size);
    need(bytes.back() == '\n', "a text does not end");
    return {bytes.begin(), bytes.end() - 1};
  }

  StateTable table(hid_t in) {
    StateTable table;
    table.name = text(in, "name");
    std::array<hsize_t, 2> ids, rows;
    table.id = array<GlobalId>(in, "id", H5T_STD_U64LE, H5T_NATIVE_UINT64, 1, ids);
    table.value = array<Real>(in, "value", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, 2, rows);
    need(rows[0] == ids[0] && rows[1] < (hsize_t{1} << 30), "a table has ragged rows");
    table.width = static_cast<int>(rows[1]);
    return table;
  }

 private:
  std::size_t left_;  // [byte] that arrays may still take
};

hsize_t members_of(hid_t group) {
  H5G_info_t info;
  need(H5Gget_info(group, &info) >= 0 && info.nlinks <= kMost, "a group cannot be read");
  return info.nlinks;
}

}  // namespace

FileImage to_hdf5(CheckpointContent content) {
  const Quiet quiet;
  Memory memory;
  {
    const Access access;
    need(memory.serve(access), "HDF5 does not take memory");
    const Creation creation(H5P_FILE_CREATE);
    Handle file(H5Fcreate("checkpoint", H5F_ACC_TRUNC, creation, access), H5Fclose,
                "HDF5 makes no file");
    write_content(file, content);
    need(file.close() >= 0, "HDF5 does not finish its file");
  }
  return memory.file();
}

CheckpointContent from_hdf5(std::string_view image) {
  const Quiet quiet;
  const Access access;
  // HDF5 takes a copy; it does not write to what it is given.
  need(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()) >= 0,
       "there is no memory for it");
  const Handle file(H5Fopen("checkpoint", H5F_ACC_RDONLY, access), H5Fclose, "it is no HDF5 file");
  const Group tables = Group::opened(file, "tables"), texts = Group::opened(file, "texts");
  ImageReader reader(image.size());
  CheckpointContent content;
  for (hsize_t k = 0, n = members_of(tables); k < n; ++k) {
    content.tables.push_back(reader.table(Group::opened(tables, std::to_string(k))));
  }
  for (hsize_t k = 0, n = members_of(texts); k < n; ++k) {
    const Group group = Group::opened(texts, std::to_string(k));
    const std::string name = reader.text(group, "name");
    need(content.texts.emplace(name, reader.text(group, "text")).second, "two texts of one name");
  }
  return content;
}

}  // namespace brunt
// Tested by tests/unit/io/checkpoint_test.cpp.
