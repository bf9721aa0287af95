#include "io/deck/key_tree.hpp"

#include <cmath>

#include "io/deck/number.hpp"
#include "io/deck/reader.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {

std::string numbers_text(const std::vector<Real>& values) {
  std::string text;
  for (const Real value : values) text += (text.empty() ? "" : ", ") + shortest_text(value);
  return values.empty() ? "" : "[" + text + "]";
}

/// Collects keys; descends into blank entries and alternatives.
class KeyWalker final : public Schema {
 public:
  explicit KeyWalker(Geometry geometry) : geometry_(geometry) {}
  KeyInfo root;

  Geometry geometry() const override { return geometry_; }
  void real(const Key& key, Real& value, const Quantity& quantity) override {
    KeyInfo& info = add(key, KeyInfo::Type::real, quantity);
    if (!info.required && std::isfinite(value)) info.fallback = shortest_text(value);
  }
  void real(const Key& key, std::optional<Real>&, const Quantity& quantity) override {
    add(key, KeyInfo::Type::real, quantity);
  }
  void real_or_word(const Key& key, std::optional<Real>& value, const Quantity& quantity,
                    const char* word) override {
    KeyInfo& info = add(key, KeyInfo::Type::real_or_word, quantity);
    info.words = {word};
    info.fallback = value ? shortest_text(*value) : word;
  }
  void integer(const Key& key, int& value, const Range& range) override {
    KeyInfo& info = add(key, KeyInfo::Type::integer, {"1", range});
    if (!info.required) info.fallback = std::to_string(value);
  }
  void integer_or_word(const Key& key, std::optional<int>& value, const Range& range,
                       const char* word) override {
    KeyInfo& info = add(key, KeyInfo::Type::integer_or_word, {"1", range});
    info.words = {word};
    info.fallback = value ? std::to_string(*value) : word;
  }
  void flag(const Key& key, bool& value) override {
    add(key, KeyInfo::Type::flag).fallback = value ? "true" : "false";
  }
  void text(const Key& key, std::string& value) override {
    add(key, KeyInfo::Type::text).fallback = value;
  }
  void choice(const Key& key, int& index, std::span<const char* const> words) override {
    KeyInfo& info = add(key, KeyInfo::Type::choice);
    take_words(info, words);
    if (!info.required) info.fallback = main_word(words[index]);
  }
  void list(const Key& key, std::vector<Real>& value, const Quantity& quantity, int size,
            bool allow_free) override {
    KeyInfo& info = add(key, KeyInfo::Type::list, quantity);
    info.size = size;
    info.free_allowed = allow_free;
    if (!info.required) info.fallback = numbers_text(value);
  }
  void list(const Key& key, std::optional<std::vector<Real>>&, const Quantity& quantity, int size,
            bool allow_free) override {
    KeyInfo& info = add(key, KeyInfo::Type::list, quantity);
    info.size = size;
    info.free_allowed = allow_free;
  }
  void direction(const Key& key, std::vector<Real>& value) override {
    KeyInfo& info = add(key, KeyInfo::Type::direction);
    if (!info.required) info.fallback = numbers_text(value);
  }
  void per_axis(const Key& key, std::optional<std::vector<Real>>&,
                const Quantity& quantity) override {
    add(key, KeyInfo::Type::per_axis, quantity);
  }
  void points(const Key& key, std::vector<std::vector<Real>>&, const Quantity& quantity) override {
    add(key, KeyInfo::Type::points, quantity);
  }
  void integers(const Key& key, std::optional<std::vector<int>>&, int size,
                const Range& range) override {
    add(key, KeyInfo::Type::integers, {"1", range}).size = size;
  }
  void words(const Key& key, std::vector<std::string>&,
             std::span<const char* const> words) override {
    take_words(add(key, KeyInfo::Type::words), words);
  }
  void names(const Key& key, std::vector<std::string>&, int size) override {
    add(key, KeyInfo::Type::names).size = size;
  }
  void varying(const Key& key, std::optional<Varying>&, const Quantity& quantity,
               std::span<const Varying::Over> over) override {
    take_overs(add(key, KeyInfo::Type::varying, quantity), over);
  }
  void components(const Key& key, std::optional<std::vector<std::optional<Varying>>>&,
                  const Quantity& quantity, std::span<const Varying::Over> over) override {
    KeyInfo& info = add(key, KeyInfo::Type::components, quantity);
    info.size = kVector;
    take_overs(info, over);
  }
  void value(Real& value, const Quantity& quantity, const char* help) override {
    KeyInfo& info = add({"", help}, KeyInfo::Type::real, quantity);
    info.bare = true;
    info.fallback = shortest_text(value);
  }
  void value(int&, std::span<const char* const> words, const char* help) override {
    KeyInfo& info = add({"", help}, KeyInfo::Type::choice);
    info.bare = true;
    take_words(info, words);
  }
  void value(std::string&, const char* help) override {
    add({"", help}, KeyInfo::Type::text).bare = true;
  }
  void section(bool, const char* when, std::function<void(Schema&)> members) override {
    const char* outer = when_;
    when_ = when;
    members(*this);
    when_ = outer;
  }
  void require(bool, const char*, const std::string&) override {}

 protected:
  void visit_object(const Key& key, std::function<bool()>, std::function<void()>,
                    Members members) override {
    add(key, KeyInfo::Type::map).children = children_of(members);
  }
  void visit_named(const Key& key, bool list_allowed, std::function<std::size_t()>,
                   std::function<std::string(std::size_t)>, std::function<void(const std::string&)>,
                   std::function<void(std::size_t, Schema&)>, Members blank) override {
    KeyInfo& info = add(key, KeyInfo::Type::named);
    info.list_allowed = list_allowed;
    info.children = children_of(blank);
  }
  void visit_one_or_more(const Key& key, std::function<std::size_t()>, std::function<void()>,
                         std::function<void(std::size_t, Schema&)>, Members blank) override {
    KeyInfo& info = add(key, KeyInfo::Type::map);
    info.list_allowed = true;
    info.children = children_of(blank);
  }
  void visit_any_of(const Key& key, Members members) override {
    KeyInfo& info = add(key, KeyInfo::Type::map);
    info.list_allowed = true;
    info.children = children_of(members);
    for (const KeyInfo& child : info.children) {
      if (child.type == KeyInfo::Type::flag) info.words.push_back(child.name);
    }
  }
  void visit_one_of(const Key& key, std::span<const Alternative> alternatives,
                    std::function<std::size_t()> index, std::function<void(std::size_t)>, Members,
                    std::function<void(std::size_t, Schema&)> blank) override {
    std::vector<KeyInfo> children;
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      KeyInfo alternative;
      alternative.name = alternatives[i].name;
      alternative.help = alternatives[i].help;
      alternative.children = children_of([&](Schema& s) { blank(i, s); });
      if (alternative.children.empty()) alternative.type = KeyInfo::Type::empty;
      alternative.in_line = alternatives[i].open;
      children.push_back(std::move(alternative));
    }
    KeyInfo& info = add(key, KeyInfo::Type::one_of);
    info.in_line = *key.name == '\0';
    if (!info.required) info.fallback = alternatives[index()].name;
    info.children = std::move(children);
  }
  void visit_varying_or_law(const Key& key, std::optional<Varying>&, const Quantity& quantity,
                            std::span<const Varying::Over> over, std::function<bool()>,
                            std::function<void(bool)>, Members members) override {
    KeyInfo& info = add(key, KeyInfo::Type::varying, quantity);
    take_overs(info, over);
    info.children = children_of(members);
  }

 private:
  KeyInfo& add(const Key& key, KeyInfo::Type type, const Quantity& quantity = {""}) {
    KeyInfo info;
    info.name = key.name;
    info.help = key.help;
    info.type = type;
    info.required = key.need == Need::required;
    info.unit = quantity.unit;
    info.range = quantity.range;
    info.plausible = quantity.plausible;
    info.when = when_;
    root.children.push_back(std::move(info));
    return root.children.back();
  }
  std::vector<KeyInfo> children_of(const Members& members) {
    KeyWalker inner(geometry_);
    members(inner);
    return std::move(inner.root.children);
  }
  static void take_words(KeyInfo& info, std::span<const char* const> words) {
    for (const char* word : words) {
      if (*word != '!') info.words.emplace_back(word);
    }
  }
  static void take_overs(KeyInfo& info, std::span<const Varying::Over> overs) {
    for (const Varying::Over over : overs) {
      const bool expression = over == Varying::Over::expression || over == Varying::Over::sliding;
      info.words.emplace_back(expression ? "expression" : over_word(over));
    }
  }

  Geometry geometry_;
  const char* when_ = "";
};

std::string word_text(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += (text.empty() ? "" : ", ") + main_word(word.c_str());
  }
  return text;
}

std::string count_of(const KeyInfo& key) {
  if (key.size == Schema::kVector) return "one an axis";
  return key.size == 0 ? "any number" : std::to_string(key.size);
}

}  // namespace

KeyInfo key_tree(Geometry geometry, const std::function<void(Schema&)>& describe) {
  KeyWalker walker(geometry);
  describe(walker);
  return std::move(walker.root);
}

std::string type_text(const KeyInfo& key) {
  using Type = KeyInfo::Type;
  const std::string unit =
      key.unit.empty() || key.unit == "1" || key.unit == "any" ? "" : " [" + key.unit + "]";
  switch (key.type) {
    case Type::map:
      if (!key.words.empty()) return word_text(key.words) + ", map, or list of them";
      return key.list_allowed ? "map, or list of maps" : "map";
    case Type::named:
      return key.list_allowed ? "map of named entries, or list" : "map of named entries";
    case Type::one_of:
      return "one of the following";
    case Type::real:
      return "number" + unit;
    case Type::real_or_word:
      return word_text(key.words) + " or number" + unit;
    case Type::integer:
      return "whole number";
    case Type::integer_or_word:
      return word_text(key.words) + " or whole number";
    case Type::flag:
      return "true or false";
    case Type::text:
      return "text";
    case Type::choice:
      return "one of " + word_text(key.words);
    case Type::list:
      return "list, " + count_of(key) + unit;
    case Type::direction:
      return "x, y, z or a vector";
    case Type::per_axis:
      return "number, or list of one an axis" + unit;
    case Type::points:
      return "list of points" + unit;
    case Type::integers:
      return "list of whole numbers, " + count_of(key);
    case Type::words:
      return "list of " + word_text(key.words);
    case Type::names:
      return "list of names, " + count_of(key);
    case Type::varying:
      return "number" + unit + ", may depend on " + word_text(key.words) +
             (key.children.empty() ? "" : ", or map");
    case Type::components:
      return "list, one an axis, each free or a number" + unit + ", may depend on " +
             word_text(key.words);
    case Type::parameters:
      return "map of values";
    case Type::empty:
      return "the word alone";
  }
  return "";
}

namespace {

/// Looks for path[at...] below `key`; the name of an entry may be left out.
const KeyInfo* find_below(const KeyInfo& key, const std::vector<std::string>& path, std::size_t at,
                          bool entry_named = false) {
  if (at == path.size()) return &key;
  for (const KeyInfo& child : key.children) {
    if (child.bare) continue;
    if (child.in_line) {
      if (const KeyInfo* found = find_below(child, path, at)) return found;
    } else if (child.name == path[at]) {
      if (const KeyInfo* found = find_below(child, path, at + 1)) return found;
    }
  }
  if (key.type != KeyInfo::Type::named || entry_named) return nullptr;
  std::vector<std::string> keys;
  for (const KeyInfo& child : key.children) keys.push_back(child.name);
  // What looks like a misspelt key is not taken for the name of an entry.
  if (at + 1 == path.size() && !nearest_word(path[at], keys).empty()) return nullptr;
  return find_below(key, path, at + 1, true);
}

}  // namespace

namespace {
void collect_paths(const KeyInfo& key, const std::string& path, std::vector<std::string>& all) {
  for (const KeyInfo& child : key.children) {
    if (child.bare) continue;
    std::string below = path;
    if (!child.in_line) {
      below += (path.empty() ? "" : ".") + child.name;
      all.push_back(below);
    }
    const bool named = child.type == KeyInfo::Type::named;
    collect_paths(child, named ? below + ".NAME" : below, all);
  }
}
}  // namespace

std::vector<std::string> paths_ending_in(const KeyInfo& root, const std::string& tail) {
  std::vector<std::string> all;
  collect_paths(root, "", all);
  std::erase_if(
      all, [&](const std::string& path) { return path != tail && !path.ends_with("." + tail); });
  return all;
}

const KeyInfo* find_key(const KeyInfo& root, const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= path.size() && !path.empty();) {
    const std::size_t dot = std::min(path.find('.', from), path.size());
    parts.push_back(path.substr(from, dot - from));
    from = dot + 1;
  }
  return find_below(root, parts, 0);
}

}  // namespace brunt
// Tested by tests/unit/app/deck_keys_test.cpp.
