// Blocks from two large pages on begin at one, smaller ones do not care, and what cannot be had is
// said as anywhere: std::bad_alloc. The address sanitizer has an operator new of its own, which
// ends the program there.
#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <vector>

namespace brunt {
namespace {

#ifndef __SANITIZE_ADDRESS__
constexpr std::size_t kPage = std::size_t{1} << 21;

TEST(LargeBlocks, BeginAtAPage) {
  for (const std::size_t bytes : {2 * kPage, 2 * kPage + 1, 7 * kPage - 1}) {
    std::vector<char> block(bytes, 1);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.data()) % kPage, 0U) << bytes;
    block.resize(bytes + kPage, 2);
    EXPECT_EQ(block.front() + block[bytes - 1] + block.back(), 4);
  }
}

// Blocks of state ask for lines of the cache, or more.
TEST(LargeBlocks, OfAlignedTypesBeginAtAPageToo) {
  struct alignas(64) Line {
    char bytes[64];
  };
  struct alignas(2 * kPage) Wide {
    char bytes[2 * kPage];
  };
  const std::vector<Line> few(3), many(2 * kPage / sizeof(Line));
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(few.data()) % sizeof(Line), 0U);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(many.data()) % kPage, 0U);
  const std::vector<Wide> wide(2);
  EXPECT_EQ(reinterpret_cast<std::uintptr_t>(wide.data()) % sizeof(Wide), 0U);
}

TEST(LargeBlocks, SayThatThereIsNoRoom) {
  // Close to the end of all addresses, where rounding up would begin anew.
  volatile std::size_t bytes = SIZE_MAX - 5;
  EXPECT_THROW(::operator delete(::operator new(bytes)), std::bad_alloc);
  bytes = SIZE_MAX / 4;
  const std::align_val_t line{64};
  EXPECT_THROW(::operator delete(::operator new(bytes, line), line), std::bad_alloc);
  EXPECT_THROW(::operator delete(::operator new(bytes)), std::bad_alloc);
}
#endif

}  // namespace
}  // namespace brunt
