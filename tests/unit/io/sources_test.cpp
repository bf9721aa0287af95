// Includes, overrides and the library on the tree, before any schema.
#include "io/deck/sources.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io/deck/yaml_reader.hpp"

namespace brunt {
namespace {

class SourcesTest : public ::testing::Test {
 protected:
  SourcesTest()
      : folder_(std::filesystem::temp_directory_path() /
                ("brunt_sources_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_ / "sub");
  }
  ~SourcesTest() override { std::filesystem::remove_all(folder_); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  /// The tree after overrides, as flow YAML; problems are appended.
  std::string overridden(const std::string& deck, const std::vector<std::string>& texts) {
    Node root = read_yaml(deck, "deck");
    problems_.clear();
    for (const Override& change : read_overrides(texts, problems_)) {
      apply_override(root, change, problems_);
    }
    return to_yaml(root);
  }
  std::filesystem::path folder_;
  std::vector<DeckProblem> problems_;
};

TEST_F(SourcesTest, TheIncludingFileWins) {
  write("sub/materials.yaml", "include: [base.yaml]\nm: {a: 2, b: 2}\nl: [1, 2]\n");
  write("sub/base.yaml", "m: {a: 1, z: 1}\n");
  const std::string deck = write("deck.yaml", "include: [sub/materials.yaml]\nm: {b: 3}\nl: [9]\n");
  const Node root = read_deck_file(deck);
  EXPECT_EQ(to_yaml(root), "m:\n  a: 2\n  z: 1\n  b: 3\nl: [9]\n");
  EXPECT_EQ(root.find("m")->find("z")->place.file, (folder_ / "sub/base.yaml").string());
}

TEST_F(SourcesTest, IncludesThatCannotBe) {
  const std::string missing = write("a.yaml", "include: [nowhere.yaml]\n");
  const std::string itself = write("b.yaml", "include: [b.yaml]\n");
  const std::string word = write("c.yaml", "include: b.yaml\n");
  for (const std::string& deck : {missing, itself, word, (folder_ / "none.yaml").string()}) {
    EXPECT_THROW(read_deck_file(deck), DeckError) << deck;
  }
}

TEST_F(SourcesTest, OverridesSetReplaceAndTakeOut) {
  const std::string deck = "a: {b: [1, 2, 3], c: x}\n";
  EXPECT_EQ(overridden(deck, {"a.b.1=7 mm"}), "a:\n  b: [1, 7 mm, 3]\n  c: x\n");
  EXPECT_EQ(overridden(deck, {"a.c=null"}), "a:\n  b: [1, 2, 3]\n");
  EXPECT_EQ(overridden(deck, {"a.b.0=null"}), "a:\n  b: [2, 3]\n  c: x\n");
  EXPECT_EQ(overridden(deck, {"d.e.f={g: 1}"}),
            "a:\n  b: [1, 2, 3]\n  c: x\nd:\n  e:\n    f:\n      g: 1\n");
  EXPECT_EQ(overridden(deck, {"a.c=1", "a.c=2"}), "a:\n  b: [1, 2, 3]\n  c: 2\n");
  EXPECT_TRUE(problems_.empty());
}

TEST_F(SourcesTest, WrongOverridesNameTheirNumber) {
  overridden("a: {b: [1], c: x}\n",
             {"a.c=1", "nothing", "=3", "a..b=1", "a.b.1=3", "a.c.d=1", "a.b=[", "a.x=null", "a="});
  ASSERT_EQ(problems_.size(), 8u);
  for (const DeckProblem& problem : problems_) {
    EXPECT_TRUE(problem.place.text().starts_with("--set #")) << problem.text();
  }
}

TEST_F(SourcesTest, LibraryValuesStandUnderTheDecks) {
  const Node library = read_yaml(
      "cu: {values: {density: 8960, strength: {jc: {A: 1, C: 2}}, thermal: {cp: 383, k: 386}}}\n",
      "library");
  Node map = read_yaml(
      "a: {library: cu, strength: {jc: {C: 0}}, thermal: {cp: 400}}\n"
      "b: {library: cu, strength: {j2: {yield: 5}}}\nc: {library: cv}\n",
      "deck");
  std::vector<DeckProblem> problems;
  expand_library(map, "materials", library, {"strength"}, problems);
  EXPECT_EQ(to_yaml(*map.find("a")),
            "density: 8960\nstrength:\n  jc:\n    A: 1\n    C: 0\nthermal:\n  cp: 400\n  k: 386\n");
  EXPECT_EQ(to_yaml(*map.find("b")->find("strength")), "j2:\n  yield: 5\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].path, "materials.c.library");
}

}  // namespace
}  // namespace brunt
