#include "app/scene/field_values.hpp"

#include <cmath>
#include <stdexcept>

namespace brunt {

namespace {
int component(const Field& field, const std::string& suffix) {
  static constexpr const char* tensor[] = {"xx", "yy", "zz", "xy", "yz", "zx"};
  for (int c = 0; c < field.components; ++c) {
    if (suffix == (field.components == 3 ? kAxes[c] : tensor[c])) return c;
  }
  if (field.components == 6 && suffix == "xz") return zx;
  throw std::invalid_argument("the field '" + field.name + "' has no component '" + suffix + "'");
}

std::vector<Real> pick(const Field& field, const std::string& suffix) {
  const auto n = field.values.size() / slot_of(field.components);
  if (field.components == 1) return field.values;
  std::vector<Real> values(n);
  const bool magnitude = suffix == "magnitude" || suffix.empty();
  const int c = magnitude ? 0 : component(field, suffix);
  for (std::size_t i = 0; i < n; ++i) {
    const Real* v = &field.values[i * slot_of(field.components)];
    if (!magnitude) {
      values[i] = v[c];
      continue;
    }
    Real square = 0;
    for (int k = 0; k < field.components; ++k) square += (k > 2 ? 2 : 1) * v[k] * v[k];
    values[i] = std::sqrt(square);
  }
  return values;
}
}  // namespace

std::size_t nearest_entity(const BodyView& start, const std::vector<Real>& at, bool cells) {
  const auto corners = slot_of(cells ? start.corners : 1);
  const std::size_t n = cells ? start.connectivity.size() / corners : start.position.size() / 3;
  std::size_t best = 0;
  Real smallest = kInfinity;
  for (std::size_t e = 0; e < n; ++e) {
    Real square = 0;
    for (std::size_t c = 0; c < at.size(); ++c) {
      Real x = 0;
      for (std::size_t k = 0; k < corners; ++k) {
        const auto p = cells ? slot_of(start.connectivity[e * corners + k]) : e;
        x += start.position[3 * p + c] / static_cast<Real>(corners);
      }
      square += (x - at[c]) * (x - at[c]);
    }
    if (square < smallest) smallest = square, best = e;
  }
  return best;
}

std::vector<Real> field_values(const BodyView& view, const std::string& field,
                               std::vector<Real>* weights) {
  const auto dot = field.find('.');
  const std::string name = field.substr(0, dot);
  const std::string suffix = dot == std::string::npos ? "" : field.substr(dot + 1);
  if (const Field* found = field_named(view.point_fields, name)) {
    if (weights) *weights = view.point_mass;
    return pick(*found, suffix);
  }
  if (const Field* found = field_named(view.cell_fields, name)) {
    if (weights) *weights = view.cell_volume;
    return pick(*found, suffix);
  }
  throw std::invalid_argument("the body '" + view.body + "' has no field '" + name + "'");
}

}  // namespace brunt
