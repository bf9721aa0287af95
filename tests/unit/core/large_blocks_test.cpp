// Blocks of a page or more begin cache lines of 64 bytes, and not all the same line of a page:
// eight of them that did would fill the eight places that a first cache has for it. What cannot be
// had is said as anywhere: std::bad_alloc. The address sanitizer has an operator new of its own,
// which ends the program there.
#include "core/large_blocks.hpp"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace brunt {
namespace {

std::uintptr_t place(const void* at) { return reinterpret_cast<std::uintptr_t>(at); }

constexpr std::size_t kLargePage = std::size_t{1} << 21;

TEST(LargeBlocks, EveryAlignmentIsGiven) {
  for (std::size_t align = 1; align <= 2 * kLargePage; align *= 2) {
    for (const std::size_t bytes :
         {std::size_t{0}, std::size_t{1}, std::size_t{5000}, std::size_t{5} << 20}) {
      void* const at = ::operator new (bytes, std::align_val_t{align});
      EXPECT_EQ(place(at) % align, 0U);
      std::memset(at, 1, bytes);
      ::operator delete (at, std::align_val_t{align});
    }
  }
}

// Blocks of state ask for lines of the cache, or more.
TEST(LargeBlocks, OfAlignedTypesBeginWhereTheseDo) {
  struct alignas(64) Line {
    char bytes[64];
  };
  struct alignas(2 * kLargePage) Wide {
    char bytes[2 * kLargePage];
  };
  const std::vector<Line> few(3), many(2 * kLargePage / sizeof(Line));
  EXPECT_EQ(place(few.data()) % sizeof(Line), 0U);
  EXPECT_EQ(place(many.data()) % sizeof(Line), 0U);
  const std::vector<Wide> wide(2);
  EXPECT_EQ(place(wide.data()) % sizeof(Wide), 0U);
}

TEST(LargeBlocks, KeepWhatIsInThemWhenTheyGrow) {
  for (const std::size_t bytes :
       {std::size_t{100}, std::size_t{4095}, std::size_t{65535}, 2 * kLargePage - 1, 2 * kLargePage,
        2 * kLargePage + 1, 7 * kLargePage - 1}) {
    std::vector<char> block(bytes, 1);
    block.resize(bytes + kLargePage, 2);
    EXPECT_EQ(block.front() + block[bytes - 1] + block.back(), 4) << bytes;
  }
}

#ifndef __SANITIZE_ADDRESS__
TEST(LargeBlocks, FieldsBeginAtDifferentLines) {
  for (const std::size_t bytes : {std::size_t{65536}, std::size_t{160000}, std::size_t{6} << 20}) {
    std::vector<std::unique_ptr<char[]>> fields;
    std::set<std::uintptr_t> lines;
    for (int k = 0; k < 40; ++k) {
      fields.push_back(std::make_unique_for_overwrite<char[]>(bytes));
      std::memset(fields.back().get(), k, bytes);
      EXPECT_EQ(place(fields.back().get()) % 64, 0U);
      lines.insert(place(fields.back().get()) % 4096);
    }
    EXPECT_GT(lines.size(), 30U) << bytes;  // of 64; other blocks may take turns between
    for (int k = 0; k < 40; ++k) {
      EXPECT_EQ(fields[static_cast<std::size_t>(k)][0], k);
      EXPECT_EQ(fields[static_cast<std::size_t>(k)][bytes - 1], k);
    }
  }
}

/// [kB] of the heap that stand in large pages.
long large_in_heap() {
  std::ifstream maps("/proc/self/smaps");
  bool heap = false;
  long all = 0;
  for (std::string line; std::getline(maps, line);) {
    if (line.find('-') != std::string::npos && line.find(':') > line.find(' ')) {
      heap = line.ends_with("[heap]");
    }
    constexpr std::string_view kLarge = "AnonHugePages:";
    if (heap && line.starts_with(kLarge)) all += std::stol(line.substr(kLarge.size()));
  }
  return all;
}

/// True where the system gathers pages (Linux from 6.1 on, with memory to spare).
bool gathers_pages() {
  constexpr int kCollapse = 25;
  void* const at = std::aligned_alloc(kLargePage, kLargePage);
  std::memset(at, 1, kLargePage);
  const bool does = madvise(at, kLargePage, kCollapse) == 0;
  std::free(at);
  return does;
}

// Fields that are too small for large pages of their own; what is in them stays.
TEST(LargeBlocks, HeapIsGatheredIntoLargePages) {
  std::vector<std::unique_ptr<char[]>> fields;
  for (int k = 0; k < 120; ++k) {
    fields.push_back(std::make_unique_for_overwrite<char[]>(100'000));
    std::memset(fields.back().get(), k, 100'000);
  }
  const long before = large_in_heap();
  gather_heap();
  for (int k = 0; k < 120; ++k) {
    const char* field = fields[static_cast<std::size_t>(k)].get();
    EXPECT_TRUE(std::all_of(field, field + 100'000, [k](char c) { return c == k; })) << k;
  }
  if (!gathers_pages()) GTEST_SKIP() << "the system does not gather pages";
  EXPECT_GE(large_in_heap(), before + 2048);
}

TEST(LargeBlocks, SayThatThereIsNoRoom) {
  // Close to the end of all addresses, where rounding up would begin anew.
  volatile std::size_t bytes = SIZE_MAX - 5;
  const std::align_val_t line{64};
  EXPECT_THROW(::operator delete(::operator new(bytes)), std::bad_alloc);
  EXPECT_THROW(::operator delete(::operator new(bytes, line), line), std::bad_alloc);
  bytes = SIZE_MAX / 4;
  EXPECT_THROW(::operator delete(::operator new(bytes, line), line), std::bad_alloc);
  EXPECT_THROW(::operator delete(::operator new(bytes)), std::bad_alloc);
  for (const std::size_t less : {0, 1, 100, 5000, 3 << 20}) {
    EXPECT_EQ(::operator new(SIZE_MAX / 2 - less, std::nothrow), nullptr);
    EXPECT_EQ(::operator new(SIZE_MAX - less, std::nothrow), nullptr);
  }
  ::operator delete(nullptr);
}
#endif

}  // namespace
}  // namespace brunt
