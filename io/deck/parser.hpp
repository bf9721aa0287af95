#pragma once
/// muParser, set up as the expressions of a deck want it.
#include <muParser.h>

#include <string>

#include "core/types.hpp"

namespace brunt {

/// True for what a name, behind "$" or not, is made of.
bool is_name_character(char c);

/// Why the parser must not see a text, or "".
std::string form_problem(const std::string& body);

/// Gives the parser what it must know before it gets an expression.
void prepare(mu::Parser& parser);

/// Throws mu::ParserError where there are several.
Real one_value_of(const mu::Parser& parser);

/// The parser's words, with what a user can do about the most frequent one.
/// known  what is known besides parameters, or ""
std::string parser_problem(const mu::ParserError& error, const std::string& known = "");

}  // namespace brunt
