// Quantities: values to the last bit where the factor is a power of ten, else to 4 units in the
// last place (one product and a rounded factor).
#include "io/deck/units.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

class UnitsTest : public ::testing::Test {
 protected:
  void expect(const char* text, const char* unit, Real value) const {
    const QuantityValue read = units_.read(text);
    EXPECT_EQ(read.problem, "") << text;
    EXPECT_DOUBLE_EQ(read.value, value) << text;
    EXPECT_EQ(read.dimension, units_.dimension_of(unit)) << text << " " << read.dimension.text();
  }
  std::string problem(const char* text) const { return units_.read(text).problem; }
  Units units_;
};

TEST_F(UnitsTest, TheUnitsOfDecks) {
  expect("139 m/s", "m/s", 139);
  expect("0.2mm", "m", 0.2e-3);
  expect("70 GPa", "Pa", 70e9);
  expect("20 degC", "K", 293.15);
  expect("6 deg", "rad", 6 * kPi / 180);
  expect("2 rev", "rad", 4 * kPi);
  expect("3000 rpm", "rad/s", 3000 * 2 * kPi / 60);
  expect("1 1/s", "1/s", 1);
  expect("5 %", "1", 0.05);
  expect("170 W/m/K", "W/m/K", 170);
  expect("383 J/kg/K", "J/kg/K", 383);
  expect("383 J/kg/degC", "J/kg/K", 383);
  expect("-9.81 m/s^2", "m/s^2", -9.81);
  expect("-9.81 m/s2", "m/s^2", -9.81);
  expect("2.7 g/cm^3", "kg/m^3", 2700);
  expect("36 km/h", "m/s", 10);
  expect("80 us", "s", 80e-6);
  expect("3 kg.m2.s-1", "kg m^2/s", 3);
}

TEST_F(UnitsTest, DecimalPrefixesAreExact) {
  EXPECT_EQ(units_.read("3.81 mm").value, 3.81e-3);
  EXPECT_EQ(units_.read("428.5 MPa").value, 428.5e6);
  EXPECT_EQ(units_.read("0.1 us").value, 1e-7);
}

TEST_F(UnitsTest, BareNumbersAreSi) {
  const QuantityValue read = units_.read("298");
  EXPECT_EQ(read.value, 298);
  EXPECT_FALSE(read.has_unit);
}

TEST_F(UnitsTest, AnglesAreADimension) {
  EXPECT_NE(units_.read("10 Hz").dimension, units_.dimension_of("rad/s"));
  EXPECT_NE(units_.read("10 1/s").dimension, units_.dimension_of("rad/s"));
  EXPECT_NE(units_.read("10 deg").dimension, units_.dimension_of("1"));
  EXPECT_EQ(units_.read("10 Hz").dimension, units_.dimension_of("1/s"));
}

TEST_F(UnitsTest, WrongUnitsAreRefused) {
  EXPECT_NE(problem("3 W/m K").find("write W/m/K"), std::string::npos);
  EXPECT_NE(problem("3 Gpa").find("did you mean 'GPa'"), std::string::npos);
  EXPECT_NE(problem("0.4 mm/2").find("an expression begins with '='"), std::string::npos);
  for (const char* text : {"3 dB", "3 s since 2000", "3 m^99999999999", "1 2", "3 m m3m3m3", "x",
                           "3 furlongs per fortnightly", "3 [m]", "3 m^", "010 m", "1e999 m",
                           "1e308 km", "3 m/", "3 (m"}) {
    EXPECT_NE(problem(text), "") << text;
  }
}

TEST_F(UnitsTest, DescribesWhatIsExpected) {
  EXPECT_EQ(describe_unit("kg/m^3"), "a density (kg/m^3)");
  EXPECT_EQ(describe_unit("1"), "a number");
}

}  // namespace
}  // namespace brunt
