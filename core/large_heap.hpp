#pragma once
#include <array>
#include <cstddef>
#include <mutex>

namespace brunt {

/// Large blocks of memory, side by side in pages of the system, so that they share its large ones.
///
/// While it is to keep what is given back, that waits for the next that asks: a page that the
/// system hands out is cleared by it first, which takes longer than to fill it. Never is there more
/// than was in use at once before, but for parts of large pages: the most memory that the program
/// has is what it would be without.
class LargeHeap {
 public:
  static constexpr std::size_t kPage = 4096, kLargePage = std::size_t{1} << 21;
  constexpr LargeHeap() = default;
  /// As many bytes in whole pages; null where the system has none.
  /// bytes  in, what is asked for, from 1 to 2^62; out, what the block has
  void* take(std::size_t& bytes) noexcept;
  /// bytes  as take() left them
  void give_back(void* at, std::size_t bytes) noexcept;
  /// Whether what is given back waits, or goes back to the system at once: all but parts of large
  /// pages, which the system would keep until the rest of them is given back.
  void keep(bool keeps) noexcept;
  /// [byte] of memory in what is not in use, at most
  std::size_t kept() noexcept;

 private:
  /// Pages that are not in use. Its last ones are those that were in use.
  struct Range {
    char* begin = nullptr;
    std::size_t bytes = 0, kept = 0;  // kept: that the system may not have back yet
    char* end() const { return begin + bytes; }
    /// For a block of `wanted` bytes, of which both have room.
    bool is_better(const Range& other, std::size_t wanted) const {
      const bool of_memory = kept >= wanted, other_of_memory = other.kept >= wanted;
      return of_memory == other_of_memory ? bytes < other.bytes : of_memory;
    }
  };
  std::size_t find(std::size_t bytes) const;
  bool extend(std::size_t bytes);
  std::size_t insert(Range range);
  void erase(std::size_t k);
  void release(std::size_t k, char* begin, char* end);
  void release_until(std::size_t kept, std::size_t spared);

  std::mutex mutex_;
  std::array<Range, 512> free_{};  // in the order of addresses, none touches another
  std::size_t n_ = 0;
  char* last_mapped_ = nullptr;
  std::size_t in_use_ = 0, most_in_use_ = 0, kept_ = 0;  // [byte]
  bool keeps_ = false;
};

}  // namespace brunt
// Tested by tests/unit/core/large_heap_test.cpp.
