#include "io/vtk/colouring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/fields.hpp"

namespace brunt {

namespace {

constexpr std::array kTensor = {"xx", "yy", "zz", "xy", "yz", "zx"};

Real magnitude(const Real* value, int components) {
  Real sum = 0;
  for (int c = 0; c < components; ++c) {
    // Off-diagonal components of a tensor count twice.
    sum += (components == 6 && c >= 3 ? 2 : 1) * value[c] * value[c];
  }
  return std::sqrt(sum);
}

Real von_mises(const Real* s) {
  const Real normal = (s[xx] - s[yy]) * (s[xx] - s[yy]) + (s[yy] - s[zz]) * (s[yy] - s[zz]) +
                      (s[zz] - s[xx]) * (s[zz] - s[xx]);
  return std::sqrt(0.5 * normal + 3 * (s[xy] * s[xy] + s[yz] * s[yz] + s[zx] * s[zx]));
}

/// Index of a component, or nothing for the magnitude.
std::optional<int> component_index(const Field& field, const std::string& component) {
  if (component.empty() && field.components == 1) return 0;
  if (component.empty() || component == "magnitude") return std::nullopt;
  for (int c = 0; c < field.components; ++c) {
    const auto i = slot_of(c);
    if (field.components == 3 && component == kAxes[i]) return c;
    if (field.components == 6 && component == kTensor[i]) return c;
  }
  throw std::invalid_argument("field " + field.name + " has no component '" + component + "'");
}

std::vector<Real> values_of(const Field& field, const std::string& component) {
  const auto n = slot_of(field.components);
  const auto index = component_index(field, component);
  std::vector<Real> values(field.values.size() / n);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Real* value = field.values.data() + i * n;
    values[i] = index ? value[*index] : magnitude(value, field.components);
  }
  return values;
}

std::vector<Real> von_mises_of(const Field& stress) {
  std::vector<Real> values(stress.values.size() / 6);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = von_mises(&stress.values[6 * i]);
  return values;
}

}  // namespace

Colouring parse_colouring(const std::string& text) {
  const auto dot = text.find('.');
  if (dot == std::string::npos) return {text, ""};
  return {text.substr(0, dot), text.substr(dot + 1)};
}

Scalars scalars_of(const BodyView& view, const Colouring& colouring) {
  for (const bool on_cells : {true, false}) {
    const auto& fields = on_cells ? view.cell_fields : view.point_fields;
    if (const Field* field = field_named(fields, colouring.field)) {
      return {on_cells, values_of(*field, colouring.component)};
    }
    const Field* stress = colouring.field == "von_mises" ? field_named(fields, "stress") : nullptr;
    if (stress != nullptr && stress->components == 6) return {on_cells, von_mises_of(*stress)};
  }
  return {};
}

bool deforms(const BodyView& view) {
  for (const char* name : {"stress", "von_mises", "pressure", "eps_p", "density", "strain_rate"}) {
    if (field_named(view.cell_fields, name) || field_named(view.point_fields, name)) return true;
  }
  return false;
}

std::string unit_of(const std::string& field) {
  const FieldInfo* info = field_info(field);
  std::string unit = info != nullptr ? info->unit : "";
  if (unit == "1") return "";
  for (const auto& [power, sign] : {std::pair("^2", "²"), std::pair("^3", "³")}) {
    if (const auto at = unit.find(power); at != std::string::npos) unit.replace(at, 2, sign);
  }
  return unit;
}

bool shows_from_zero(const std::string& field) { return field != "temperature"; }

DisplayUnit display_unit(Real largest, const std::string& unit) {
  static constexpr std::array<std::pair<Real, const char*>, 7> prefixes = {
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1, ""}, {1e-3, "m"}, {1e-6, "µ"}, {1e-9, "n"}}};
  if (unit != "Pa" && unit != "N" && unit != "m" && unit != "s") return {1, unit};
  for (const auto& [size, prefix] : prefixes) {
    if ((unit == "m" || unit == "s") && size > 1) continue;
    if (largest >= size * (1 - 1e-12)) return {1 / size, prefix + unit};
  }
  return {1, unit};
}

std::vector<Real> ticks(const Interval& range, int count) {
  const Real width = range.high - range.low;
  if (!(width > 0)) return {range.low};
  const Real rough = width / count;
  const Real power = std::pow(10.0, std::floor(std::log10(rough)));
  Real step = 10 * power;
  for (const Real round : {5.0, 2.5, 2.0, 1.0}) {
    if (round * power >= rough * (1 - 1e-9)) step = round * power;
  }
  std::vector<Real> result;
  const Real first = std::ceil(range.low / step - 1e-9);
  for (Real k = first; k * step <= range.high + 1e-9 * width; k += 1) {
    result.push_back(k * step + 0.0);  // no -0
  }
  return result;
}

}  // namespace brunt
// Tested by tests/unit/io/render_test.cpp.
