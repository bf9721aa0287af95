// Strict numbers: what a YAML reader would guess differently from reader to reader is refused.
#include "io/deck/number.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

TEST(Number, ReadsDecimalNumbersOnly) {
  EXPECT_EQ(whole_number("0"), 0.0);
  EXPECT_EQ(whole_number("-1.5e3"), -1500.0);
  EXPECT_EQ(whole_number("+.5"), 0.5);
  EXPECT_EQ(whole_number("5."), 5.0);
  for (const char* text : {"", "-", ".", "e3", "0x10", "1_000", "1,5", "inf", "nan", "1 ", " 1",
                           "--1", "1e", "1e400", "010", "00", "-01"}) {
    EXPECT_FALSE(whole_number(text)) << text;
  }
}

TEST(Number, LeadingZeroIsRefusedWithTheWayOut) {
  const NumberText number = leading_number("010 mm");
  EXPECT_EQ(number.length, 3u);
  EXPECT_NE(number.problem.find("write '10'"), std::string::npos) << number.problem;
}

TEST(Number, ShiftRoundsOnce) {
  // 3.81 * 1e-3 rounds twice and misses the double 3.81e-3 by one unit; a shifted text does not.
  EXPECT_EQ(leading_number("3.81", -3).value, 3.81e-3);
  EXPECT_EQ(leading_number("25.4e1", -3).value, 0.254);
}

TEST(Number, ShortestTextReadsBack) {
  Real value = 1e-300;
  for (int i = 0; i < 2000; ++i) {
    EXPECT_EQ(whole_number(shortest_text(value)), value);
    value *= -1.9;
    if (!std::isfinite(value)) break;
  }
  EXPECT_EQ(shortest_text(0.1), "0.1");
}

}  // namespace
}  // namespace brunt
