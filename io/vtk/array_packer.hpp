#pragma once
/// Arrays of a .vtu as VTK's readers want them packed.
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/file.hpp"

namespace brunt {

/// Packed bytes of arrays that are the same in one frame after the other: corners, numbers.
/// Memory: some 30 bytes a hex.
struct KeptArrays {
  struct Array {
    std::size_t size = 0;
    std::uint64_t hash = 0;
    std::string packed;
  };
  std::map<std::string, Array> by_name;
};

/// Packs arrays by LZ4 in blocks of 256 kB, on several threads. Blocks are kept as they are where
/// their first 4 kB get smaller by less than a half, as most numbers do (by a quarter where they
/// are packed once for many frames): files get larger by a sixth, and writing them takes half the
/// time (docs/decisions/228-frames-in-parts.md). As VTK has it: number of blocks, bytes of each, of
/// the last one where that is shorter, packed bytes of each; then the blocks.
class ArrayPacker {
 public:
  /// Appends an array. Throws MachineError.
  void append(std::string_view bytes, ReplacedFile& file);
  /// The same of one that is likely to be as it was in the last frame, by what is kept of that.
  void append_kept(const std::string& name, std::string_view bytes, KeptArrays& kept,
                   ReplacedFile& file);

 private:
  template <class Sink>
  void pack_into(std::string_view bytes, double worth, Sink& sink);
  void pack(std::string_view bytes, double worth, std::span<std::uint64_t> size);

  std::string packed_;             // blocks, with room between them; of a plain one its head
  std::vector<std::size_t> head_;  // [byte] of a plain block; 0: it is packed
};

}  // namespace brunt
// Tested by tests/unit/io/array_packer_test.cpp.
