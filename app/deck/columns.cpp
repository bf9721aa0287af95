#include "app/deck/columns.hpp"

#include "app/deck/measures.hpp"

namespace brunt::deck {

namespace {

bool is_axis(std::string_view text) { return text == "x" || text == "y" || text == "z"; }

/// True where the end of a column is what a pattern has after NAME: `.force.AXIS`, `.FIELD`.
bool ends_like(std::string_view column, std::string_view ending) {
  if (const auto axis = ending.find("AXIS"); axis != std::string_view::npos) {
    const std::string_view stem = ending.substr(0, axis);
    if (column.empty() || !is_axis(column.substr(column.size() - 1))) return false;
    column.remove_suffix(1);
    ending = stem;
  }
  return column.size() > ending.size() && column.ends_with(ending);
}

/// The field of `probe.NAME.FIELD`.
std::string_view field_of_probe(std::string_view column) {
  const auto dot = column.find('.', std::string_view("probe.").size());
  return dot == std::string_view::npos ? "" : column.substr(dot + 1);
}

bool is_of_pattern(std::string_view column, std::string_view pattern) {
  const auto name = pattern.find("NAME");
  if (name == std::string_view::npos) {
    const auto axis = pattern.find("AXIS");
    if (axis == std::string_view::npos) return column == pattern;
    return column.starts_with(pattern.substr(0, axis)) && is_axis(column.substr(axis));
  }
  if (!column.starts_with(pattern.substr(0, name))) return false;
  if (pattern.ends_with("FIELD")) {
    return unit_of_field(std::string(field_of_probe(column))) != nullptr;
  }
  return ends_like(column.substr(name), pattern.substr(name + std::string_view("NAME").size()));
}

}  // namespace

const ColumnInfo* column_info(std::string_view column) {
  for (const ColumnInfo& info : kHistoryColumns) {
    if (is_of_pattern(column, info.pattern)) return &info;
  }
  return nullptr;
}

const char* unit_of_column(std::string_view column) {
  const ColumnInfo* info = column_info(column);
  if (info == nullptr) return "any";
  if (*info->unit != '\0') return info->unit;
  return unit_of_field(std::string(field_of_probe(column)));
}

}  // namespace brunt::deck
