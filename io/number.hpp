#pragma once
/// Numbers as text that reads back as the same double.
#include <optional>
#include <string>
#include <string_view>

#include "core/types.hpp"

namespace brunt {

/// The shortest text that reads back as the same double; "nan", "inf", "-inf" otherwise.
std::string shortest(Real value);

/// Appends shortest(value) to text.
void append_shortest(std::string& text, Real value);

/// value with so many significant digits, without trailing zeros: for tables that people read.
std::string rounded(Real value, int digits);

/// The number that makes up all of text, or nothing.
std::optional<Real> parse_real(std::string_view text);

}  // namespace brunt
