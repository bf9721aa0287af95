#pragma once
/// Tables and texts as the bytes of an HDF5 file, and back. The only place that knows HDF5.
#include <string>
#include <string_view>

#include "io/checkpoint.hpp"

namespace brunt {

/// What an HDF5 file is not: `what` says why. Its caller knows the file's name.
class ImageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The bytes of an HDF5 file with the content; tables without rows are left out. Each table is
/// freed when it stands in the file, so that memory holds the content twice at the most. Throws
/// ImageError where HDF5 has no memory for it.
std::string to_hdf5(CheckpointContent content);

/// Reads what to_hdf5 wrote. Types, sizes and checksums are looked at before anything is allocated
/// or believed. Throws ImageError.
CheckpointContent from_hdf5(std::string_view image);

}  // namespace brunt
