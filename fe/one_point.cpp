/// One-point elements with hourglass control, Flanagan & Belytschko 1981, in modal coordinates.
#include "fe/element_step.hpp"

namespace brunt {
namespace {

template <int Dim>
constexpr Real kRootCorners = Dim == 3 ? 2.82842712474619009760 : 2.0;

/// Values of the hourglass modes of a field, [mode][component].
template <int Dim>
using HourglassModes = Pack[Shape<Dim>::kHourglass][Dim];

/// One configuration, and the gradient of a field u at it: of the displacement of the step.
template <int Dim>
struct Configuration {
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
                           const Thickness& thickness, Configuration<Dim>& at) {
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

/// q_a = u_I gamma_aI / sqrt(corners): hourglass amplitudes [m] of a field of modes u, whose
/// gradient `at` has. gamma is orthogonal to all fields that are linear over `at`.
template <int Dim>
BRUNT_INLINE void hourglass_amplitudes(const Configuration<Dim>& at, const Modal<Dim, Pack>& u,
                                       HourglassModes<Dim>& q) {
  const Pack inverse = 1.0 / at.measure;
  Pack L[Dim][Dim];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = at.G[i][j] * inverse;
  }
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) {
      Pack linear = L[i][0] * at.mode[a][0];
      for (int j = 1; j < Dim; ++j) linear += L[i][j] * at.mode[a][j];
      q[a][i] = kRootCorners<Dim> * (u.m[Dim + a][i] - linear);
    }
  }
}

template <int Dim>
BRUNT_INLINE Pack dot(const HourglassModes<Dim>& Q, const HourglassModes<Dim>& q) {
  Pack sum = broadcast<Pack>(0);
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) sum += Q[a][i] * q[a][i];
  }
  return sum;
}

/// What kinematics hand to forces, of four elements.
template <int Dim>
struct OnePointWork {
  Configuration<Dim> now;  ///< at x(n+1)
  OperatorNorm<Pack> norm;
  Pack hourglass[Shape<Dim>::kModes - 1][Dim];  ///< [N] modes of the forces of hourglass control
  Pack rho;                                     ///< [kg/m^3]
  Pack rate;                                    ///< [1/s] volumetric strain rate at mid-step
  Pack q;                                       ///< [Pa] bulk viscosity at n+1
  Pack speed;                                   ///< [m/s] of sound
  Pack stress_work, viscous_work;               ///< [J] halves of the old forces
};

template <int Dim>
struct Lane {
  ElementBlock<Dim>& block;
  const ElementStep<Dim>& step;
  std::size_t e;  ///< first of four elements
};

template <int Dim>
BRUNT_INLINE void load_modes(const Lane<Dim>& lane, Modal<Dim, Pack>& c, Modal<Dim, Pack>& u) {
  const LocalIndex* corner = lane.block.corner.data() + lane.e * Shape<Dim>::kCorners;
  Pack node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, lane.step.x, node);
  c = modes_of<Dim>(node);
  gather<Dim>(corner, lane.step.v, node);
  u = modes_of<Dim>(node);
  for (auto& mode : u.m) {
    for (int i = 0; i < Dim; ++i) mode[i] = lane.step.dt * mode[i];
  }
}

template <int Dim>
BRUNT_INLINE Modal<Dim, Pack> moved_back(const Modal<Dim, Pack>& c, const Modal<Dim, Pack>& u,
                                         Real part) {
  Modal<Dim, Pack> r;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) r.m[m][i] = c.m[m][i] - part * u.m[m][i];
  }
  return r;
}

/// Modes of the forces that do the work Q . q on amplitudes measured on `at`, to w.hourglass.
template <int Dim>
BRUNT_INLINE void set_hourglass_forces(const Configuration<Dim>& at, const HourglassModes<Dim>& Q,
                                       OnePointWork<Dim>& w) {
  const Pack k = kRootCorners<Dim> / at.measure;
  for (int i = 0; i < Dim; ++i) {
    Pack moment[Dim];
    for (int j = 0; j < Dim; ++j) {
      moment[j] = Q[0][i] * at.mode[0][j];
      for (int a = 1; a < Shape<Dim>::kHourglass; ++a) moment[j] += Q[a][i] * at.mode[a][j];
      moment[j] *= k;
    }
    for (int m = 0; m < Shape<Dim>::kModes - 1; ++m) {
      Pack force = broadcast<Pack>(0);
      if (m < Shape<Dim>::kActive) {
        for (int j = 0; j < Dim; ++j) force += moment[j] * at.E[m][j];
      }
      if (m >= Dim) force -= (1.0 / kRootCorners<Dim>)*Q[m - Dim][i];
      w.hourglass[m][i] = force;
    }
  }
}

/// Viscous control: Q = 2 Q_HG rho c l^2 dq/dt at mid-step.
template <int Dim>
BRUNT_INLINE void resist_rates(const Lane<Dim>& lane, Real coefficient,
                               const Configuration<Dim>& old, const Configuration<Dim>& mid,
                               const Modal<Dim, Pack>& u, OnePointWork<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  const auto kept = [&](int a, int i) {
    return block.hourglass.data() + static_cast<std::size_t>(a * Dim + i) * block.n_padded + lane.e;
  };
  HourglassModes<Dim> q, Q;
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) Q[a][i] = load(kept(a, i));
  }
  hourglass_amplitudes(old, u, q);
  const Pack old_work = dot<Dim>(Q, q);
  hourglass_amplitudes(mid, u, q);
  const Pack size = load(block.reference_size.data() + lane.e);
  Pack area = size * size;
  if constexpr (Dim == 2) area = size * w.now.thickness;
  const Pack k = (2.0 * coefficient / lane.step.dt) * w.rho * w.speed * area;
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) {
      Q[a][i] = k * q[a][i];
      store(kept(a, i), Q[a][i]);
    }
  }
  hourglass_amplitudes(w.now, u, q);
  add_half(block.hourglass_work, lane.e, old_work + dot<Dim>(Q, q));
  set_hourglass_forces(w.now, Q, w);
}

/// Stiffness control: Q = k q of the positions c, gamma and k those of the positions at time 0.
/// A linear map of the body has no q, a turn turns it with the body, and its energy k q^2/2 is that
/// of a spring. Forces summed over rates have no potential: where the deformation of an element
/// comes and goes they keep a rest, of the order of the strain (Joldes, Wittek & Miller 2008).
template <int Dim>
BRUNT_INLINE void resist_amplitudes(const Lane<Dim>& lane, const Modal<Dim, Pack>& c,
                                    OnePointWork<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  Pack node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(block.corner.data() + lane.e * Shape<Dim>::kCorners, lane.step.x_start, node);
  Configuration<Dim> start;
  evaluate(modes_of<Dim>(node), c, lane.step.thickness, start);
  HourglassModes<Dim> q, Q;
  hourglass_amplitudes(start, c, q);
  const Pack k = load(block.hourglass_stiffness.data() + lane.e);
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) Q[a][i] = k * q[a][i];
  }
  store(block.hourglass_work.data() + lane.e, 0.5 * dot<Dim>(Q, q));
  set_hourglass_forces(start, Q, w);
}

/// Halves of the works that the forces at n do on the displacement of the step.
template <int Dim>
BRUNT_INLINE void book_old_forces(const Lane<Dim>& lane, const Configuration<Dim>& old,
                                  OnePointWork<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, lane.e, s);
  w.stress_work = old.work(s, load(block.state.pressure.data() + lane.e));
  w.viscous_work = -load(block.viscous_pressure.data() + lane.e) * old.dilatation();
}

/// Strain increment and rotation at mid-step: fills the tile, rotates the deviator.
template <int Dim>
BRUNT_INLINE void deform(const Lane<Dim>& lane, const Configuration<Dim>& mid, int at,
                         MaterialTile& tile, OnePointWork<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  const Pack inverse = 1.0 / mid.measure;
  Pack L[Dim][Dim], hoop = broadcast<Pack>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = mid.G[i][j] * inverse;
  }
  if constexpr (Dim == 2) hoop = inverse * mid.G_hoop / mid.thickness;
  store_strain<Dim>(L, hoop, at, tile);

  const auto rotation = step_rotation(L);
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, lane.e, s);
  rotate_symmetric(rotation, s);
  for (int k = 0; k < kTensorSize<Dim>; ++k) store(block.state.deviator[k].data() + lane.e, s[k]);

  w.rate = (1.0 / lane.step.dt) * (trace(L) + hoop);
  const Pack bulk = load(block.state.bulk.data() + lane.e);
  w.speed = vsqrt((bulk + (4.0 / 3) * block.material->shear) / w.rho);
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.norm.template height<Dim>(), w.speed,
                       w.rate);
}

/// Strain, rotation and ratios of four elements for the material; works of the old forces.
template <int Dim>
BRUNT_INLINE void kinematics(const Lane<Dim>& lane, int at, MaterialTile& tile,
                             OnePointWork<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  const Thickness& thickness = lane.step.thickness;
  Modal<Dim, Pack> c, u;
  load_modes(lane, c, u);
  evaluate(c, u, thickness, w.now);
  Configuration<Dim> old, mid;
  evaluate(moved_back<Dim>(c, u, 1.0), u, thickness, old);
  evaluate(moved_back<Dim>(c, u, 0.5), u, thickness, mid);
  book_old_forces(lane, old, w);

  const Pack inverse_reference = 1.0 / load(block.element_volume.data() + lane.e);
  const Pack volume = w.now.volume();
  store(tile.ratio_old + at, old.volume() * inverse_reference);
  store(tile.ratio + at, volume * inverse_reference);
  w.rho = load(block.mass.data() + lane.e) / volume;
  w.norm = operator_norm<Dim, Pack>(w.now.E, w.now.measure, w.now.hoop_gradient(thickness));
  deform(lane, mid, at, tile, w);
  if (const auto* viscous = std::get_if<ViscousHourglass>(&block.options.hourglass)) {
    resist_rates(lane, viscous->coefficient, old, mid, u, w);
  } else {
    resist_amplitudes(lane, c, w);
  }
  w.viscous_work -= w.q * w.now.dilatation();
  store(tile.viscous_work + at, 0.5 * w.viscous_work * inverse_reference);
}

/// Forces of four elements on their corners, from the stress at n+1 and hourglass control.
template <int Dim>
BRUNT_INLINE void corner_forces(const OnePointWork<Dim>& w, const Pack (&s)[6], Pack p, Real* out,
                                const Thickness& thickness) {
  Pack sigma[Dim][Dim];
  stress_matrix(s, p, sigma);
  if constexpr (Dim == 2) {
    for (auto& row : sigma) {
      for (Pack& component : row) component *= w.now.thickness;
    }
  }
  Modal<Dim, Pack> f;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) {
      f.m[m][i] = m < Shape<Dim>::kModes - 1 ? w.hourglass[m][i] : broadcast<Pack>(0);
      if (m >= Shape<Dim>::kActive) continue;
      for (int j = 0; j < Dim; ++j) f.m[m][i] -= sigma[i][j] * w.now.E[m][j];
    }
  }
  if constexpr (Dim == 2) {
    f.m[Shape<2>::kModes - 1][0] -= (0.25 * thickness.radial) * w.now.measure * (s[zz] - p);
  }
  Pack node[Shape<Dim>::kCorners][Dim];
  for (int i = 0; i < Dim; ++i) to_corners(f, i, node);
  scatter<Dim>(node, out);
}

/// New halves of the works, forces and stable step of four elements.
template <int Dim>
BRUNT_INLINE void dynamics(const Lane<Dim>& lane, OnePointWork<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  const std::size_t e = lane.e;
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, e, s);
  const Pack p = load(block.state.pressure.data() + e);
  add_half(block.stress_work, e, w.stress_work + w.now.work(s, p));
  add_half(block.viscous_work, e, w.viscous_work);
  store(block.viscous_pressure.data() + e, w.q);
  store_stable_step<Dim>(block, e, w.norm, w.rho, load(block.state.bulk.data() + e), w.rate);
  corner_forces(w, s, p + w.q, lane.step.corner_force + e * Shape<Dim>::kCorners * Dim,
                lane.step.thickness);
}

}  // namespace

template <int Dim>
void advance_one_point(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  constexpr int kGroups = kTile / kLanes;
  OnePointWork<Dim> work[kGroups];
  MaterialTile tile;
  open_tile(block, index, tile);
  for (int g = 0; g < kGroups; ++g) {
    kinematics(Lane<Dim>{block, step, tile.first + g * kLanes}, g * kLanes, tile, work[g]);
  }
  block.material->update(tile, step.dt);
  for (int g = 0; g < kGroups; ++g) {
    dynamics(Lane<Dim>{block, step, tile.first + g * kLanes}, work[g]);
  }
}

template void advance_one_point(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_one_point(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
