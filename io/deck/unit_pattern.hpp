#pragma once
#include <string>

#include "core/schema.hpp"

namespace brunt {

/// A regular expression (ECMA 262) of what a quantity may be as a text in a deck: a number with a
/// unit of its dimension, a parameter ($name) or an expression (= ...). Units are symbols as
/// engineers write them, with prefixes, and their quotients: kg/m^3, kg.m-3, g/cm3, W/(m^2.K); the
/// program knows more.
/// range: a sign or zero that it forbids is no match; other bounds are not seen behind a unit.
std::string quantity_pattern(const std::string& unit, const Range& range);
/// What stands for any value: $name or -$name, or an expression.
std::string parameter_pattern();

}  // namespace brunt
