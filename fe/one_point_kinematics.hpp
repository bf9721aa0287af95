#pragma once
/// The kinematics of one-point elements, four at a time, in modal coordinates.
#include "fe/element_step.hpp"

namespace brunt {

/// Values of the hourglass modes of a field, [mode][component].
template <int Dim, class V>
using HourglassModes = V[Shape<Dim>::kHourglass][Dim];

/// One configuration, and the gradient of a field u at it: of the displacement of the step.
template <int Dim, class V>
struct OnePointConfiguration {
  V E[Shape<Dim>::kActive][Dim];  ///< [m^(Dim-1)] dV/dc / corners
  HourglassModes<Dim, V> mode;    ///< [m] of the positions
  V measure;                      ///< [m^Dim] volume; area in 2D
  V inverse;                      ///< 1/measure
  V thickness;                    ///< [m] depth or 2 pi r; 1 in 3D
  V G[Dim][Dim];                  ///< [m^Dim] sum u (x) B
  V G_hoop;                       ///< [m^3] volume times hoop strain

  V volume() const { return Dim == 3 ? measure : measure * thickness; }
  V inverse_volume() const { return Dim == 3 ? inverse : 1.0 / volume(); }
  V hoop_gradient(const Thickness& option) const {
    if constexpr (Dim == 3) return broadcast<V>(0);
    return (0.5 * option.radial) / thickness;
  }
  /// Volume times the trace of the gradient [m^3].
  V dilatation() const {
    if constexpr (Dim == 3) return trace(G);
    return thickness * trace(G) + G_hoop;
  }
  /// OnePointWork of the stress s - p on the displacement of the step [J].
  V work(const V (&s)[6], V p) const {
    if constexpr (Dim == 3) return double_dot(s, G) - p * dilatation();
    return thickness * double_dot(s, G) + s[zz] * G_hoop - p * dilatation();
  }
};

/// What of a configuration does not need E: the hourglass modes of c, and in 2D the thickness.
template <int Dim, class V>
BRUNT_INLINE void take_modes(const Modal<Dim, V>& c, const Modal<Dim, V>& u,
                             const Thickness& thickness, OnePointConfiguration<Dim, V>& at) {
  constexpr int mean = Shape<Dim>::kModes - 1;
  at.inverse = 1.0 / at.measure;
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) at.mode[a][i] = c.m[Dim + a][i];
  }
  if constexpr (Dim == 2) {
    at.thickness = thickness.constant + thickness.radial * c.m[mean][0];
    at.G_hoop = thickness.radial * at.measure * u.m[mean][0];
  }
}

template <int Dim, class V>
BRUNT_INLINE void evaluate(const Modal<Dim, V>& c, const Modal<Dim, V>& u,
                           const Thickness& thickness, OnePointConfiguration<Dim, V>& at) {
  volume_gradient(c, at.E);
  at.measure = measure<Dim, V>(c, at.E);
  volume_times_gradient<Dim, V>(u, at.E, at.G);
  take_modes(c, u, thickness, at);
}

/// The configuration c - u at the start of a step, without its E, from those at the end and at the
/// middle. E is of degree Dim - 1 in the positions, so E(c - u) = 2 E(c - u/2) - E(c), plus E(u)/2
/// in 3D, and G with it, where sum u (x) B(u) is the volume of u. Along the step the volume grows
/// by the trace of G, whose mean is that of Simpson's rule.
template <int Dim, class V>
BRUNT_INLINE void evaluate_start(const Modal<Dim, V>& start, const Modal<Dim, V>& u,
                                 const OnePointConfiguration<Dim, V>& now,
                                 const OnePointConfiguration<Dim, V>& mid,
                                 const Thickness& thickness, OnePointConfiguration<Dim, V>& old) {
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) old.G[i][j] = 2.0 * mid.G[i][j] - now.G[i][j];
  }
  if constexpr (Dim == 3) {
    const V half = 0.5 * volume_of(u);
    for (int i = 0; i < Dim; ++i) old.G[i][i] += half;
  }
  const V grown = trace(old.G) + 4.0 * trace(mid.G) + trace(now.G);
  old.measure = now.measure - (1.0 / 6) * grown;
  take_modes(start, u, thickness, old);
}

/// What kinematics hand to forces, of four elements.
template <int Dim, class V>
struct OnePointWork {
  OnePointConfiguration<Dim, V> now;  ///< at x(n+1)
  OperatorNorm<V> norm;
  V height;       ///< [m] of the norm
  V mode_square;  ///< [m^2] sum of the squares of the hourglass modes of the positions
  V hourglass[Shape<Dim>::kModes - 1][Dim];  ///< [N] modes of the forces of hourglass control
  V rho;                                     ///< [kg/m^3]
  V rate;                                    ///< [1/s] volumetric strain rate at mid-step
  V q;                                       ///< [Pa] bulk viscosity at n+1
  V speed;                                   ///< [m/s] of sound
  V stress_work, viscous_work;               ///< [J] halves of the old forces
};

/// Where a kernel works: four elements of a block in one step.
template <int Dim, class V>
struct OnePointLane {
  ElementBlock<Dim>& block;
  const ElementStep<Dim>& step;
  std::size_t e;  ///< first of four elements
};

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
