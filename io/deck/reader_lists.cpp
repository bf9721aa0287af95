/// The part of the reader that reads vectors, tables and expressions over time.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {

/// Adds `unit` behind each bare number below `node`; false where something else stands.
bool add_unit(Node& node, const std::string& unit) {
  if (node.is_list()) {
    return std::all_of(node.items.begin(), node.items.end(),
                       [&](Node& item) { return add_unit(item, unit); });
  }
  if (!node.is_scalar() || !whole_number(node.text)) return false;
  node.text += " " + unit;
  return true;
}

std::string count_text(int size) {
  return size == 1 ? "1 component" : std::to_string(size) + " components";
}

}  // namespace

const char* over_word(Varying::Over over) {
  switch (over) {
    case Varying::Over::time:
      return "time";
    case Varying::Over::temperature:
      return "temperature";
    case Varying::Over::slip_speed:
      return "slip_speed";
    case Varying::Over::pressure:
      return "pressure";
    case Varying::Over::eps_p:
      return "eps_p";
    default:
      return "";
  }
}

const char* over_unit(Varying::Over over) {
  switch (over) {
    case Varying::Over::time:
      return "s";
    case Varying::Over::temperature:
      return "K";
    case Varying::Over::slip_speed:
      return "m/s";
    case Varying::Over::pressure:
      return "Pa";
    default:
      return "1";
  }
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
    const Node& item = node->items[static_cast<std::size_t>(i)];
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
    value.assign(axis == 2 ? 3 : static_cast<std::size_t>(dimensions()), 0);
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
      value.emplace(static_cast<std::size_t>(dimensions()), *read);
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

std::optional<Node> Reader::table_rows(const Node& node, const std::string& path) {
  if (const Node* table = node.find("table")) {
    if (table->is_list() && !table->items.empty()) return *table;
    problem(*table, path,
            "expects a list of pairs: [[0 s, 1 kN], [1 ms, 0]], got " + what_stands(*table));
    return {};
  }
  const Node& name = *node.find("file");
  if (!name.is_scalar() || name.text.empty()) {
    problem(name, path, "expects a file of two columns, got " + what_stands(name));
    return {};
  }
  const auto file = std::filesystem::path(name.place.file).parent_path() / name.text;
  std::error_code error;
  std::ifstream stream(file);
  if (!std::filesystem::is_regular_file(file, error) || !stream) {
    problem(name, path, "cannot read the file '" + file.string() + "'");
    return {};
  }
  Node rows = list_node();
  rows.place = name.place;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.find_first_not_of(" ") == std::string::npos || line[0] == '#') continue;
    std::replace(line.begin(), line.end(), ';', ',');
    std::istringstream columns(line);
    Node row = list_node();
    row.place = {file.string(), number, 1};
    for (std::string column; std::getline(columns, column, ',');) {
      const std::size_t from = column.find_first_not_of(' ');
      const std::size_t to = column.find_last_not_of(' ');
      row.items.push_back(
          scalar_node(from == std::string::npos ? "" : column.substr(from, to - from + 1)));
      row.items.back().place = row.place;
    }
    const bool header = rows.items.empty() && number == 1 && row.items.size() == 2 &&
                        leading_number(row.items[0].text).length == 0;
    if (!header) rows.items.push_back(std::move(row));
  }
  if (rows.items.empty()) {
    problem(name, path, "the file '" + file.string() + "' has no rows");
    return {};
  }
  return rows;
}

std::optional<Varying> Reader::table_value(const Node& node, const std::string& path,
                                           const Quantity& quantity,
                                           std::span<const Varying::Over> over) {
  std::vector<std::string> overs, keys{"table", "file", "over", "unit"};
  std::string over_list;
  for (const Varying::Over candidate : over) {
    if (*over_word(candidate) == '\0') continue;
    overs.emplace_back(over_word(candidate));
    over_list += (over_list.empty() ? "" : " | ") + overs.back();
  }
  for (const Entry& entry : node.entries) {
    if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
    problem_at(entry.place, path, "unknown key '" + entry.key + "'" + suggestion(entry.key, keys));
    return {};
  }
  const Node* over_node = node.find("over");
  if ((node.find("table") != nullptr) == (node.find("file") != nullptr) || !over_node) {
    problem(node, path,
            "expects a value, or {table: [[...], ...], over: " + over_list +
                "}, or {file: curve.csv, over: " + over_list + ", unit: [.., ..]}");
    return {};
  }
  const auto found = std::find_if(over.begin(), over.end(), [&](Varying::Over candidate) {
    return over_node->is_scalar() && over_node->text == over_word(candidate);
  });
  if (found == over.end() || over_node->text.empty()) {
    problem(*over_node, path + ".over",
            "expects one of " + over_list + ", got " + what_stands(*over_node));
    return {};
  }
  std::optional<Node> rows = table_rows(node, path);
  if (!rows) return {};
  const Node* unit = node.find("unit");
  if (unit && (!unit->is_list() || unit->items.size() != 2 || !unit->items[0].is_scalar() ||
               !unit->items[1].is_scalar())) {
    problem(*unit, path + ".unit",
            "expects the units of both columns: [ms, kN], got " + what_stands(*unit));
    return {};
  }
  Varying varying;
  varying.over = *found;
  for (std::size_t i = 0; i < rows->items.size(); ++i) {
    Node& row = rows->items[i];
    const std::string row_path = path + ".table." + std::to_string(i);
    if (!row.is_list() || row.items.size() != 2) {
      problem(row, row_path, "expects a pair, got " + what_stands(row));
      return {};
    }
    for (const std::size_t column : {0, 1}) {
      if (unit && !add_unit(row.items[column], unit->items[column].text)) {
        problem(row.items[column], row_path,
                "expects a number without unit, got " + what_stands(row.items[column]));
        return {};
      }
    }
    const auto s = quantity_value(row.items[0], row_path, {over_unit(*found)});
    const auto v = quantity_value(row.items[1], row_path, quantity);
    if (!s || !v) return {};
    if (!varying.abscissa.empty() && !(*s > varying.abscissa.back())) {
      problem(row, row_path, "the first column of a table rises from row to row");
      return {};
    }
    varying.abscissa.push_back(*s);
    varying.ordinate.push_back(*v);
  }
  return varying;
}

std::optional<Varying> Reader::varying_value(const Node& node, const std::string& path,
                                             const Quantity& quantity,
                                             std::span<const Varying::Over> over) {
  if (node.is_map()) return table_value(node, path, quantity, over);
  Varying varying;
  const bool expressions =
      std::find(over.begin(), over.end(), Varying::Over::expression) != over.end();
  if (expressions && node.is_scalar() && is_expression(node.text) &&
      depends_on_place_or_time(node.text)) {
    CompiledExpression compiled = compile_expression(node.text, parameters_);
    if (!compiled.problem.empty()) {
      problem(node, path, what_stands(node) + ": " + compiled.problem);
      return {};
    }
    varying.over = Varying::Over::expression;
    varying.expression = std::move(compiled.text);
    varying.evaluate = std::move(compiled.evaluate);
    return varying;
  }
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
  for (std::size_t i = 0; i < node->items.size(); ++i) {
    const Node& item = node->items[i];
    if (item.is_scalar() && item.text == "free") {
      components.emplace_back();
      continue;
    }
    auto read = varying_value(item, path + "." + std::to_string(i), quantity, over);
    if (!read) return;
    if (item.is_scalar() && !is_expression(item.text) && read->constant != 0) {
      (units_.read(item.text).has_unit ? with_unit : bare) = &item;
    }
    components.push_back(std::move(read));
  }
  if (bare && with_unit) {
    problem(*bare, path,
            what_stands(*bare) + " has no unit and " + what_stands(*with_unit) +
                " has one: every component but 0 has a unit, or none has");
    return;
  }
  value = std::move(components);
}

}  // namespace brunt
