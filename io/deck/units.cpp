#include "io/deck/units.hpp"

#include <udunits2.h>

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/errors.hpp"
#include "io/deck/number.hpp"
#include "io/deck/suggest.hpp"

namespace brunt {

namespace {

constexpr std::array<const char*, Dimension::kBases> kBaseSymbols{"m", "kg",  "s",  "K",
                                                                  "A", "mol", "cd", "rad"};

struct UnitDeleter {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, UnitDeleter>;
struct ConverterDeleter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Converter = std::unique_ptr<cv_converter, ConverterDeleter>;

/// Collects the exponents of the base units of which a unit is made.
struct Exponents {
  Dimension dimension;
  bool linear = true;  ///< false: logarithmic, a date, or made of other bases
};

ut_status visit_basic(const ut_unit* unit, void* argument);
ut_status visit_product(const ut_unit*, int count, const ut_unit* const* units, const int* powers,
                        void* argument) {
  auto& exponents = *static_cast<Exponents*>(argument);
  for (int i = 0; i < count; ++i) {
    const char* symbol = ut_get_symbol(units[i], UT_ASCII);
    bool known = false;
    for (int base = 0; symbol && base < Dimension::kBases; ++base) {
      if (std::string_view(symbol) != kBaseSymbols[base]) continue;
      exponents.dimension.exponent[base] += powers[i];
      known = true;
    }
    if (!known) exponents.linear = false;
  }
  return UT_SUCCESS;
}
ut_status visit_basic(const ut_unit* unit, void* argument) {
  const int one = 1;
  return visit_product(unit, 1, &unit, &one, argument);
}
ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* argument) {
  static_cast<Exponents*>(argument)->linear = false;
  return UT_SUCCESS;
}
ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* argument) {
  static_cast<Exponents*>(argument)->linear = false;
  return UT_SUCCESS;
}
ut_status visit_galilean(const ut_unit*, double, const ut_unit* underlying, double, void* argument);
constexpr ut_visitor kVisitor{visit_basic, visit_product, visit_galilean, visit_timestamp,
                              visit_logarithmic};
ut_status visit_galilean(const ut_unit*, double, const ut_unit* underlying, double,
                         void* argument) {
  return ut_accept_visitor(underlying, &kVisitor, argument);
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Why the text of a unit is refused before UDUNITS sees it, or "".
std::string form_problem(std::string_view unit) {
  constexpr std::size_t kLongest = 48;
  if (unit.size() > kLongest) return "the unit is too long";
  bool divided = false;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    const char c = unit[i];
    if (c == '/') divided = true;
    if (c == ' ' && divided) {
      return "a blank after '/' could mean either: write W/m/K, not W/m K";
    }
    if (is_digit(c)) {
      std::size_t end = i;
      while (end < unit.size() && is_digit(unit[end])) ++end;
      const bool leading_one = i == 0 && unit.starts_with("1/");
      const bool exponent =
          i > 0 &&
          (is_letter(unit[i - 1]) || unit[i - 1] == '^' ||
           (unit[i - 1] == '-' && i > 1 && (is_letter(unit[i - 2]) || unit[i - 2] == '^')));
      if (!leading_one && !(exponent && end - i <= 1)) {
        return "'" + std::string(unit) + "' is not a unit; an expression begins with '='";
      }
      i = end - 1;
    } else if (!is_letter(c) && std::string_view("%/^-.* ()_").find(c) == std::string_view::npos) {
      return "'" + std::string(unit) + "' is not a unit";
    }
  }
  return "";
}

/// 10^shift where scale is a power of ten but for round-off, so that 3.81 mm is the double 3.81e-3.
std::optional<int> decimal_shift(double scale) {
  if (!(scale > 0)) return {};
  const double exponent = std::log10(scale);
  const double nearest = std::round(exponent);
  constexpr double kRoundOff = 1e-13;  // a few products of rounded prefixes
  if (std::abs(exponent - nearest) > kRoundOff || std::abs(nearest) > 60) return {};
  return static_cast<int>(nearest);
}

const std::vector<std::string>& common_units() {
  static const std::vector<std::string> kUnits{
      "m",   "mm",   "um",   "cm",     "km",     "s",      "ms",    "us",  "ns",
      "kg",  "g",    "t",    "K",      "degC",   "Pa",     "kPa",   "MPa", "GPa",
      "N",   "kN",   "J",    "kJ",     "W",      "deg",    "rad",   "rev", "rpm",
      "m/s", "km/h", "mm/s", "kg/m^3", "g/cm^3", "J/kg/K", "W/m/K", "%",   "1/s"};
  return kUnits;
}

std::string trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return std::string(text);
}

}  // namespace

Dimension Dimension::without_angle() const {
  Dimension result = *this;
  result.exponent[kAngle] = 0;
  return result;
}

std::string Dimension::text() const {
  std::string all;
  for (int base = 0; base < kBases; ++base) {
    if (exponent[base] == 0) continue;
    all += (all.empty() ? "" : " ") + std::string(kBaseSymbols[base]);
    if (exponent[base] != 1) all += "^" + std::to_string(exponent[base]);
  }
  return all.empty() ? "1" : all;
}

std::string Dimension::unit() const {
  std::string all;
  for (int base = 0; base < kBases; ++base) {
    if (exponent[base] == 0) continue;
    all += (all.empty() ? "" : ".") + std::string(kBaseSymbols[base]);
    if (exponent[base] != 1) all += std::to_string(exponent[base]);
  }
  return all.empty() ? "1" : all;
}

struct Units::Implementation {
  ut_system* system = nullptr;

  Unit parse(const std::string& text) const {
    return Unit(ut_parse(system, text.c_str(), UT_UTF8));
  }
  std::optional<Dimension> dimension(const Unit& unit) const {
    Exponents exponents;
    if (ut_accept_visitor(unit.get(), &kVisitor, &exponents) != UT_SUCCESS || !exponents.linear) {
      return {};
    }
    return exponents.dimension;
  }
};

Units::Units() : implementation_(std::make_unique<Implementation>()) {
  ut_set_error_message_handler(ut_ignore);
  implementation_->system = ut_read_xml(nullptr);
  if (implementation_->system == nullptr) {
    throw MachineError("cannot read the database of UDUNITS-2 (udunits2.xml)");
  }
  for (const auto& [name, meaning] : {std::pair{"deg", "arc_degree"}, {"rev", "revolution"}}) {
    const Unit unit = implementation_->parse(meaning);
    if (unit) ut_map_symbol_to_unit(name, UT_ASCII, unit.get());
  }
}

Units::~Units() { ut_free_system(implementation_->system); }

QuantityValue Units::read(std::string_view given) const {
  const std::string text = trimmed(given);
  QuantityValue quantity;
  NumberText number = leading_number(text);
  if (number.length == 0 || !number.problem.empty()) {
    quantity.problem = number.length == 0 ? "is not a number" : number.problem;
    return quantity;
  }
  quantity.value = number.value;
  const std::string unit_text = trimmed(std::string_view(text).substr(number.length));
  if (unit_text.empty()) return quantity;
  quantity.has_unit = true;
  if (unit_text.size() > 1 && unit_text[0] == ',' && unit_text[1] >= '0' && unit_text[1] <= '9') {
    quantity.problem = "decimals stand behind a point: 1.5";
    return quantity;
  }
  quantity.problem = form_problem(unit_text);
  if (!quantity.problem.empty()) return quantity;
  const Unit unit = implementation_->parse(unit_text);
  const auto dimension = unit ? implementation_->dimension(unit) : std::nullopt;
  if (!dimension) {
    const std::string near = nearest_word(unit_text, common_units());
    quantity.problem =
        "unknown unit '" + unit_text + "'" + (near.empty() ? "" : "; did you mean '" + near + "'?");
    return quantity;
  }
  quantity.dimension = *dimension;
  const Unit si = implementation_->parse(dimension->unit());
  const Converter converter(ut_get_converter(unit.get(), si.get()));
  if (!converter) {
    quantity.problem = "the unit '" + unit_text + "' cannot be converted";
    return quantity;
  }
  const double offset = cv_convert_double(converter.get(), 0);
  const double scale = cv_convert_double(converter.get(), 1);
  const auto shift = offset == 0 ? decimal_shift(scale) : std::nullopt;
  if (shift) number = leading_number(text, *shift);
  quantity.value = shift ? number.value : cv_convert_double(converter.get(), quantity.value);
  if (!number.problem.empty() || !std::isfinite(quantity.value)) {
    quantity.problem = "the number does not fit into a double";
  }
  return quantity;
}

Dimension Units::dimension_of(const std::string& unit) const {
  const Unit parsed = implementation_->parse(unit);
  const auto dimension = parsed ? implementation_->dimension(parsed) : std::nullopt;
  if (!dimension) throw std::logic_error("the schema names an unknown unit: " + unit);
  return *dimension;
}

std::string describe_unit(const std::string& unit) {
  static const std::map<std::string, std::string> kNames{
      {"m", "a length"},           {"kg", "a mass"},     {"s", "a time"},
      {"K", "a temperature"},      {"m/s", "a speed"},   {"m/s^2", "an acceleration"},
      {"kg/m^3", "a density"},     {"Pa", "a pressure"}, {"N", "a force"},
      {"J", "an energy"},          {"W", "a power"},     {"rad", "an angle"},
      {"rad/s", "a rate of spin"}, {"1/s", "a rate"},    {"J/kg/K", "a specific heat"},
      {"W/m/K", "a conductivity"}, {"m^2", "an area"},   {"kg m/s", "a momentum"}};
  if (unit == "1") return "a number";
  if (unit == "any") return "a number with its unit";
  const auto found = kNames.find(unit);
  return (found == kNames.end() ? "a quantity" : found->second) + " (" + unit + ")";
}

}  // namespace brunt
