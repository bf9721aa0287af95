#include "app/scene/place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/scene/field_values.hpp"
#include "fe/elements/catalog.hpp"

namespace brunt {

namespace {

/// Solves the n x n system a x = b by elimination with pivots; nothing where it is singular.
template <std::size_t N>
std::optional<std::array<Real, N>> solved(std::array<std::array<Real, N>, N> a,
                                          std::array<Real, N> b, std::size_t n) {
  Real largest = 0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::fabs(a[i][i]));
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i) {
      if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
    }
    if (!(std::fabs(a[pivot][k]) > 1e-12 * largest)) return std::nullopt;
    std::swap(a[k], a[pivot]), std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// Weights of the corners of an element at a place; nothing where it does not hold the place.
std::optional<std::vector<Real>> weights_in(const BodyView& view, const ElementType& type,
                                            std::size_t cell, const std::vector<Real>& at) {
  const std::size_t dim = at.size(), corners = slot_of(view.corners);
  const auto x = [&](std::size_t I, std::size_t c) {
    return view.position[3 * slot_of(view.connectivity[cell * corners + I]) + c];
  };
  for (std::size_t c = 0; c < dim; ++c) {
    Real low = kInfinity, high = -kInfinity;
    for (std::size_t I = 0; I < corners; ++I) {
      low = std::min(low, x(I, c)), high = std::max(high, x(I, c));
    }
    const Real slack = 1e-9 * (high - low);
    if (at[c] < low - slack || at[c] > high + slack) return std::nullopt;
  }
  constexpr int kIterations = 30;  // Newton's method takes some five
  constexpr Real kOnAFace = 1e-9;  // of the local coordinates, which rounding moves
  LocalPlace xi = type.center;
  ShapeValues shape;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    type.shape(xi, shape);
    std::array<std::array<Real, 3>, 3> jacobian{};
    std::array<Real, 3> left{};
    for (std::size_t c = 0; c < dim; ++c) {
      left[c] = at[c];
      for (std::size_t I = 0; I < corners; ++I) {
        left[c] -= shape.value[I] * x(I, c);
        for (std::size_t j = 0; j < dim; ++j) jacobian[c][j] += shape.slope[I][j] * x(I, c);
      }
    }
    const auto step = solved(jacobian, left, dim);
    if (!step) return std::nullopt;
    Real longest = 0;
    for (std::size_t j = 0; j < dim; ++j) {
      xi[j] = std::clamp(xi[j] + (*step)[j], -2.0, 2.0);
      longest = std::max(longest, std::fabs((*step)[j]));
    }
    if (longest > 1e-13) continue;
    break;
  }
  if (!type.snap(xi, kOnAFace)) return std::nullopt;
  type.shape(xi, shape);
  return std::vector<Real>(shape.value.begin(),
                           shape.value.begin() + static_cast<std::ptrdiff_t>(corners));
}

Real distance_to(const BodyView& view, std::size_t point, const std::vector<Real>& at) {
  Real square = 0;
  for (std::size_t c = 0; c < at.size(); ++c) {
    const Real d = view.position[3 * point + c] - at[c];
    square += d * d;
  }
  return std::sqrt(square);
}

/// Moving least squares about `at`, in the order of the view; nothing where the particles within
/// reach lie in a plane or a line.
bool weigh_particles(const BodyView& view, const std::vector<Real>& at, Real reach, Place& place) {
  const std::size_t n = at.size() + 1;
  std::array<std::array<Real, 4>, 4> moment{};
  std::vector<std::size_t> points;
  std::vector<std::array<Real, 4>> terms;
  std::vector<Real> kernel;
  std::vector<unsigned> reflected;
  const auto add = [&](std::size_t i, unsigned axes) {
    std::array<Real, 4> term{1, 0, 0, 0};
    Real square = 0;
    for (std::size_t c = 0; c < at.size(); ++c) {
      const Real own = view.position[3 * i + c];
      const Real x = ((axes >> c) & 1U) != 0 ? 2 * *view.mirrors[c] - own : own;
      square += (x - at[c]) * (x - at[c]);
      term[c + 1] = (x - at[c]) / reach;
    }
    const Real far = std::sqrt(square) / reach;
    if (far >= 1) return;
    const Real w = (1 - far * far) * (1 - far * far);
    for (std::size_t a = 0; a < n; ++a) {
      for (std::size_t b = 0; b < n; ++b) moment[a][b] += w * term[a] * term[b];
    }
    points.push_back(i), terms.push_back(term), kernel.push_back(w), reflected.push_back(axes);
  };
  unsigned planes = 0;
  for (std::size_t c = 0; c < at.size(); ++c) {
    if (view.mirrors[c]) planes |= 1U << c;
  }
  for (std::size_t i = 0; i < view.position.size() / 3; ++i) {
    for (unsigned axes = 0; axes <= planes; ++axes) {
      if ((axes & ~planes) == 0) add(i, axes);
    }
  }
  const auto solution = solved(moment, std::array<Real, 4>{1, 0, 0, 0}, n);
  if (!solution) return false;
  place.points = points, place.reflected = reflected;
  for (std::size_t k = 0; k < points.size(); ++k) {
    Real sum = 0;
    for (std::size_t a = 0; a < n; ++a) sum += (*solution)[a] * terms[k][a];
    place.weights.push_back(kernel[k] * sum);
  }
  return true;
}

Real centre_distance(const BodyView& view, std::size_t cell, const std::vector<Real>& at) {
  const auto corners = slot_of(view.corners);
  Real square = 0;
  for (std::size_t c = 0; c < at.size(); ++c) {
    Real x = 0;
    for (std::size_t I = 0; I < corners; ++I) {
      const auto p = slot_of(view.connectivity[cell * corners + I]);
      x += view.position[3 * p + c] / static_cast<Real>(corners);
    }
    square += (x - at[c]) * (x - at[c]);
  }
  return std::sqrt(square);
}
}  // namespace

Place find_place(const BodyView& start, const std::vector<Real>& at) {
  Place place;
  const auto corners = slot_of(start.corners);
  const std::size_t nearest = nearest_entity(start, at, false);
  const auto dimension = static_cast<int>(at.size());
  const ElementType* type =
      start.cell_dimension == dimension ? element_type(dimension, start.corners) : nullptr;
  if (type != nullptr) {
    for (std::size_t cell = 0; cell < start.connectivity.size() / corners; ++cell) {
      const auto weights = weights_in(start, *type, cell, at);
      if (!weights) continue;
      place.cell = cell, place.weights = *weights;
      for (std::size_t I = 0; I < corners; ++I) {
        place.points.push_back(slot_of(start.connectivity[cell * corners + I]));
        place.reflected.push_back(0);
      }
      return place;
    }
  } else if (corners == 0 && !start.point_radius.empty()) {
    // A particle stands for a cube of one spacing; its corner is sqrt(dim) radii away.
    const Real radius = start.point_radius[nearest];
    const Real within = (1 + 1e-9) * std::sqrt(static_cast<Real>(at.size())) * radius;
    if (distance_to(start, nearest, at) <= within &&
        weigh_particles(start, at, 4 * radius, place)) {
      return place;
    }
  }
  place.points = {nearest}, place.weights = {1}, place.reflected = {0};
  place.point_distance = distance_to(start, nearest, at);
  if (corners > 0) {
    place.cell = nearest_entity(start, at, true);
    place.cell_distance = centre_distance(start, place.cell, at);
  }
  return place;
}

unsigned odd_axes(const std::string& field) {
  const std::size_t dot = field.find('.');
  unsigned axes = 0;
  for (std::size_t k = dot + 1; dot != std::string::npos && k < field.size(); ++k) {
    if (field[k] < 'x' || field[k] > 'z') return 0;  // a magnitude
    axes ^= 1U << (field[k] - 'x');
  }
  return axes;
}

Real value_at(const Place& place, const std::vector<Real>& values, bool of_cells, unsigned odd) {
  if (of_cells) return values[place.cell];
  Real sum = 0;
  for (std::size_t k = 0; k < place.points.size(); ++k) {
    sum += sign_in_image(odd, place.reflected[k]) * place.weights[k] * values[place.points[k]];
  }
  return sum;
}

}  // namespace brunt
