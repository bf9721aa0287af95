#include "io/deck/column_expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <stdexcept>

#include "io/deck/expression.hpp"
#include "io/deck/parser.hpp"

namespace brunt {

namespace {
bool begins_name(const std::string& text, std::size_t at) {
  const auto is_letter = [](char c) {
    return c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
  };
  const bool inside = at > 0 && (is_name_character(text[at - 1]) || text[at - 1] == '.');
  return is_letter(text[at]) && !inside;
}

std::size_t end_of_name(const std::string& text, std::size_t at) {
  while (at < text.size() && (is_name_character(text[at]) || text[at] == '.')) ++at;
  return at;
}

/// The longest name that stands at a place, or npos.
std::size_t column_at(const std::string& text, std::size_t at,
                      const std::vector<std::string>& columns) {
  std::size_t found = std::string::npos, longest = 0;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const auto& name = columns[c];
    const bool stands = name.size() > longest && text.compare(at, name.size(), name) == 0 &&
                        end_of_name(text, at + name.size()) == at + name.size();
    if (stands) found = c, longest = name.size();
  }
  return found;
}

/// visit(first, last, column) of each name in a text: npos for what is no column.
template <class Visit>
void visit_names(const std::string& text, const std::vector<std::string>& columns,
                 const Visit& visit) {
  for (std::size_t i = 0; i < text.size();) {
    if (!begins_name(text, i)) {
      ++i;
      continue;
    }
    const std::size_t column = column_at(text, i, columns);
    const std::size_t end =
        column == std::string::npos ? end_of_name(text, i) : i + columns[column].size();
    visit(i, end, column);
    i = end;
  }
}
}  // namespace

std::vector<std::string> unknown_columns_in(const std::string& text,
                                            const std::vector<std::string>& columns) {
  std::vector<std::string> unknown;
  visit_names(text, columns, [&](std::size_t first, std::size_t last, std::size_t column) {
    const std::string name = text.substr(first, last - first);
    if (column == std::string::npos && name.find('.') != std::string::npos) unknown.push_back(name);
  });
  return unknown;
}

struct ColumnExpression::Parsed {
  mu::Parser parser;
  std::vector<std::size_t> columns;
  std::vector<mu::value_type> values;  // of these columns; the parser reads them here
};

ColumnExpression::ColumnExpression(const std::string& text, const std::vector<std::string>& columns)
    : parsed_(std::make_unique<Parsed>()) {
  auto& used = parsed_->columns;
  std::string body;
  std::size_t done = text.find('=') + 1;
  visit_names(text, columns, [&](std::size_t first, std::size_t last, std::size_t column) {
    if (column == std::string::npos) return;
    const auto at = std::find(used.begin(), used.end(), column);
    const auto place = slot_of(at - used.begin());
    if (at == used.end()) used.push_back(column);
    body += text.substr(done, first - done) + "column_" + std::to_string(place);
    done = last;
  });
  body += text.substr(done);
  parsed_->values.resize(used.size());
  const std::string problem = form_problem(body);
  if (!problem.empty()) throw std::invalid_argument(problem);
  prepare(parsed_->parser);
  try {
    for (std::size_t i = 0; i < used.size(); ++i) {
      parsed_->parser.DefineVar("column_" + std::to_string(i), &parsed_->values[i]);
    }
    parsed_->parser.SetExpr(body);
    one_value_of(parsed_->parser);
  } catch (const mu::ParserError& error) {
    throw std::invalid_argument(
        parser_problem(error, " of history columns, which are in SI, and parameters"));
  }
}

ColumnExpression::~ColumnExpression() = default;
ColumnExpression::ColumnExpression(ColumnExpression&&) noexcept = default;
ColumnExpression& ColumnExpression::operator=(ColumnExpression&&) noexcept = default;

Real ColumnExpression::operator()(std::span<const Real> row) const {
  for (std::size_t i = 0; i < parsed_->columns.size(); ++i) {
    parsed_->values[i] = row[parsed_->columns[i]];
  }
  return one_value_of(parsed_->parser);
}

}  // namespace brunt
// Tested by tests/unit/io/expression_test.cpp.
