#pragma once
/// Parameters of a deck: `$speed` as a value, `-$speed`, in expressions, in texts.
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/deck/expression.hpp"
#include "io/deck/node.hpp"
#include "io/deck/units.hpp"

namespace brunt {

struct Parameter {
  std::string name;
  std::string text;  ///< as declared
  SourcePlace place;
  Node node;                            ///< what `$name` stands for
  std::optional<ParameterValue> value;  ///< of numbers and quantities
  bool failed = false;                  ///< it is wrong, and so is what is made of it
  bool declared = true;                 ///< false: it is used alone
  std::vector<SourcePlace> used_at;     ///< outside of other parameters
};

/// Of a formula, in which `$name` may stand for more than parameters: those names, at a path of the
/// deck. Null where no formula stands.
using FormulaNames = std::function<const std::set<std::string>*(const std::string& path)>;

/// Takes the key `parameters` out of the deck, and puts values in wherever a `$name` stands but in
/// expressions; in formulas numbers in SI, but for what the formula knows itself. Undeclared and
/// unused ones are problems, each reported once. Undeclared ones come last.
std::vector<Parameter> resolve_parameters(Node& root, const Units& units,
                                          const FormulaNames& formula_names,
                                          std::vector<DeckProblem>& problems);
ParameterValues values_of(const std::vector<Parameter>& parameters);

}  // namespace brunt
