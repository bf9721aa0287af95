// Checkpoints: what is written reads back to the bit; a damaged one is refused with file and
// reason, whatever the damage, and never read wrong.
#include "io/checkpoint.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <fstream>
#include <random>
#include <thread>

#include "io/file.hpp"
#include "io/hash.hpp"
#include "io/hdf5_image.hpp"
#include "tests/unit/io/scratch_folder.hpp"

namespace brunt {
namespace {

namespace fs = std::filesystem;

class CheckpointFiles : public test::ScratchFolder {
 protected:
  /// Writes a checkpoint of two ranks and returns its manifest.
  fs::path write(std::uint64_t step) {
    const CheckpointHeader header{"0.1", "00ff", 1.5e-6 * static_cast<Real>(step), step, 2};
    std::vector<CheckpointPart> parts;
    for (std::uint64_t rank = 0; rank < 2; ++rank) {
      parts.push_back(write_checkpoint_part(folder_, header, rank, content(rank)));
    }
    write_checkpoint_manifest(folder_, header, parts);
    return checkpoint_manifest(folder_, step);
  }

  static CheckpointContent content(std::uint64_t rank) {
    CheckpointContent content;
    StateTable points{"points", 3, {}, {}}, few{"support.a/b", 1, {rank}, {-0.0}};
    for (GlobalId id = 0; id < 50000; ++id) {  // three chunks
      points.id.push_back(2 * id + rank);
      for (int c = 0; c < 3; ++c) points.value.push_back(std::sin(static_cast<Real>(3 * id) + c));
    }
    points.value[7] = std::bit_cast<Real>(std::uint64_t{0x7ff0000000000001u});
    content.tables = {points, few};
    content.texts = {{"deck", "time: {end: 1}\n"}, {"empty", ""}, {"bytes", {"\0\n\xff", 3}}};
    return content;
  }
};

std::string refusal(const fs::path& manifest) {
  try {
    (void)read_checkpoint(manifest);
  } catch (const CheckpointError& error) {
    return error.what();
  }
  return "";
}

TEST_F(CheckpointFiles, ReadBackToTheBit) {
  const auto read = read_checkpoint(write(42));
  EXPECT_EQ(read.header, (CheckpointHeader{"0.1", "00ff", 1.5e-6 * 42, 42, 2}));
  ASSERT_EQ(read.content.tables.size(), 4u);
  for (std::size_t k = 0; k < 4; ++k) {
    const auto wanted = content(k / 2).tables[k % 2];
    const auto& table = read.content.tables[k];
    EXPECT_EQ(table.name, wanted.name);
    EXPECT_EQ(table.width, wanted.width);
    EXPECT_EQ(table.id, wanted.id);
    ASSERT_EQ(table.value.size(), wanted.value.size());
    EXPECT_EQ(std::memcmp(table.value.data(), wanted.value.data(), 8 * wanted.value.size()), 0);
  }
  EXPECT_EQ(read.content.texts, content(0).texts);
}

TEST_F(CheckpointFiles, TheSameStateIsTheSameBytesAtAnotherTime) {
  const auto part = folder_ / "checkpoint-000000000042.0.h5";
  write(42);
  const std::string before = read_file(part);
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 has times in seconds
  write(42);
  EXPECT_TRUE(read_file(part) == before);
}

TEST_F(CheckpointFiles, TablesWithoutRowsAreLeftOut) {
  CheckpointContent content;
  content.tables = {{"none", 2, {}, {}}, {"one", 1, {3}, {4}}};
  const auto read = from_hdf5(to_hdf5(content).bytes());
  ASSERT_EQ(read.tables.size(), 1u);
  EXPECT_EQ(read.tables[0].name, "one");
  content.tables[1].value.push_back(5);
  EXPECT_THROW(to_hdf5(content), ImageError);
}

TEST_F(CheckpointFiles, SwappedAndForeignPartsAreRefused) {
  const auto manifest = write(7);
  const auto a = checkpoint_part(folder_, 7, 0), b = checkpoint_part(folder_, 7, 1);
  fs::rename(a, folder_ / "kept"), fs::rename(b, a), fs::rename(folder_ / "kept", b);
  EXPECT_NE(refusal(manifest).find(a.string()), std::string::npos) << refusal(manifest);
  // Even with a manifest that belongs to them, the parts know their ranks.
  std::vector<CheckpointPart> parts;
  for (const auto& file : {a, b}) {
    const auto bytes = read_file(file);
    parts.push_back({bytes.size(), hash_bytes(bytes)});
  }
  write_checkpoint_manifest(folder_, {"0.1", "00ff", 1.5e-6 * 7, 7, 2}, parts);
  EXPECT_NE(refusal(manifest).find("another rank"), std::string::npos) << refusal(manifest);
}

TEST_F(CheckpointFiles, WhatIsMissingOrNoFileIsNamed) {
  const auto manifest = write(7);
  EXPECT_NE(refusal(folder_ / "nowhere").find("nowhere': it is missing"), std::string::npos);
  EXPECT_NE(refusal(folder_), "");
  const auto part = checkpoint_part(folder_, 7, 1);
  fs::remove(part);
  EXPECT_NE(refusal(manifest).find(part.string() + "': it is missing"), std::string::npos);
  ASSERT_EQ(mkfifo(part.c_str(), 0600), 0);  // would hang whoever opens it
  EXPECT_NE(refusal(manifest).find("not a file"), std::string::npos) << refusal(manifest);
  const auto elsewhere = checkpoint_manifest(folder_, 8);
  fs::rename(manifest, elsewhere);
  EXPECT_NE(refusal(elsewhere).find("another step"), std::string::npos) << refusal(elsewhere);
}

TEST_F(CheckpointFiles, ListsTheLatestFirstAndRemovesTheRest) {
  for (const std::uint64_t step : {5, 1000, 70}) write(step);
  const auto all = checkpoints_in(folder_);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], checkpoint_manifest(folder_, 1000));
  EXPECT_EQ(all[2], checkpoint_manifest(folder_, 5));
  std::ofstream(folder_ / "checkpoint-000000000070.1.h5.tmp-abcdef") << "left by a crash";
  std::ofstream(folder_ / "checkpoint-notes.txt") << "the user's own";
  remove_checkpoints_but(folder_, {70, 5});
  EXPECT_EQ(checkpoints_in(folder_).size(), 2u);
  EXPECT_EQ(refusal(checkpoint_manifest(folder_, 70)), "");
  EXPECT_FALSE(fs::exists(checkpoint_part(folder_, 1000, 0)));
  EXPECT_FALSE(fs::exists(folder_ / "checkpoint-000000000070.1.h5.tmp-abcdef"));
  EXPECT_TRUE(fs::exists(folder_ / "checkpoint-notes.txt"));
}

TEST_F(CheckpointFiles, OfLaterStepsGo) {
  for (const std::uint64_t step : {5, 70, 1000, 71}) write(step);
  std::ofstream(folder_ / "checkpoint-notes.txt") << "the user's own";
  remove_checkpoints_after(checkpoint_manifest(folder_, 70));
  const auto all = checkpoints_in(folder_);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(refusal(all[0]), "");
  EXPECT_EQ(all[0], checkpoint_manifest(folder_, 70));
  EXPECT_FALSE(fs::exists(checkpoint_part(folder_, 71, 0)));
  EXPECT_TRUE(fs::exists(folder_ / "checkpoint-notes.txt"));
}

/// Damages `bytes` in one way of several, and never not at all.
void damage(std::string& bytes, std::mt19937_64& random) {
  const std::string before = bytes;
  while (bytes == before) {
    const std::size_t at = random() % bytes.size();
    const std::size_t length = std::min<std::size_t>(1 + random() % 4096, bytes.size() - at);
    switch (random() % 6) {
      case 0:
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        break;
      case 1:
        bytes[at] = static_cast<char>(random());
        break;
      case 2:
        bytes.resize(at);
        break;
      case 3:
        bytes.replace(at, length, length, '\0');
        break;
      case 4:
        bytes.erase(at, length);
        break;
      default:
        bytes += bytes.substr(at, length);
    }
    if (bytes.empty()) return;
  }
}

/// Each mutation of any of its files must be refused, naming that file and a reason.
void expect_mutations_refused(const fs::path& folder, const fs::path& manifest, int count) {
  ASSERT_EQ(refusal(manifest), "");
  const std::vector<fs::path> files = {manifest, checkpoint_part(folder, 7, 0),
                                       checkpoint_part(folder, 7, 1)};
  std::mt19937_64 random(1);
  for (int n = 0; n < count; ++n) {
    const auto& file = files[static_cast<std::size_t>(n) % files.size()];
    const std::string good = read_file(file);
    std::string bad = good;
    damage(bad, random);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bad;
    EXPECT_NE(refusal(manifest).find("'" + file.string() + "': "), std::string::npos)
        << "mutation " << n << ": " << refusal(manifest);
    std::ofstream(file, std::ios::binary | std::ios::trunc) << good;
  }
  EXPECT_EQ(refusal(manifest), "");
}

TEST_F(CheckpointFiles, MutationsAreRefused) { expect_mutations_refused(folder_, write(7), 60); }

TEST_F(CheckpointFiles, LongTwoThousandMutationsAreRefused) {
  expect_mutations_refused(folder_, write(7), 2000);
}

/// Behind the hashes stands HDF5 with its own checks: what it reads of a damaged image, it must
/// read right or refuse.
void expect_images_right_or_refused(const CheckpointContent& content, int count) {
  const std::string good(to_hdf5(content).bytes());
  std::mt19937_64 random(2);
  int refused = 0;
  ASSERT_EQ(from_hdf5(good).texts, content.texts);
  for (int n = 0; n < count; ++n) {
    std::string bad = good;
    bad[random() % bad.size()] ^= static_cast<char>(1 + random() % 255);
    try {
      const auto read = from_hdf5(bad);
      ASSERT_EQ(read.tables.size(), content.tables.size()) << n;
      for (std::size_t k = 0; k < read.tables.size(); ++k) {
        const auto &a = read.tables[k], &b = content.tables[k];
        ASSERT_EQ(a.id, b.id) << n;
        ASSERT_EQ(std::memcmp(a.value.data(), b.value.data(), 8 * b.value.size()), 0) << n;
      }
      ASSERT_EQ(read.texts, content.texts) << n;
    } catch (const ImageError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, count / 2);
}

TEST_F(CheckpointFiles, DamagedImagesAreRefusedOrReadRight) {
  expect_images_right_or_refused(content(0), 60);
}

TEST_F(CheckpointFiles, LongDamagedImagesAreRefusedOrReadRight) {
  expect_images_right_or_refused(content(0), 2000);
}

}  // namespace
}  // namespace brunt
