#pragma once
/// Lines of values between commas, or in columns, as keyword decks have them.
#include <charconv>
#include <optional>
#include <string>
#include <string_view>

#include "io/mesh/mesh_text.hpp"

namespace brunt {

/// Without blanks at both ends.
inline std::string_view trimmed(std::string_view text) {
  const auto from = text.find_first_not_of(" \t\r");
  if (from == std::string_view::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

inline std::string upper(std::string_view text) {
  std::string large(text);
  for (char& c : large) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return large;
}

/// A line, taken field by field.
class Card {
 public:
  /// text  for its messages
  /// hint  behind them
  Card(const MeshText& text, std::string_view line, const char* hint = "")
      : text_(text), rest_(line), commas_(line.find(',') != std::string_view::npos), hint_(hint) {}

  /// True where nothing but blanks is left.
  bool at_end() const { return trimmed(rest_).empty(); }
  /// The next field: up to a comma where the line has any or width is 0, else of so many columns.
  std::string_view field(std::size_t width) {
    const bool to_comma = commas_ || width == 0;
    const std::size_t end = to_comma ? std::min(rest_.find(','), rest_.size()) : width;
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(std::min(rest_.size(), end + (to_comma ? 1 : 0)));
    return trimmed(taken);
  }
  /// The next whole number; none where the field is empty.
  std::optional<std::int64_t> maybe_integer(std::size_t width, const char* what) {
    const std::string_view taken = field(width);
    if (taken.empty()) return std::nullopt;
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(taken.data(), taken.data() + taken.size(), value);
    if (error != std::errc{} || stop != taken.data() + taken.size()) refuse(taken, what);
    return value;
  }
  std::int64_t integer(std::size_t width, const char* what) {
    const auto value = maybe_integer(width, what);
    if (!value) refuse("", what);
    return *value;
  }
  /// The next number; 0 where the field is empty.
  Real real(std::size_t width, const char* what) {
    std::string_view taken = field(width);
    if (taken.empty()) return 0;
    if (taken.front() == '+') taken.remove_prefix(1);
    Real value = 0;
    const auto [stop, error] = std::from_chars(taken.data(), taken.data() + taken.size(), value);
    if (stop == taken.data() + taken.size() && error == std::errc{}) return value;
    // Fortran's 1.5D-3, and what is beyond the range of numbers.
    std::string text(taken);
    for (char& c : text) c = c == 'D' || c == 'd' ? 'E' : c;
    char* end = nullptr;
    value = std::strtod(text.c_str(), &end);
    if (text.empty() || end != text.c_str() + text.size()) refuse(taken, what);
    return value;
  }

 private:
  [[noreturn]] void refuse(std::string_view taken, const char* what) const {
    text_.wrong(std::string("expects ") + what + ", got '" + std::string(taken.substr(0, 40)) +
                "'" + hint_);
  }

  const MeshText& text_;
  std::string_view rest_;
  bool commas_;
  const char* hint_;
};

}  // namespace brunt
// Tested by tests/unit/io/abaqus_test.cpp.
