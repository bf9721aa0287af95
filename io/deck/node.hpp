#pragma once
/// The deck as a tree of strings with places: nothing is guessed from how a text looks.
#include <string>
#include <string_view>
#include <vector>

#include "core/errors.hpp"

namespace brunt {

struct Entry;

struct Node {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  SourcePlace place;
  std::string text;            ///< scalar
  bool quoted = false;         ///< scalar: stood in quotes or in a block
  std::string written;         ///< scalar: text before parameters were put in; empty if unchanged
  bool pieced = false;         ///< scalar: parameters were put inside a longer text
  std::vector<Node> items;     ///< list
  std::vector<Entry> entries;  ///< map, in the order of the deck

  bool is_null() const { return kind == Kind::null; }
  bool is_scalar() const { return kind == Kind::scalar; }
  bool is_list() const { return kind == Kind::list; }
  bool is_map() const { return kind == Kind::map; }
  /// The value of a key of this map, or null.
  const Node* find(std::string_view key) const;
  Node* find(std::string_view key);
  const Entry* find_entry(std::string_view key) const;
  Entry* find_entry(std::string_view key);
  /// The value of a key of this map, made where it is not there.
  Node& at_or_new(const std::string& key, const SourcePlace& place);
  void erase(std::string_view key);
};

struct Entry {
  std::string key;
  SourcePlace place;  ///< of the key
  Node value;
};

Node scalar_node(std::string text);
Node map_node();
Node list_node();
/// Adds a key without a place.
void add_entry(Node& map, const std::string& key, Node value);

/// Throws a DeckError of one problem.
[[noreturn]] void refuse_deck(const SourcePlace& place, const std::string& path,
                              const std::string& message);
/// Number of nodes of a tree.
std::size_t count_nodes(const Node& node);
/// What stands there, short, for messages: '2700 kg', a map, a list, nothing.
std::string what_stands(const Node& node);
/// Maps merge key by key and `over` wins; anything else is replaced whole.
void merge(Node& base, const Node& over);
/// The tree as YAML that reads back to the same tree; places are lost.
std::string to_yaml(const Node& node);

}  // namespace brunt
