#include "io/deck/sources.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/deck/suggest.hpp"
#include "io/deck/yaml_reader.hpp"

namespace brunt {

namespace {

namespace fs = std::filesystem;

/// Why a path names no file that can be read as a deck.
std::string why_unreadable(const std::string& path) {
  std::error_code error;
  const auto type = fs::status(path, error).type();
  if (type == fs::file_type::directory) {
    return "is a folder, not a deck; name the .yaml file in it";
  }
  if (type == fs::file_type::not_found) return "there is no such file";
  if (type == fs::file_type::none) return "cannot be read: " + error.message();
  return "is a pipe or a device; a deck is read from a file";
}

/// A path as it can be compared with others; as it stands where there is no file.
std::string identity(const std::string& path) {
  std::error_code error;
  const fs::path found = fs::canonical(path, error);
  return error ? path : found.string();
}

std::string read_text(const std::string& path, const SourcePlace& asked_at) {
  const std::string where = asked_at.file.empty() ? "" : "include";
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    const std::string problem = why_unreadable(path);
    if (asked_at.file.empty()) refuse_deck({path, 0, 0}, where, problem);
    refuse_deck(asked_at, where, "'" + path + "': " + problem);
  }
  if (fs::file_size(path, error) > kMaxDeckBytes) {
    refuse_deck({path, 0, 0}, "", "the deck is larger than 16 MiB");
  }
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) refuse_deck(asked_at, where, "cannot read the file '" + path + "'");
  return text.str();
}

constexpr std::size_t kMaxIncludeDepth = 64, kMaxIncludes = 1000;

/// Files on the way from the deck to what is being read, and what was read before.
struct Open {
  std::vector<std::string> files;  ///< outermost first
  std::size_t n_read = 0;
  std::size_t bytes = 0;
};

Node with_includes(Node deck, const std::string& name, Open& open);

Node read_included(const std::string& path, const SourcePlace& asked_at, Open& open) {
  const std::string canonical = identity(path);
  if (std::find(open.files.begin(), open.files.end(), canonical) != open.files.end()) {
    refuse_deck(asked_at, "include", "'" + path + "' includes itself");
  }
  if (open.files.size() > kMaxIncludeDepth) {
    refuse_deck(asked_at, "include",
                "files include each other over more than " + std::to_string(kMaxIncludeDepth) +
                    " levels; include them from one");
  }
  if (++open.n_read > kMaxIncludes) {
    refuse_deck(asked_at, "include",
                "a deck includes at most " + std::to_string(kMaxIncludes) +
                    " files, each as often as it is named; include each once");
  }
  const std::string text = read_text(path, asked_at);
  open.bytes += text.size();
  if (open.bytes > kMaxDeckBytes) {
    refuse_deck(asked_at, "include", "the deck and what it includes are larger than 16 MiB");
  }
  open.files.push_back(canonical);
  Node node = with_includes(read_yaml(text, path), path, open);
  open.files.pop_back();
  return node;
}

Node with_includes(Node deck, const std::string& name, Open& open) {
  if (deck.is_null()) {
    deck = map_node();
    deck.place = {name, 1, 1};
  }
  if (!deck.is_map()) {
    refuse_deck(deck.place, "", "a deck is a map of keys, got " + what_stands(deck));
  }
  const Node* include = deck.find("include");
  if (!include) return deck;
  if (!include->is_list()) {
    refuse_deck(include->place, "include",
                "expects a list of files: [materials.yaml], got " + what_stands(*include));
  }
  Node merged = map_node();
  merged.place = deck.place;
  for (const Node& item : include->items) {
    if (!item.is_scalar() || item.text.empty()) {
      refuse_deck(item.place, "include", "expects a file, got " + what_stands(item));
    }
    const fs::path path = fs::path(name).parent_path() / item.text;
    merge(merged, read_included(path.string(), item.place, open));
  }
  deck.erase("include");
  merge(merged, deck);
  return merged;
}

/// The entry of a list at an index written as text, or null.
Node* list_entry(Node& list, const std::string& text) {
  std::size_t index = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), index);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) return nullptr;
  return index < list.items.size() ? &list.items[index] : nullptr;
}

}  // namespace

Node read_deck_file(const std::string& path) {
  Open open{{identity(path)}};
  return with_includes(read_yaml(read_text(path, {}), path), path, open);
}

Node read_deck_source(const std::string& text, const std::string& name) {
  Open open;
  return with_includes(read_yaml(text, name), name, open);
}

std::vector<Override> read_overrides(const std::vector<std::string>& texts,
                                     std::vector<DeckProblem>& problems) {
  std::vector<Override> changes;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const SourcePlace place{"--set #" + std::to_string(i + 1), 0, 0};
    const std::size_t equals = texts[i].find('=');
    if (equals == std::string::npos || equals == 0) {
      problems.push_back({place, "", "expects KEY=VALUE, got '" + texts[i] + "'"});
      continue;
    }
    Override change;
    change.place = place;
    std::string key = texts[i].substr(0, equals);
    std::istringstream keys(key);
    for (std::string part; std::getline(keys, part, '.');) change.path.push_back(part);
    const auto empty = [](const std::string& part) { return part.empty(); };
    if (key.back() == '.' || std::any_of(change.path.begin(), change.path.end(), empty)) {
      problems.push_back({place, "", "'" + key + "' is not a key: keys are joined by one dot"});
      continue;
    }
    if (texts[i].find_first_not_of(' ', equals + 1) == std::string::npos) {
      problems.push_back({place, key, "has no value; " + key + "=null takes the key out"});
      continue;
    }
    try {
      change.value = read_yaml_value(texts[i].substr(equals + 1), place.file);
      changes.push_back(std::move(change));
    } catch (const DeckError& error) {
      for (DeckProblem problem : error.problems()) {
        problem.path = key;
        problems.push_back(problem);
      }
    }
  }
  return changes;
}

void apply_override(Node& root, const Override& change, std::vector<DeckProblem>& problems) {
  Node* node = &root;
  std::string path;
  for (std::size_t i = 0; i < change.path.size(); ++i) {
    const std::string& key = change.path[i];
    const bool last = i + 1 == change.path.size();
    if (node->is_list()) {
      Node* entry = list_entry(*node, key);
      if (!entry) {
        problems.push_back({change.place, join_path(path, key),
                            "is not an entry: " + path + " is a list of " +
                                std::to_string(node->items.size()) + ", counted from 0"});
        return;
      }
      if (last && change.value.is_null()) {
        node->items.erase(node->items.begin() + (entry - node->items.data()));
        return;
      }
      node = entry;
    } else if (node->is_map() || node->is_null()) {
      if (node->is_null()) {
        *node = map_node();
        node->place = change.place;
      }
      if (change.value.is_null() && (last || !node->find(key))) {
        if (!node->find(key)) {
          problems.push_back({change.place, join_path(path, key), "is not there to be taken out"});
        }
        node->erase(key);
        return;
      }
      Node* map = node;
      node = &map->at_or_new(key, change.place);
      if (last) map->find_entry(key)->place = change.place;
    } else {
      problems.push_back({change.place, join_path(path, key),
                          path + " is " + what_stands(*node) + " and has no keys"});
      return;
    }
    path = join_path(path, key);
  }
  *node = change.value;
}

void expand_library(Node& map, const std::string& path, const Node& library,
                    const std::vector<std::string>& alternatives,
                    std::vector<DeckProblem>& problems) {
  std::vector<std::string> unknown;
  for (Entry& entry : map.entries) {
    Node& own = entry.value;
    const Node* name = own.is_map() ? own.find("library") : nullptr;
    if (!name) continue;
    const Node* found = name->is_scalar() ? library.find(name->text) : nullptr;
    if (!found) {
      std::vector<std::string> known;
      for (const Entry& candidate : library.entries) known.push_back(candidate.key);
      problems.push_back({name->place, join_path(join_path(path, entry.key), "library"),
                          "the library has no " + what_stands(*name) +
                              suggestion(name->is_scalar() ? name->text : std::string(), known)});
      unknown.push_back(entry.key);
      continue;
    }
    Node values = *found->find("values");
    values.place = own.place;
    own.erase("library");
    for (const std::string& key : alternatives) {
      const Node* theirs = values.find(key);
      const Node* ours = own.find(key);
      if (!theirs || !ours || !theirs->is_map() || !ours->is_map()) continue;
      const bool shared =
          std::any_of(ours->entries.begin(), ours->entries.end(),
                      [&](const Entry& part) { return theirs->find(part.key) != nullptr; });
      if (!shared) values.erase(key);
    }
    merge(values, own);
    own = std::move(values);
  }
  // What an entry with a wrong name lacks is not reported a second time.
  for (const std::string& name : unknown) map.erase(name);
}

std::string join_path(const std::string& path, const std::string& key) {
  return path.empty() ? key : path + "." + key;
}

}  // namespace brunt
