// Where two checkpoints differ first: table, body, entity and column; for a test that says that two
// runs are not the same.
//   state_difference A B                      manifests or folders; status 0: the same, 1: not
//   state_difference --tables A               names of its tables
//   state_difference --change A OUT TABLE ID COLUMN   writes A with the last bit of a value changed
#include <algorithm>
#include <bit>
#include <cstdio>
#include <map>
#include <optional>

#include "app/setup/scene_builder.hpp"
#include "fe/finite_elements.hpp"
#include "io/checkpoint.hpp"

namespace brunt {
namespace {

namespace fs = std::filesystem;

struct Row {
  const StateTable* table = nullptr;
  std::size_t place = 0;
  Real value(int column) const {
    return table
        ->value[place * static_cast<std::size_t>(table->width) + static_cast<std::size_t>(column)];
  }
};
/// Rows of all ranks, by name of the table and id.
using Rows = std::map<std::string, std::map<GlobalId, Row>>;

Rows rows_of(const Checkpoint& checkpoint) {
  Rows rows;
  for (const auto& table : checkpoint.content.tables) {
    for (std::size_t k = 0; k < table.id.size(); ++k) rows[table.name][table.id[k]] = {&table, k};
  }
  return rows;
}

fs::path manifest_in(const fs::path& path) {
  if (!fs::is_directory(path)) return path;
  const auto all = checkpoints_in(path);
  if (all.empty()) throw MachineError("there is no checkpoint in " + path.string());
  return all.front();
}

/// Names of the bodies of points and of elements, by their ids, from the deck in the checkpoint.
struct Bodies {
  std::map<GlobalId, std::string> of_point, of_element;
};

template <int Dim>
Bodies bodies_of(const LoadedDeck& loaded) {
  Bodies bodies;
  const auto scene = build_scene<Dim>(loaded);
  for (const auto& solid : scene->solids) {
    const auto& points = solid->points();
    for (std::size_t i = 0; i < points.id.size(); ++i) {
      bodies.of_point[points.id[i]] = scene->body_names[points.body[i]];
    }
    const auto* elements = dynamic_cast<const FiniteElements<Dim>*>(solid.get());
    if (elements == nullptr) continue;
    for (const auto& block : elements->blocks()) {
      for (LocalIndex e = 0; e < block.n; ++e) {
        bodies.of_element[block.id[e]] = scene->body_names[block.body[e]];
      }
    }
  }
  return bodies;
}

std::string body_of(const Checkpoint& checkpoint, const std::string& table, GlobalId id) {
  const auto loaded = load_deck_text(checkpoint.content.texts.at("deck"), "deck", {});
  const auto bodies =
      loaded.deck.geometry == Geometry::three_d ? bodies_of<3>(loaded) : bodies_of<2>(loaded);
  const auto& names = table.starts_with("element") ? bodies.of_element : bodies.of_point;
  const auto found = names.find(id);
  return found == names.end() ? "" : ", body " + found->second;
}

/// The first column in which two rows differ in a bit; their width where it does.
std::optional<int> column_that_differs(const Row& a, const Row& b) {
  const int both = std::min(a.table->width, b.table->width);
  for (int c = 0; c < both; ++c) {
    if (std::bit_cast<std::uint64_t>(a.value(c)) != std::bit_cast<std::uint64_t>(b.value(c))) {
      return c;
    }
  }
  return a.table->width == b.table->width ? std::nullopt : std::optional(both);
}

/// Motion first, then what else there is: what the points did shows in all other tables.
std::vector<std::string> names_in_order(const Rows& a, const Rows& b) {
  std::vector<std::string> names = {"points"};
  for (const auto* rows : {&a, &b}) {
    for (const auto& [name, table] : *rows) {
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

int compare(const fs::path& of_a, const fs::path& of_b) {
  const Checkpoint a = read_checkpoint(manifest_in(of_a)), b = read_checkpoint(manifest_in(of_b));
  if (a.header.step != b.header.step) throw MachineError("the checkpoints are of different steps");
  const Rows rows_a = rows_of(a), rows_b = rows_of(b);
  const auto step = static_cast<unsigned long long>(a.header.step);
  for (const auto& name : names_in_order(rows_a, rows_b)) {
    static const std::map<GlobalId, Row> none;
    const auto find = [&](const Rows& rows) -> const std::map<GlobalId, Row>& {
      const auto found = rows.find(name);
      return found == rows.end() ? none : found->second;
    };
    const auto &in_a = find(rows_a), &in_b = find(rows_b);
    std::size_t count = 0;
    std::string first;
    const auto note = [&](GlobalId id, const std::string& what) {
      if (count++ == 0) first = "id " + std::to_string(id) + body_of(a, name, id) + what;
    };
    for (const auto& [id, row] : in_a) {
      const auto other = in_b.find(id);
      if (other == in_b.end()) {
        note(id, ": only in the first");
      } else if (const auto c = column_that_differs(row, other->second)) {
        char text[96];
        std::snprintf(text, sizeof(text), ", column %d: %.17g and %.17g", *c, row.value(*c),
                      other->second.value(*c));
        note(id, text);
      }
    }
    for (const auto& [id, row] : in_b) {
      if (in_a.count(id) == 0) note(id, ": only in the second");
    }
    if (count == 0) continue;
    std::printf("step %llu, table %s, %s; %zu of %zu rows differ\n", step, name.c_str(),
                first.c_str(), count, std::max(in_a.size(), in_b.size()));
    return 1;
  }
  return 0;
}

int change(const fs::path& from, const fs::path& to, const std::string& table, GlobalId id,
           std::size_t column) {
  Checkpoint checkpoint = read_checkpoint(manifest_in(from));
  bool found = false;
  for (auto& one : checkpoint.content.tables) {
    if (one.name != table || column >= static_cast<std::size_t>(one.width)) continue;
    for (std::size_t k = 0; k < one.id.size(); ++k) {
      if (one.id[k] != id) continue;
      auto& value = one.value[k * static_cast<std::size_t>(one.width) + column];
      value = std::bit_cast<Real>(std::bit_cast<std::uint64_t>(value) ^ 1U);
      found = true;
    }
  }
  if (!found) throw MachineError("there is no such value");
  checkpoint.header.ranks = 1;  // all tables go into one part
  fs::create_directories(to);
  const auto part = write_checkpoint_part(to, checkpoint.header, 0, std::move(checkpoint.content));
  write_checkpoint_manifest(to, checkpoint.header, {part});
  return 0;
}

int run(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  try {
    if (words.size() == 2 && words[0] == "--tables") {
      const Checkpoint checkpoint = read_checkpoint(manifest_in(words[1]));
      for (const auto& [name, rows] : rows_of(checkpoint)) std::printf("%s\n", name.c_str());
      return 0;
    }
    if (words.size() == 2) return compare(words[0], words[1]);
    if (words.size() == 6 && words[0] == "--change") {
      return change(words[1], words[2], words[3], std::stoull(words[4]), std::stoull(words[5]));
    }
    throw MachineError("call: state_difference A B, or --change A OUT TABLE ID COLUMN");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "state_difference: %s\n", error.what());
    return 2;
  }
}

}  // namespace
}  // namespace brunt

int main(int argc, char** argv) { return brunt::run(argc, argv); }
