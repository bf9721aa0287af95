#pragma once
/// Expressions of the deck: "= 2*$size + 0.1*$gap". muParser's functions and `pi`.
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "io/deck/units.hpp"

namespace brunt {

/// What a parameter is worth in an expression.
struct ParameterValue {
  Real value = 0;  ///< SI
  Dimension dimension;
  bool has_unit = false;
};
using ParameterValues = std::map<std::string, ParameterValue>;

struct ExpressionResult {
  Real value = 0;              ///< SI
  Dimension dimension;         ///< without angle: in expressions angles are numbers
  bool any_dimension = false;  ///< zero whatever the units
  bool bare = false;           ///< made of numbers without units only: SI
  std::string problem;
};

/// True for a text that is an expression: it begins with "=".
bool is_expression(const std::string& text);
/// Names behind "$", in order, each once; "$$" is none.
std::vector<std::string> names_in(const std::string& text);
/// The four arguments that an expression may have.
using ArgumentNames = std::array<const char*, 4>;
inline constexpr ArgumentNames kTimeAndPlace{"t", "x", "y", "z"};
inline constexpr ArgumentNames kSliding{"T", "yield", "p", "v"};
/// Which of the arguments stand in it.
std::array<bool, 4> arguments_in(const std::string& text, const ArgumentNames& names);
/// True if any of them does.
bool depends_on(const std::string& text, const ArgumentNames& names);

/// The text with parameters written as numbers in SI.
std::string with_numbers(const std::string& text, const ParameterValues& parameters);

/// Evaluates an expression of parameters. It is evaluated in other base units too: the sum of a
/// length and a number cannot pass, and the dimension of the result follows.
ExpressionResult evaluate_expression(const std::string& text, const ParameterValues& parameters);

/// An expression of four arguments, SI in, SI out, with parameters put in as SI numbers.
struct CompiledExpression {
  std::string text;  ///< with the numbers of the parameters: reads back
  /// May be called by many threads at once.
  std::function<Real(const std::array<Real, 4>&)> evaluate;
  std::string problem;
};
CompiledExpression compile_expression(const std::string& text, const ParameterValues& parameters,
                                      const ArgumentNames& names);

/// Evaluates "= $a / $b" over what `lookup` knows; throws std::invalid_argument with the reason.
Real evaluate_formula(const std::string& text,
                      const std::function<std::optional<Real>(const std::string&)>& lookup);

}  // namespace brunt
