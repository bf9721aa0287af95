// Wrong decks made from the schema: every key that a deck can have is misspelt, given a wrong
// dimension, put out of range, given a wrong type, and left out. Each must be reported at the line
// and the path of the key. The decks are two that hold every key, written one key a line by the
// echo.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "app/deck/deck.hpp"
#include "app/deck/loader.hpp"
#include "full_deck.hpp"
#include "io/deck/key_tree.hpp"
#include "io/deck/number.hpp"

namespace brunt::deck {
namespace {

/// One line of an echoed deck: "  key: value".
struct Line {
  std::size_t indent = 0;
  std::string key, value, path;
  std::size_t end = 0;  ///< first line after what is nested below it
};

std::vector<Line> lines_of(const std::string& text) {
  std::vector<Line> lines;
  std::istringstream stream(text);
  for (std::string row; std::getline(stream, row);) {
    Line line;
    line.indent = row.find_first_not_of(' ');
    const std::size_t colon = row.find(':');
    line.key = row.substr(line.indent, colon - line.indent);
    line.value = colon + 2 < row.size() ? row.substr(colon + 2) : "";
    line.path = line.key;
    for (std::size_t i = lines.size(); i-- > 0;) {
      if (lines[i].indent < line.indent) {
        line.path = lines[i].path + "." + line.key;
        break;
      }
    }
    lines.push_back(line);
  }
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::size_t end = i + 1;
    while (end < lines.size() && lines[end].indent > lines[i].indent) ++end;
    lines[i].end = end;
  }
  return lines;
}

KeyInfo keys_of(Geometry geometry) {
  return key_tree(geometry, [](Schema& s) {
    Deck blank;
    describe(s, blank);
  });
}

/// A value that a key may have, in the full deck.
std::string plausible_value(const KeyInfo& key) {
  using Type = KeyInfo::Type;
  if (key.type == Type::choice) return key.words.at(0).substr(0, key.words[0].find('|'));
  if (key.type == Type::text) return key.name == "body" ? "a" : "temperature";
  const Real low = std::max(key.plausible.min, key.range.min);
  const Real high = std::min(key.plausible.max, key.range.max);
  return shortest_text(low > 0 && high < kInfinity ? std::sqrt(low * high) : 1);
}

/// "{voce: {A: 1e7}}", of the keys that an alternative needs.
std::string written(const KeyInfo& alternative) {
  std::string keys;
  for (const KeyInfo& key : alternative.children) {
    if (!key.required) continue;
    keys += (keys.empty() ? "" : ", ") + key.name + ": " + plausible_value(key);
  }
  return "{" + (alternative.in_line ? keys : alternative.name + ": {" + keys + "}") + "}";
}

/// The deck with a material for each law that it has not, and with each measure. What takes no such
/// values stands in full_deck.hpp.
std::string with_all_laws(std::string deck) {
  const KeyInfo root = keys_of(Geometry::three_d);
  int count = 0;
  const auto add = [&](const std::string& section, const KeyInfo& choice, const std::string& before,
                       const std::string& after) {
    const std::string start = choice.name.empty() ? ": {" : choice.name + ": {";
    const std::string head = "\n" + section + ":\n";
    for (const KeyInfo& one : choice.children) {
      if (one.type == KeyInfo::Type::empty) continue;
      if (deck.find(start + one.name + ":") != std::string::npos) continue;
      const std::string name = "n" + std::to_string(++count);  // like no key
      deck.insert(deck.find(head) + head.size(),
                  "  " + name + ": " + before + written(one) + after + "\n");
    }
  };
  for (const std::string kind : {"strength", "eos", "damage"}) {
    add("materials", *find_key(root, "materials." + kind),
        "{density: 1000, elastic: {K: 1 GPa, G: 1 GPa}, " + kind + ": ", "}");
  }
  for (const KeyInfo& key : find_key(root, "measures")->children) {
    if (key.type == KeyInfo::Type::one_of) add("measures", key, "", "");
  }
  return deck;
}

class WrongDecks {
 public:
  explicit WrongDecks(const std::string& text, Geometry geometry)
      : root_(keys_of(geometry)),
        resolved_(loader_.load_text(text, "deck").resolved),
        lines_(lines_of(resolved_)) {}

  /// Breaks every key in every way; returns the number of wrong decks.
  int try_all() {
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const KeyInfo* key = find_key(root_, lines_[i].path);
      const KeyInfo* outer = find_key(root_, parent(i));
      if (!key && outer && outer->type == KeyInfo::Type::varying) continue;  // parts of a table
      if (!key) {
        ADD_FAILURE() << "no key at " << lines_[i].path;
        continue;
      }
      visit(*key);
      const bool entry = key->type == KeyInfo::Type::named && lines_[i].key != key->name;
      if (entry) continue;
      misspell(i);
      wrong_type(i, *key);
      if (has_unit(*key)) wrong_dimension(i, *key);
      if (has_range(*key)) out_of_range(i, *key);
      if (key->required) leave_out(i);
    }
    return count_;
  }

  /// Paths of keys that no line has.
  std::vector<std::string> not_visited() const {
    std::vector<std::string> paths;
    collect(root_, "", paths);
    return paths;
  }

 private:
  static bool has_unit(const KeyInfo& key) { return !value_key(key).unit.empty(); }
  static bool has_range(const KeyInfo& key) {
    const Range& range = value_key(key).range;
    return range.min > -kInfinity || range.max < kInfinity;
  }
  /// The bare value of an alternative stands for it.
  static const KeyInfo& value_key(const KeyInfo& key) {
    return key.children.size() == 1 && key.children[0].bare ? key.children[0] : key;
  }

  void visit(const KeyInfo& key) {
    visited_.insert(&key);
    if (&value_key(key) != &key) visited_.insert(&value_key(key));
    // A bare word such as `where: all` is the visit of an alternative without keys.
    for (const KeyInfo& child : key.children) {
      if (key.type == KeyInfo::Type::one_of && child.type == KeyInfo::Type::empty) {
        visited_.insert(&child);
      }
    }
  }

  /// At its path, or where it is a key of several: those of a pair are those of `default` too, and
  /// laws whose name is left out share theirs.
  bool was_visited(const KeyInfo& key, const std::string& path, const KeyInfo& outer) const {
    if (visited_.contains(&key)) return true;
    const std::string all = ".contact.default.";
    std::string other;
    if (path.starts_with(all)) other = "contact.pairs." + path.substr(all.size());
    if (outer.in_line) {
      const std::size_t name = path.rfind("." + outer.name + "." + key.name);
      other = path.substr(1, name) + key.name;
    }
    return !other.empty() && visited_.contains(find_key(root_, other));
  }

  void collect(const KeyInfo& key, const std::string& path, std::vector<std::string>& out) const {
    for (const KeyInfo& child : key.children) {
      const std::string child_path = path + "." + child.name;
      if (!child.in_line && !was_visited(child, child_path, key)) out.push_back(child_path);
      collect(child, child_path, out);
    }
  }

  /// The deck with line i and what is below it replaced by `rows`.
  std::string with(std::size_t i, const std::string& rows) const {
    std::istringstream stream(resolved_);
    std::string out, row;
    for (std::size_t k = 0; std::getline(stream, row); ++k) {
      if (k == i) out += rows;
      if (k < i || k >= lines_[i].end) out += row + "\n";
    }
    return out;
  }

  std::string row(std::size_t i, const std::string& key, const std::string& value) const {
    return std::string(lines_[i].indent, ' ') + key + ": " + value + "\n";
  }

  /// Loads a wrong deck; there must be a problem at the line whose path begins with `path`.
  void expect(const std::string& text, std::size_t i, const std::string& path,
              const std::string& part, bool same_line = true) {
    ++count_;
    try {
      loader_.load_text(text, "deck");
      ADD_FAILURE() << "loaded, and should not: " << path << " " << part << "\n" << text;
    } catch (const DeckError& error) {
      const auto fits = [&](const DeckProblem& problem) {
        const bool line = !same_line || problem.place.line == static_cast<int>(i) + 1;
        return line && problem.path.starts_with(path) &&
               problem.message.find(part) != std::string::npos;
      };
      const auto& problems = error.problems();
      EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), fits))
          << "wanted line " << i + 1 << ", " << path << ", " << part << "; got\n"
          << error.what();
    }
  }

  std::string parent(std::size_t i) const {
    const std::size_t dot = lines_[i].path.rfind('.');
    return dot == std::string::npos ? "" : lines_[i].path.substr(0, dot);
  }

  void misspell(std::size_t i) {
    std::string rows = row(i, lines_[i].key + "q", lines_[i].value);
    const std::vector<Line>& lines = lines_;
    for (std::size_t k = i + 1; k < lines[i].end; ++k) rows += row(k, lines[k].key, lines[k].value);
    expect(with(i, rows), i, parent(i), "unknown key '" + lines_[i].key + "q'");
  }

  void wrong_type(std::size_t i, const KeyInfo& key) {
    using Type = KeyInfo::Type;
    const bool is_map =
        key.type == Type::map || key.type == Type::named || key.type == Type::one_of;
    const bool bare = &value_key(key) != &key;
    expect(with(i, row(i, lines_[i].key, is_map && !bare ? "17" : "{a: b}")), i, lines_[i].path,
           "");
  }

  void wrong_dimension(std::size_t i, const KeyInfo& key) {
    expect(with(i, row(i, lines_[i].key, value_text(key, lines_[i].value, "3 cd"))), i,
           lines_[i].path, "expects");
  }

  void out_of_range(std::size_t i, const KeyInfo& key) {
    const Range& range = value_key(key).range;
    const Real wrong = range.min > -kInfinity ? range.min - 1 : range.max + 1;
    expect(with(i, row(i, lines_[i].key, value_text(key, lines_[i].value, shortest_text(wrong)))),
           i, lines_[i].path, "must be");
  }

  void leave_out(std::size_t i) {
    const bool alone = lines_[i].end - i + 1 == lines_.size();
    ASSERT_FALSE(alone);
    expect(with(i, ""), i, parent(i), "", false);
  }

  /// A list of as many components as before, or a number.
  static std::string value_text(const KeyInfo& key, const std::string& before,
                                const std::string& number) {
    using Type = KeyInfo::Type;
    if (key.type == Type::points) {
      return "[[" + number + ", " + number + "], [0, 0], [1, 1]]";
    }
    if (before.empty() || before.front() != '[') return number;
    std::string list;
    const auto count = 1 + std::count(before.begin(), before.end(), ',');
    for (long n = 0; n < count; ++n) list += (n ? ", " : "") + number;
    return "[" + list + "]";
  }

  DeckLoader loader_;
  KeyInfo root_;
  std::string resolved_;
  std::vector<Line> lines_;
  std::set<const KeyInfo*> visited_;
  int count_ = 0;
};

TEST(DeckKeys, EveryWrongKeyIsToldAtItsPlace) {
  WrongDecks decks(with_all_laws(kFull), Geometry::three_d);
  EXPECT_GT(decks.try_all(), 600);
  EXPECT_EQ(decks.not_visited(), std::vector<std::string>{".depth"});  // of two dimensions
}

TEST(DeckKeys, InTwoDimensionsToo) {
  WrongDecks decks(kFlat, Geometry::plane_strain);
  EXPECT_GT(decks.try_all(), 40);
}

TEST(DeckKeys, MutatedDecksEndWithAMessageOrADeck) {
  // A fixed generator changes, drops, doubles and swaps bytes of the full deck.
  const DeckLoader loader;
  unsigned state = 12345;
  const auto next = [&](std::size_t n) {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) % n;
  };
  const std::string alphabet = "{}[]:,-.$=#'\"& \n0123456789eabcxyz/%^*()|";
  int refused = 0;
  constexpr int kDecks = 1500;
  for (int i = 0; i < kDecks; ++i) {
    std::string text = i % 2 ? kFull : kFlat;
    const std::size_t changes = 1 + next(4);
    for (std::size_t k = 0; k < changes; ++k) {
      const std::size_t at = next(text.size());
      switch (next(4)) {
        case 0:
          text[at] = alphabet[next(alphabet.size())];
          break;
        case 1:
          text.erase(at, 1 + next(6));
          break;
        case 2:
          text.insert(at, text.substr(next(text.size()), next(12)));
          break;
        default:
          text.insert(at, 1, alphabet[next(alphabet.size())]);
      }
    }
    try {
      const LoadedDeck loaded = loader.load_text(text, "deck");
      EXPECT_EQ(loader.load_text(loaded.resolved, "echo").resolved, loaded.resolved) << text;
    } catch (const DeckError& error) {
      ++refused;
      for (const DeckProblem& problem : error.problems()) {
        EXPECT_FALSE(problem.message.empty());
        EXPECT_FALSE(problem.place.file.empty()) << problem.text();
      }
    }
  }
  EXPECT_GT(refused, kDecks / 2);
  EXPECT_LT(refused, kDecks);
}

}  // namespace
}  // namespace brunt::deck
