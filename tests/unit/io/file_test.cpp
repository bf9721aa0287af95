// Files that are whole or not there. A disk is full where a limit on the size of files stands for
// it. Expected: MachineError with the file's name, the file as it was, nothing left beside it.
#include "io/file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/unit/io/scratch_folder.hpp"

namespace brunt {
namespace {

using test::FileSizeLimit;
using test::message_of;
using test::ScratchFolder;

class FileTest : public ScratchFolder {
 protected:
  std::size_t files_in_folder() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder_)) ++n;
    return n;
  }
};

TEST_F(FileTest, ReplacesAllBytesAndLeavesNothingBeside) {
  const auto path = folder_ / "a.bin";
  const std::string bytes("one\0two\n", 8);
  write_file_atomically(path, "an older and longer text");
  write_file_atomically(path, bytes);
  EXPECT_EQ(read_file(path), bytes);
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(FileTest, HonoursTheUmask) {
  const mode_t old = umask(027);
  write_file_atomically(folder_ / "a", "x");
  umask(old);
  struct stat status {};
  ASSERT_EQ(stat((folder_ / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(FileTest, KeepsTheOldFileOnAFullDisk) {
  const auto path = folder_ / "frame.vtu";
  write_file_atomically(path, "old");
  std::string message;
  {
    FileSizeLimit limit(1000);
    message = message_of([&] { write_file_atomically(path, std::string(5000, 'x')); });
  }
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_NE(message.find("errno 27"), std::string::npos) << message;  // EFBIG
  EXPECT_EQ(read_file(path), "old");
  EXPECT_EQ(files_in_folder(), 1u);
}

/// What waits goes in one call with a long part behind it; the disk takes a part of both, or of
/// what waits alone.
TEST_F(FileTest, KeepsTheOldFileWhereTheDiskTakesAPart) {
  const auto path = folder_ / "frame.vtu";
  write_file_atomically(path, "old");
  for (const unsigned most : {300U, 1000U, 20'000U}) {
    std::string message;
    {
      FileSizeLimit limit(most);
      message = message_of([&] {
        ReplacedFile file(path);
        file.append(std::string(500, 'a'));
        file.append(std::string(40'000, 'b'));
      });
    }
    EXPECT_NE(message.find("errno 27"), std::string::npos) << most << message;  // EFBIG
    EXPECT_EQ(read_file(path), "old");
    EXPECT_EQ(files_in_folder(), 1u);
  }
}

/// Parts, of which some are in the file already when others are written over.
TEST_F(FileTest, ReplacesInParts) {
  const auto path = folder_ / "a.bin";
  write_file_atomically(path, "old");
  const std::string part(700'000, 'x');
  {
    ReplacedFile file(path);
    file.append("head ");
    for (int k = 0; k < 4; ++k) file.append(part);
    EXPECT_EQ(file.size(), 5 + 4 * part.size());
    file.overwrite(0, "HEAD");
    file.append("tail");
    file.overwrite(file.size() - 4, "T");
    EXPECT_EQ(read_file(path), "old");
    file.finish();
  }
  EXPECT_EQ(read_file(path), "HEAD " + part + part + part + part + "Tail");
  { ReplacedFile(path).append("never finished"); }
  EXPECT_EQ(read_file(path).size(), 9 + 4 * part.size());
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(FileTest, NamesTheFileWhereTheFolderIsMissing) {
  const auto path = folder_ / "none" / "a";
  const std::string message = message_of([&] { write_file_atomically(path, "x"); });
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_NE(message_of([&] { read_file(path); }).find(path.string()), std::string::npos);
}

TEST_F(FileTest, RefusesAFolderBelowAFile) {
  write_file_atomically(folder_ / "a", "x");
  EXPECT_THROW(create_folder(folder_ / "a" / "b"), MachineError);
}

TEST_F(FileTest, AppendsLinesThatAreThereAtOnce) {
  const auto path = folder_ / "history.csv";
  LineFile file(path);
  file.append("1,2\n");
  EXPECT_EQ(read_file(path), "1,2\n");
  file.append("3,4\n");
  file.flush();
  EXPECT_EQ(read_file(path), "1,2\n3,4\n");
}

TEST_F(FileTest, CutsAPartOfALineOffOnAFullDisk) {
  // 12 bytes fit, so the second line of 8 bytes is taken by half and must be cut off again.
  const auto path = folder_ / "history.csv";
  LineFile file(path);
  file.append("1111111\n");
  std::string message;
  {
    FileSizeLimit limit(12);
    message = message_of([&] { file.append("2222222\n"); });
  }
  EXPECT_NE(message.find(path.string()), std::string::npos) << message;
  EXPECT_EQ(read_file(path), "1111111\n");
  file.append("3333333\n");
  EXPECT_EQ(read_file(path), "1111111\n3333333\n");
}

TEST(LineFile, NamesTheDeviceThatIsFull) {
  LineFile file("/dev/full");
  EXPECT_NE(message_of([&] { file.append("1\n"); }).find("/dev/full"), std::string::npos);
}

}  // namespace
}  // namespace brunt
