#include "io/deck/node.hpp"

#include <algorithm>

namespace brunt {

const Entry* Node::find_entry(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

Entry* Node::find_entry(std::string_view key) {
  return const_cast<Entry*>(static_cast<const Node*>(this)->find_entry(key));
}

const Node* Node::find(std::string_view key) const {
  const Entry* entry = find_entry(key);
  return entry ? &entry->value : nullptr;
}

Node* Node::find(std::string_view key) {
  return const_cast<Node*>(static_cast<const Node*>(this)->find(key));
}

Node& Node::at_or_new(const std::string& key, const SourcePlace& key_place) {
  if (Node* found = find(key)) return *found;
  Node fresh;
  fresh.place = key_place;
  entries.push_back({key, key_place, fresh});
  return entries.back().value;
}

void Node::erase(std::string_view key) {
  std::erase_if(entries, [&](const Entry& entry) { return entry.key == key; });
}

Node scalar_node(std::string text) {
  Node node;
  node.kind = Node::Kind::scalar;
  node.text = std::move(text);
  return node;
}

Node map_node() {
  Node node;
  node.kind = Node::Kind::map;
  return node;
}

Node list_node() {
  Node node;
  node.kind = Node::Kind::list;
  return node;
}

void refuse_deck(const SourcePlace& place, const std::string& path, const std::string& message) {
  std::vector<DeckProblem> problems(1);
  problems.front().place = place;
  problems.front().path = path;
  problems.front().message = message;
  throw DeckError(std::move(problems));
}

void add_entry(Node& map, const std::string& key, Node value) {
  Entry& entry = map.entries.emplace_back();
  entry.key = key;
  entry.value = std::move(value);
}

std::size_t count_nodes(const Node& node) {
  std::size_t n = 1;
  for (const Node& item : node.items) n += count_nodes(item);
  for (const Entry& entry : node.entries) n += count_nodes(entry.value);
  return n;
}

std::string what_stands(const Node& node) {
  constexpr std::size_t kLongest = 60;
  switch (node.kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::map:
      return "a map";
    case Node::Kind::list:
      return "a list of " + std::to_string(node.items.size());
    case Node::Kind::scalar:
      break;
  }
  const std::string& text = node.written.empty() ? node.text : node.written;
  if (text.size() <= kLongest) return "'" + text + "'";
  std::size_t cut = kLongest;  // not inside a UTF-8 sequence
  while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;
  return "'" + text.substr(0, cut) + "...'";
}

void merge(Node& base, const Node& over) {
  if (!base.is_map() || !over.is_map()) {
    base = over;
    return;
  }
  for (const Entry& entry : over.entries) {
    const auto found = std::find_if(base.entries.begin(), base.entries.end(),
                                    [&](const Entry& old) { return old.key == entry.key; });
    if (found == base.entries.end()) {
      base.entries.push_back(entry);
    } else {
      merge(found->value, entry.value);
      found->place = entry.place;
    }
  }
  base.place = over.place;
}

}  // namespace brunt
// Tested by tests/unit/io/yaml_reader_test.cpp.
