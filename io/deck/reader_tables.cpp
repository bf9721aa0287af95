/// The part of the reader that reads tables and what varies over time.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

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
