// The patterns of the JSON schema against what the program reads: for each unit of the schema and
// many texts, made of signs, numbers and units, both say the same of kind and sign.
#include "io/deck/unit_pattern.hpp"

#include <gtest/gtest.h>

#include <regex>

#include "io/deck/reader.hpp"
#include "io/deck/units.hpp"

namespace brunt {
namespace {

const char* const kSi[] = {"1",   "m",     "s",      "kg",    "K",     "rad",
                           "m/s", "m/s^2", "s/m",    "1/s",   "rad/s", "kg/m^3",
                           "N",   "Pa",    "J/kg/K", "W/m/K", "W/m^2", "W/m^2/K"};

// As engineers write them, some of no kind that a deck has, and some that are none.
const char* const kTexts[] = {
    "m",         "mm",         "um",      "in",      "km",     "s",      "ms",     "us",
    "min",       "kg",         "g",       "t",       "K",      "degC",   "deg",    "rad",
    "mrad",      "rev",        "m/s",     "mm/s",    "km/h",   "m.s-1",  "m s-1",  "m/s^2",
    "mm/ms^2",   "m.s-2",      "s/m",     "ms/mm",   "1/s",    "s-1",    "Hz",     "kHz",
    "rad/s",     "rpm",        "rev/min", "deg/s",   "kg/m^3", "g/cm^3", "g/cm3",  "t/mm^3",
    "kg.m-3",    "kg m-3",     "t/m^3",   "N",       "kN",     "Pa",     "MPa",    "GPa",
    "kbar",      "psi",        "N/mm^2",  "kN/mm^2", "N/mm2",  "J/mm^3", "J/kg/K", "J/(kg K)",
    "kJ/kg/K",   "J.kg-1.K-1", "W/m/K",   "W/(m K)", "W/mm/K", "W/m^2",  "kW/m^2", "W/m^2/K",
    "W/(m^2 K)", "W/(m^2.K)",  "%",       "mm^2",    "m^3",    "N m",    "J",      "kJ",
    "Gpa",       "milimeter",  "mpa/s",   "m/s/s/s", "kg/m",   "Ns",     "x"};

const char* const kNumbers[] = {"1",  "2.5",     ".5", "3.",  "1e3", "-1",
                                "+4", "-2.5e-3", "0",  "0.0", "-0"};

TEST(UnitPattern, AgreesWithWhatIsRead) {
  const Units units;
  int n_match = 0;
  for (const std::string si : kSi) {
    for (const Range& range : {Range{}, at_least(0), positive()}) {
      const std::regex pattern(quantity_pattern(si, range));
      for (const std::string number : kNumbers) {
        for (const std::string text : kTexts) {
          const std::string whole = number + " " + text;
          const QuantityValue read = units.read(whole);
          // Of a temperature with an offset the pattern does not know the sign.
          const bool fits = read.problem.empty() && read.dimension == units.dimension_of(si);
          const bool inside = si == "K" || in_range(read.value, range);
          const bool minus_zero = number == "-0";  // is written with a sign
          if (minus_zero && fits) continue;
          EXPECT_EQ(std::regex_match(whole, pattern), fits && inside) << si << ": " << whole;
          n_match += fits && inside;
        }
      }
    }
  }
  EXPECT_GT(n_match, 500);
}

TEST(UnitPattern, TakesParametersExpressionsAndBareNumbers) {
  const std::regex length(quantity_pattern("m", positive()));
  for (const char* text : {"$size", "-$size", "= 2 * $size", "3", "3mm", "3  mm"}) {
    EXPECT_TRUE(std::regex_match(text, length)) << text;
  }
  for (const char* text : {"size", "2*$size", "3 mm mm", "mm", "", "1,5 mm", "-3", "0"}) {
    EXPECT_FALSE(std::regex_match(text, length)) << text;
  }
}

}  // namespace
}  // namespace brunt
