#include "io/deck/unit_pattern.hpp"

#include <map>
#include <vector>

namespace brunt {

namespace {
/// A kind of unit to a power: {"L", -3} is a length^-3.
struct Factor {
  const char* kind;
  int power;
};
using Product = std::vector<Factor>;

/// The symbols of a kind of unit.
const std::string& symbols_of(const std::string& kind) {
  static const std::string kPrefix = "(?:da|[yzafpnuµmcdhkMGTPEZY])?";
  static const std::map<std::string, std::string> kSymbols{
      {"L", "(?:" + kPrefix + "m|in|inch|ft|yd|mile)"},
      {"T", "(?:" + kPrefix + "s|min|h|d|day)"},
      {"M", "(?:" + kPrefix + "[gt]|lb)"},
      {"K", "(?:" + kPrefix + "K|degC|degF|°C|°F)"},
      {"A", "(?:" + kPrefix + "rad|deg|°|rev)"},
      {"F", "(?:" + kPrefix + "N|lbf|kgf)"},
      {"P", "(?:" + kPrefix + "(?:Pa|bar)|psi|atm)"},
      {"E", "(?:" + kPrefix + "(?:J|eV)|cal|kcal)"},
      {"W", "(?:" + kPrefix + "W|hp)"},
      {"Hz", "(?:" + kPrefix + "Hz)"},
      {"rpm", "(?:rpm)"},
      {"%", "(?:%)"}};
  return kSymbols.at(kind);
}

/// The products that have the dimension of an SI unit; none: it is not known here.
const std::vector<Product>& products_of(const std::string& unit) {
  static const std::map<std::string, std::vector<Product>> kProducts{
      {"1", {{{"%", 1}}}},
      {"m", {{{"L", 1}}}},
      {"s", {{{"T", 1}}}},
      {"kg", {{{"M", 1}}}},
      {"K", {{{"K", 1}}}},
      {"rad", {{{"A", 1}}}},
      {"m/s", {{{"L", 1}, {"T", -1}}}},
      {"m/s^2", {{{"L", 1}, {"T", -2}}, {{"F", 1}, {"M", -1}}}},
      {"s/m", {{{"T", 1}, {"L", -1}}}},
      {"1/s", {{{"T", -1}}, {{"Hz", 1}}}},
      {"rad/s", {{{"A", 1}, {"T", -1}}, {{"rpm", 1}}}},
      {"kg/m^3", {{{"M", 1}, {"L", -3}}}},
      {"N", {{{"F", 1}}, {{"M", 1}, {"L", 1}, {"T", -2}}}},
      {"Pa", {{{"P", 1}}, {{"F", 1}, {"L", -2}}, {{"E", 1}, {"L", -3}}}},
      {"J/kg/K", {{{"E", 1}, {"M", -1}, {"K", -1}}}},
      {"W/m/K", {{{"W", 1}, {"L", -1}, {"K", -1}}}},
      {"W/m^2", {{{"W", 1}, {"L", -2}}}},
      {"W/m^2/K", {{{"W", 1}, {"L", -2}, {"K", -1}}}}};
  static const std::vector<Product> kNone;
  const auto found = kProducts.find(unit);
  return found == kProducts.end() ? kNone : found->second;
}

std::string power_of(const Factor& factor, int power) {
  const std::string symbol = symbols_of(factor.kind);
  return power == 1 ? symbol : symbol + "\\^?" + std::to_string(power);
}

/// a/b^2/c, a/(b^2.c) and a.b-2.c-1 of a product.
std::string product_pattern(const Product& product) {
  std::string above, divided, inside, negative;
  int n_below = 0;
  for (const Factor& factor : product) {
    if (factor.power > 0) {
      above += (above.empty() ? "" : "[ .*]") + power_of(factor, factor.power);
      continue;
    }
    ++n_below;
    divided += "/" + power_of(factor, -factor.power);
    inside += (inside.empty() ? "" : "[.*]") + power_of(factor, -factor.power);
    negative += (above.empty() && negative.empty() ? "" : "[ .*]") + power_of(factor, factor.power);
  }
  if (n_below == 0) return above;
  const std::string over = above.empty() ? "1" : above;
  const std::string whole = n_below > 1 ? "|" + over + "/\\(" + inside + "\\)" : "";
  return over + divided + whole + "|" + above + negative;
}
}  // namespace

std::string parameter_pattern() { return "-?\\$[A-Za-z_][A-Za-z0-9_]*|=.*"; }

std::string quantity_pattern(const std::string& unit, const Range& range) {
  std::string units;
  for (const Product& product : products_of(unit)) {
    units += (units.empty() ? "" : "|") + product_pattern(product);
  }
  if (units.empty()) units = ".*";
  // A temperature below 0 degC is above 0 K.
  const bool offset = unit == "K";
  const bool positive = !offset && range.min >= 0;
  const std::string not_zero = positive && range.min == 0 && range.min_excluded
                                   ? "(?![+]?[0.]+(?:[eE][+-]?[0-9]+)?(?![0-9.]|[eE][+-]?[0-9]))"
                                   : "";
  const std::string number = not_zero + (positive ? "[+]?" : "[+-]?") +
                             "(?:[0-9]+\\.?[0-9]*|\\.[0-9]+)(?:[eE][+-]?[0-9]+)?";
  return "^(?:" + parameter_pattern() + "|" + number + " *(?:" + units + ")?)$";
}

}  // namespace brunt
