#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace brunt {

/// The text of a mesh file, read once into memory, taken word by word or line by line. What is not
/// as it should be throws std::runtime_error with file:line.
class MeshText {
 public:
  /// Reads the file, but for the mark of UTF-8 at its head. Throws std::runtime_error where it is
  /// none, too large, or UTF-16.
  explicit MeshText(std::string path);

  const std::string& path() const { return path_; }
  /// Line of the word taken last, from 1.
  int line() const { return taken_ > 0 ? taken_ : line_; }
  /// Bytes that are left: no count in a sound file is larger.
  std::size_t left() const { return slot_of(end_ - at_); }
  bool at_end();
  /// The whole file, for formats that are neither of words nor of lines.
  std::string_view all() const { return bytes_; }

  /// The next word; "" at the end. Words stand between blanks and line ends.
  std::string_view word();
  /// What is left of this line, without blanks around it; goes on to the next line.
  std::string_view rest_of_line();
  /// The whole next number. `what` says in messages what it is.
  std::int64_t integer(const char* what);
  Real real(const char* what);
  /// A number of things to come, each of at least `bytes` bytes.
  std::size_t count(const char* what, std::size_t bytes);
  /// The next bytes as they are, of binary parts.
  void raw(void* into, std::size_t size);

  /// The next line, without blanks at its end. Files that are read by lines are read so alone.
  std::string_view next_line();
  /// The first character of the next line; 0 at the end.
  char peek() const { return at_ == end_ ? '\0' : *at_; }
  /// Goes on behind the next line that begins with `start`; false at the end of the file.
  bool skip_to_line(std::string_view start);
  [[noreturn]] void wrong(const std::string& what) const;

 private:
  void skip_blanks();

  std::string path_, bytes_;
  const char *at_ = nullptr, *end_ = nullptr;
  int line_ = 1;
  int taken_ = 0;  // line that next_line has given; 0: none
};

}  // namespace brunt
