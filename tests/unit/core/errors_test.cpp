#include "core/errors.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(Errors, APlaceIsFileLineAndColumn) {
  EXPECT_EQ((SourcePlace{"bar.yaml", 3, 7}).text(), "bar.yaml:3:7");
  EXPECT_EQ((SourcePlace{"--set #2", 0, 0}).text(), "--set #2");
}

TEST(Errors, AProblemSaysWhereWhichKeyAndWhat) {
  const DeckProblem problem{{"bar.yaml", 3, 7}, "materials.copper.density", "must be above 0"};
  for (const char* part : {"bar.yaml:3:7", "materials.copper.density", "must be above 0"}) {
    EXPECT_NE(problem.text().find(part), std::string::npos) << problem.text();
  }
}

TEST(Errors, ADeckErrorKeepsAllProblemsAndTellsThem) {
  const DeckError error({{{"a", 1, 1}, "x", "first"}, {{"a", 2, 1}, "y", "second"}});
  ASSERT_EQ(error.problems().size(), 2U);
  EXPECT_EQ(error.problems()[1].path, "y");
  for (const char* part : {"first", "second"}) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(Errors, APhysicsErrorSaysTimeBodyEntityQuantityAndCause) {
  const PhysicsError error({2.5e-6, "bar", "element 12", "volume", -0.25, "the size is too large"});
  for (const char* part : {"2.5e-06", "bar", "element 12", "volume", "-0.25", "too large"}) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  EXPECT_EQ(error.failure().body, "bar");
}

}  // namespace
}  // namespace brunt
