#pragma once
/// Expressions of the deck: "= 2*$size + 0.1*$gap". muParser's functions and `pi`.
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
/// True if t, x, y or z stands in it.
bool depends_on_place_or_time(const std::string& text);

/// Evaluates an expression of parameters. It is evaluated in other base units too: the sum of a
/// length and a number cannot pass, and the dimension of the result follows.
ExpressionResult evaluate_expression(const std::string& text, const ParameterValues& parameters);

/// An expression of t, x, y, z, SI in, SI out, with parameters put in as SI numbers.
struct CompiledExpression {
  std::string text;  ///< with the numbers of the parameters: reads back
  std::function<Real(Real t, const Vec3& x)> evaluate;  ///< may be called by many threads at once
  std::string problem;
};
CompiledExpression compile_expression(const std::string& text, const ParameterValues& parameters);

/// Evaluates "= $a / $b" over what `lookup` knows; throws std::invalid_argument with the reason.
Real evaluate_formula(const std::string& text,
                      const std::function<std::optional<Real>(const std::string&)>& lookup);

}  // namespace brunt
