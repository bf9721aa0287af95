#pragma once
/// Numbers as text: one strict way in, the shortest exact way out.
#include <optional>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace brunt {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// A number at the beginning of a text. length 0: there is none.
struct NumberText {
  std::size_t length = 0;
  Real value = 0;
  std::string problem;  ///< not empty: it looks like a number and is refused
};

/// Reads [sign] digits [. digits] [e [sign] digits] from the beginning of `text`; the value is
/// multiplied by 10^shift before it is rounded. No leading zeros, hex, inf, nan, underscores.
NumberText leading_number(std::string_view text, int shift = 0);
/// The whole text as a number.
std::optional<Real> whole_number(std::string_view text);
/// The shortest text that reads back as the same double.
std::string shortest_text(Real value);

}  // namespace brunt
