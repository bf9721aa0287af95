// Packed arrays unpack to what they were, byte for byte, by VTK's own LZ4: numbers that repeat,
// numbers that do not, those that begin as one and go on as the other, and every size about the
// ends of a block and of the 15 and 255 bytes that LZ4 counts by.
#include "io/vtk/array_packer.hpp"

#include <gtest/gtest.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>

#include <cstring>
#include <random>
#include <vector>

#include "tests/unit/io/scratch_folder.hpp"

namespace brunt {
namespace {

std::string noise(std::size_t size, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::string bytes(size, '\0');
  for (char& byte : bytes) byte = static_cast<char>(random() & 0xff);
  return bytes;
}

std::uint64_t number_at(const std::string& bytes, std::size_t i) {
  std::uint64_t number = 0;
  std::memcpy(&number, bytes.data() + 8 * i, 8);
  return number;
}

/// What VTK makes of a packed array.
std::string unpacked(const std::string& packed) {
  const auto blocks = number_at(packed, 0), block = number_at(packed, 1);
  const auto last = number_at(packed, 2);
  const vtkNew<vtkLZ4DataCompressor> lz4;
  std::string bytes;
  std::size_t at = 8 * (3 + blocks);
  for (std::size_t b = 0; b < blocks; ++b) {
    const std::size_t to = b + 1 == blocks && last > 0 ? last : block;
    std::string one(to, '\0');
    const std::size_t size = number_at(packed, 3 + b);
    EXPECT_EQ(lz4->Uncompress(reinterpret_cast<const unsigned char*>(packed.data()) + at, size,
                              reinterpret_cast<unsigned char*>(one.data()), to),
              to);
    bytes += one;
    at += size;
  }
  EXPECT_EQ(at, packed.size());
  return bytes;
}

struct ArrayPackerTest : test::ScratchFolder {
  ArrayPacker packer;
  KeptArrays kept;

  std::string packed(const std::string& bytes) {
    const auto path = folder_ / "array";
    ReplacedFile file(path);
    packer.append(bytes, file);
    file.finish();
    return read_file(path);
  }
  std::string packed_as(const std::string& name, const std::string& bytes) {
    const auto path = folder_ / "array";
    ReplacedFile file(path);
    packer.append_kept(name, bytes, kept, file);
    file.finish();
    return read_file(path);
  }
};

TEST_F(ArrayPackerTest, GivesBackWhatItGot) {
  constexpr std::size_t kBlock = 1 << 18;
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{14}, std::size_t{15}, std::size_t{16},
        std::size_t{269}, std::size_t{270}, std::size_t{271}, std::size_t{525}, kBlock - 1, kBlock,
        kBlock + 1, kBlock + 14, kBlock + 15, kBlock + 270, 8 * kBlock, 9 * kBlock + 5,
        17 * kBlock + 1}) {
    EXPECT_EQ(unpacked(packed(noise(size))), noise(size)) << size;
    EXPECT_EQ(unpacked(packed(std::string(size, 'a'))), std::string(size, 'a')) << size;
    const std::string both = std::string(size, 'a') + noise(size) + std::string(size, 'b');
    EXPECT_EQ(unpacked(packed(both)), both) << size;
  }
}

// 16 blocks: zeros take 1/255 of their bytes, noise 1/255 more than its own; each block is tried
// anew.
TEST_F(ArrayPackerTest, PacksWhatIsWorthIt) {
  const std::size_t size = 16 << 18;
  EXPECT_LT(packed(std::string(size, '\0')).size(), size / 200);
  EXPECT_LT(packed(noise(size)).size(), size + size / 200);
  const std::string both = noise(1 << 18) + std::string(size, '\0');
  EXPECT_LT(packed(both).size(), (1 << 18) + size / 100);
}

TEST_F(ArrayPackerTest, KeptArraysFollowTheirBytes) {
  const std::string first = noise(100'000, 1), second = noise(100'000, 2), longer = noise(100'001);
  EXPECT_EQ(unpacked(packed_as("id", first)), first);
  EXPECT_EQ(unpacked(packed_as("id", first)), first);
  EXPECT_EQ(unpacked(packed_as("corners", second)), second);
  EXPECT_EQ(unpacked(packed_as("id", first)), first);
  EXPECT_EQ(unpacked(packed_as("id", second)), second);
  EXPECT_EQ(unpacked(packed_as("id", longer)), longer);
  EXPECT_EQ(unpacked(packed_as("id", "")), "");
  EXPECT_EQ(unpacked(packed_as("id", first)), first);
  EXPECT_EQ(kept.by_name.size(), 2U);
}

}  // namespace
}  // namespace brunt
