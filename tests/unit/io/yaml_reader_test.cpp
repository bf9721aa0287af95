// YAML as strings with places; what YAML readers guess or drop in silence is refused.
#include "io/deck/yaml_reader.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

/// The one problem of a text, as "line:column: message".
std::string problem(const std::string& text) {
  try {
    read_yaml(text, "deck");
  } catch (const DeckError& error) {
    EXPECT_EQ(error.problems().size(), 1u);
    return error.problems().front().text();
  }
  return "";
}

void expect_problem(const std::string& text, const std::string& place, const std::string& part) {
  const std::string found = problem(text);
  EXPECT_EQ(found.substr(0, 6 + place.size()), "deck:" + place + ":") << found;
  EXPECT_NE(found.find(part), std::string::npos) << found;
}

TEST(YamlReader, KeepsStringsAndPlaces) {
  const Node root = read_yaml("a: 010\nb:\n  - yes\n  - {c: 1e3, d: 'x y'}\n", "deck");
  EXPECT_EQ(root.find("a")->text, "010");
  EXPECT_EQ(root.find("a")->place.text(), "deck:1:4");
  EXPECT_EQ(root.find("b")->items[0].text, "yes");
  const Node& map = root.find("b")->items[1];
  EXPECT_EQ(map.find("c")->text, "1e3");
  EXPECT_EQ(map.find_entry("d")->place.text(), "deck:4:14");
  EXPECT_EQ(map.find("d")->text, "x y");
  EXPECT_TRUE(map.find("d")->quoted);
}

TEST(YamlReader, EmptyTextsAreNull) {
  for (const char* text : {"", "\n", "# only a comment\n", "---\n", "null\n"}) {
    EXPECT_TRUE(read_yaml(text, "deck").is_null()) << text;
  }
}

TEST(YamlReader, DuplicateKeysNameBothPlaces) {
  expect_problem("a: 1\nb: 2\na: 3\n", "3:1", "deck:1:1");
  expect_problem("m: {x: 1, y: 2, x: 3}\n", "1:17", "deck:1:5");
}

TEST(YamlReader, RefusesWhatWouldBeDropped) {
  expect_problem("a: 1\n---\nb: 2\n", "2:1", "second document");
  expect_problem("a: [1, 2] m/s\n", "1:11", "a unit stands inside the list");
  expect_problem("a:\n  b: 1\n c: 2\n", "3:2", "");
  expect_problem("a: 1\n\tb: 2\n", "2:1", "a tab");
  expect_problem("a:\n  <<: {b: 1}\n", "2:3", "'<<'");
  expect_problem("a: &x 1\n", "1:4", "anchor");
  expect_problem("a: *x\n", "1:4", "");
  expect_problem("a: !!int 3\n", "1:4", "tag");
  expect_problem("? [1]\n: 2\n", "1:3", "a key is a word");
  expect_problem("a: [${b}]\n", "1:6", "");
  expect_problem(std::string("a: \x01\n"), "1:4", "control character");
}

TEST(YamlReader, LimitsDepth) {
  expect_problem("a: " + std::string(100, '[') + std::string(100, ']'), "1:51", "nested deeper");
  const std::string fits = std::string(40, '[') + "1" + std::string(40, ']');
  EXPECT_EQ(problem("a: " + fits), "");
}

TEST(YamlReader, ShortInputsEnd) {
  // All texts of up to five of these characters, and longer ones from a fixed generator: reading
  // ends, with a tree or a problem. yaml-cpp's LoadAll does not end on some inputs of this kind.
  const std::string alphabet = "-[]{}:,\n #a\"'&*!|>?%@";
  std::size_t refused = 0;
  unsigned state = 1;
  for (int i = 0; i < 4000; ++i) {
    std::string text;
    state = state * 1664525u + 1013904223u;
    const std::size_t length = 1 + (state >> 16) % 24;
    for (std::size_t k = 0; k < length; ++k) {
      state = state * 1664525u + 1013904223u;
      text += alphabet[(state >> 16) % alphabet.size()];
    }
    try {
      read_yaml(text, "deck");
    } catch (const DeckError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000u);
}

TEST(YamlReader, ValuesOfTheCommandLine) {
  const Node value = read_yaml_value("[0, 0, -200 m/s]", "--set #2");
  EXPECT_EQ(value.items[2].text, "-200 m/s");
  EXPECT_EQ(value.items[2].place.text(), "--set #2");
  EXPECT_THROW(read_yaml_value("[0", "--set #1"), DeckError);
}

TEST(YamlWriter, WritesWhatReadsBack) {
  const std::string text =
      "a: 1e-05\nb:\n  c: [x, \"y: z\", \"\"]\n  d: \"a \\\"b\\\" # \\n\\\\\"\n  e: -1\n  f: {}\n";
  const Node first = read_yaml(text, "deck");
  const std::string written = to_yaml(first);
  EXPECT_EQ(to_yaml(read_yaml(written, "deck")), written);
  EXPECT_EQ(read_yaml(written, "deck").find("b")->find("d")->text, "a \"b\" # \n\\");
}

}  // namespace
}  // namespace brunt
