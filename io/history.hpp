#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "core/types.hpp"
#include "io/file.hpp"

namespace brunt {

/// A number of a row: a quantity in SI, or a whole number (step, planes, state_hash).
using HistoryValue = std::variant<Real, std::int64_t, std::uint64_t>;

/// Writes history.csv: a line of column names, then a row an instant. Numbers are the shortest text
/// that reads back as the same double; a crash leaves whole rows.
class HistoryWriter {
 public:
  /// Starts anew: the file holds the line of names and nothing else. Throws MachineError.
  HistoryWriter(const std::filesystem::path& path, std::vector<std::string> columns);

  /// Goes on with an existing file after a restart: keeps the rows up to time `until` [s] (the
  /// first column), drops later ones. Throws MachineError where its columns are not these.
  static HistoryWriter resume(const std::filesystem::path& path, std::vector<std::string> columns,
                              Real until);

  const std::vector<std::string>& columns() const { return columns_; }

  /// Appends a row, one value a column, in the order of columns(). Throws MachineError;
  /// std::invalid_argument where the count is wrong.
  void write_row(std::span<const HistoryValue> values);

  /// Waits until all rows are on the disk. Throws MachineError.
  void flush() { file_.flush(); }

 private:
  struct Resumed {};
  HistoryWriter(Resumed, const std::filesystem::path& path, std::vector<std::string> columns);

  std::vector<std::string> columns_;
  LineFile file_;
};

/// A history in memory.
struct History {
  std::vector<std::string> columns;
  std::vector<std::vector<Real>> rows;  ///< one value a column

  /// Index of a column, or -1.
  int index(const std::string& column) const;
};

/// Reads history.csv; a last line without its newline is left out. state_hash is read as a double
/// and loses bits. Throws MachineError where the file cannot be read or a row is not numbers.
History read_history(const std::filesystem::path& path);

}  // namespace brunt
