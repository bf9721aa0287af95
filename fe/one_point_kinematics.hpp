#pragma once
/// The kinematics of one-point elements, four at a time, in modal coordinates.
#include "fe/element_step.hpp"

namespace brunt {

/// Values of the hourglass modes of a field, [mode][component].
template <int Dim>
using HourglassModes = Pack[Shape<Dim>::kHourglass][Dim];

/// One configuration, and the gradient of a field u at it: of the displacement of the step.
template <int Dim>
struct OnePointConfiguration {
  Pack E[Shape<Dim>::kActive][Dim];  ///< [m^(Dim-1)] dV/dc / corners
  HourglassModes<Dim> mode;          ///< [m] of the positions
  Pack measure;                      ///< [m^Dim] volume; area in 2D
  Pack thickness;                    ///< [m] depth or 2 pi r; 1 in 3D
  Pack G[Dim][Dim];                  ///< [m^Dim] sum u (x) B
  Pack G_hoop;                       ///< [m^3] volume times hoop strain

  Pack volume() const { return Dim == 3 ? measure : measure * thickness; }
  Pack hoop_gradient(const Thickness& option) const {
    if constexpr (Dim == 3) return broadcast<Pack>(0);
    return (0.5 * option.radial) / thickness;
  }
  /// Volume times the trace of the gradient [m^3].
  Pack dilatation() const {
    if constexpr (Dim == 3) return trace(G);
    return thickness * trace(G) + G_hoop;
  }
  /// OnePointWork of the stress s - p on the displacement of the step [J].
  Pack work(const Pack (&s)[6], Pack p) const {
    if constexpr (Dim == 3) return double_dot(s, G) - p * dilatation();
    return thickness * double_dot(s, G) + s[zz] * G_hoop - p * dilatation();
  }
};

template <int Dim>
BRUNT_INLINE void evaluate(const Modal<Dim, Pack>& c, const Modal<Dim, Pack>& u,
                           const Thickness& thickness, OnePointConfiguration<Dim>& at) {
  constexpr int mean = Shape<Dim>::kModes - 1;
  volume_gradient(c, at.E);
  at.measure = measure<Dim, Pack>(c, at.E);
  volume_times_gradient<Dim, Pack>(u, at.E, at.G);
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) at.mode[a][i] = c.m[Dim + a][i];
  }
  if constexpr (Dim == 2) {
    at.thickness = thickness.constant + thickness.radial * c.m[mean][0];
    at.G_hoop = thickness.radial * at.measure * u.m[mean][0];
  }
}

/// What kinematics hand to forces, of four elements.
template <int Dim>
struct OnePointWork {
  OnePointConfiguration<Dim> now;  ///< at x(n+1)
  OperatorNorm<Pack> norm;
  Pack hourglass[Shape<Dim>::kModes - 1][Dim];  ///< [N] modes of the forces of hourglass control
  Pack rho;                                     ///< [kg/m^3]
  Pack rate;                                    ///< [1/s] volumetric strain rate at mid-step
  Pack q;                                       ///< [Pa] bulk viscosity at n+1
  Pack speed;                                   ///< [m/s] of sound
  Pack stress_work, viscous_work;               ///< [J] halves of the old forces
};

/// Where a kernel works: four elements of a block in one step.
template <int Dim>
struct OnePointLane {
  ElementBlock<Dim>& block;
  const ElementStep<Dim>& step;
  std::size_t e;  ///< first of four elements
};

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
