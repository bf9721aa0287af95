#include "io/deck/number.hpp"

#include <charconv>
#include <cmath>

#include "io/number.hpp"

namespace brunt {

namespace {

std::size_t skip_digits(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// Reads an exponent e[sign]digits at `at`; false where there is none. Capped far beyond double.
bool read_exponent(std::string_view text, std::size_t& at, long& exponent) {
  if (at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return false;
  std::size_t digits = at + 1;
  const bool sign = digits < text.size() && (text[digits] == '+' || text[digits] == '-');
  if (sign) ++digits;
  const std::size_t end = skip_digits(text, digits);
  if (end == digits) return false;
  exponent = 0;
  for (std::size_t i = digits; i < end; ++i) {
    if (exponent < 100000) exponent = 10 * exponent + (text[i] - '0');
  }
  if (sign && text[at + 1] == '-') exponent = -exponent;
  at = end;
  return true;
}

}  // namespace

NumberText leading_number(std::string_view text, int shift) {
  NumberText number;
  std::size_t at = 0;
  if (at < text.size() && (text[at] == '+' || text[at] == '-')) ++at;
  const std::size_t first = at;
  at = skip_digits(text, at);
  const std::size_t whole = at - first;
  std::size_t fraction = 0;
  if (at < text.size() && text[at] == '.') {
    const std::size_t end = skip_digits(text, at + 1);
    fraction = end - at - 1;
    if (whole + fraction > 0) at = end;
  }
  if (whole + fraction == 0) return number;
  std::string mantissa(text.substr(first, at - first));
  long exponent = 0;
  read_exponent(text, at, exponent);
  number.length = at;
  if (whole > 1 && text[first] == '0') {
    number.problem = "a number does not begin with 0: write '" +
                     mantissa.substr(std::min(mantissa.find_first_not_of('0'), whole - 1)) + "'";
    return number;
  }
  mantissa += "e" + std::to_string(exponent + shift);
  const auto result =
      std::from_chars(mantissa.data(), mantissa.data() + mantissa.size(), number.value);
  if (result.ec != std::errc{} || !std::isfinite(number.value)) {
    number.problem = "the number does not fit into a double";
  }
  if (text[0] == '-') number.value = -number.value;
  return number;
}

std::optional<Real> whole_number(std::string_view text) {
  const NumberText number = leading_number(text);
  if (number.length != text.size() || number.length == 0 || !number.problem.empty()) return {};
  return number.value;
}

std::string shortest_text(Real value) { return shortest(value); }

}  // namespace brunt
