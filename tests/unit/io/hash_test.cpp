#include "io/hash.hpp"

#include <gtest/gtest.h>

#include <set>

namespace brunt {
namespace {

// Each step is one to one in the word: no damage within one word may be missed.
TEST(Hash, EveryBitCounts) {
  std::string bytes(101, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(31 * i);
  for (const auto hash : {hash_bytes, hash_long_bytes}) {
    std::set<std::uint64_t> hashes = {hash(bytes)};
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      std::string damaged = bytes;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
      EXPECT_TRUE(hashes.insert(hash(damaged)).second) << "bit " << bit;
    }
  }
}

TEST(Hash, ZerosAtTheEndCount) {
  for (const auto hash : {hash_bytes, hash_long_bytes}) {
    std::set<std::uint64_t> hashes;
    for (std::size_t size = 0; size < 100; ++size) {
      EXPECT_TRUE(hashes.insert(hash(std::string(size, '\0'))).second) << size;
    }
  }
}

// The four parts of a long text are told apart.
TEST(Hash, PartsThatChangePlacesCount) {
  const std::string a(64, 'a'), b(64, 'b');
  std::set<std::uint64_t> hashes;
  for (const auto& text : {a + a + b + b, a + b + a + b, b + a + a + b, b + b + a + a}) {
    EXPECT_TRUE(hashes.insert(hash_long_bytes(text)).second);
  }
}

TEST(Hash, DigitsAreSixteen) {
  EXPECT_EQ(hex_digits(0), "0000000000000000");
  EXPECT_EQ(hex_digits(0x0123456789abcdefULL), "0123456789abcdef");
  EXPECT_EQ(hex_digits(~0ULL), "ffffffffffffffff");
}

}  // namespace
}  // namespace brunt
