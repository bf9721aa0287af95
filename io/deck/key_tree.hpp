#pragma once
/// The keys of a schema as a tree of plain data, from which manual, JSON schema and `explain` are
/// made, and the wrong decks of the tests.
#include <functional>
#include <string>
#include <vector>

#include "core/schema.hpp"

namespace brunt {

struct KeyInfo {
  enum class Type {
    map,
    named,
    one_of,
    real,
    real_or_word,
    integer,
    integer_or_word,
    flag,
    text,
    choice,
    list,
    direction,
    per_axis,
    points,
    integers,
    words,
    names,
    varying,
    components,
    parameters,
    empty
  };
  std::string name;
  std::string help;
  Type type = Type::map;
  bool required = false;
  std::string unit;  ///< SI; "1" for a number, "" where there is none
  Range range, plausible;
  int size = 0;                    ///< of lists: 0 any, Schema::kVector by the geometry
  bool free_allowed = false;       ///< of lists: a component may be the word `free`
  bool list_allowed = false;       ///< map, named entries: a list may stand in its place
  bool in_line = false;            ///< one_of: stands among the keys of its map
  bool bare = false;               ///< the value of an alternative, not a key of its own
  std::vector<std::string> words;  ///< of choices, with synonyms as "a|b"; of maps their flags
  std::string fallback;            ///< default as text in SI; "" where there is none
  /// Where a key is needed by another of its map, for schemas: "method: sph", "!file"; "" by
  /// `required` alone.
  std::string needed_when;
  std::string when;               ///< "only for method: sph"; "" always
  std::vector<KeyInfo> children;  ///< keys; of named: of an entry; of one_of: alternatives
};

/// Visits a struct that holds its defaults.
KeyInfo key_tree(Geometry geometry, const std::function<void(Schema&)>& describe);

/// Type, range, need and default of a key.
std::string facts_text(const KeyInfo& key);
/// "number [Pa]", "list of 3 [m]", "one of a, b".
std::string type_text(const KeyInfo& key);
/// The key at "bodies.shape.cylinder"; names of entries and of alternatives may stand in the path
/// or be left out. Null where there is none.
const KeyInfo* find_key(const KeyInfo& root, const std::string& path);

/// Paths of all keys that end in these parts: "contact.default.friction" and
/// "contact.pairs.NAME.friction" for "friction".
std::vector<std::string> paths_ending_in(const KeyInfo& root, const std::string& tail);

/// The reference manual of all keys in Markdown.
std::string manual_text(const KeyInfo& root, const std::string& title);
/// A JSON schema (draft 7), for completion in editors.
std::string json_schema_text(const KeyInfo& root, const std::string& title);
/// A key with its unit, range, default and help, and its keys one level down.
std::string explain_text(const KeyInfo& key, const std::string& path);

}  // namespace brunt
