#include "fe/elements/box.hpp"

#include "core/parallel/threads.hpp"
#include "core/wide_lanes.hpp"
#include "fe/conduction_kernel.hpp"
#include "fe/element_step.hpp"
#include "fe/gauss_point.hpp"
#include "fe/shape_guard.hpp"

namespace brunt {
namespace {

template <int Dim>
Modal<Dim, Real> modes_at(CornerPlaces<Dim> x) {
  Real node[Shape<Dim>::kCorners][Dim];
  for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
    for (int i = 0; i < Dim; ++i) node[I][i] = x[I][i];
  }
  return modes_of<Dim>(node);
}

/// Volume of Gauss point g [m^3], by the arithmetic of the kernels: an element that has not moved
/// has to the last bit the volume it began with.
template <int Dim, class V>
V gauss_volume(const Modal<Dim, V>& c, int g, const Thickness& thickness) {
  V J[Dim][Dim], cof[Dim][Dim];
  slopes(c, g, J);
  cofactors(J, cof);
  const V determinant = determinant_of<Dim>(J, cof);
  if constexpr (Dim == 3) return determinant;
  if constexpr (Dim == 2) {
    return determinant * (thickness.constant + thickness.radial * radius_at(c, g));
  }
}

/// Volume [m^3] from its gradient.
template <int Dim, class V>
V whole_volume(const Modal<Dim, V>& c, const Thickness& thickness) {
  V E[Shape<Dim>::kActive][Dim];
  volume_gradient(c, E);
  const V size = measure<Dim, V>(c, E);
  if constexpr (Dim == 3) return size;
  return size * (thickness.constant + thickness.radial * c.m[Shape<Dim>::kModes - 1][0]);
}

/// sum_I B_iI B_iI / V^2 [1/m^2], what gradients of an element's corners are like.
template <int Dim>
Real squared_gradients(CornerPlaces<Dim> x) {
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
  const auto padded = slot_of(block.n_padded);
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

/// Slopes d N_I/d xi_j and values of the shape functions at the Gauss points, [g].
template <int Dim>
struct CornerTable {
  ShapeValues at[kGauss<Dim>];
};
template <int Dim>
constexpr CornerTable<Dim> make_corner_table() {
  CornerTable<Dim> table{};
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const auto place = gauss_place<Dim>(g);
    LocalPlace at{};
    for (int j = 0; j < Dim; ++j) at[j] = place[j];
    Shape<Dim>::shape(at, table.at[g]);
  }
  return table;
}
template <int Dim>
inline constexpr CornerTable<Dim> kCornerTable = make_corner_table<Dim>();

/// int grad N_I . grad N_J dV of four quads [m], I < J.
BRUNT_INLINE void gradient_products(const Modal<2, Pack>& c, const Thickness& option,
                                    Pack (&K)[4][4]) {
  for (auto& row : K) {
    for (auto& value : row) value = broadcast<Pack>(0);
  }
  for (int g = 0; g < kGauss<2>; ++g) {
    Pack J[2][2], cof[2][2], b[4][2];  // b: determinant times grad N_I
    slopes(c, g, J);
    cofactors(J, cof);
    const Pack radius = radius_at(c, g);
    const Pack weight =
        (1.0 / determinant_of<2>(J, cof)) * (option.constant + option.radial * radius);
    for (int I = 0; I < 4; ++I) {
      const auto& slope = kCornerTable<2>.at[g].slope[I];
      for (int j = 0; j < 2; ++j) b[I][j] = slope[0] * cof[j][0] + slope[1] * cof[j][1];
    }
    for (int I = 0; I < 4; ++I) {
      for (int L = I + 1; L < 4; ++L) {
        K[I][L] += weight * (b[I][0] * b[L][0] + b[I][1] * b[L][1]);
      }
    }
  }
}

/// Heat of four quads from e on.
void conduct_quads(ElementBlock<2>& block, std::size_t e, const ConductionStep<2>& step) {
  const LocalIndex* const corner = block.corner.data() + e * 4;
  Pack node[4][2], K[4][4], T[4];
  gather<2>(corner, step.x, node);
  gradient_products(modes_of<2>(node), step.thickness, K);
  gather_temperature(corner, step.temperature, T);
  exchange_heat(K, conductivity(block.material->conductivity, T), T, step.corner_heat + 8 * e);
}

/// Heat of kGroup hexes from e on.
void conduct_box(ElementBlock<3>& block, std::size_t e, const ConductionStep<3>& step) {
  constexpr std::size_t kCorners = 8;
  const LocalIndex* const corner = block.corner.data() + e * kCorners;
  Real* const heat = step.corner_heat + 2 * kCorners * e;
  alignas(64) Real k[kGroup];
  for (std::size_t four = 0; four < kGroup; four += kLanes) {
    Pack T[kCorners];
    if (!block.material->conductivity.is_constant()) {
      gather_temperature(corner + four * kCorners, step.temperature, T);
    }
    store(k + four, conductivity(block.material->conductivity, T));
  }
  if (wide_lanes()) return conduct_hexes<Wide>(corner, k, step, heat);
  for (std::size_t four = 0; four < kGroup; four += kLanes) {
    conduct_hexes<Pack>(corner + four * kCorners, k + four, step, heat + 2 * kCorners * four);
  }
}
void conduct_box(ElementBlock<2>& block, std::size_t e, const ConductionStep<2>& step) {
  for (std::size_t four = 0; four < kGroup; four += kLanes) conduct_quads(block, e + four, step);
}

template <int Dim>
class BoxFormulation final : public Formulation<Dim> {
  static constexpr int kCorners = Shape<Dim>::kCorners;

 public:
  const ElementType& type() const override { return kElementType<Shape<Dim>>; }
  void cut_box(std::span<const int> box, std::vector<int>& corners) const override {
    corners.insert(corners.end(), box.begin(), box.end());
  }
  int material_points(const ElementOptions& options) const override {
    return options.integration == Integration::one_point ? 1 : kGauss<Dim>;
  }
  PartVolumes part_volumes(CornerPlaces<Dim> x, const Thickness& thickness) const override {
    PartVolumes parts;
    parts.n = kGauss<Dim>;
    const auto volume = gauss_volumes<Dim>(x, thickness);
    std::copy(volume.begin(), volume.end(), parts.part.begin());
    return parts;
  }
  std::array<PartVolumes, kLanes> parts_of_four(const ElementBlock<Dim>& block, std::size_t e,
                                                const Points<Dim>& points,
                                                const Thickness& thickness) const override {
    std::array<PartVolumes, kLanes> of;
    const Modal<Dim, Pack> c = modes_of_four(block, e, points);
    for (int g = 0; g < kGauss<Dim>; ++g) {
      const Pack volume = gauss_volume<Dim>(c, g, thickness);
      for (int lane = 0; lane < kLanes; ++lane) of[lane].part[g] = volume[lane];
    }
    for (auto& parts : of) parts.n = kGauss<Dim>;
    return of;
  }
  Real volume(CornerPlaces<Dim> x, bool one_point, const Thickness& thickness) const override {
    return element_volume<Dim>(x, one_point, thickness);
  }
  Real step_volume(CornerPlaces<Dim> x, const Thickness& thickness) const override {
    return one_point_volume<Dim>(x, thickness);
  }
  std::array<Real, kLanes> step_volumes(const ElementBlock<Dim>& block, std::size_t e,
                                        const Points<Dim>& points,
                                        const Thickness& thickness) const override {
    std::array<Real, kLanes> volume;
    store(volume.data(), whole_volume<Dim>(modes_of_four(block, e, points), thickness));
    return volume;
  }
  static Modal<Dim, Pack> modes_of_four(const ElementBlock<Dim>& block, std::size_t e,
                                        const Points<Dim>& points) {
    Pack node[kCorners][Dim];
    gather<Dim>(block.corner.data() + e * kCorners, points.x.data(), node);
    return modes_of<Dim>(node);
  }
  unsigned have_volume(const ElementBlock<Dim>& block, std::size_t e, const Points<Dim>& points,
                       const Thickness& thickness) const override {
    const Modal<Dim, Pack> c = modes_of_four(block, e, points);
    if (block.gauss == 1) return mask_bits(whole_volume<Dim>(c, thickness) > 0);
    PackMask all = gauss_volume<Dim>(c, 0, thickness) > 0;
    for (int g = 1; g < kGauss<Dim>; ++g) all = all & (gauss_volume<Dim>(c, g, thickness) > 0);
    return mask_bits(all);
  }
  Real add_corner_volumes(CornerPlaces<Dim> x, const Thickness& thickness, Real factor,
                          Real* sum) const override {
    const auto volume = gauss_volumes<Dim>(x, thickness);
    Real whole = 0;
    for (int g = 0; g < kGauss<Dim>; ++g) {
      const auto at = gauss_place<Dim>(g);
      whole += volume[g];
      for (int I = 0; I < kCorners; ++I) {
        Real value = factor * volume[g];
        for (int j = 0; j < Dim; ++j) value *= 0.5 * (1 + Shape<Dim>::kSign[I][j] * at[j]);
        sum[I] += value;
      }
    }
    return whole;
  }
  Vec<Dim> material_place(CornerPlaces<Dim> x, int points, int g) const override {
    Vec<Dim> place = Vec<Dim>::Zero();
    for (int I = 0; I < kCorners; ++I) {
      place += (points == 1 ? 1.0 / kCorners : kCornerTable<Dim>.at[g].value[slot_of(I)]) * x[I];
    }
    return place;
  }
  void start(const Points<Dim>& points, ElementBlock<Dim>& block) const override {
    if (block.material->yields()) {
      block.guard_reach.resize(slot_of(block.n_padded));
      for_each(block.n_padded, kPointsWorthThreads, [&](LocalIndex e) {
        block.guard_reach[e] = guard_reach<Dim>(corner_positions(block, e, points));
      });
    }
    if (block.gauss == 1) start_hourglass(points, block);
  }
  void advance(ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) const override {
    if (wide_lanes()) {
      advance_as<Wide>(block, tile, step);
    } else {
      advance_as<Pack>(block, tile, step);
    }
  }
  template <class V>
  static void advance_as(ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) {
    if (block.gauss == 1) {
      advance_one_point<Dim, V>(block, tile, step);
    } else {
      advance_gauss<Dim, V>(block, tile, step);
    }
  }
  void refresh_stable_steps(ElementBlock<Dim>& block, int tile,
                            const ElementStep<Dim>& step) const override {
    refresh_box_steps(block, tile, step);
  }
  void conduct(ElementBlock<Dim>& block, std::size_t e,
               const ConductionStep<Dim>& step) const override {
    conduct_box(block, e, step);
  }
  void interpolate_temperature(ElementBlock<Dim>& block, std::size_t e,
                               const Real* temperature) const override {
    if (block.gauss == 1) return mean_temperature<kCorners>(block, e, temperature);
    Real* out = block.state.temperature.data() + block.point(static_cast<LocalIndex>(e), 0);
    Pack T[kCorners];
    gather_temperature(block.corner.data() + e * kCorners, temperature, T);
    for (int g = 0; g < block.gauss; ++g) {
      Pack sum = broadcast<Pack>(0);
      for (int I = 0; I < kCorners; ++I) sum += kCornerTable<Dim>.at[g].value[I] * T[I];
      store(out + kGroup * g, sum);
    }
  }
};
}  // namespace

template <int Dim>
std::array<Real, Shape<Dim>::kGauss> gauss_volumes(CornerPlaces<Dim> x,
                                                   const Thickness& thickness) {
  const Modal<Dim, Real> modes = modes_at<Dim>(x);
  std::array<Real, Shape<Dim>::kGauss> volume;
  for (int g = 0; g < Shape<Dim>::kGauss; ++g) volume[g] = gauss_volume<Dim>(modes, g, thickness);
  return volume;
}

template <int Dim>
Real element_volume(CornerPlaces<Dim> x, bool one_point, const Thickness& thickness) {
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
Real one_point_volume(CornerPlaces<Dim> x, const Thickness& thickness) {
  return whole_volume<Dim>(modes_at<Dim>(x), thickness);
}

const Formulation<2>& formulation(Quad4) {
  static const BoxFormulation<2> box;
  return box;
}
const Formulation<3>& formulation(Hex8) {
  static const BoxFormulation<3> box;
  return box;
}

template std::array<Real, 4> gauss_volumes<2>(CornerPlaces<2>, const Thickness&);
template std::array<Real, 8> gauss_volumes<3>(CornerPlaces<3>, const Thickness&);
template Real element_volume<2>(CornerPlaces<2>, bool, const Thickness&);
template Real element_volume<3>(CornerPlaces<3>, bool, const Thickness&);
template Real one_point_volume<2>(CornerPlaces<2>, const Thickness&);
template Real one_point_volume<3>(CornerPlaces<3>, const Thickness&);

}  // namespace brunt
// Tested by tests/unit/fe/element_step_test.cpp.
