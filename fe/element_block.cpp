#include "fe/element_block.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/errors.hpp"
#include "fe/shape_guard.hpp"

namespace brunt {
namespace {

template <int Dim>
using Corners = std::array<Vec<Dim>, Shape<Dim>::kCorners>;

template <int Dim>
Modal<Dim, Real> modes_at(const Corners<Dim>& x) {
  Real node[Shape<Dim>::kCorners][Dim];
  for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
    for (int i = 0; i < Dim; ++i) node[I][i] = x[I][i];
  }
  return modes_of<Dim>(node);
}

/// Determinant of dx/dxi and first coordinate at Gauss point g.
template <int Dim>
struct GaussPlace {
  Real determinant = 0;
  Real radius = 0;
};
template <int Dim>
GaussPlace<Dim> gauss_geometry(const Modal<Dim, Real>& c, int g) {
  const auto slope = Shape<Dim>::mode_slopes(gauss_place<Dim>(g));
  const auto value = Shape<Dim>::mode_values(gauss_place<Dim>(g));
  Eigen::Matrix<Real, Dim, Dim> J = Eigen::Matrix<Real, Dim, Dim>::Zero();
  GaussPlace<Dim> place;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    place.radius += value[m] * c.m[m][0];
    if (m == Shape<Dim>::kModes - 1) break;
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) J(i, j) += c.m[m][i] * slope[m][j];
    }
  }
  place.determinant = J.determinant();
  return place;
}

Hourglass resolved(const Hourglass& hourglass, const Material& material) {
  if (!std::holds_alternative<AutomaticHourglass>(hourglass)) return hourglass;
  if (material.yields()) return ViscousHourglass{};
  return AssumedStrainHourglass{};
}

[[noreturn]] void report_inverted(GlobalId id, Real volume) {
  throw PhysicsError({0, "", "element " + std::to_string(id), "volume", volume,
                      "the element is inverted at the start: check the order of its corners"});
}

template <int Dim>
void copy_elements(const ElementSet<Dim>& set, ElementBlock<Dim>& block) {
  constexpr std::size_t n = Shape<Dim>::kCorners;
  const auto padded = static_cast<std::size_t>(block.n_padded);
  block.corner.resize(padded * n);
  block.id.resize(padded);
  block.body.resize(padded);
  block.piece.resize(padded);
  for (std::size_t e = 0; e < padded; ++e) {
    const std::size_t from = std::min(e, set.id.size() - 1);
    std::copy_n(set.corners[from].begin(), n, block.corner.begin() + static_cast<long>(e * n));
    block.id[e] = set.id[from];
    block.body[e] = set.body[from];
    block.piece[e] = set.piece[from];
  }
}

/// Reference volumes and masses. Throws at the first element in order of storage without volume.
template <int Dim>
void measure_elements(const Points<Dim>& points, const Thickness& thickness,
                      ElementBlock<Dim>& block) {
  const auto padded = static_cast<std::size_t>(block.n_padded);
  block.reference_volume.resize(padded * static_cast<std::size_t>(block.gauss));
  block.element_volume.resize(padded);
  block.reference_size.resize(padded);
  block.mass.resize(padded);
  if (block.material->yields()) block.guard_reach.resize(padded);
  for (LocalIndex e = 0; e < block.n_padded; ++e) {
    const auto x = corner_positions(block, e, points);
    const auto part = gauss_volumes<Dim>(x, thickness);
    const Real volume = element_volume<Dim>(x, block.gauss == 1, thickness);
    const Real least = *std::min_element(part.begin(), part.end());
    if (!(volume > 0) || (block.gauss > 1 && !(least > 0))) report_inverted(block.id[e], volume);
    Real exact = 0;
    for (int g = 0; g < Shape<Dim>::kGauss; ++g) exact += part[g];
    block.element_volume[e] = volume;
    block.mass[e] = block.material->density * exact;
    const Real size = Dim == 3 ? volume : element_volume<Dim>(x, true, Thickness{1, 0});
    block.reference_size[e] = Dim == 3 ? std::cbrt(size) : std::sqrt(size);
    if (!block.guard_reach.empty()) block.guard_reach[e] = guard_reach<Dim>(x);
    for (int g = 0; g < block.gauss; ++g) {
      block.reference_volume[block.point(e, g)] = block.gauss == 1 ? volume : part[g];
    }
  }
}

/// sum_I B_iI B_iI / V^2 [1/m^2], what gradients of an element's corners are like.
template <int Dim>
Real squared_gradients(const Corners<Dim>& x) {
  const Modal<Dim, Real> modes = modes_at<Dim>(x);
  Real E[Shape<Dim>::kActive][Dim], sum = 0;
  volume_gradient(modes, E);
  for (const auto& row : E) {
    for (const Real component : row) sum += component * component;
  }
  const Real volume = measure<Dim, Real>(modes, E);
  return Shape<Dim>::kCorners * sum / (volume * volume);
}

/// Elastic constants of bending (AssumedStrainEnergy), times a coefficient.
BendingModuli bending_moduli(const Material& material, Real coefficient) {
  const Real E = 9 * material.bulk * material.shear / (3 * material.bulk + material.shear);
  const Real nu = E / (2 * material.shear) - 1;
  return {coefficient * E, coefficient * E / (1 - nu * nu), nu, coefficient * material.shear};
}

/// Hourglass control of one-point elements: k = kappa mu V sum B B / V^2 of stiffness
/// in its form with 2 mu (docs/theory/elements.md (E6)).
template <int Dim>
void start_hourglass(const Points<Dim>& points, ElementBlock<Dim>& block) {
  const auto padded = static_cast<std::size_t>(block.n_padded);
  if (const auto* bends = std::get_if<AssumedStrainHourglass>(&block.options.hourglass)) {
    block.bending = bending_moduli(*block.material, bends->coefficient);
    return;
  }
  const auto* stiff = std::get_if<StiffnessHourglass>(&block.options.hourglass);
  if (stiff == nullptr) {
    block.hourglass.assign(padded * block.kHourglassValues, 0.0);
    return;
  }
  block.hourglass_stiffness.resize(padded);
  for (LocalIndex e = 0; e < block.n_padded; ++e) {
    block.hourglass_stiffness[e] = stiff->coefficient * block.material->shear *
                                   squared_gradients<Dim>(corner_positions(block, e, points)) *
                                   block.element_volume[e];
  }
}

}  // namespace

Thickness thickness_of(Geometry geometry, Real depth) {
  switch (geometry) {
    case Geometry::plane_strain:
      return {depth, 0};
    case Geometry::axisymmetric:
      return {0, 2 * kPi};
    case Geometry::three_d:
      break;
  }
  return {1, 0};
}

template <int Dim>
std::vector<LocalIndex> axis_nodes(const Points<Dim>& points, const Thickness& thickness) {
  std::vector<LocalIndex> nodes;
  if (thickness.radial == 0) return nodes;
  Real largest = 0;
  for (const auto& x : points.x) largest = std::max(largest, std::abs(x[0]));
  for (LocalIndex k = 0; k < points.size(); ++k) {
    if (std::abs(points.x[k][0]) <= 1e-12 * largest) nodes.push_back(k);
  }
  return nodes;
}

template <int Dim>
std::array<Real, Shape<Dim>::kGauss> gauss_volumes(const Corners<Dim>& x,
                                                   const Thickness& thickness) {
  const Modal<Dim, Real> modes = modes_at<Dim>(x);
  std::array<Real, Shape<Dim>::kGauss> volume;
  for (int g = 0; g < Shape<Dim>::kGauss; ++g) {
    const GaussPlace<Dim> place = gauss_geometry<Dim>(modes, g);
    volume[g] = place.determinant;
    if (Dim == 2) volume[g] *= thickness.constant + thickness.radial * place.radius;
  }
  return volume;
}

template <int Dim>
Real element_volume(const Corners<Dim>& x, bool one_point, const Thickness& thickness) {
  Real sum = 0;
  if (!one_point) {
    for (const Real part : gauss_volumes<Dim>(x, thickness)) sum += part;
    return sum;
  }
  for (const Real part : gauss_volumes<Dim>(x, Thickness{1, 0})) sum += part;
  if constexpr (Dim == 2) {
    const Real radius = 0.25 * ((x[0][0] + x[1][0]) + (x[2][0] + x[3][0]));
    sum *= thickness.constant + thickness.radial * radius;
  }
  return sum;
}

template <int Dim>
Real one_point_volume(const Corners<Dim>& x, const Thickness& thickness) {
  const Modal<Dim, Real> modes = modes_at<Dim>(x);
  Real E[Shape<Dim>::kActive][Dim];
  volume_gradient(modes, E);
  const Real size = measure<Dim, Real>(modes, E);
  if constexpr (Dim == 3) return size;
  return size * (thickness.constant + thickness.radial * modes.m[Shape<Dim>::kModes - 1][0]);
}

template <int Dim>
ElementBlock<Dim> make_block(const ElementSet<Dim>& set, const Points<Dim>& points,
                             const Thickness& thickness) {
  ElementBlock<Dim> block;
  block.material = set.material;
  block.options = set.options;
  block.options.hourglass = resolved(set.options.hourglass, *set.material);
  block.gauss = set.options.integration == Integration::one_point ? 1 : Shape<Dim>::kGauss;
  block.adiabatic = set.adiabatic;
  block.conducts = set.conducts, block.held = set.held, block.rigid = set.rigid;
  block.temperature = set.temperature;
  block.n = static_cast<LocalIndex>(set.id.size());
  const int tile = block.elements_per_tile();
  block.n_padded = (block.n + tile - 1) / tile * tile;
  if (block.n == 0) return block;
  copy_elements(set, block);
  block.owned = set.owned;
  block.owned.resize(static_cast<std::size_t>(block.n), 1);
  measure_elements(points, thickness, block);
  const auto padded = static_cast<std::size_t>(block.n_padded);
  const bool warms = set.material->yields() || set.material->warms_by_compression();
  block.state =
      set.material->initial_state(padded * static_cast<std::size_t>(block.gauss), set.temperature,
                                  set.adiabatic || (set.conducts && warms));
  if (block.conducts) {
    block.heat_share = corner_shares(block, points, thickness);
    if (warms) block.heat_given.assign(padded, 0.0);
  }
  if (block.gauss == 1) start_hourglass(points, block);
  for (auto* field : {&block.viscous_pressure, &block.stress_work, &block.hourglass_work,
                      &block.viscous_work, &block.stable_step}) {
    field->assign(padded, 0.0);
  }
  return block;
}

template <int Dim>
std::vector<Real> corner_shares(const ElementBlock<Dim>& block, const Points<Dim>& points,
                                const Thickness& thickness) {
  constexpr int n = Shape<Dim>::kCorners;
  std::vector<Real> shares(static_cast<std::size_t>(block.n_padded) * n);
  for (LocalIndex e = 0; e < block.n_padded; ++e) {
    Real* share = shares.data() + static_cast<std::size_t>(e) * n;
    const auto volume = gauss_volumes<Dim>(corner_positions(block, e, points), thickness);
    Real whole = 0;
    for (int g = 0; g < Shape<Dim>::kGauss; ++g) {
      const auto at = gauss_place<Dim>(g);
      whole += volume[g];
      for (int I = 0; I < n; ++I) {
        Real value = volume[g];
        for (int j = 0; j < Dim; ++j) value *= 0.5 * (1 + Shape<Dim>::kSign[I][j] * at[j]);
        share[I] += value;
      }
    }
    for (int I = 0; I < n; ++I) share[I] /= whole;
  }
  return shares;
}

template <int Dim>
std::vector<Real> corner_masses(const ElementBlock<Dim>& block, const Points<Dim>& points,
                                const Thickness& thickness) {
  constexpr int n = Shape<Dim>::kCorners;
  std::vector<Real> mass(static_cast<std::size_t>(block.n) * n);
  for (LocalIndex e = 0; e < block.n; ++e) {
    Real* share = mass.data() + static_cast<std::size_t>(e) * n;
    std::fill_n(share, n, block.mass[e] / n);
    if (block.gauss == 1 || thickness.radial == 0) continue;
    std::fill_n(share, n, 0.0);
    const auto volume = gauss_volumes<Dim>(corner_positions(block, e, points), thickness);
    for (int g = 0; g < Shape<Dim>::kGauss; ++g) {
      const auto at = gauss_place<Dim>(g);
      for (int I = 0; I < n; ++I) {
        Real value = block.material->density * volume[g];
        for (int j = 0; j < Dim; ++j) value *= 0.5 * (1 + Shape<Dim>::kSign[I][j] * at[j]);
        share[I] += value;
      }
    }
  }
  return mass;
}

template std::vector<LocalIndex> axis_nodes(const Points<2>&, const Thickness&);
template std::vector<LocalIndex> axis_nodes(const Points<3>&, const Thickness&);
template std::array<Real, 4> gauss_volumes<2>(const Corners<2>&, const Thickness&);
template std::array<Real, 8> gauss_volumes<3>(const Corners<3>&, const Thickness&);
template Real element_volume<2>(const Corners<2>&, bool, const Thickness&);
template Real element_volume<3>(const Corners<3>&, bool, const Thickness&);
template Real one_point_volume<2>(const Corners<2>&, const Thickness&);
template Real one_point_volume<3>(const Corners<3>&, const Thickness&);
template ElementBlock<2> make_block(const ElementSet<2>&, const Points<2>&, const Thickness&);
template ElementBlock<3> make_block(const ElementSet<3>&, const Points<3>&, const Thickness&);
template std::vector<Real> corner_shares(const ElementBlock<2>&, const Points<2>&,
                                         const Thickness&);
template std::vector<Real> corner_shares(const ElementBlock<3>&, const Points<3>&,
                                         const Thickness&);
template std::vector<Real> corner_masses(const ElementBlock<2>&, const Points<2>&,
                                         const Thickness&);
template std::vector<Real> corner_masses(const ElementBlock<3>&, const Points<3>&,
                                         const Thickness&);

}  // namespace brunt
