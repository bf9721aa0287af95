#include "io/number.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace brunt {

void append_shortest(std::string& text, Real value) {
  if (std::isnan(value)) {  // to_chars would show the sign of a NaN, which means nothing
    text += "nan";
    return;
  }
  std::array<char, 32> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
  text.append(buffer.data(), end);
}

std::string shortest(Real value) {
  std::string text;
  append_shortest(text, value);
  return text;
}

std::string rounded(Real value, int digits) {
  if (!std::isfinite(value)) return shortest(value);
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::general, digits)
                       .ptr;
  return std::string(buffer.data(), end);
}

std::optional<Real> parse_real(std::string_view text) {
  Real value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || result.ec != std::errc{} || result.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace brunt
