#pragma once
/// Tables and texts as the bytes of an HDF5 file, and back. The only place that knows HDF5.
#include <cstdlib>
#include <memory>
#include <string_view>

#include "io/checkpoint.hpp"

namespace brunt {

/// What an HDF5 file is not: `what` says why. Its caller knows the file's name.
class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of a file, in the memory that HDF5 wrote them to.
class FileImage {
 public:
  /// data  as malloc gives it; taken over
  FileImage(char* data, std::size_t size) : data_(data), size_(size) {}
  std::string_view bytes() const { return {data_.get(), size_}; }

 private:
  struct Free {
    // NOLINTNEXTLINE(cppcoreguidelines-no-malloc,cppcoreguidelines-owning-memory): HDF5's own
    void operator()(char* data) const { std::free(data); }
  };
  std::unique_ptr<char, Free> data_;
  std::size_t size_;  // [byte]
};

/// The bytes of an HDF5 file with the content; tables without rows are left out. Each table is
/// freed when it stands in the file, so that memory holds the content and its largest table at the
/// most. Throws ImageError where HDF5 has no memory for it.
FileImage to_hdf5(CheckpointContent content);

/// Reads what to_hdf5 wrote. Types, sizes and checksums are looked at before anything is allocated
/// or believed. Throws ImageError.
CheckpointContent from_hdf5(std::string_view image);

}  // namespace brunt
