#pragma once
/// Files that are whole or not there: what a crash or a full disk must not spoil.
#include <filesystem>
#include <string>
#include <string_view>

namespace brunt {

/// Replaces path by bytes: a temporary file in the same folder, fsync, rename, fsync of the folder.
/// Whoever reads path sees the old bytes or the new ones, never a part; after an error the old
/// ones stay and the temporary is gone.
/// Throws MachineError with the name of the file and the reason.
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

/// The same without fsync: whole or not there after a crash of the program, not after one of the
/// machine. For what a run writes often and can do without: waiting for the disk at every frame
/// costs more than the frame.
void replace_file(const std::filesystem::path& path, std::string_view bytes);

/// What replace_file does, in parts, for what is too much for memory. All functions throw
/// MachineError; a file that was not finished is gone, and the old one stays.
class ReplacedFile {
 public:
  explicit ReplacedFile(std::filesystem::path path);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  void append(std::string_view bytes);
  /// Writes over bytes that were appended.
  void overwrite(std::size_t at, std::string_view bytes);
  std::size_t size() const { return written_ + waiting_.size(); }
  /// lasting: with fsync of file and folder
  void finish(bool lasting = false);

 private:
  /// Writes what waits, and more behind it.
  void flush(std::string_view more = {});

  std::filesystem::path path_;
  std::string temporary_;  // "": there is none
  int descriptor_ = -1;
  std::size_t written_ = 0;  // [byte]
  std::string waiting_;      // what is appended and not written yet
};

/// All bytes of a file. Throws MachineError where it cannot be read.
std::string read_file(const std::filesystem::path& path);

/// Creates a folder and its parents. Throws MachineError where that fails.
void create_folder(const std::filesystem::path& folder);

/// Appends whole lines to a text file: each is with the operating system before append returns, so
/// that a crash of the program leaves whole lines only.
class LineFile {
 public:
  /// Opens path for appending, made if it is not there. Throws MachineError.
  explicit LineFile(std::filesystem::path path);
  ~LineFile();
  LineFile(const LineFile&) = delete;
  LineFile& operator=(const LineFile&) = delete;

  /// Appends lines (complete, each with its newline). Where the disk takes only a part of them, the
  /// part is cut off again and MachineError is thrown.
  void append(std::string_view lines);
  /// Waits until all lines are on the disk. Throws MachineError.
  void flush();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

}  // namespace brunt
