// What is generated from the schema: the manual in docs/, the JSON schema, explanations.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "app/deck/reference.hpp"
#include "io/deck/key_tree.hpp"
#include "tests/support/source_path.hpp"

namespace brunt::deck {
namespace {

TEST(DeckReference, TheManualInDocsIsFresh) {
  std::ifstream file(test::source_path("docs/deck.md"));
  ASSERT_TRUE(file) << "write it with: brunt schema --markdown > docs/deck.md";
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_TRUE(text.str() == manual_text(deck_keys(), "The keys of a deck"))
      << "docs/deck.md is stale: brunt schema --markdown > docs/deck.md";
}

TEST(DeckReference, FindsKeysWithAndWithoutNamesOfEntries) {
  const KeyInfo root = deck_keys();
  const KeyInfo* with = find_key(root, "materials.copper.strength.johnson-cook.C");
  const KeyInfo* without = find_key(root, "materials.strength.johnson-cook.C");
  ASSERT_NE(with, nullptr);
  EXPECT_EQ(with, without);
  EXPECT_EQ(with->range.min, 0);
  EXPECT_EQ(find_key(root, "bodies.bar.shape.cylinder.radius")->unit, "m");
  EXPECT_EQ(find_key(root, "time.safty"), nullptr);
  EXPECT_EQ(find_key(root, "materials.densty"), nullptr);
}

TEST(DeckReference, FindsKeysByTheirLastParts) {
  const KeyInfo root = deck_keys();
  EXPECT_EQ(paths_ending_in(root, "friction"),
            (std::vector<std::string>{"contact.default.friction", "contact.pairs.NAME.friction"}));
  EXPECT_EQ(paths_ending_in(root, "johnson-cook.T_melt"),
            (std::vector<std::string>{"materials.NAME.strength.johnson-cook.T_melt",
                                      "materials.NAME.damage.johnson-cook.T_melt"}));
  EXPECT_TRUE(paths_ending_in(root, "riction").empty());
  // Whatever stands in a deck is found by its last part, and each path leads to its key.
  for (const std::string& path : paths_ending_in(root, "axis")) {
    EXPECT_NE(find_key(root, path), nullptr) << path;
  }
}

TEST(DeckReference, ExplainsUnitRangeDefaultAndHelp) {
  const KeyInfo root = deck_keys();
  const std::string text = explain_text(*find_key(root, "time.safety"), "time.safety");
  for (const char* part : {"time.safety", "fraction of the stable step", "number", "above 0",
                           "at most 1", "default 0.9"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in " << text;
  }
}

TEST(DeckReference, JsonSchemaNamesEveryTopKey) {
  const KeyInfo root = deck_keys();
  const std::string schema = json_schema_text(root, "deck");
  for (const KeyInfo& key : root.children) {
    EXPECT_NE(schema.find("\"" + key.name + "\": {"), std::string::npos) << key.name;
  }
}

}  // namespace
}  // namespace brunt::deck
