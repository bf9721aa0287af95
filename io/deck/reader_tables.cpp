/// The part of the reader that reads tables, inline and from files.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

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

namespace {

/// Read, all of a deck take 580 MB and 1.5 s where their rows are as short as can be.
constexpr std::uintmax_t kMostTableBytes = std::uintmax_t{4} << 20;

/// One row of a file of columns; a blank line and a comment have none.
Node csv_row(std::string line, const SourcePlace& place) {
  Node row = list_node();
  row.place = place;
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (line.find_first_not_of(' ') == std::string::npos || line[0] == '#') return row;
  std::replace(line.begin(), line.end(), ';', ',');
  std::istringstream columns(line);
  for (std::string column; std::getline(columns, column, ',');) {
    const std::size_t from = column.find_first_not_of(' ');
    const std::size_t to = column.find_last_not_of(' ');
    row.items.push_back(
        scalar_node(from == std::string::npos ? "" : column.substr(from, to - from + 1)));
    row.items.back().place = place;
  }
  return row;
}

}  // namespace

void Reader::visit_varying_or_law(const Key& key, std::optional<Varying>& value,
                                  const Quantity& quantity, std::span<const Varying::Over> over,
                                  std::function<bool()>, std::function<void(bool)> choose,
                                  Members members) {
  const Node* node = find(key);
  if (!node) return;
  const std::string path = path_of(key.name);
  const bool is_law =
      node->is_map() && !node->find("table") && !node->find("file") && !node->find("over");
  choose(is_law);
  if (is_law) {
    read_members(*node, path, members);
  } else if (auto read = varying_value(*node, path, quantity, over)) {
    value = std::move(*read);
  }
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
  // A pipe would be opened for ever.
  const bool is_file = std::filesystem::is_regular_file(file, error);
  if (is_file) table_bytes_ += std::filesystem::file_size(file, error);
  if (!error && table_bytes_ > kMostTableBytes) {
    problem(name, path,
            "the files of tables are larger than 4 MiB together, some 100,000 rows: write fewer "
            "rows, what is between them is interpolated");
    return {};
  }
  std::ifstream stream;
  if (is_file && !error) stream.open(file);
  if (!stream.is_open()) {
    problem(name, path, "cannot read the file '" + file.string() + "'");
    return {};
  }
  Node rows = list_node();
  rows.place = name.place;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    Node row = csv_row(line, {file.string(), number, 1});
    const bool header =
        number == 1 && row.items.size() == 2 && leading_number(row.items[0].text).length == 0;
    if (!row.items.empty() && !header) rows.items.push_back(std::move(row));
  }
  if (rows.items.empty()) {
    problem(name, path, "the file '" + file.string() + "' has no rows");
    return {};
  }
  return rows;
}

std::optional<Varying::Over> Reader::table_over(const Node& node, const std::string& path,
                                                std::span<const Varying::Over> over) {
  static const std::vector<std::string> kKeys{"table", "file", "over", "unit"};
  std::string list;
  for (const Varying::Over candidate : over) {
    const std::string word = over_word(candidate);
    if (!word.empty()) list += (list.empty() ? "" : " | ") + word;
  }
  if (list.empty()) {
    problem(node, path, "expects a value, or an expression: \"= ...\"; no table has a place here");
    return {};
  }
  for (const Entry& entry : node.entries) {
    if (std::find(kKeys.begin(), kKeys.end(), entry.key) != kKeys.end()) continue;
    problem_at(entry.place, path, "unknown key '" + entry.key + "'" + suggestion(entry.key, kKeys));
    return {};
  }
  const Node* over_node = node.find("over");
  if ((node.find("table") != nullptr) == (node.find("file") != nullptr) || !over_node) {
    problem(node, path,
            "expects a value, or {table: [[...], ...], over: " + list +
                "}, or {file: curve.csv, over: " + list + ", unit: [.., ..]}");
    return {};
  }
  const auto found = std::find_if(over.begin(), over.end(), [&](Varying::Over candidate) {
    return over_node->is_scalar() && over_node->text == over_word(candidate);
  });
  if (found == over.end() || over_node->text.empty()) {
    problem(*over_node, path + ".over",
            "expects one of " + list + ", got " + what_stands(*over_node));
    return {};
  }
  return *found;
}

std::optional<Varying> Reader::table_value(const Node& node, const std::string& path,
                                           const Quantity& quantity,
                                           std::span<const Varying::Over> over) {
  const auto chosen = table_over(node, path, over);
  if (!chosen) return {};
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
  varying.over = *chosen;
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
    const auto s = quantity_value(row.items[0], row_path, {over_unit(*chosen)});
    const auto v = quantity_value(row.items[1], row_path, quantity);
    if (!s || !v) return {};
    if (!varying.abscissa.empty() && !(*s > varying.abscissa.back())) {
      problem(row, row_path, "the first column of a table rises from row to row");
      return {};
    }
    varying.abscissa.push_back(*s);
    varying.ordinate.push_back(*v);
  }
  if (varying.abscissa.size() < 2) {
    problem(*rows, path, "a table has at least two rows; a constant is written as it is");
    return {};
  }
  return varying;
}

}  // namespace brunt
// Tested by tests/unit/app/deck_test.cpp.
