#include "io/deck/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

namespace brunt {

namespace {

constexpr std::size_t kMaxNodes = 4'000'000;

[[noreturn]] void refuse(const SourcePlace& place, const std::string& message) {
  refuse_deck(place, "", message);
}

/// Builds the tree from the events of one document.
class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::string file) : file_(std::move(file)) {}
  Node take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    refuse_anchor(mark, anchor);
    Node node;
    node.place = place(mark);
    add(std::move(node));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(place(mark),
           "'*' refers to an anchor, which decks do not have; use a parameter, or "
           "put the text in quotes");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    Node node = scalar_node(value);
    node.place = place(mark);
    node.quoted = tag == "!";
    add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, list_node());
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, map_node());
  }
  void OnMapEnd() override { close(); }

 private:
  /// A list or map that is being read; a map waits for a key or for its value.
  struct Open {
    Node node;
    bool has_key = false;
    std::string key;
    SourcePlace key_place;
  };

  SourcePlace place(const YAML::Mark& mark) const {
    return {file_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
  }
  void refuse_anchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != 0) refuse(place(mark), "'&' is an anchor, which decks do not have");
  }
  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    refuse(place(mark), "'" + tag + "' is a tag, which decks do not have");
  }
  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, Node node) {
    refuse_anchor(mark, anchor);
    refuse_tag(mark, tag);
    if (static_cast<int>(open_.size()) >= kMaxDeckDepth) {
      refuse(place(mark), "is nested deeper than " + std::to_string(kMaxDeckDepth) + " levels");
    }
    node.place = place(mark);
    open_.push_back({std::move(node), false, "", {}});
  }
  void close() {
    Node node = std::move(open_.back().node);
    open_.pop_back();
    add(std::move(node));
  }
  void add(Node node) {
    if (++n_nodes_ > kMaxNodes) refuse(node.place, "the deck has too many entries");
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    Open& parent = open_.back();
    if (parent.node.is_list()) {
      parent.node.items.push_back(std::move(node));
    } else if (parent.has_key) {
      // The mark of an empty value is that of the next token.
      if (node.is_null()) node.place = parent.key_place;
      parent.node.entries.push_back({parent.key, parent.key_place, std::move(node)});
      parent.has_key = false;
    } else {
      take_key(parent, node);
    }
  }
  static void take_key(Open& parent, const Node& node) {
    if (!node.is_scalar()) {
      refuse(node.place, "a key is a word, got " + what_stands(node) +
                             (node.is_map() ? "; '${...}' is not known: write $name" : ""));
    }
    if (node.text == "<<") {
      refuse(node.place, "'<<' is not known: use include, or a parameter");
    }
    if (const Entry* first = parent.node.find_entry(node.text)) {
      refuse(node.place, "the key '" + node.text + "' stands here and at " + first->place.text() +
                             "; keep one");
    }
    parent.key = node.text;
    parent.key_place = node.place;
    parent.has_key = true;
  }

  std::string file_;
  Node root_;
  std::vector<Open> open_;
  std::size_t n_nodes_ = 0;
};

/// The way out for "[0, 0, -190] m/s", which YAML cannot read.
std::string unit_after_list_hint(const std::string& text, int line) {
  std::istringstream lines(text);
  std::string row;
  for (int i = 0; i <= line && std::getline(lines, row); ++i) {
  }
  const std::size_t bracket = row.rfind(']');
  if (bracket == std::string::npos) return "";
  const std::size_t unit = row.find_first_not_of(' ', bracket + 1);
  if (unit == std::string::npos ||
      !(std::isalpha(static_cast<unsigned char>(row[unit])) || row[unit] == '%')) {
    return "";
  }
  return "; a unit stands inside the list: [0, 0, -190 m/s], or {unit: m/s, value: [0, 0, -190]}";
}

/// Refuses whatever comes after the first document.
class NothingMore final : public YAML::EventHandler {
 public:
  NothingMore(std::string file, const std::string& text) : file_(std::move(file)), text_(text) {}
  void OnDocumentStart(const YAML::Mark& mark) override {
    refuse({file_, mark.line + 1, mark.column + 1},
           "the deck ends before this: wrong indentation, text after a closed bracket, or a "
           "second document" +
               unit_after_list_hint(text_, mark.line));
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  std::string file_;
  const std::string& text_;
};

/// What a user can do about the words of yaml-cpp.
std::string meaning_of(const std::string& message) {
  struct Meaning {
    const char* words;
    const char* remedy;
  };
  static constexpr Meaning kMeanings[] = {
      {"end of map flow", "a '{' before this is not closed, or a comma is missing"},
      {"end of sequence flow", "a '[' before this is not closed, or a comma is missing"},
      {"end of map not found", "keys of one map begin in the same column"},
      {"end of sequence not found", "entries of one list begin in the same column"},
      {"illegal map value", "a text that holds ': ' stands in quotes, and a key on its own line"},
      {"illegal EOF in scalar", "a quote is not closed"},
      {"anchor is not defined", "'*' begins an alias; a text with a star stands in quotes"},
      {"illegal flow end", "a '}' or ']' closes nothing"},
      {"unknown token", "a text that begins with one of % @ ` stands in quotes"}};
  for (const Meaning& meaning : kMeanings) {
    if (message.find(meaning.words) != std::string::npos) {
      return std::string(meaning.remedy) + " (" + message + ")";
    }
  }
  return message;
}

/// Decks of other programs are recognised by their first line.
std::string keyword_hint(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \r\n");
  const bool keyword = first != std::string::npos && text[first] == '*';
  return keyword ? "; this looks like a keyword deck: decks of brunt are YAML, as in decks/" : "";
}

void refuse_bad_characters(const std::string& text, const std::string& file) {
  if (text.size() > kMaxDeckBytes) refuse({file, 1, 1}, "the deck is larger than 16 MiB");
  int line = 1, column = 1;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '\t') refuse({file, line, column}, "a tab; decks are indented with spaces");
    if ((byte < 0x20 && c != '\n' && c != '\r') || byte == 0x7f) {
      refuse({file, line, column}, "a control character; a deck is plain text in UTF-8");
    }
    if (c == '\n') {
      ++line;
      column = 1;
    } else if ((byte & 0xC0) != 0x80) {
      ++column;
    }
  }
}

}  // namespace

Node read_yaml(const std::string& text, const std::string& file) {
  refuse_bad_characters(text, file);
  std::istringstream stream(text);
  try {
    YAML::Parser parser(stream);
    TreeBuilder builder(file);
    if (!parser.HandleNextDocument(builder)) return {};
    NothingMore nothing_more(file, text);
    parser.HandleNextDocument(nothing_more);
    return builder.take_root();
  } catch (const YAML::Exception& error) {
    const int line = std::max(error.mark.line, 0), column = std::max(error.mark.column, 0);
    refuse({file, line + 1, column + 1}, "this is not YAML: " + meaning_of(error.msg) +
                                             unit_after_list_hint(text, line) + keyword_hint(text));
  }
}

namespace {
void set_place(Node& node, const SourcePlace& place) {
  node.place = place;
  for (Node& item : node.items) set_place(item, place);
  for (Entry& entry : node.entries) {
    entry.place = place;
    set_place(entry.value, place);
  }
}
}  // namespace

Node read_yaml_value(const std::string& text, const std::string& source) {
  Node node;
  try {
    node = read_yaml(text, source);
  } catch (const DeckError& error) {
    refuse_deck({source, 0, 0}, "", error.problems().front().message);
  }
  set_place(node, {source, 0, 0});
  return node;
}

}  // namespace brunt
