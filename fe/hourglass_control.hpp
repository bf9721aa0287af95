#pragma once
/// Hourglass control of one-point elements: viscous and by stiffness after Flanagan & Belytschko
/// 1981, by assumed strain after Belytschko & Bindeman 1991, 1993.
/// docs/theory/elements.md (E4) to (E7).
#include "fe/one_point_kinematics.hpp"

namespace brunt {

template <int Dim>
constexpr Real kRootCorners = Dim == 3 ? 2.82842712474619009760 : 2.0;

/// q_a = u_I gamma_aI / sqrt(corners): hourglass amplitudes [m] of a field of modes u, whose
/// gradient `at` has. gamma is orthogonal to all fields that are linear over `at`.
template <int Dim, class V>
BRUNT_INLINE void hourglass_amplitudes(const OnePointConfiguration<Dim, V>& at,
                                       const Modal<Dim, V>& u, HourglassModes<Dim, V>& q) {
  V L[Dim][Dim];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = at.G[i][j] * at.inverse;
  }
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) {
      V rest = u.m[Dim + a][i];
      for (int j = 0; j < Dim; ++j) rest = vfnma(L[i][j], at.mode[a][j], rest);
      q[a][i] = kRootCorners<Dim> * rest;
    }
  }
}

/// Part of a corner's momentum that viscous control may take in a step; 2 is the limit.
inline constexpr Real kStableRates = 1.6;

template <int Dim, class V>
BRUNT_INLINE V dot(const HourglassModes<Dim, V>& Q, const HourglassModes<Dim, V>& q) {
  V sum = broadcast<V>(0);
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) sum = vfma(Q[a][i], q[a][i], sum);
  }
  return sum;
}

/// Modes of the forces that do the work Q . q on amplitudes measured on `at`, to w.hourglass.
template <int Dim, class V>
BRUNT_INLINE void set_hourglass_forces(const OnePointConfiguration<Dim, V>& at,
                                       const HourglassModes<Dim, V>& Q, OnePointWork<Dim, V>& w) {
  const V k = kRootCorners<Dim> * at.inverse;
  for (int i = 0; i < Dim; ++i) {
    V moment[Dim];
    for (int j = 0; j < Dim; ++j) {
      moment[j] = Q[0][i] * at.mode[0][j];
      for (int a = 1; a < Shape<Dim>::kHourglass; ++a) {
        moment[j] = vfma(Q[a][i], at.mode[a][j], moment[j]);
      }
      moment[j] *= k;
    }
    for (int m = 0; m < Shape<Dim>::kModes - 1; ++m) {
      V force = broadcast<V>(0);
      if (m >= Dim) force = (-1.0 / kRootCorners<Dim>)*Q[m - Dim][i];
      if (m < Shape<Dim>::kActive) {
        for (int j = 0; j < Dim; ++j) force = vfma(moment[j], at.E[m][j], force);
      }
      w.hourglass[m][i] = force;
    }
  }
}

/// Largest Q/q [N/m] that takes from nodes of this element no more in a step than is stable: mass
/// of a corner over dt^2 gamma^2. In crushed and skewed elements gamma has parts along the linear
/// modes that are larger than it: gamma^2 <= 1 + sum (grad h)^2 (mode)^2 <= 1 + |B B/V^2| sum
/// mode^2.
template <int Dim, class V>
BRUNT_INLINE V most_rate_stiffness(const OnePointLane<Dim, V>& lane,
                                   const OnePointWork<Dim, V>& w) {
  constexpr Real corners = Shape<Dim>::kCorners;
  const V gamma_square = 1.0 + corners * w.norm.largest * w.mode_square;
  const Real dt = lane.step.dt;
  return (kStableRates / (corners * dt * dt)) * load_as<V>(lane.block.mass.data() + lane.e) /
         gamma_square;
}

/// Viscous control: Q = 2 Q_HG rho c l^2 dq/dt at mid-step.
template <int Dim, class V>
BRUNT_INLINE void resist_rates(const OnePointLane<Dim, V>& lane, Real coefficient,
                               const OnePointConfiguration<Dim, V>& old,
                               const OnePointConfiguration<Dim, V>& mid, const Modal<Dim, V>& u,
                               OnePointWork<Dim, V>& w) {
  ElementBlock<Dim>& block = lane.block;
  const auto kept = [&](int a, int i) {
    return block.hourglass.data() + slot_of(a * Dim + i) * block.n_padded + lane.e;
  };
  HourglassModes<Dim, V> q, Q;
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) Q[a][i] = load_as<V>(kept(a, i));
  }
  hourglass_amplitudes(old, u, q);
  const V old_work = dot<Dim>(Q, q);
  hourglass_amplitudes(mid, u, q);
  const V size = load_as<V>(block.reference_size.data() + lane.e);
  V area = size * size;
  if constexpr (Dim == 2) area = size * w.now.thickness;
  const V k = vmin((2.0 * coefficient / lane.step.dt) * w.rho * w.speed * area,
                   most_rate_stiffness(lane, w));
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) {
      Q[a][i] = k * q[a][i];
      store(kept(a, i), Q[a][i]);
    }
  }
  set_hourglass_forces(w.now, Q, w);
  // Q . q on the present positions is minus the work of these forces.
  V sum = w.hourglass[0][0] * u.m[0][0];
  for (int m = 0; m < Shape<Dim>::kModes - 1; ++m) {
    for (int i = m == 0 ? 1 : 0; i < Dim; ++i) sum = vfma(w.hourglass[m][i], u.m[m][i], sum);
  }
  constexpr Real corners = Shape<Dim>::kCorners;
  add_half(block.hourglass_work, lane.e, old_work - corners * sum);
}

/// Modes of the positions at time 0.
template <int Dim, class V>
BRUNT_INLINE Modal<Dim, V> modes_at_start(const OnePointLane<Dim, V>& lane) {
  V node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(lane.block.corner.data() + lane.e * Shape<Dim>::kCorners, lane.step.x_start, node);
  return modes_of<Dim>(node);
}

/// Of the displacement since time 0. Amplitudes of the positions are those of it: at time 0 they
/// are 0, and to the last bit so.
template <int Dim, class V>
BRUNT_INLINE Modal<Dim, V> moved_since(const Modal<Dim, V>& reference, const Modal<Dim, V>& c) {
  Modal<Dim, V> moved;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) moved.m[m][i] = c.m[m][i] - reference.m[m][i];
  }
  return moved;
}

/// Stiffness control: Q = k q of the positions c, gamma and k those of the positions at time 0.
/// A linear map of the body has no q, a turn turns it with the body, and its energy k q^2/2 is that
/// of a spring. Forces summed over rates have no potential: where the deformation of an element
/// comes and goes they keep a rest, of the order of the strain (Joldes, Wittek & Miller 2008).
template <int Dim, class V>
BRUNT_INLINE void resist_amplitudes(const OnePointLane<Dim, V>& lane, const Modal<Dim, V>& c,
                                    OnePointWork<Dim, V>& w) {
  ElementBlock<Dim>& block = lane.block;
  const auto reference = modes_at_start(lane);
  const auto moved = moved_since<Dim>(reference, c);
  OnePointConfiguration<Dim, V> start;
  evaluate(reference, moved, lane.step.thickness, start);
  HourglassModes<Dim, V> q, Q;
  hourglass_amplitudes(start, moved, q);
  const V k = load_as<V>(block.hourglass_stiffness.data() + lane.e);
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) Q[a][i] = k * q[a][i];
  }
  store(block.hourglass_work.data() + lane.e, 0.5 * dot<Dim>(Q, q));
  set_hourglass_forces(start, Q, w);
}

/// What assumed-strain control reads of a field: its hourglass and its linear modes.
template <int Dim, class V>
struct BendingModes {
  HourglassModes<Dim, V> h;
  V l[Dim][Dim];

  /// start  the positions at time 0, with the gradient of the field of modes u
  /// linear  the field whose linear modes are wanted: u, and what has no hourglass modes
  BRUNT_INLINE BendingModes(const OnePointConfiguration<Dim, V>& start, const Modal<Dim, V>& u,
                            const Modal<Dim, V>& linear) {
    hourglass_amplitudes(start, u, h);
    for (int i = 0; i < Dim; ++i) {
      for (auto& mode : h) mode[i] = (1.0 / kRootCorners<Dim>)*mode[i];
      for (int m = 0; m < Dim; ++m) l[m][i] = linear.m[m][i];
    }
  }
  BRUNT_INLINE void subtract(const BendingModes& other) {
    for (int i = 0; i < Dim; ++i) {
      for (int a = 0; a < Shape<Dim>::kHourglass; ++a) h[a][i] -= other.h[a][i];
      for (int m = 0; m < Dim; ++m) l[m][i] -= other.l[m][i];
    }
  }
  BRUNT_INLINE AssumedStrainEnergy<Dim, V> energy(const V (&inverse)[Dim],
                                                  const BendingModuli& moduli, V volume) const {
    return {h, l, inverse, moduli, volume};
  }
  /// Work [J] on these modes as displacements.
  BRUNT_INLINE V work_of(const AssumedStrainEnergy<Dim, V>& u) const {
    V sum = dot<Dim>(u.by_hourglass, h);
    for (int m = 0; m < Dim; ++m) {
      for (int i = 0; i < Dim; ++i) sum += u.by_linear[m][i] * l[m][i];
    }
    return sum;
  }
};

/// Assumed-strain control: minus the gradient of its energy, gamma that of the positions at time 0.
/// The work is that of the forces at both ends of the step.
template <int Dim, class V>
BRUNT_INLINE void resist_bending(const OnePointLane<Dim, V>& lane, const Modal<Dim, V>& c,
                                 const Modal<Dim, V>& u, OnePointWork<Dim, V>& w) {
  ElementBlock<Dim>& block = lane.block;
  const auto reference = modes_at_start(lane);
  OnePointConfiguration<Dim, V> start;
  evaluate(reference, u, lane.step.thickness, start);
  V inverse[Dim];
  for (int m = 0; m < Dim; ++m) {
    V square = reference.m[m][0] * reference.m[m][0];
    for (int i = 1; i < Dim; ++i) square += reference.m[m][i] * reference.m[m][i];
    inverse[m] = 1.0 / vsqrt(square);
  }
  const BendingModes<Dim, V> step(start, u, u);
  const auto moved = moved_since<Dim>(reference, c);
  volume_times_gradient<Dim, V>(moved, start.E, start.G);
  BendingModes<Dim, V> modes(start, moved, c);
  const V volume = load_as<V>(block.element_volume.data() + lane.e);
  const auto now = modes.energy(inverse, block.bending, volume);
  modes.subtract(step);
  const auto old = modes.energy(inverse, block.bending, volume);
  add_half(block.hourglass_work, lane.e, step.work_of(old) + step.work_of(now));

  HourglassModes<Dim, V> Q;
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) Q[a][i] = (1.0 / kRootCorners<Dim>)*now.by_hourglass[a][i];
  }
  set_hourglass_forces(start, Q, w);
  for (int m = 0; m < Dim; ++m) {
    for (int i = 0; i < Dim; ++i) {
      w.hourglass[m][i] -= (1.0 / Shape<Dim>::kCorners) * now.by_linear[m][i];
    }
  }
}

/// Adds the control that the block's elements have to w.hourglass, and books its work.
/// old, mid: configurations of this step; c, u: modes of the positions and of the step.
template <int Dim, class V>
BRUNT_INLINE void resist_hourglasses(const OnePointLane<Dim, V>& lane,
                                     const OnePointConfiguration<Dim, V>& old,
                                     const OnePointConfiguration<Dim, V>& mid,
                                     const Modal<Dim, V>& c, const Modal<Dim, V>& u,
                                     OnePointWork<Dim, V>& w) {
  const Hourglass& control = lane.block.options.hourglass;
  if (const auto* viscous = std::get_if<ViscousHourglass>(&control)) {
    resist_rates(lane, viscous->coefficient, old, mid, u, w);
  } else if (std::holds_alternative<AssumedStrainHourglass>(control)) {
    resist_bending(lane, c, u, w);
  } else {
    resist_amplitudes(lane, c, w);
  }
}

}  // namespace brunt
// Tested by tests/unit/fe/assumed_strain_test.cpp.
