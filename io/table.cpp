#include "io/table.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string_view>

#include "core/errors.hpp"
#include "io/file.hpp"
#include "io/number.hpp"

namespace brunt {

namespace {

/// A number or a text of one run, or nothing.
struct Cell {
  enum class Kind { absent, number, text } kind = Kind::absent;
  Real number = 0;
  std::string text;

  Cell() = default;
  Cell(Real value) : kind(Kind::number), number(value) {}
  Cell(std::string value) : kind(Kind::text), text(std::move(value)) {}
};

Cell parameter_cell(const RunSummary& run, std::string_view name) {
  for (const auto& [key, text] : run.parameters) {
    if (key == name) return text;
  }
  return {};
}

const MeasureResult* find_measure(const RunSummary& run, std::string_view name) {
  for (const auto& measure : run.measures) {
    if (measure.name == name) return &measure;
  }
  return nullptr;
}

Cell measure_cell(const RunSummary& run, std::string_view key) {
  if (const auto* measure = find_measure(run, key)) return measure->value;
  const auto dot = key.rfind('.');
  if (dot == std::string_view::npos) return {};
  const auto* measure = find_measure(run, key.substr(0, dot));
  if (measure == nullptr) return {};
  const auto part = key.substr(dot + 1);
  if (part == "value") return measure->value;
  if (part == "unit") return measure->unit;
  if (part == "reference" && measure->reference) return *measure->reference;
  if (part == "error" && measure->error) return *measure->error;
  if (part == "exact" && measure->exact) return *measure->exact;
  if (part == "time" && measure->time) return *measure->time;
  if (part == "bound" && measure->bound) return *measure->bound;
  return {};
}

struct PlainKey {
  std::string_view name;
  Cell (*cell)(const RunSummary&);
};

constexpr PlainKey kPlainKeys[] = {
    {"wall_seconds", [](const RunSummary& r) { return Cell(r.wall_seconds); }},
    {"start_seconds", [](const RunSummary& r) { return Cell(r.start_seconds); }},
    {"cpu_seconds", [](const RunSummary& r) { return Cell(r.cpu_seconds); }},
    {"created", [](const RunSummary& r) { return Cell(r.energy.created); }},
    {"drift", [](const RunSummary& r) { return Cell(r.drift); }},
    {"status", [](const RunSummary& r) { return Cell(status_word(r.status)); }},
    {"reason", [](const RunSummary& r) { return Cell(r.reason); }},
    {"steps", [](const RunSummary& r) { return Cell(static_cast<Real>(r.steps)); }},
    {"points", [](const RunSummary& r) { return Cell(static_cast<Real>(r.points)); }},
    {"elements", [](const RunSummary& r) { return Cell(static_cast<Real>(r.elements)); }},
    {"particles", [](const RunSummary& r) { return Cell(static_cast<Real>(r.particles)); }},
    {"loop_seconds", [](const RunSummary& r) { return Cell(r.loop_seconds); }},
    {"ns_element_step", [](const RunSummary& r) { return Cell(r.ns_element_step); }},
    {"ns_particle_step", [](const RunSummary& r) { return Cell(r.ns_particle_step); }},
    {"peak_memory", [](const RunSummary& r) { return Cell(r.peak_memory); }},
    {"warnings", [](const RunSummary& r) { return Cell(static_cast<Real>(r.warnings.size())); }},
    {"ranks", [](const RunSummary& r) { return Cell(static_cast<Real>(r.ranks)); }},
    {"threads", [](const RunSummary& r) { return Cell(static_cast<Real>(r.threads)); }},
    {"instruction_set", [](const RunSummary& r) { return Cell(r.instruction_set); }},
    {"version", [](const RunSummary& r) { return Cell(r.version); }},
    {"deck_hash", [](const RunSummary& r) { return Cell(r.deck_hash); }},
};

Cell plain_cell(const RunSummary& run, std::string_view key) {
  for (const auto& plain : kPlainKeys) {
    if (plain.name == key) return plain.cell(run);
  }
  if (!key.starts_with("phases.")) return {};
  for (const auto& [name, seconds] : run.phases) {
    if (key.substr(7) == name) return seconds;
  }
  return {};
}

bool is_absent(const Cell& cell) { return cell.kind == Cell::Kind::absent; }

Cell cell_of(const RunSummary& run, std::string_view key) {
  if (key.starts_with("parameters.")) return parameter_cell(run, key.substr(11));
  if (key.starts_with("measures.")) return measure_cell(run, key.substr(9));
  Cell cell = parameter_cell(run, key);
  if (is_absent(cell)) cell = measure_cell(run, key);
  if (is_absent(cell)) cell = plain_cell(run, key);
  return cell;
}

/// The last row of a column of history.csv.
Cell history_cell(const std::string& folder, std::string_view column) {
  const auto path = std::filesystem::path(folder) / "history.csv";
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};
  std::string text = read_file(path);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const auto end = text.find('\n'), last = text.rfind('\n');
  if (end == std::string::npos) return {};
  std::istringstream names(text.substr(0, end)), values(text.substr(last + 1));
  std::string name, value;
  while (std::getline(names, name, ',') && std::getline(values, value, ',')) {
    if (name != column) continue;
    const auto number = parse_real(value);
    return number ? Cell(*number) : Cell(value);
  }
  return {};
}

Cell cell_of(const TableRun& run, const std::string& key) {
  if (!run.summary) return key == "status" ? Cell(run.problem) : Cell();
  constexpr std::string_view kHistory = "history.";
  if (key.starts_with(kHistory)) return history_cell(run.folder, key.substr(kHistory.size()));
  const Cell cell = cell_of(*run.summary, key);
  return is_absent(cell) ? history_cell(run.folder, key) : cell;
}

/// The names of all runs' entries, each once, in the order in which they first appear.
template <class Entries, class Name>
std::vector<std::string> names_of(const std::vector<TableRun>& runs, Entries entries, Name name) {
  std::vector<std::string> names;
  for (const auto& run : runs) {
    if (!run.summary) continue;
    for (const auto& entry : (*run.summary).*entries) {
      if (std::find(names.begin(), names.end(), name(entry)) == names.end()) {
        names.push_back(name(entry));
      }
    }
  }
  return names;
}

std::vector<std::string> parameter_names(const std::vector<TableRun>& runs) {
  return names_of(runs, &RunSummary::parameters, [](const auto& p) { return p.first; });
}

std::vector<std::string> measure_names(const std::vector<TableRun>& runs) {
  return names_of(runs, &RunSummary::measures, [](const auto& m) { return m.name; });
}

bool differs(const std::vector<TableRun>& runs, const std::string& parameter) {
  std::set<std::string> values;
  for (const auto& run : runs) {
    if (run.summary) values.insert(parameter_cell(*run.summary, parameter).text);
  }
  return values.size() > 1;
}

std::vector<std::string> default_keys(const std::vector<TableRun>& runs) {
  std::vector<std::string> keys;
  for (const auto& name : parameter_names(runs)) {
    if (differs(runs, name)) keys.push_back("parameters." + name);
  }
  for (const auto& name : measure_names(runs)) keys.push_back("measures." + name);
  for (const char* name : {"wall_seconds", "drift", "status"}) keys.emplace_back(name);
  return keys;
}

/// Throws DeckError where no run has the key; says nothing where no run has a summary at all.
void require_key(const std::vector<TableRun>& runs, const std::string& key) {
  const auto has = [&key](const TableRun& run) { return !is_absent(cell_of(run, key)); };
  const auto whole = [](const TableRun& run) { return run.summary.has_value(); };
  if (std::none_of(runs.begin(), runs.end(), whole)) return;
  if (std::any_of(runs.begin(), runs.end(), has)) return;
  std::string message = "no run has this key; there are:";
  for (const auto& name : parameter_names(runs)) message.append(" ").append(name);
  for (const auto& name : measure_names(runs)) message.append(" ").append(name);
  for (const auto& plain : kPlainKeys) message.append(" ").append(plain.name);
  message += ", and the columns of history.csv";
  std::vector<DeckProblem> problems(1);
  problems[0].place.file = "--show";
  problems[0].path = key;
  problems[0].message = message;
  throw DeckError(std::move(problems));
}

std::string title_of(const std::vector<TableRun>& runs, const std::string& key) {
  for (const std::string prefix : {"parameters.", "measures."}) {
    if (key.starts_with(prefix)) return title_of(runs, key.substr(prefix.size()));
  }
  for (const auto& run : runs) {
    if (!run.summary) continue;
    const auto* measure = find_measure(*run.summary, key);
    if (measure != nullptr && !measure->unit.empty()) return key + " [" + measure->unit + "]";
  }
  if (key == "wall_seconds" || key == "start_seconds" || key == "loop_seconds" ||
      key == "cpu_seconds" || key.starts_with("phases."))
    return key + " [s]";
  if (key == "ns_element_step" || key == "ns_particle_step") return key + " [ns]";
  if (key == "peak_memory") return key + " [byte]";
  return key;
}

std::string text_of(const Cell& cell, bool csv) {
  if (cell.kind == Cell::Kind::absent) return csv ? "" : "-";
  if (cell.kind == Cell::Kind::text) return cell.text;
  const bool whole = cell.number == std::trunc(cell.number) && std::fabs(cell.number) < 1e12;
  return csv || whole ? shortest(cell.number) : rounded(cell.number, 6);
}

/// A field of a CSV line, quoted where it must be (RFC 4180).
std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

/// Columns as the terminal shows them: UTF-8 continuation bytes take no room.
std::size_t width_of(const std::string& text) {
  return slot_of(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  }));
}

using Grid = std::vector<std::vector<std::string>>;

std::string csv_text(const Grid& grid) {
  std::string out;
  for (const auto& row : grid) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (c > 0) out += ',';
      out += quoted(row[c]);
    }
    out += '\n';
  }
  return out;
}

/// First column and texts to the left, numbers to the right.
std::string aligned_text(const Grid& grid, const std::vector<bool>& numeric) {
  std::vector<std::size_t> width(numeric.size(), 0);
  for (const auto& row : grid) {
    for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], width_of(row[c]));
  }
  std::string out;
  for (const auto& row : grid) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string room(width[c] - width_of(row[c]), ' ');
      if (c > 0) line += "  ";
      line += numeric[c] ? room + row[c] : row[c] + room;
    }
    out += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return out;
}

}  // namespace

std::vector<TableRun> read_runs(const std::vector<std::filesystem::path>& folders) {
  std::vector<TableRun> runs;
  for (const auto& folder : folders) {
    TableRun run;
    run.folder = folder.string();
    while (run.folder.size() > 1 && run.folder.back() == '/') run.folder.pop_back();
    std::error_code error;
    if (!std::filesystem::exists(folder / "summary.json", error)) {
      run.problem = std::filesystem::exists(folder, error) ? "no summary" : "no folder";
    } else {
      try {
        run.summary = read_summary(folder);
      } catch (const MachineError&) {
        run.problem = "broken summary";
      }
    }
    runs.push_back(std::move(run));
  }
  return runs;
}

std::string format_table(const std::vector<TableRun>& runs, const TableOptions& options) {
  std::vector<std::string> keys = options.show;
  for (const auto& key : keys) require_key(runs, key);
  if (keys.empty()) keys = default_keys(runs);

  Grid grid(1, {"run"});
  std::vector<bool> numeric(keys.size() + 1, false);
  for (const auto& key : keys) grid[0].push_back(title_of(runs, key));
  for (const auto& run : runs) {
    std::vector<std::string> row{run.folder};
    for (std::size_t k = 0; k < keys.size(); ++k) {
      const Cell cell = cell_of(run, keys[k]);
      if (cell.kind == Cell::Kind::number) numeric[k + 1] = true;
      row.push_back(text_of(cell, options.csv));
    }
    grid.push_back(std::move(row));
  }
  return options.csv ? csv_text(grid) : aligned_text(grid, numeric);
}

}  // namespace brunt
