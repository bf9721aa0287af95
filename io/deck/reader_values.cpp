/// The part of the reader that reads scalars: quantities, whole numbers, flags, texts, words.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

std::string range_text(const Range& range) {
  const bool low = range.min > -kInfinity, high = range.max < kInfinity;
  if (low && high && range.min == range.max) return shortest_text(range.min);
  std::string from =
      std::string(range.min_excluded ? "above " : "at least ") + shortest_text(range.min);
  const std::string to =
      std::string(range.max_excluded ? "below " : "at most ") + shortest_text(range.max);
  if (low && high) return from + " and " + to;
  if (low) return from;
  return high ? to : "any";
}

bool in_range(Real value, const Range& range) {
  if (value < range.min || value > range.max) return false;
  return !(range.min_excluded && value == range.min) && !(range.max_excluded && value == range.max);
}

namespace {

bool starts_with_letter(const Node& node) {
  return !node.text.empty() && std::isalpha(static_cast<unsigned char>(node.text.front()));
}

std::vector<std::string> spellings(const char* words) {
  std::vector<std::string> all;
  std::string text = words;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t bar = std::min(text.find('|', from), text.size());
    all.push_back(text.substr(from, bar - from));
    from = bar + 1;
  }
  return all;
}

std::string expects(const std::string& unit, const Node& node) {
  // C is the coulomb, and a degree an angle.
  const bool degrees =
      unit == "K" && node.is_scalar() && (node.text.ends_with("C") || node.text.ends_with("deg"));
  return "expects " + describe_unit(unit) + ", got " + what_stands(node) +
         (degrees ? "; degrees Celsius are written degC" : "");
}

}  // namespace

std::string main_word(const char* words) { return spellings(words).front(); }

std::string word_list(std::span<const char* const> words) {
  std::string list;
  for (const char* word : words) {
    if (*word != '!') list += (list.empty() ? "" : ", ") + main_word(word);
  }
  return list;
}

std::optional<Real> Reader::expression_value(const Node& node, const std::string& path,
                                             const std::string& unit) {
  if (depends_on(node.text, kTimeAndPlace)) {
    problem(node, path, "cannot depend on t, x, y or z, got " + what_stands(node));
    return {};
  }
  const ExpressionResult result = evaluate_expression(node.text, parameters_);
  if (!result.problem.empty()) {
    problem(node, path, what_stands(node) + ": " + result.problem);
    return {};
  }
  if (unit == "any" || result.any_dimension || result.bare) return result.value;
  if (result.dimension != units_.dimension_of(unit).without_angle()) {
    problem(node, path, expects(unit, node) + ", which is in " + result.dimension.text());
    return {};
  }
  return result.value;
}

std::optional<Real> Reader::unchecked_value(const Node& node, const std::string& path,
                                            const std::string& unit, bool* has_unit) {
  if (!node.is_scalar()) {
    problem(node, path, expects(unit, node));
    return {};
  }
  if (is_expression(node.text)) {
    if (has_unit) *has_unit = true;
    return expression_value(node, path, unit);
  }
  if (node.pieced) {
    problem(node, path,
            expects(unit, node) + "; an expression begins with '=': \"= " + node.written + "\"");
    return {};
  }
  const QuantityValue quantity = units_.read(node.text);
  if (!quantity.problem.empty()) {
    const bool no_number = quantity.problem == "is not a number";
    problem(node, path, expects(unit, node) + (no_number ? "" : ": " + quantity.problem));
    return {};
  }
  if (has_unit) *has_unit = quantity.has_unit || quantity.value == 0;
  if (quantity.has_unit && unit != "any" && quantity.dimension != units_.dimension_of(unit)) {
    problem(node, path, expects(unit, node));
    return {};
  }
  return quantity.value;
}

void Reader::check_range(const Node& node, const std::string& path, Real value,
                         const Quantity& quantity) {
  const std::string unit = quantity.unit;
  const std::string si = unit == "1" || unit == "any" ? "" : " " + unit;
  if (!in_range(value, quantity.range)) {
    problem(node, path,
            "must be " + range_text(quantity.range) + si + ", got " + what_stands(node));
  } else if (value != 0 && !in_range(value, quantity.plausible)) {  // 0 has no unit to mistake
    report_.warnings.push_back({node.place, path,
                                what_stands(node) + " is " + shortest_text(value) + si +
                                    "; usual is " + range_text(quantity.plausible) + si +
                                    ": check the value and its unit"});
  }
}

std::optional<Real> Reader::quantity_value(const Node& node, const std::string& path,
                                           const Quantity& quantity, bool* has_unit) {
  const std::optional<Real> value = unchecked_value(node, path, quantity.unit, has_unit);
  if (value) check_range(node, path, *value, quantity);
  return value;
}

void Reader::real(const Key& key, Real& value, const Quantity& quantity) {
  const Node* node = find(key);
  if (!node) return;
  if (const auto read = quantity_value(*node, path_of(key.name), quantity)) value = *read;
}

void Reader::real(const Key& key, std::optional<Real>& value, const Quantity& quantity) {
  const Node* node = find(key);
  if (!node) return;
  if (const auto read = quantity_value(*node, path_of(key.name), quantity)) value = *read;
}

void Reader::real_or_word(const Key& key, std::optional<Real>& value, const Quantity& quantity,
                          const char* word) {
  const Node* node = find(key);
  if (!node) return;
  if (node->is_scalar() && node->text == word) {
    value.reset();
  } else if (!node->is_scalar() || starts_with_letter(*node)) {
    problem(*node, path_of(key.name),
            "expects '" + std::string(word) + "' or " + describe_unit(quantity.unit) + ", got " +
                what_stands(*node));
  } else if (const auto read = quantity_value(*node, path_of(key.name), quantity)) {
    value = *read;
  }
}

std::optional<int> Reader::integer_value(const Node& node, const std::string& path,
                                         const Range& range) {
  Real value = 0;
  if (node.is_scalar() && is_expression(node.text)) {
    const auto read = expression_value(node, path, "1");
    if (!read) return {};
    value = *read;
  } else {
    const auto digits = [](const std::string& text) {
      return text.find_first_not_of("+-0123456789") == std::string::npos;
    };
    const auto read = node.is_scalar() && !node.pieced && digits(node.text)
                          ? whole_number(node.text)
                          : std::nullopt;
    if (!read) {
      problem(node, path, "expects a whole number, got " + what_stands(node));
      return {};
    }
    value = *read;
  }
  constexpr Real kLargest = 2147483647.0;
  if (value != std::round(value) || std::abs(value) > kLargest) {
    problem(node, path, "expects a whole number, got " + what_stands(node));
    return {};
  }
  if (!in_range(value, range)) {
    problem(node, path, "must be " + range_text(range) + ", got " + what_stands(node));
    return {};
  }
  return static_cast<int>(value);
}

void Reader::integer(const Key& key, int& value, const Range& range) {
  const Node* node = find(key);
  if (!node) return;
  if (const auto read = integer_value(*node, path_of(key.name), range)) value = *read;
}

void Reader::integer_or_word(const Key& key, std::optional<int>& value, const Range& range,
                             const char* word) {
  const Node* node = find(key);
  if (!node) return;
  if (node->is_scalar() && node->text == word) {
    value.reset();
  } else if (!node->is_scalar() || starts_with_letter(*node)) {
    problem(*node, path_of(key.name),
            "expects '" + std::string(word) + "' or a whole number, got " + what_stands(*node));
  } else if (const auto read = integer_value(*node, path_of(key.name), range)) {
    value = *read;
  }
}

void Reader::flag(const Key& key, bool& value) {
  const Node* node = find(key);
  if (!node) return;
  if (scope().words_are_flags && node->is_scalar() && node->text == key.name) {
    value = true;
    return;
  }
  if (!node->is_scalar() || (node->text != "true" && node->text != "false")) {
    problem(*node, path_of(key.name), "expects true or false, got " + what_stands(*node));
    return;
  }
  value = node->text == "true";
}

void Reader::text(const Key& key, std::string& value) {
  const Node* node = find(key);
  if (!node) return;
  if (!node->is_scalar()) {
    problem(*node, path_of(key.name), "expects a text, got " + what_stands(*node));
  } else if (node->text.empty() && key.need == Need::required) {
    problem(*node, path_of(key.name), "is empty: " + std::string(key.help));
  } else {
    value = is_expression(node->text) ? with_numbers(node->text, parameters_) : node->text;
  }
}

std::optional<int> Reader::word_index(const Node& node, const std::string& path,
                                      std::span<const char* const> words) {
  std::vector<std::string> known;
  for (std::size_t i = 0; node.is_scalar() && i < words.size(); ++i) {
    const std::vector<std::string> all = spellings(words[i]);
    if (*words[i] == '!') {
      if (all[0].substr(1) != node.text) continue;
      problem(node, path, what_stands(node) + ": " + all.back());
      return {};
    }
    if (std::find(all.begin(), all.end(), node.text) != all.end()) return static_cast<int>(i);
    known.insert(known.end(), all.begin(), all.end());
  }
  const std::string near = node.is_scalar() ? nearest_word(node.text, known) : "";
  problem(node, path,
          "expects one of " + word_list(words) + ", got " + what_stands(node) +
              (near.empty() ? "" : "; did you mean '" + near + "'?"));
  return {};
}

void Reader::choice(const Key& key, int& index, std::span<const char* const> words) {
  const Node* node = find(key);
  if (!node) return;
  if (const auto read = word_index(*node, path_of(key.name), words)) index = *read;
}

void Reader::words(const Key& key, std::vector<std::string>& value,
                   std::span<const char* const> words) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  if (!node->is_list() || node->items.empty()) {
    problem(*node, path, "expects a list of " + word_list(words) + ", got " + what_stands(*node));
    return;
  }
  std::vector<bool> there(words.size());
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const auto index = word_index(node->items[i], path + "." + std::to_string(i), words);
    if (index) there[*index] = true;
  }
  value.clear();
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (there[i]) value.push_back(main_word(words[i]));
  }
}

void Reader::names(const Key& key, std::vector<std::string>& value, int size) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  const auto is_name = [](const Node& item) { return item.is_scalar() && !item.text.empty(); };
  const bool count_fits = size == 0 ? !node->items.empty() : node->items.size() == slot_of(size);
  if (!node->is_list() || !count_fits ||
      !std::all_of(node->items.begin(), node->items.end(), is_name)) {
    problem(*node, path,
            "expects a list of " + (size == 0 ? "" : std::to_string(size) + " ") + "names, got " +
                what_stands(*node));
    return;
  }
  value.clear();
  for (const Node& item : node->items) value.push_back(item.text);
}

void Reader::value(Real& value, const Quantity& quantity, const char*) {
  scope().value_taken = true;
  if (not_applicable_) return;
  if (const auto read = quantity_value(*scope().node, scope().path, quantity)) value = *read;
}

void Reader::value(int& index, std::span<const char* const> words, const char*) {
  scope().value_taken = true;
  if (not_applicable_) return;
  if (const auto read = word_index(*scope().node, scope().path, words)) index = *read;
}

void Reader::value(std::string& text, const char* help) {
  scope().value_taken = true;
  if (not_applicable_) return;
  const Node& node = *scope().node;
  if (!node.is_scalar() || node.text.empty()) {
    problem(node, scope().path, "expects " + std::string(help) + ", got " + what_stands(node));
    return;
  }
  text = node.text;
}

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
