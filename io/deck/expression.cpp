#include "io/deck/expression.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "io/deck/number.hpp"
#include "io/deck/parser.hpp"

namespace brunt {

namespace {
std::string body_of(const std::string& text) { return text.substr(text.find('=') + 1); }

/// A copy of a compiled expression with its own variables.
struct Instance {
  mu::Parser parser;
  std::array<mu::value_type, 4> argument{};

  Instance(const std::string& body, const ArgumentNames& names) {
    prepare(parser);
    for (std::size_t k = 0; k < names.size(); ++k) parser.DefineVar(names[k], &argument[k]);
    parser.SetExpr(body);
  }
};

/// Callable from many threads: each call takes an instance out of a pool and puts it back.
class PooledExpression {
 public:
  PooledExpression(std::string body, const ArgumentNames& names)
      : body_(std::move(body)), names_(names) {}
  PooledExpression(const PooledExpression& other) : body_(other.body_), names_(other.names_) {}
  PooledExpression& operator=(const PooledExpression&) = delete;

  Real operator()(const std::array<Real, 4>& arguments) const {
    std::unique_ptr<Instance> instance = take();
    instance->argument = arguments;
    const Real value = one_value_of(instance->parser);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(instance));
    return value;
  }

 private:
  std::unique_ptr<Instance> take() const {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<Instance> instance = std::move(free_.back());
        free_.pop_back();
        return instance;
      }
    }
    return std::make_unique<Instance>(body_, names_);
  }

  std::string body_;
  ArgumentNames names_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<Instance>> free_;  ///< cache, under mutex_
};

/// Evaluates one expression with its parameters in changing base units.
class ScaledEvaluation {
 public:
  ScaledEvaluation(const std::string& body, const std::vector<ParameterValue>& parameters,
                   const std::vector<std::string>& names)
      : parameters_(parameters), values_(parameters.size()) {
    prepare(parser_);
    for (std::size_t i = 0; i < names.size(); ++i) {
      parser_.DefineVar("$" + names[i], &values_[i]);
    }
    parser_.SetExpr(body);
  }
  /// log2_scale: binary logarithm of the SI unit over the other unit, for each base; powers of
  /// two, so that scaling is exact.
  Real operator()(const std::array<int, Dimension::kBases>& log2_scale) {
    for (std::size_t i = 0; i < values_.size(); ++i) {
      int power = 0;
      for (int base = 0; base < Dimension::kBases; ++base) {
        power += parameters_[i].dimension.exponent[base] * log2_scale[base];
      }
      values_[i] = std::ldexp(parameters_[i].value, power);
    }
    return one_value_of(parser_);
  }

 private:
  mu::Parser parser_;
  const std::vector<ParameterValue>& parameters_;
  std::vector<mu::value_type> values_;
};

/// The exponent k for which f(scaled) = 2^(k log2_scale) f, or nothing where there is none.
std::optional<int> scaling_exponent(Real plain, Real scaled, int log2_scale) {
  constexpr Real kRoundOff = 1e-9;  // functions such as pow round anew in other units
  if (plain == 0 || scaled == 0 || !std::isfinite(scaled)) return {};
  const Real ratio = scaled / plain;
  if (!(ratio > 0)) return {};
  const Real exponent = std::log2(ratio) / log2_scale;
  const Real nearest = std::round(exponent);
  if (std::abs(exponent - nearest) > kRoundOff || std::abs(nearest) > 20) return {};
  return static_cast<int>(nearest);
}

/// Finds the dimension of the result; sets the problem where there is none.
void find_dimension(ScaledEvaluation& evaluate, ExpressionResult& result) {
  constexpr const char* kMixed =
      "mixes dimensions: what is added or compared must be of one kind, and functions take numbers";
  constexpr int kBits = 17;
  result.any_dimension = result.value == 0;
  for (int base = 0; base < Dimension::kAngle; ++base) {
    std::optional<int> exponents[2];
    for (const int sign : {0, 1}) {
      std::array<int, Dimension::kBases> scale{};
      scale[base] = sign == 0 ? kBits : -kBits;
      const Real scaled = evaluate(scale);
      if (result.value == 0
              ? scaled != 0
              : !(exponents[sign] = scaling_exponent(result.value, scaled, scale[base]))) {
        result.problem = kMixed;
        return;
      }
    }
    if (exponents[0] != exponents[1]) {
      result.problem = kMixed;
      return;
    }
    result.dimension.exponent[base] = exponents[0].value_or(0);
  }
}

}  // namespace

bool is_expression(const std::string& text) { return !text.empty() && text.front() == '='; }

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '$') continue;
    std::size_t end = i + 1;
    if (end < text.size() && text[end] == '$') {
      i = end;
      continue;
    }
    while (end < text.size() && is_name_character(text[end])) ++end;
    const std::string name = text.substr(i + 1, end - i - 1);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    i = end - 1;
  }
  return names;
}

std::array<bool, 4> arguments_in(const std::string& text, const ArgumentNames& names) {
  std::array<bool, 4> found{};
  for (std::size_t i = 0; i < text.size();) {
    if (!is_name_character(text[i]) && text[i] != '$') {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && is_name_character(text[end])) ++end;
    const std::string name = text.substr(i, end - i);
    for (std::size_t k = 0; k < names.size(); ++k) found[k] = found[k] || name == names[k];
    i = end;
  }
  return found;
}

bool depends_on(const std::string& text, const ArgumentNames& names) {
  const auto found = arguments_in(text, names);
  return std::any_of(found.begin(), found.end(), [](bool one) { return one; });
}

std::string with_numbers(const std::string& text, const ParameterValues& parameters) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] != '$') {
      result += text[i++];
      continue;
    }
    std::size_t end = i + 1;
    while (end < text.size() && is_name_character(text[end])) ++end;
    const auto found = parameters.find(text.substr(i + 1, end - i - 1));
    if (found == parameters.end()) {
      result += text.substr(i, end - i);
    } else {
      result += "(" + shortest_text(found->second.value) + ")";
    }
    i = end;
  }
  return result;
}

ExpressionResult evaluate_expression(const std::string& text, const ParameterValues& parameters) {
  ExpressionResult result;
  const std::string body = body_of(text);
  result.problem = form_problem(body);
  if (!result.problem.empty()) return result;
  const std::vector<std::string> names = names_in(body);
  std::vector<ParameterValue> values;
  result.bare = true;
  for (const std::string& name : names) {
    const auto found = parameters.find(name);
    if (found == parameters.end()) {
      result.problem = "$" + name + " is not a number";
      return result;
    }
    values.push_back(found->second);
    if (found->second.has_unit) result.bare = false;
  }
  try {
    ScaledEvaluation evaluate(body, values, names);
    result.value = evaluate({});
    if (!std::isfinite(result.value)) {
      result.problem = "the value is " + shortest_text(result.value);
    } else {
      find_dimension(evaluate, result);
    }
  } catch (const mu::ParserError& error) {
    result.problem = parser_problem(error);
  }
  return result;
}

CompiledExpression compile_expression(const std::string& text, const ParameterValues& parameters,
                                      const ArgumentNames& names) {
  CompiledExpression compiled;
  const std::string body = with_numbers(body_of(text), parameters);
  compiled.text = "=" + body;
  compiled.problem = form_problem(body);
  if (!compiled.problem.empty()) return compiled;
  try {
    const PooledExpression pooled(body, names);
    const Real start = pooled({});
    static_cast<void>(start);
    compiled.evaluate = pooled;
  } catch (const mu::ParserError& error) {
    std::string known;
    for (const char* name : names) known += std::string(known.empty() ? " of " : ", ") + name;
    compiled.problem = parser_problem(error, known);
  }
  return compiled;
}

Real evaluate_formula(const std::string& text,
                      const std::function<std::optional<Real>(const std::string&)>& lookup) {
  const std::string body = body_of(text);
  const std::string problem = form_problem(body);
  if (!problem.empty()) throw std::invalid_argument(problem);
  try {
    mu::Parser parser;
    prepare(parser);
    for (const std::string& name : names_in(body)) {
      const std::optional<Real> value = lookup(name);
      if (!value) throw std::invalid_argument("$" + name + " is not known");
      parser.DefineConst("$" + name, *value);
    }
    parser.SetExpr(body);
    return one_value_of(parser);
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(parser_problem(error));
  }
}

}  // namespace brunt
