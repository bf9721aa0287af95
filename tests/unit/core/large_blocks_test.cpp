// Blocks of a page or more begin cache lines of 64 bytes, and not all the same line of a page:
// eight of them that did would fill the eight places that a first cache has for it. What cannot be
// had is said as anywhere: std::bad_alloc. The address sanitizer has an operator new of its own,
// which ends the program there.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>
#include <set>
#include <string>
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

/// What the system says of the memory at a place, by its flags ("hg": large pages are asked for).
std::string flags_of(std::uintptr_t at) {
  std::ifstream maps("/proc/self/smaps");
  bool here = false;
  for (std::string line; std::getline(maps, line);) {
    std::uintptr_t begin = 0, end = 0;
    if (std::sscanf(line.c_str(), "%lx-%lx ", &begin, &end) == 2) here = begin <= at && at < end;
    if (here && line.starts_with("VmFlags:")) return line + " ";
  }
  return "";
}

// Fields that are too small for large pages of their own stand in those of the heap.
TEST(LargeBlocks, HeapHasLargePages) {
  if (!std::filesystem::exists("/sys/kernel/mm/transparent_hugepage")) GTEST_SKIP();
  std::vector<std::unique_ptr<char[]>> fields;
  for (int k = 0; k < 80; ++k) fields.push_back(std::make_unique<char[]>(100'000));
  const auto heap = reinterpret_cast<std::uintptr_t>(sbrk(0)) - 1;
  EXPECT_NE(flags_of(heap).find(" hg "), std::string::npos) << flags_of(heap);
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
