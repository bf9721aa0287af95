#include "io/mesh/ls_dyna.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "io/mesh/card.hpp"
#include "io/mesh/ls_dyna_keyword.hpp"

namespace brunt {

namespace {
/// A set as it is written: ids, and ranges of them.
struct DynaSet {
  enum class Of { nodes, solids, shells, parts };
  std::string name;
  Of of = Of::nodes;
  std::vector<std::int64_t> ids;
  std::vector<std::array<std::int64_t, 2>> ranges;
};

/// The kind of a solid by the corners that it repeats, and those that are its own.
CellKind solid_kind(std::array<std::int64_t, 8>& n) {
  const auto same = [&](std::size_t a, std::size_t b) { return n[a] == n[b]; };
  if (same(4, 5) && same(5, 6) && same(6, 7)) {
    if (same(3, 4)) return CellKind::tet4;
    return CellKind::pyramid5;
  }
  if (same(4, 5) && same(6, 7)) return CellKind::wedge6;
  return CellKind::hex8;
}

class DynaReader {
 public:
  explicit DynaReader(const std::string& path) : text_(path) { mesh_.path = path; }

  MeshFile read() {
    while (text_.left() > 0 && !ended_) {
      const std::string_view line = text_.next_line();
      if (line.empty() || line[0] == '$' || trimmed(line).empty()) {
        // Blank lines count where a title stands, or numbers that are 0, and nowhere else.
        if (line.empty() && (wants_title() || lines_to_skip_ > 0)) read_data(line);
        continue;
      }
      if (line[0] == '*') {
        open(line);
      } else {
        read_data(line);
      }
    }
    finish_element();
    if (mesh_.nodes.empty()) text_.wrong("the file has no *NODE");
    if (mesh_.n_cells() == 0) text_.wrong("the file has no *ELEMENT_SOLID, _SHELL or _BEAM");
    mesh_.resolve_corners();
    name_parts();
    resolve_sets();
    return std::move(mesh_);
  }

 private:
  enum class Data { none, comment, node, solid, shell, beam, part, set, segment };

  void open(std::string_view line) {
    finish_element();
    data_ = Data::none, row_ = 0, lines_to_skip_ = 0;
    const DynaKeyword opened = dyna_keyword(line, columns_of_file_);
    const std::string& keyword = opened.name;
    columns_ = opened.columns;
    if (keyword.starts_with("*END")) ended_ = keyword == "*END";
    if (keyword.starts_with("*KEYWORD")) columns_of_file_ = columns_of_file(line);
    if (const char* instead = instead_of_dyna(keyword)) {
      text_.wrong(keyword + " is not read: " + instead);
    }
    if (keyword == "*NODE") {
      data_ = Data::node;
    } else if (keyword == "*ELEMENT_SOLID") {
      data_ = Data::solid;
    } else if (keyword.starts_with("*ELEMENT_SHELL")) {
      data_ = Data::shell;
      find_shell_lines(keyword, shell_lines_);
    } else if (keyword == "*ELEMENT_BEAM") {
      data_ = Data::beam;
    } else if (keyword.starts_with("*ELEMENT_")) {
      if (passed_over_.insert(keyword).second) {
        mesh_.notes.push_back(keyword + " (" + mesh_.place(text_.line()) +
                              ") is passed over: it has no solids");
      }
    } else if (keyword == "*COMMENT") {
      data_ = Data::comment;
    } else if (keyword == "*PART") {
      data_ = Data::part;
    } else if (keyword.starts_with("*SET_")) {
      open_set(keyword.substr(5));
    }
  }

  /// rest  NODE_LIST_TITLE, SOLID_GENERATE, SEGMENT, ...
  void open_set(std::string rest) {
    const std::string written = rest;
    const auto take_end = [&](std::string_view end) {
      if (rest.size() < end.size() || rest.substr(rest.size() - end.size()) != end) return false;
      rest.resize(rest.size() - end.size());
      return true;
    };
    const bool titled = take_end("_TITLE");
    const bool ranges = take_end("_GENERATE");
    take_end("_LIST");
    using Of = DynaSet::Of;
    static const std::map<std::string, Of> kOf = {{"NODE", Of::nodes},
                                                  {"SOLID", Of::solids},
                                                  {"SHELL", Of::shells},
                                                  {"PART", Of::parts},
                                                  {"SEGMENT", Of::nodes}};
    const auto of = kOf.find(rest);
    if (of == kOf.end()) {
      // Sets of beams, boxes, ... are sets of nothing that a body has.
      const bool is_known = kOf.count(rest.substr(0, rest.find('_'))) > 0;
      if (is_known)
        mesh_.unread_sets.push_back("*SET_" + written + " (" + mesh_.place(text_.line()) + ")");
      return;
    }
    data_ = rest == "SEGMENT" ? Data::segment : Data::set;
    kind_of_set_ = rest;
    row_ = titled ? 0 : 1;
    has_ranges_ = ranges;
    sets_.emplace_back().of = of->second;
  }

  bool wants_title() const {
    return row_ == 0 && (data_ == Data::part || data_ == Data::set || data_ == Data::segment);
  }

  /// Keywords that are not at the head of their line would be passed over with all that they hold.
  void require_no_keyword(std::string_view line) const {
    if (line.front() != ' ' && line.front() != '\t') return;
    const std::string word = upper(trimmed(line));
    if (word.starts_with("*NODE") || word.starts_with("*ELEMENT_")) {
      text_.wrong("a keyword stands in the first column: delete the blanks before " + word);
    }
  }

  void read_data(std::string_view line) {
    if (lines_to_skip_ > 0) {
      --lines_to_skip_;
      return;
    }
    switch (data_) {
      case Data::none:
        return require_no_keyword(line);
      case Data::comment:
        return;
      case Data::node:
        return read_node(line);
      case Data::solid:
        return read_solid(line);
      case Data::shell:
        return read_shell(line);
      case Data::beam:
        return read_beam(line);
      case Data::part:
        return read_part(line);
      case Data::set:
      case Data::segment:
        return read_set(line);
    }
  }

  void read_node(std::string_view line) {
    Card card(text_, line, columns_.hint);
    const std::int64_t id = card.integer(columns_.id, "the number of a node");
    Vec3 x;
    for (int c = 0; c < 3; ++c) x[c] = card.real(columns_.real, "a coordinate");
    mesh_.add_node(id, x, text_.line());
  }

  void finish_element() const {
    if (!element_.empty()) {
      text_.wrong("element " + std::to_string(element_[0]) + " has no line of nodes");
    }
  }

  /// A solid stands in one line, or its number and part in one and its nodes in the next.
  void read_solid(std::string_view line) {
    Card card(text_, line, columns_.hint);
    if (element_.empty()) {
      element_.push_back(card.integer(columns_.id, "the number of an element"));
      element_.push_back(card.integer(columns_.id, "the part of an element"));
      element_line_ = text_.line();
      if (card.at_end()) return;
    }
    std::array<std::int64_t, 8> n{};
    for (std::int64_t& each : n)
      each = card.maybe_integer(columns_.id, "a node of a solid").value_or(0);
    if (n[4] == 0) n[4] = n[5] = n[6] = n[7] = n[3];
    // Nodes 9 and 10 are those of a tetrahedron of second order.
    const bool higher = card.maybe_integer(columns_.id, "a node of a solid").value_or(0) != 0;
    const CellKind kind = higher ? CellKind::higher3 : solid_kind(n);
    if (kind == CellKind::wedge6) n = {n[0], n[1], n[4], n[3], n[2], n[6], 0, 0};
    const auto corners = slot_of(info(kind).corners);
    add_element(kind, {n.data(), corners});
  }

  void read_shell(std::string_view line) {
    Card card(text_, line, columns_.hint);
    element_ = {card.integer(columns_.id, "the number of an element"),
                card.integer(columns_.id, "the part of an element")};
    element_line_ = text_.line();
    std::array<std::int64_t, 4> n{};
    for (std::int64_t& each : n)
      each = card.maybe_integer(columns_.id, "a node of a shell").value_or(0);
    const bool higher = card.maybe_integer(columns_.id, "a node of a shell").value_or(0) != 0;
    const bool triangle = n[3] == 0 || n[3] == n[2];
    const CellKind kind = higher ? CellKind::higher2 : triangle ? CellKind::tri3 : CellKind::quad4;
    add_element(kind, {n.data(), slot_of(info(kind).corners)});
    lines_to_skip_ = shell_lines_.always + (higher ? shell_lines_.higher : 0);
  }

  void read_beam(std::string_view line) {
    Card card(text_, line, columns_.hint);
    element_ = {card.integer(columns_.id, "the number of an element"),
                card.integer(columns_.id, "the part of an element")};
    element_line_ = text_.line();
    const std::array<std::int64_t, 2> n = {card.integer(columns_.id, "a node of a beam"),
                                           card.integer(columns_.id, "a node of a beam")};
    add_element(CellKind::line2, n);
  }

  void add_element(CellKind kind, std::span<const std::int64_t> corners) {
    mesh_.add_cell(kind, element_[0], corners, element_line_);
    part_cells_[element_[1]].push_back(static_cast<int>(mesh_.n_cells()) - 1);
    element_.clear();
  }

  /// A title, and a line that begins with the part's number, by turns.
  void read_part(std::string_view line) {
    if (row_++ % 2 == 0) {
      title_ = trimmed(line);
      return;
    }
    Card card(text_, line, columns_.hint);
    title_of_[card.integer(columns_.wide, "the number of a part")] = title_;
    row_ = 0;
  }

  /// A title where the keyword says so, a line that begins with the set's number, then lines of
  /// eight numbers, or of segments of four.
  void read_set(std::string_view line) {
    DynaSet& set = sets_.back();
    if (row_ == 0) {
      set.name = trimmed(line);
      ++row_;
      return;
    }
    Card card(text_, line, columns_.hint);
    if (row_ == 1) {
      const std::int64_t id = card.integer(columns_.wide, "the number of a set");
      if (set.name.empty()) {
        set.name = "set_" + kind_of_set_ + " " + std::to_string(id);
        for (char& c : set.name) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
      }
      ++row_;
      return;
    }
    const int most = data_ == Data::segment ? 4 : 8;
    for (int i = 0; i < most && !card.at_end(); i += has_ranges_ ? 2 : 1) {
      const std::int64_t id = card.maybe_integer(columns_.wide, "an entry of a set").value_or(0);
      if (has_ranges_) {
        const std::int64_t to = card.maybe_integer(columns_.wide, "the end of a range").value_or(0);
        if (id != 0) set.ranges.push_back({id, to});
      } else if (id != 0) {
        set.ids.push_back(id);
      }
    }
  }

  /// Parts by their titles; of several of one title, by title and number.
  void name_parts() {
    std::map<std::string, int> times;
    for (const auto& [id, title] : title_of_) ++times[title];
    for (auto& [id, cells] : part_cells_) {
      const auto titled = title_of_.find(id);
      std::string name = titled == title_of_.end() ? "" : titled->second;
      if (name.empty() || times[name] > 1) {
        name += (name.empty() ? "part " : " ") + std::to_string(id);
      }
      mesh_.set(name).cells = cells;
    }
  }

  void resolve_sets() {
    const IdTable nodes(mesh_.node_id), cells(mesh_.cell_id);
    for (const DynaSet& set : sets_) {
      if (set.ids.empty() && set.ranges.empty()) continue;
      MeshSet& made = mesh_.set(set.name);
      switch (set.of) {
        case DynaSet::Of::nodes:
          add(set, mesh_.node_id, nodes, 0, made.nodes);
          break;
        case DynaSet::Of::solids:
          add(set, mesh_.cell_id, cells, 3, made.cells);
          break;
        case DynaSet::Of::shells:
          add(set, mesh_.cell_id, cells, 2, made.cells);
          break;
        case DynaSet::Of::parts:
          for (const auto& [id, of_part] : part_cells_) {
            const auto in = [&, number = id](const auto& range) {
              return range[0] <= number && number <= range[1];
            };
            if (std::find(set.ids.begin(), set.ids.end(), id) == set.ids.end() &&
                std::none_of(set.ranges.begin(), set.ranges.end(), in)) {
              continue;
            }
            made.cells.insert(made.cells.end(), of_part.begin(), of_part.end());
          }
      }
    }
  }

  /// Entries that the file has, as indices. Numbers of solids and shells may be the same: dim says
  /// which are meant; 0: nodes.
  void add(const DynaSet& set, const std::vector<std::int64_t>& ids, const IdTable& table, int dim,
           std::vector<int>& list) const {
    const auto fits = [&](std::size_t i) { return dim == 0 || info(mesh_.kind[i]).dim == dim; };
    const bool one_each = table.repeated() < 0;
    std::vector<std::int64_t> wanted = set.ids;
    std::sort(wanted.begin(), wanted.end());
    for (const std::int64_t id : wanted) {
      const int at = one_each ? table[id] : -1;
      if (at >= 0 && fits(slot_of(at))) list.push_back(at);
    }
    if (one_each && set.ranges.empty()) return;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const auto in = [&](const auto& range) { return range[0] <= ids[i] && ids[i] <= range[1]; };
      const bool listed = !one_each && std::binary_search(wanted.begin(), wanted.end(), ids[i]);
      if (!fits(i)) continue;
      if (listed || std::any_of(set.ranges.begin(), set.ranges.end(), in)) {
        list.push_back(static_cast<int>(i));
      }
    }
  }

  MeshText text_;
  MeshFile mesh_;
  Data data_ = Data::none;
  bool ended_ = false, has_ranges_ = false;
  DynaColumns columns_of_file_;
  DynaColumns columns_;                // of the keyword that is read
  ShellLines shell_lines_;             // of the shells that are read
  int lines_to_skip_ = 0;              // that go on with the element read last
  std::set<std::string> passed_over_;  // keywords of elements without solids
  int row_ = 0;                        // of what a keyword holds, its title counted
  std::string kind_of_set_;            // NODE, SOLID, ...
  std::string title_;                  // of the part whose number comes next
  std::vector<std::int64_t> element_;  // number and part of the element whose nodes come next
  int element_line_ = 0;
  std::map<std::int64_t, std::string> title_of_;
  std::map<std::int64_t, std::vector<int>> part_cells_;
  std::vector<DynaSet> sets_;
};
}  // namespace

MeshFile read_ls_dyna(const std::string& path) { return DynaReader(path).read(); }

}  // namespace brunt
