#pragma once
/// What the kernels of all formulations share: the arguments of a step, and the bound on it.
#include "fe/corner_values.hpp"
#include "fe/element_block.hpp"
#include "fe/gradient.hpp"

namespace brunt {

/// One step for the kernels. Positions are x(n+1), velocities v(n+1/2).
template <int Dim>
struct ElementStep {
  const Vec<Dim>* x = nullptr;        ///< [m] by node
  const Vec<Dim>* v = nullptr;        ///< [m/s] by node
  const Vec<Dim>* x_start = nullptr;  ///< [m] by node, at time 0
  Thickness thickness;
  Real dt = 0;      ///< [s]
  CornerSums sums;  ///< [N] take the forces on the corners
  /// [1] by node: volume of the elements about it that average volumes, over that at time 0
  const Real* node_ratio = nullptr;
};

/// Formulation::advance of hexes and quads of one point.
template <int Dim, class V>
void advance_one_point(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step);
/// The same for q1p0 and full integration.
template <int Dim, class V>
void advance_gauss(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step);
/// Formulation::refresh_stable_steps of hexes and quads.
template <int Dim>
void refresh_box_steps(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step);

/// Components of a symmetric tensor that are not zero by symmetry of the geometry.
template <int Dim>
inline constexpr int kTensorSize = Dim == 3 ? 6 : 4;

template <int Dim, class V>
BRUNT_INLINE void load_tensor(const std::array<std::vector<Real>, 6>& from, std::size_t at,
                              V (&s)[6]) {
  for (int k = 0; k < kTensorSize<Dim>; ++k) s[k] = load_as<V>(from[k].data() + at);
  for (int k = kTensorSize<Dim>; k < 6; ++k) s[k] = broadcast<V>(0);
}

/// 2 cos(2/3 arccos(s/2)), 0 <= s <= 2: the largest root y of y^3 - 3 y = s^2 - 2. From above, by
/// at most 1.4e-8: a sum of Chebyshev polynomials up to the 8th, which has the error 6.52e-9 on
/// both sides, lifted by as much. The function is smooth but at s = -2.
template <class V>
BRUNT_INLINE V largest_root(V s) {
  constexpr Real kLift = 6.6e-9;
  const V z = s - 1.0, z2 = z * z, z4 = z2 * z2;
  const V low = vfma(line_at(z, -0.0310183376327174, 0.004933347985785019), z2,
                     line_at(z, 1.5320888854456332 + kLift, 0.494818083847365));
  const V high = vfma(line_at(z, -5.699346794477478e-05, 1.7975453238285864e-05), z2,
                      line_at(z, -0.0010085588731993235, 0.00023058702637549722));
  return vfma(vfma(broadcast<V>(-4.9946435034797785e-06), z4, high), z4, low);
}

/// Largest eigenvalue of a symmetric positive matrix, from above to 1.4e-8 (round-off is 1e-8 at a
/// double root). 3 x 3: mean + r y, y^3 - 3 y = det(deviator)/r^3.
template <class V>
BRUNT_INLINE V largest_eigenvalue(const V (&g)[3][3]) {
  const V mean = (1.0 / 3) * (g[0][0] + g[1][1] + g[2][2]);
  const V a = g[0][0] - mean, b = g[1][1] - mean, c = g[2][2] - mean;
  const V d2 = g[0][1] * g[0][1], e2 = g[1][2] * g[1][2], f2 = g[2][0] * g[2][0];
  const V r2 = (1.0 / 6) * (a * a + b * b + c * c + 2.0 * (d2 + e2 + f2));
  const V r = vsqrt(r2);
  const V determinant = a * (b * c - e2) - c * d2 - b * f2 + 2.0 * (g[0][1] * g[1][2] * g[2][0]);
  const auto isotropic = r2 <= 1e-20 * (mean * mean);
  const V two = broadcast<V>(2);
  const V cubic = select(isotropic, two, determinant / select(isotropic, two, r2 * r));
  const V target = vmin(vmax(cubic, -two), two);
  return mean + r * largest_root(vsqrt(target + 2.0));
}
template <class V>
BRUNT_INLINE V largest_eigenvalue(const V (&g)[2][2]) {
  const V mean = 0.5 * (g[0][0] + g[1][1]), half = 0.5 * (g[0][0] - g[1][1]);
  return mean + vsqrt(half * half + g[0][1] * g[0][1]);
}

/// Size of the gradient operator: trace and largest eigenvalue of sum_I B_iI B_jI / V^2, and the
/// square of the hoop gradient of an axisymmetric element [1/m^2].
template <class V>
struct OperatorNorm {
  V trace, largest, hoop;
  /// Smallest height of the element [m]: the shortest edge of a box.
  template <class Element>
  V height() const {
    return vsqrt(Element::kHeightSquare / largest);
  }
};
/// inverse  of the volume, in 2D of the area
template <int Dim, class V>
BRUNT_INLINE OperatorNorm<V> operator_norm(const V (&E)[Shape<Dim>::kActive][Dim], V inverse,
                                           V hoop_gradient) {
  constexpr Real corners = Shape<Dim>::kCorners;
  const V scale = corners * (inverse * inverse);
  V g[Dim][Dim];
  for (int i = 0; i < Dim; ++i) {
    for (int j = i; j < Dim; ++j) {
      V sum = E[0][i] * E[0][j];
      for (int m = 1; m < Shape<Dim>::kActive; ++m) sum = vfma(E[m][i], E[m][j], sum);
      g[i][j] = g[j][i] = scale * sum;
    }
  }
  return {trace(g), largest_eigenvalue(g), hoop_gradient * hoop_gradient};
}

/// Bulk viscosity q = rho l (Q2 l D^2 - Q1 c D) for D < 0, else 0 [Pa]   von Neumann & Richtmyer.
template <class V>
BRUNT_INLINE V bulk_viscosity(const BulkViscosity& option, V rho, V height, V c, V rate) {
  const V D = vmin(rate, broadcast<V>(0));
  return rho * height * D * (option.quadratic * height * D - option.linear * c);
}

/// Part of K + 4/3 G up to which tension is left to `time.safety`: 0.7 % of the step of a cube.
/// What is pulled by less keeps its steps whatever the sign of its pressure.
inline constexpr Real kTensionOfSafety = 0.02;

/// Stable step [s]: 2/omega, omega^2 = (corners/rho) (lambda (tr + hoop) + 2 mu max(g_max, hoop)),
/// times sqrt(1 + Q^2) - Q with Q = Q1 + Q2 l |D|/c in compression and in tension alike, so that
/// the step does not follow the signs of round-off. Tension t [Pa] pulls more as an element grows,
/// by t ((tr L)^2 - tr(L L)): it adds to lambda and takes from 2 mu.
/// height  as of the norm;  slowness [s/m] 1/c
template <class V>
BRUNT_INLINE V stable_step(const BulkViscosity& option, const OperatorNorm<V>& norm, int corners,
                           V height, V slowness, V rho, V bulk, Real shear, V rate, V tension) {
  const V zero = broadcast<V>(0), modulus = bulk + (4.0 / 3) * shear;
  const V t = vmax(tension - kTensionOfSafety * modulus, zero);
  const V lambda = vmax(bulk - (2.0 / 3) * shear + t, zero);
  const V stiffness = lambda * (norm.trace + norm.hoop) +
                      vmax(2.0 * shear - t, zero) * vmax(norm.largest, norm.hoop);
  const V Q = option.linear + option.quadratic * height * vabs(rate) * slowness;
  return 2.0 * vsqrt(rho / (static_cast<Real>(corners) * stiffness)) * (vsqrt(1.0 + Q * Q) - Q);
}

/// Stores the stable steps of the elements from e on. Viscous hourglass control damps its
/// modes at the rate 2 Q c V^(2/3) corners/V, explicit in time: the step is at most 1.6 over it,
/// the true limit 2 being for undistorted elements.
template <class Element, class V>
BRUNT_INLINE void store_stable_step(ElementBlock<Element::kDim>& block, std::size_t e,
                                    const OperatorNorm<V>& norm, V height, V rho, V bulk, V rate) {
  const Real shear = block.material->shear;
  const Real* pressure = block.state.pressure.data() + block.point(static_cast<LocalIndex>(e), 0);
  V tension = -load_as<V>(pressure);
  for (int g = 1; g < block.gauss; ++g) tension = vmax(tension, -load_as<V>(pressure + kGroup * g));
  const V slowness = vsqrt(rho / (bulk + (4.0 / 3) * shear));
  V dt = stable_step(block.options.bulk_viscosity, norm, Element::kCorners, height, slowness, rho,
                     bulk, shear, rate, tension);
  const auto* viscous = std::get_if<ViscousHourglass>(&block.options.hourglass);
  if (Element::kHourglass > 0 && block.gauss == 1 && viscous != nullptr) {
    const V size = load_as<V>(block.reference_size.data() + e);
    const Real factor = 0.8 / (Element::kCorners * viscous->coefficient);
    dt = vmin(dt, factor * size * slowness);
  }
  store(block.stable_step.data() + e, dt);
}

template <class V>
BRUNT_INLINE void add_half(std::vector<Real>& total, std::size_t e, V work) {
  store(total.data() + e, load_as<V>(total.data() + e) + 0.5 * work);
}

/// Strain increment of points from the gradient of displacement L at mid-step.
template <int Dim, class V>
BRUNT_INLINE void store_strain(const V (&L)[Dim][Dim], V hoop, int at, MaterialTile& tile) {
  V strain[6];
  for (auto& component : strain) component = broadcast<V>(0);
  strain[zz] = hoop;
  step_strain(L, strain);
  for (int k = 0; k < 6; ++k) store(tile.strain[k] + at, strain[k]);
}

template <int Dim>
void open_tile(ElementBlock<Dim>& block, int index, MaterialTile& tile) {
  tile.state = &block.state;
  tile.first = slot_of(index) * kTile;
  tile.count = kTile;
  tile.fixed_temperature = block.temperature;
  tile.adiabatic = block.adiabatic;
}

}  // namespace brunt
