/// The part of the reader that reads vectors, points and expressions over time.
#include <algorithm>
#include <cmath>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"

namespace brunt {

namespace {

std::string count_text(int size) {
  return size == 1 ? "1 component" : std::to_string(size) + " components";
}

}  // namespace

bool add_unit(Node& node, const std::string& unit) {
  if (node.is_list()) {
    return std::all_of(node.items.begin(), node.items.end(),
                       [&](Node& item) { return add_unit(item, unit); });
  }
  if (!node.is_scalar() || !whole_number(node.text)) return false;
  node.text += " " + unit;
  return true;
}

std::optional<Node> Reader::with_unit_once(const Node& node, const std::string& path) {
  if (!node.is_map()) return node;
  const Node* unit = node.find("unit");
  const Node* value = node.find("value");
  if (node.entries.size() != 2 || !unit || !value || !unit->is_scalar() || !value->is_list()) {
    problem(node, path, "expects a list, or {unit: mm, value: [...]}, got " + what_stands(node));
    return {};
  }
  Node list = *value;
  if (!add_unit(list, unit->text)) {
    problem(*value, path, "with {unit:, value:} all values are numbers without unit");
    return {};
  }
  return list;
}

std::optional<std::vector<Real>> Reader::list_values(const Node& given, const std::string& path,
                                                     const Quantity& quantity, int size,
                                                     bool allow_free) {
  const std::optional<Node> node = with_unit_once(given, path);
  if (!node) return {};
  const int wanted = size == kVector ? dimensions() : size;
  const auto count = static_cast<int>(node->items.size());
  if (!node->is_list() || count == 0 || (wanted > 0 && count != wanted)) {
    problem(given, path,
            "expects a list of " + (wanted > 0 ? count_text(wanted) + ", each " : std::string()) +
                describe_unit(quantity.unit) + ", got " + what_stands(given));
    return {};
  }
  std::vector<Real> values;
  const std::size_t problems_before = report_.problems.size();
  const Node* bare = nullptr;
  const Node* with_unit = nullptr;
  for (int i = 0; i < count; ++i) {
    const Node& item = node->items[i];
    const std::string item_path = path + "." + std::to_string(i);
    if (allow_free && item.is_scalar() && item.text == "free") {
      values.push_back(std::nan(""));
      continue;
    }
    bool has_unit = false;
    const auto value = quantity_value(item, item_path, quantity, &has_unit);
    values.push_back(value.value_or(0));
    if (value && *value != 0) (has_unit ? with_unit : bare) = &item;
  }
  if (report_.problems.size() > problems_before) return {};
  if (bare && with_unit) {
    problem(*bare, path,
            what_stands(*bare) + " has no unit and " + what_stands(*with_unit) +
                " has one: every component but 0 has a unit, or none has");
    return {};
  }
  return values;
}

void Reader::list(const Key& key, std::vector<Real>& value, const Quantity& quantity, int size,
                  bool allow_free) {
  const Node* node = find(key);
  if (!node) return;
  auto read = list_values(*node, path_of(key.name), quantity, size, allow_free);
  if (read) value = std::move(*read);
}

void Reader::list(const Key& key, std::optional<std::vector<Real>>& value, const Quantity& quantity,
                  int size, bool allow_free) {
  const Node* node = find(key);
  if (!node) return;
  auto read = list_values(*node, path_of(key.name), quantity, size, allow_free);
  if (read) value = std::move(*read);
}

void Reader::direction(const Key& key, std::vector<Real>& value) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  if (node->is_scalar()) {
    const std::size_t axis =
        node->text.size() == 1 ? std::string("xyz").find(node->text) : std::string::npos;
    if (axis == std::string::npos) {
      problem(*node, path, "expects x, y, z or a vector, got " + what_stands(*node));
      return;
    }
    value.assign(axis == 2 ? 3 : slot_of(dimensions()), 0);
    value[axis] = 1;
    return;
  }
  const bool out_of_plane = dimensions() == 2 && node->is_list() && node->items.size() == 3;
  const auto read = list_values(*node, path, {"1"}, out_of_plane ? 3 : kVector);
  if (!read) return;
  Real largest = 0, sum = 0;
  for (const Real component : *read) largest = std::max(largest, std::abs(component));
  for (const Real component : *read) sum += (component / largest) * (component / largest);
  if (largest == 0) {
    problem(*node, path, "a direction has a length above 0");
    return;
  }
  value = *read;
  const Real length = std::sqrt(sum);
  // A unit vector is kept as it stands, so that an echoed deck reads back to the same bits.
  constexpr Real kRoundOff = 4e-16;
  if (std::abs(length * largest - 1) <= kRoundOff) return;
  for (Real& component : value) component = component / largest / length;
}

void Reader::per_axis(const Key& key, std::optional<std::vector<Real>>& value,
                      const Quantity& quantity) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  if (node->is_scalar()) {
    if (const auto read = quantity_value(*node, path, quantity)) {
      value.emplace(slot_of(dimensions()), *read);
    }
  } else if (auto read = list_values(*node, path, quantity, kVector)) {
    value = std::move(*read);
  }
}

void Reader::points(const Key& key, std::vector<std::vector<Real>>& value,
                    const Quantity& quantity) {
  const Node* given = find(key);
  if (!given) return;
  const std::string path = path_of(key.name);
  const std::optional<Node> node = with_unit_once(*given, path);
  if (!node) return;
  if (!node->is_list() || node->items.size() < 3) {
    problem(*given, path,
            "expects a list of at least 3 points: [[0, 0], [10 mm, 0], [10 mm, 5 mm]], got " +
                what_stands(*given));
    return;
  }
  std::vector<std::vector<Real>> points;
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    auto point = list_values(node->items[i], path + "." + std::to_string(i), quantity, 2);
    if (!point) return;
    points.push_back(std::move(*point));
  }
  value = std::move(points);
}

void Reader::integers(const Key& key, std::optional<std::vector<int>>& value, int size,
                      const Range& range) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  const int wanted = size == kVector ? dimensions() : size;
  if (!node->is_list() || node->items.empty() ||
      (wanted > 0 && static_cast<int>(node->items.size()) != wanted)) {
    problem(*node, path,
            "expects a list of " + (wanted > 0 ? std::to_string(wanted) + " " : "") +
                "whole numbers, got " + what_stands(*node));
    return;
  }
  std::vector<int> numbers;
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const auto number = integer_value(node->items[i], path + "." + std::to_string(i), range);
    if (!number) return;
    numbers.push_back(*number);
  }
  value = std::move(numbers);
}

namespace {
/// States of sliding at which a coefficient is tried: cold and hot, soft and hard, any pressure and
/// speed of bodies that rub. None of their arguments is 0.
std::vector<std::array<Real, 4>> sliding_samples() {
  std::vector<std::array<Real, 4>> samples;
  for (const Real T : {300.0, 100.0, 700.0, 1500.0}) {
    for (const Real yield : {1e8, 1e6, 1e9}) {
      for (const Real p : {1e6, 1e3, 1e9}) {
        for (const Real v : {1.0, 1e-3, 100.0}) samples.push_back({T, yield, p, v});
      }
    }
  }
  return samples;
}

/// What is wrong with an expression that has no value in its range at any of these states.
std::string sliding_problem(const Varying& varying, const Range& range) {
  const auto samples = sliding_samples();
  for (const auto& at : samples) {
    const Real value = varying.evaluate(at);
    if (std::isfinite(value) && value >= range.min && value <= range.max) return "";
  }
  return "is " + shortest_text(varying.evaluate(samples.front())) +
         " at T = 300 K, yield = 100 MPa, p = 1 MPa, v = 1 m/s, and at least " +
         shortest_text(range.min) + " nowhere";
}
}  // namespace

std::optional<Varying> Reader::compiled_value(const Node& node, const std::string& path,
                                              const Quantity& quantity, Varying::Over kind) {
  const bool sliding = kind == Varying::Over::sliding;
  const auto& names = sliding ? kSliding : kTimeAndPlace;
  CompiledExpression compiled = compile_expression(node.text, parameters_, names);
  Varying varying;
  varying.over = kind;
  varying.depends = arguments_in(node.text, names);
  varying.expression = std::move(compiled.text);
  varying.evaluate = std::move(compiled.evaluate);
  std::string wrong = std::move(compiled.problem);
  if (wrong.empty() && sliding) wrong = sliding_problem(varying, quantity.range);
  if (wrong.empty()) return varying;
  problem(node, path, what_stands(node) + ": " + wrong);
  return {};
}

std::optional<Varying> Reader::varying_value(const Node& node, const std::string& path,
                                             const Quantity& quantity,
                                             std::span<const Varying::Over> over) {
  if (node.is_map()) return table_value(node, path, quantity, over);
  for (const auto kind : over) {
    if (kind != Varying::Over::expression && kind != Varying::Over::sliding) continue;
    const auto& names = kind == Varying::Over::sliding ? kSliding : kTimeAndPlace;
    if (node.is_scalar() && is_expression(node.text) && depends_on(node.text, names)) {
      return compiled_value(node, path, quantity, kind);
    }
  }
  Varying varying;
  const auto value = quantity_value(node, path, quantity);
  if (!value) return {};
  varying.constant = *value;
  return varying;
}

void Reader::varying(const Key& key, std::optional<Varying>& value, const Quantity& quantity,
                     std::span<const Varying::Over> over) {
  const Node* node = find(key);
  if (!node) return;
  auto read = varying_value(*node, path_of(key.name), quantity, over);
  if (read) value = std::move(*read);
}

void Reader::components(const Key& key, std::optional<std::vector<std::optional<Varying>>>& value,
                        const Quantity& quantity, std::span<const Varying::Over> over) {
  const Node* given = find(key);
  if (!given) return;
  const std::string path = path_of(key.name);
  const bool unit_once = given->is_map() && given->find("unit") && given->find("value");
  const std::optional<Node> node = unit_once ? with_unit_once(*given, path) : *given;
  if (!node) return;
  if (!node->is_list() || static_cast<int>(node->items.size()) != dimensions()) {
    problem(*given, path,
            "expects a list of " + count_text(dimensions()) + ", each " +
                describe_unit(quantity.unit) + ", a table, an expression or free, got " +
                what_stands(*given));
    return;
  }
  std::vector<std::optional<Varying>> components;
  const Node* bare = nullptr;
  const Node* with_unit = nullptr;
  bool all_read = true;
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const Node& item = node->items[i];
    if (item.is_scalar() && item.text == "free") {
      components.emplace_back();
      continue;
    }
    auto read = varying_value(item, path + "." + std::to_string(i), quantity, over);
    if (!read) {
      all_read = false;
      continue;
    }
    if (item.is_scalar() && !is_expression(item.text) && read->constant != 0) {
      (units_.read(item.text).has_unit ? with_unit : bare) = &item;
    }
    components.push_back(std::move(read));
  }
  if (!all_read) return;
  if (bare && with_unit) {
    problem(*bare, path,
            what_stands(*bare) + " has no unit and " + what_stands(*with_unit) +
                " has one: every component but 0 has a unit, or none has");
    return;
  }
  value = std::move(components);
}

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
