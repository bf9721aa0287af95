#include "io/mesh/mesh_text.hpp"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace brunt {

namespace {
constexpr std::uintmax_t kLargest = std::uintmax_t{2} << 30;  // [byte]

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0'; }

std::string all_bytes_of(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto type = fs::status(path, error).type();
  if (type == fs::file_type::not_found) throw std::runtime_error(path + ": there is no such file");
  if (type != fs::file_type::regular) {
    throw std::runtime_error(path +
                             ": is a folder, a pipe or a device; a mesh is read from a file");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (size > kLargest)
    throw std::runtime_error(path + ": is larger than 2 GiB, some 20 million elements");
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  std::string bytes(slot_of(size), '\0');
  if (!file || std::fread(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
    throw std::runtime_error(path + ": cannot be read");
  }
  return bytes;
}
}  // namespace

MeshText::MeshText(std::string path) : path_(std::move(path)), bytes_(all_bytes_of(path_)) {
  at_ = bytes_.data();
  end_ = at_ + bytes_.size();
  // Editors of some systems mark texts by their first bytes; the mark is no part of the text.
  const std::string_view start = std::string_view(bytes_).substr(0, 3);
  if (start == "\xEF\xBB\xBF") at_ += 3;
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) {
    wrong("is text of 16 bits a letter (UTF-16): save it as UTF-8 or ASCII");
  }
}

void MeshText::wrong(const std::string& what) const {
  throw std::runtime_error(path_ + ":" + std::to_string(line()) + ": " + what);
}

void MeshText::skip_blanks() {
  for (; at_ != end_ && is_blank(*at_); ++at_) line_ += *at_ == '\n';
}

bool MeshText::at_end() {
  skip_blanks();
  return at_ == end_;
}

std::string_view MeshText::word() {
  skip_blanks();
  const char* start = at_;
  while (at_ != end_ && !is_blank(*at_)) ++at_;
  return {start, slot_of(at_ - start)};
}

std::string_view MeshText::rest_of_line() {
  const char* start = at_;
  const void* found = std::memchr(at_, '\n', left());
  at_ = found ? static_cast<const char*>(found) : end_;
  const char* stop = at_;
  while (start != stop && is_blank(*start)) ++start;
  while (stop != start && is_blank(stop[-1])) --stop;
  if (at_ != end_) ++at_, ++line_;
  return {start, slot_of(stop - start)};
}

std::string_view MeshText::next_line() {
  const char* start = at_;
  const void* found = std::memchr(at_, '\n', left());
  const char* stop = found ? static_cast<const char*>(found) : end_;
  at_ = stop == end_ ? end_ : stop + 1;
  taken_ = line_++;
  while (stop != start && is_blank(stop[-1])) --stop;
  return {start, slot_of(stop - start)};
}

std::int64_t MeshText::integer(const char* what) {
  skip_blanks();
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(at_, end_, value);
  if (error != std::errc{} || (stop != end_ && !is_blank(*stop))) {
    wrong(std::string("expects ") + what + ", a whole number, got '" +
          std::string(word().substr(0, 40)) + "'");
  }
  at_ = stop;
  return value;
}

Real MeshText::real(const char* what) {
  skip_blanks();
  Real value = 0;
  const char* start = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
  const auto [stop, error] = std::from_chars(start, end_, value);
  const bool ends = stop == end_ || is_blank(*stop);
  if (error == std::errc::result_out_of_range && ends) {
    value = std::strtod(std::string(start, stop).c_str(), nullptr);  // 0 or infinite
  } else if (error != std::errc{} || !ends) {
    wrong(std::string("expects ") + what + ", a number, got '" + std::string(word().substr(0, 40)) +
          "'");
  }
  at_ = stop;
  return value;
}

std::size_t MeshText::count(const char* what, std::size_t bytes) {
  const std::int64_t n = integer(what);
  if (n < 0 || static_cast<std::uint64_t>(n) > left() / bytes + 1) {
    wrong(std::string(what) + " is " + std::to_string(n) + ", and " + std::to_string(left()) +
          " bytes are left of the file");
  }
  return slot_of(n);
}

void MeshText::raw(void* into, std::size_t size) {
  if (left() < size) wrong("the file ends inside its binary part");
  std::memcpy(into, at_, size);
  at_ += size;
}

bool MeshText::skip_to_line(std::string_view start) {
  while (at_ != end_) {
    const std::string_view line = rest_of_line();
    if (line.substr(0, start.size()) == start) return true;
  }
  return false;
}

}  // namespace brunt
// Tested by tests/unit/io/gmsh_test.cpp.
