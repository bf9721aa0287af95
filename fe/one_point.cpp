/// One-point elements with hourglass control, Flanagan & Belytschko 1981, in modal coordinates.
#include "fe/element_step.hpp"

namespace brunt {
namespace {

template <int Dim>
constexpr Real kRootCorners = Dim == 3 ? 2.82842712474619009760 : 2.0;

/// Gradients of the displacement of the step at one configuration.
template <int Dim>
struct Configuration {
  Pack E[Shape<Dim>::kActive][Dim];  ///< [m^(Dim-1)] dV/dc / corners
  Pack measure;                      ///< [m^Dim] volume; area in 2D
  Pack thickness;                    ///< [m] depth or 2 pi r; 1 in 3D
  Pack G[Dim][Dim];                  ///< [m^Dim] sum dx (x) B
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
  /// Work of the stress s - p on the displacement of the step [J].
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
  if constexpr (Dim == 2) {
    at.thickness = thickness.constant + thickness.radial * c.m[mean][0];
    at.G_hoop = thickness.radial * at.measure * u.m[mean][0];
  }
}

/// Values of the hourglass modes of a field, [mode][component].
template <int Dim>
using HourglassModes = Pack[Shape<Dim>::kHourglass][Dim];

/// q_a = dx_I gamma_aI / sqrt(corners): what the step adds to the hourglass amplitudes [m].
/// c, u  hourglass modes of position and displacement [m]
template <int Dim>
BRUNT_INLINE void hourglass_increment(const Pack (*c)[Dim], const Pack (*u)[Dim],
                                      const Configuration<Dim>& at, HourglassModes<Dim>& q) {
  const Pack inverse = 1.0 / at.measure;
  Pack L[Dim][Dim];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = at.G[i][j] * inverse;
  }
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) {
      Pack linear = L[i][0] * c[a][0];
      for (int j = 1; j < Dim; ++j) linear += L[i][j] * c[a][j];
      q[a][i] = kRootCorners<Dim> * (u[a][i] - linear);
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
struct Work {
  Configuration<Dim> now;     ///< at x(n+1)
  HourglassModes<Dim> mode;   ///< [m] of x(n+1)
  HourglassModes<Dim> moved;  ///< [m] of the displacement of the step
  HourglassModes<Dim> Q;      ///< [N] hourglass forces: n, then n+1
  OperatorNorm<Pack> norm;
  Pack rho;                                        ///< [kg/m^3]
  Pack rate;                                       ///< [1/s] volumetric strain rate at mid-step
  Pack q;                                          ///< [Pa] bulk viscosity at n+1
  Pack stress_work, hourglass_work, viscous_work;  ///< [J] halves of the old forces
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

/// Hourglass forces of the step: viscous from the rate, stiffness rotated and incremented.
template <int Dim, class R>
BRUNT_INLINE void update_hourglass(const Lane<Dim>& lane, const R& rotation,
                                   const HourglassModes<Dim>& q, Pack c, Work<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  if (const auto* viscous = std::get_if<ViscousHourglass>(&block.options.hourglass)) {
    const Pack size = load(block.reference_size.data() + lane.e);
    Pack area = size * size;
    if constexpr (Dim == 2) area = size * w.now.thickness;
    const Pack k = (2.0 * viscous->coefficient / lane.step.dt) * w.rho * c * area;
    for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
      for (int i = 0; i < Dim; ++i) w.Q[a][i] = k * q[a][i];
    }
    return;
  }
  const Real coefficient = std::get<StiffnessHourglass>(block.options.hourglass).coefficient;
  const Pack k = (coefficient * block.material->shear) * w.norm.trace * w.now.volume();
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    rotate_vector(rotation, w.Q[a]);
    for (int i = 0; i < Dim; ++i) w.Q[a][i] += k * q[a][i];
  }
}

/// Halves of the works that the forces at n do on the displacement of the step.
template <int Dim>
BRUNT_INLINE void book_old_forces(const Lane<Dim>& lane, const Configuration<Dim>& old,
                                  const Modal<Dim, Pack>& c, const Modal<Dim, Pack>& u,
                                  Work<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, lane.e, s);
  HourglassModes<Dim> q;
  hourglass_increment<Dim>(&c.m[Dim], &u.m[Dim], old, q);
  w.stress_work = old.work(s, load(block.state.pressure.data() + lane.e));
  w.hourglass_work = dot<Dim>(w.Q, q);
  w.viscous_work = -load(block.viscous_pressure.data() + lane.e) * old.dilatation();
}

/// Strain increment and rotation at mid-step: fills the tile, rotates deviator and Q.
template <int Dim>
BRUNT_INLINE void deform(const Lane<Dim>& lane, const Modal<Dim, Pack>& c,
                         const Modal<Dim, Pack>& u, int at, MaterialTile& tile, Work<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  Configuration<Dim> mid;
  evaluate(c, u, lane.step.thickness, mid);
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
  const Pack speed = vsqrt((bulk + (4.0 / 3) * block.material->shear) / w.rho);
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.norm.template height<Dim>(), speed,
                       w.rate);
  HourglassModes<Dim> q;
  hourglass_increment<Dim>(&c.m[Dim], &u.m[Dim], mid, q);
  update_hourglass(lane, rotation, q, speed, w);
}

/// Strain, rotation and ratios of four elements for the material; works of the old forces.
template <int Dim>
BRUNT_INLINE void kinematics(const Lane<Dim>& lane, int at, MaterialTile& tile, Work<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  const Thickness& thickness = lane.step.thickness;
  Modal<Dim, Pack> c, u;
  load_modes(lane, c, u);
  for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
    for (int i = 0; i < Dim; ++i) {
      w.mode[a][i] = c.m[Dim + a][i];
      w.moved[a][i] = u.m[Dim + a][i];
      w.Q[a][i] = load(block.hourglass.data() +
                       static_cast<std::size_t>(a * Dim + i) * block.n_padded + lane.e);
    }
  }
  evaluate(c, u, thickness, w.now);
  Configuration<Dim> old;
  const Modal<Dim, Pack> c_old = moved_back<Dim>(c, u, 1.0);
  evaluate(c_old, u, thickness, old);
  book_old_forces(lane, old, c_old, u, w);

  const Pack inverse_reference = 1.0 / load(block.element_volume.data() + lane.e);
  const Pack volume = w.now.volume();
  store(tile.ratio_old + at, old.volume() * inverse_reference);
  store(tile.ratio + at, volume * inverse_reference);
  w.rho = load(block.mass.data() + lane.e) / volume;
  w.norm = operator_norm<Dim, Pack>(w.now.E, w.now.measure, w.now.hoop_gradient(thickness));
  deform(lane, moved_back<Dim>(c, u, 0.5), u, at, tile, w);
  w.viscous_work -= w.q * w.now.dilatation();
  store(tile.viscous_work + at, 0.5 * w.viscous_work * inverse_reference);
}

/// Forces of four elements on their corners, from stress and hourglass forces at n+1.
template <int Dim>
BRUNT_INLINE void corner_forces(const Work<Dim>& w, const Pack (&s)[6], Pack p, Real* out,
                                const Thickness& thickness) {
  Pack sigma[Dim][Dim];
  stress_matrix(s, p, sigma);
  const Pack k = kRootCorners<Dim> / w.now.measure;
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      Pack moment = w.Q[0][i] * w.mode[0][j];
      for (int a = 1; a < Shape<Dim>::kHourglass; ++a) moment += w.Q[a][i] * w.mode[a][j];
      if constexpr (Dim == 2) sigma[i][j] *= w.now.thickness;
      sigma[i][j] = k * moment - sigma[i][j];
    }
  }
  Modal<Dim, Pack> f;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) {
      f.m[m][i] = broadcast<Pack>(0);
      if (m < Shape<Dim>::kActive) {
        for (int j = 0; j < Dim; ++j) f.m[m][i] += sigma[i][j] * w.now.E[m][j];
      }
      if (m >= Dim && m < Dim + Shape<Dim>::kHourglass) {
        f.m[m][i] -= (1.0 / kRootCorners<Dim>)*w.Q[m - Dim][i];
      }
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
BRUNT_INLINE void dynamics(const Lane<Dim>& lane, Work<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  const std::size_t e = lane.e;
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, e, s);
  const Pack p = load(block.state.pressure.data() + e);
  HourglassModes<Dim> q;
  hourglass_increment<Dim>(w.mode, w.moved, w.now, q);
  add_half(block.stress_work, e, w.stress_work + w.now.work(s, p));
  add_half(block.hourglass_work, e, w.hourglass_work + dot<Dim>(w.Q, q));
  add_half(block.viscous_work, e, w.viscous_work);
  store(block.viscous_pressure.data() + e, w.q);
  for (int k = 0; k < block.kHourglassValues; ++k) {
    store(block.hourglass.data() + static_cast<std::size_t>(k) * block.n_padded + e,
          w.Q[k / Dim][k % Dim]);
  }
  store_stable_step<Dim>(block, e, w.norm, w.rho, load(block.state.bulk.data() + e), w.rate);
  corner_forces(w, s, p + w.q, lane.step.corner_force + e * Shape<Dim>::kCorners * Dim,
                lane.step.thickness);
}

}  // namespace

template <int Dim>
void advance_one_point(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  constexpr int kGroups = kTile / kLanes;
  Work<Dim> work[kGroups];
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
