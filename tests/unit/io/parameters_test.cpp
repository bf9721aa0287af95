#include "io/deck/parameters.hpp"

#include <gtest/gtest.h>

#include "io/deck/yaml_reader.hpp"

namespace brunt {
namespace {

class ParametersTest : public ::testing::Test {
 protected:
  std::string resolved(const std::string& deck) {
    Node root = read_yaml(deck, "deck");
    problems_.clear();
    parameters_ = resolve_parameters(
        root, units_, [&](const std::string& path) { return path == "formula" ? &own_ : nullptr; },
        problems_);
    return to_yaml(root);
  }
  Units units_;
  const std::set<std::string> own_{"other"};
  std::vector<Parameter> parameters_;
  std::vector<DeckProblem> problems_;
};

TEST_F(ParametersTest, StandForValues) {
  EXPECT_EQ(resolved("parameters: {speed: 139 m/s, way: [1, 2 mm], word: cubic}\n"
                     "v: [0, -$speed, $speed]\nw: $way\nk: $word\nt: \"at $speed for 5 $$\"\n"),
            "v: [0, -139 m.s-1, 139 m/s]\nw: [1, 2 mm]\nk: cubic\nt: at 139 m/s for 5 $\n");
  EXPECT_TRUE(problems_.empty());
}

TEST_F(ParametersTest, OfOtherParameters) {
  EXPECT_EQ(resolved("parameters: {half: = $size/2, size: $base, base: 8 mm}\na: $half\n"),
            "a: 0.004 m\n");
  EXPECT_TRUE(problems_.empty());
}

TEST_F(ParametersTest, NegativeOfATemperatureIsThatOfItsValue) {
  EXPECT_EQ(resolved("parameters: {T: 20 degC}\na: -$T\n"), "a: -293.15 K\n");
}

TEST_F(ParametersTest, ProblemsHaveTheirPlaces) {
  resolved("parameters:\n  unused: 1\n  a: = $b\n  b: = $a\ny: $a\n");
  std::string all;
  for (const DeckProblem& problem : problems_) all += problem.text() + "\n";
  EXPECT_NE(all.find("deck:2:3: parameters.unused: is not used"), std::string::npos) << all;
  EXPECT_NE(all.find("depends on itself"), std::string::npos) << all;
}

// What nothing uses may be what is missed, and is not reported beside it.
TEST_F(ParametersTest, UndeclaredOnesAreToldOnce) {
  resolved("parameters:\n  unused: 1\nx: $nobody\ny: -$nobody\nz: \"= 2*$gone\"\n");
  ASSERT_EQ(problems_.size(), 2u);
  EXPECT_EQ(problems_[0].text(),
            "deck:3:4: x: the parameter $nobody is not declared; known are unused; it is used 2 "
            "times");
  EXPECT_EQ(problems_[1].text(),
            "deck:5:4: z: the parameter $gone is not declared; known are unused");
}

TEST_F(ParametersTest, FormulasKeepTheirOwnNames) {
  EXPECT_EQ(resolved("formula: \"= $a / $b\"\n"), "formula: \"= $a / $b\"\n");
  EXPECT_TRUE(problems_.empty());
  EXPECT_EQ(resolved("parameters: {a: 3 mm, other: 2}\nformula: \"= $a / $other + $b\"\n"),
            "formula: \"= (0.003) / $other + $b\"\n");
  EXPECT_TRUE(problems_.empty());
}

TEST_F(ParametersTest, DoublingTextsAreStopped) {
  std::string deck = "parameters:\n  p0: aaaaaaaaaa\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "$p" + std::to_string(i - 1);
    deck += "  p" + std::to_string(i) + ": \"" + before + " " + before + "\"\n";
  }
  resolved(deck + "a: $p39\n");
  EXPECT_FALSE(problems_.empty());
  std::string lists = "parameters:\n  p0: [1, 1]\n";
  for (int i = 1; i < 40; ++i) {
    const std::string before = "$p" + std::to_string(i - 1);
    lists += "  p" + std::to_string(i) + ": [" + before + ", " + before + "]\n";
  }
  resolved(lists + "a: $p39\n");
  EXPECT_FALSE(problems_.empty());
}

}  // namespace
}  // namespace brunt
