#include "io/deck/suggest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace brunt {
namespace {

TEST(Suggest, EditDistance) {
  EXPECT_EQ(edit_distance("density", "density"), 0);
  EXPECT_EQ(edit_distance("densty", "density"), 1);   // one letter missing
  EXPECT_EQ(edit_distance("dnesity", "density"), 1);  // two neighbours swapped
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);   // the textbook example
  EXPECT_EQ(edit_distance("", "abc"), 3);
}

TEST(Suggest, NamesWhatWasMeantAndNothingElse) {
  const std::vector<std::string> known{"density", "elastic", "cp", "k"};
  EXPECT_EQ(nearest_word("densiti", known), "density");
  EXPECT_EQ(nearest_word("velocity", known), "");
  EXPECT_EQ(nearest_word("q", known), "");  // any letter is one change away from k
  const std::vector<std::string> units{"m", "s", "ms", "us", "Pa", "MPa", "GPa"};
  EXPECT_EQ(nearest_word("Us", units), "us");  // nearer than ms, which is as far by letters
  EXPECT_EQ(nearest_word("gpa", units), "GPa");
  EXPECT_EQ(nearest_word("DENSITY", known), "density");
  const std::vector<std::string> sections{"title", "bodies", "body_forces"};
  EXPECT_EQ(nearest_word("body", sections), "bodies");
  EXPECT_EQ(nearest_word("bodys", sections), "bodies");
  EXPECT_EQ(suggestion("elastc", known), "; did you mean 'elastic'?");
  EXPECT_EQ(suggestion("zzzzzz", known), "; known are density, elastic, cp, k");
}

}  // namespace
}  // namespace brunt
