#include "io/deck/parser.hpp"

#include <algorithm>
#include <string_view>

namespace brunt {

namespace {
constexpr const char* kNameCharacters =
    "$_0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

}  // namespace

std::string form_problem(const std::string& body) {
  constexpr std::size_t kLongest = 2000;
  if (body.size() > kLongest) return "the expression is too long";
  for (std::size_t i = 0; i < body.size(); ++i) {
    const char c = body[i];
    if (c == '"' || c == '#' || c == '\'' || c == ';' || c == '{' || c == '}') {
      return std::string("'") + c + "' has no meaning in an expression";
    }
    if (c != '=') continue;
    const bool compares =
        (i + 1 < body.size() && body[i + 1] == '=') ||
        (i > 0 && std::string_view("=<>!").find(body[i - 1]) != std::string_view::npos);
    if (!compares) return "'=' assigns; compare with '=='";
  }
  return "";
}

bool is_name_character(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void prepare(mu::Parser& parser) {
  parser.DefineNameChars(kNameCharacters);
  parser.DefineConst("pi", kPi);
}

Real one_value_of(const mu::Parser& parser) {
  int n = 0;
  const mu::value_type* values = parser.Eval(n);
  if (n != 1) throw mu::ParserError("an expression has one value");
  return values[0];
}

namespace {
/// True where what was not understood stands behind a number, as a unit would.
bool follows_a_number(const mu::ParserError& error) {
  const std::string& text = error.GetExpr();
  const std::size_t end =
      std::min(text.size(), static_cast<std::size_t>(std::max(error.GetPos(), 0)));
  const std::size_t before = text.substr(0, end).find_last_not_of(' ');
  return before != std::string::npos && text[before] >= '0' && text[before] <= '9';
}
}  // namespace

std::string parser_problem(const mu::ParserError& error, const std::string& known) {
  std::string message = error.GetMsg();
  if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN) {
    const std::string& name = error.GetToken();
    message = "'" + name + "' is not known in an expression" + known;
    if (follows_a_number(error)) {
      message += "; numbers in it are in SI units, and none is written";
    } else if (!name.empty() && name[0] != '$') {
      message += "; a parameter is written $" + name;
    }
  }
  return message;
}

}  // namespace brunt
// Tested by tests/unit/io/expression_test.cpp.
