#include "io/history.hpp"

#include <stdexcept>
#include <string_view>
#include <utility>

#include "core/errors.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {

std::string header(const std::vector<std::string>& columns) {
  std::string line;
  for (const auto& column : columns) {
    if (!line.empty()) line += ',';
    line += column;
  }
  return line + "\n";
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto comma = line.find(',');
    parts.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    line.remove_prefix(comma + 1);
  }
}

/// Takes the next whole line, without its newline, off the front of text; false at the end.
bool take_line(std::string_view& text, std::string_view& line) {
  const auto end = text.find('\n');
  if (end == std::string_view::npos) return false;
  line = text.substr(0, end);
  text.remove_prefix(end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return true;
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what) {
  throw MachineError("cannot use '" + path.string() + "': " + what);
}

}  // namespace

HistoryWriter::HistoryWriter(const std::filesystem::path& path, std::vector<std::string> columns)
    : columns_(std::move(columns)), file_((write_file_atomically(path, header(columns_)), path)) {}

HistoryWriter::HistoryWriter(Resumed, const std::filesystem::path& path,
                             std::vector<std::string> columns)
    : columns_(std::move(columns)), file_(path) {}

HistoryWriter HistoryWriter::resume(const std::filesystem::path& path,
                                    std::vector<std::string> columns, Real until) {
  const std::string old = read_file(path);
  std::string kept = header(columns);
  if (!old.starts_with(kept)) fail(path, "its columns are not those of this deck");
  std::string_view rest(old);
  rest.remove_prefix(kept.size());
  for (std::string_view line; take_line(rest, line);) {
    const auto time = parse_real(line.substr(0, line.find(',')));
    if (!time) fail(path, "the time '" + std::string(line.substr(0, 32)) + "' is not a number");
    if (*time > until) break;
    kept.append(line).push_back('\n');
  }
  write_file_atomically(path, kept);
  return HistoryWriter(Resumed{}, path, std::move(columns));
}

void HistoryWriter::write_row(std::span<const HistoryValue> values) {
  if (values.size() != columns_.size()) {
    throw std::invalid_argument("history row of " + std::to_string(values.size()) + " values for " +
                                std::to_string(columns_.size()) + " columns");
  }
  std::string line;
  for (const auto& value : values) {
    if (!line.empty()) line += ',';
    if (const Real* real = std::get_if<Real>(&value)) {
      append_shortest(line, *real);
    } else if (const std::int64_t* whole = std::get_if<std::int64_t>(&value)) {
      line += std::to_string(*whole);
    } else {
      line += std::to_string(std::get<std::uint64_t>(value));
    }
  }
  line += '\n';
  file_.append(line);
}

int History::index(const std::string& column) const {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i] == column) return static_cast<int>(i);
  }
  return -1;
}

History read_history(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  std::string_view rest(text);
  std::string_view line;
  History history;
  if (!take_line(rest, line)) fail(path, "it has no line of column names");
  for (const auto name : split(line)) history.columns.emplace_back(name);
  for (std::size_t number = 2; take_line(rest, line); ++number) {
    std::vector<Real> row;
    for (const auto part : split(line)) {
      const auto value = parse_real(part);
      if (!value) {
        fail(path,
             "line " + std::to_string(number) + ": '" + std::string(part) + "' is not a number");
      }
      row.push_back(*value);
    }
    if (row.size() != history.columns.size()) {
      fail(path, "line " + std::to_string(number) + " has " + std::to_string(row.size()) +
                     " values for " + std::to_string(history.columns.size()) + " columns");
    }
    history.rows.push_back(std::move(row));
  }
  return history;
}

}  // namespace brunt
