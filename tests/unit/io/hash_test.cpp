#include "io/hash.hpp"

#include <gtest/gtest.h>

#include <set>

namespace brunt {
namespace {

// Each step is one to one in the word: no damage within one word may be missed.
TEST(Hash, EveryBitCounts) {
  std::string bytes(37, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(31 * i);
  std::set<std::uint64_t> hashes = {hash_bytes(bytes)};
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    EXPECT_TRUE(hashes.insert(hash_bytes(damaged)).second) << "bit " << bit;
  }
}

TEST(Hash, ZerosAtTheEndCount) {
  std::set<std::uint64_t> hashes;
  for (std::size_t size = 0; size < 40; ++size) {
    EXPECT_TRUE(hashes.insert(hash_bytes(std::string(size, '\0'))).second) << size;
  }
}

TEST(Hash, DigitsAreSixteen) {
  EXPECT_EQ(hex_digits(0), "0000000000000000");
  EXPECT_EQ(hex_digits(0x0123456789abcdefULL), "0123456789abcdef");
  EXPECT_EQ(hex_digits(~0ULL), "ffffffffffffffff");
}

}  // namespace
}  // namespace brunt
