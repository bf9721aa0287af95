// Variants of a small deck: their names, decks and sizes, written out by hand.
#include "app/trade/variants.hpp"

#include <gtest/gtest.h>

#include "io/file.hpp"
#include "tests/support/own_file.hpp"

namespace brunt {
namespace {

constexpr const char* kVariantsDeck = R"yaml(
parameters: {size: 0.1, cells: 4}
time: {end: 1}
materials: {m: {density: 1000, elastic: {E: 1e9, nu: 0.3}}}
bodies:
  a: {material: m, shape: {box: {min: [0, 0, 0], max: [1, 1, 1]}}, size: $size}
  b:
    material: m
    shape: {box: {min: [2, 0, 0], max: [3, 1, 1]}}
    cells: [$cells, 1, 1]
  f: {rigid: true, shape: {plane: {origin: [0, 0, -9], normal: z, extent: 4}}}
measures: {length: {extent: {body: a, axis: x}}}
)yaml";

class Variants : public testing::Test {
 protected:
  std::vector<Variant> make(const std::vector<std::string>& vary, Design design = Design::grid) {
    write_file_atomically(deck_, kVariantsDeck);
    return make_variants(deck_, {}, read_varies(vary), design);
  }
  std::string deck_ = test::own_file("variants.yaml");
};

std::vector<std::string> labels_of(const std::vector<Variant>& variants) {
  std::vector<std::string> labels;
  for (const auto& variant : variants) labels.push_back(variant.label);
  return labels;
}

TEST_F(Variants, KeysAndValuesAreReadWithBrackets) {
  const auto varies = read_varies({"a.size=1 mm, 2 mm", "b.v+c.v=[1, 2],[3, 4]"});
  ASSERT_EQ(varies.size(), 2u);
  EXPECT_EQ(varies[0].values, (std::vector<std::string>{"1 mm", "2 mm"}));
  EXPECT_EQ(varies[0].label, "size");
  EXPECT_EQ(varies[1].keys, (std::vector<std::string>{"b.v", "c.v"}));
  EXPECT_EQ(varies[1].values, (std::vector<std::string>{"[1, 2]", "[3, 4]"}));
  // Ends of keys that are the same are longer.
  EXPECT_EQ(read_varies({"a.size=1", "b.size=1"})[1].label, "b.size");
  EXPECT_THROW(read_varies({"size"}), DeckError);
  EXPECT_THROW(read_varies({"size=1,,2"}), DeckError);
  EXPECT_THROW(read_varies({"size=1", "size=2"}), DeckError);
}

TEST_F(Variants, GridAndOneAtATime) {
  const auto grid = make({"parameters.size=0.1,0.2", "time.safety=0.5,0.8"});
  EXPECT_EQ(labels_of(grid),
            (std::vector<std::string>{"size 0.1, safety 0.5", "size 0.1, safety 0.8",
                                      "size 0.2, safety 0.5", "size 0.2, safety 0.8"}));
  EXPECT_EQ(grid[2].folder, "size-0.2-safety-0.5");
  EXPECT_EQ(grid[3].overrides,
            (std::vector<std::string>{"parameters.size=0.2", "time.safety=0.8"}));
  EXPECT_EQ(grid[3].loaded.deck.time.safety, 0.8);
  // size 0.1 is the deck as it stands: it runs once.
  const auto single = make({"parameters.size=0.1,0.2", "time.safety=0.5"}, Design::one_at_a_time);
  EXPECT_EQ(labels_of(single),
            (std::vector<std::string>{"as it stands", "size 0.2", "safety 0.5"}));
}

TEST_F(Variants, AllThatIsWrongIsSaid) {
  try {
    make({"parameters.size=0.1,-1", "time.safty=0.5"});
    FAIL() << "accepted a wrong deck";
  } catch (const DeckError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("safty"), std::string::npos) << text;
    EXPECT_NE(text.find("size"), std::string::npos) << text;
  }
}

TEST_F(Variants, SizesAreComparedOfBodiesThatDeform) {
  const auto sizes = make({"parameters.size=0.1,0.2"});
  EXPECT_DOUBLE_EQ(*size_ratio(sizes[1].loaded.deck, sizes[0].loaded.deck), 2);
  const auto cells = make({"parameters.cells=4,8"});
  EXPECT_DOUBLE_EQ(*size_ratio(cells[1].loaded.deck, cells[0].loaded.deck), 0.5);
  EXPECT_FALSE(size_ratio(make({"time.safety=0.5"})[0].loaded.deck, sizes[0].loaded.deck));
  // One body finer and the other coarser is no refinement.
  const auto apart = make({"parameters.size=0.1,0.2", "parameters.cells=4,8"});
  EXPECT_FALSE(size_ratio(apart[0].loaded.deck, apart[3].loaded.deck));
}

TEST_F(Variants, SeriesDifferInTheirSizeAlone) {
  const auto variants = make({"parameters.size=0.1,0.2,0.4", "time.safety=0.5,0.8"});
  const auto series = size_series(variants, 2);
  ASSERT_EQ(series.size(), 2u);  // one for each safety
  EXPECT_EQ(series[0].vary, 0u);
  EXPECT_EQ(series[0].variants, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(series[1].variants, (std::vector<std::size_t>{1, 3, 5}));
  EXPECT_DOUBLE_EQ(series[0].sizes[2], 4);
}

TEST_F(Variants, AnOverrideMayLeaveAParameterUnused) {
  const auto variants = make({"bodies.a.size=0.1,0.2"});
  EXPECT_EQ(variants.size(), 2u);
  // What the deck itself does not use is missed somewhere, and one of the call is misspelt.
  EXPECT_THROW(make({"parameters.sise=0.1,0.2"}), DeckError);
}

}  // namespace
}  // namespace brunt
