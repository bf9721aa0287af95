/// One-point elements, Flanagan & Belytschko 1981, in modal coordinates.
/// docs/theory/elements.md (E1) to (E3).
#include "fe/hourglass_control.hpp"
#include "fe/shape_guard.hpp"

namespace brunt {
namespace {

template <int Dim>
BRUNT_INLINE void load_modes(const OnePointLane<Dim>& lane, Modal<Dim, Pack>& c,
                             Modal<Dim, Pack>& u) {
  const LocalIndex* corner = lane.block.corner.data() + lane.e * Shape<Dim>::kCorners;
  Pack node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, lane.step.x, node);
  c = modes_of<Dim>(node);
  gather<Dim>(corner, lane.step.v, node);
  u = modes_of<Dim>(node, lane.step.dt);
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

/// Halves of the works that the forces at n do on the displacement of the step.
template <int Dim>
BRUNT_INLINE void book_old_forces(const OnePointLane<Dim>& lane,
                                  const OnePointConfiguration<Dim>& old, OnePointWork<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, lane.e, s);
  w.stress_work = old.work(s, load(block.state.pressure.data() + lane.e));
  w.viscous_work = -load(block.viscous_pressure.data() + lane.e) * old.dilatation();
}

/// Strain increment and rotation at mid-step: fills the tile, rotates the deviator.
template <int Dim>
BRUNT_INLINE void deform(const OnePointLane<Dim>& lane, const OnePointConfiguration<Dim>& mid,
                         int at, MaterialTile& tile, OnePointWork<Dim>& w) {
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
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.norm.template height<Shape<Dim>>(),
                       w.speed, w.rate);
}

/// Strain, rotation and ratios of four elements for the material; works of the old forces.
template <int Dim>
BRUNT_INLINE void kinematics(const OnePointLane<Dim>& lane, int at, MaterialTile& tile,
                             OnePointWork<Dim>& w) {
  const ElementBlock<Dim>& block = lane.block;
  const Thickness& thickness = lane.step.thickness;
  Modal<Dim, Pack> c, u;
  load_modes(lane, c, u);
  evaluate(c, u, thickness, w.now);
  OnePointConfiguration<Dim> old, mid;
  evaluate(moved_back<Dim>(c, u, 1.0), u, thickness, old);
  evaluate(moved_back<Dim>(c, u, 0.5), u, thickness, mid);
  book_old_forces(lane, old, w);

  const Pack reference = load(block.element_volume.data() + lane.e);
  const Pack volume = w.now.volume();
  store(tile.ratio_old + at, old.volume() / reference);
  store(tile.ratio + at, volume / reference);
  w.rho = load(block.mass.data() + lane.e) / volume;
  w.norm = operator_norm<Dim, Pack>(w.now.E, w.now.measure, w.now.hoop_gradient(thickness));
  deform(lane, mid, at, tile, w);
  resist_hourglasses(lane, old, mid, c, u, w);
  w.viscous_work -= w.q * w.now.dilatation();
  store(tile.viscous_work + at, 0.5 * w.viscous_work / reference);
}

/// Forces of four elements on their corners, from the stress at n+1 and hourglass control.
template <int Dim>
BRUNT_INLINE void corner_forces(const OnePointWork<Dim>& w, const Pack (&s)[6], Pack p,
                                const Thickness& thickness,
                                Pack (&node)[Shape<Dim>::kCorners][Dim]) {
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
  for (int i = 0; i < Dim; ++i) to_corners(f, i, node);
}

/// New halves of the works, forces and stable step of four elements.
template <int Dim>
BRUNT_INLINE void dynamics(const OnePointLane<Dim>& lane, OnePointWork<Dim>& w) {
  ElementBlock<Dim>& block = lane.block;
  const std::size_t e = lane.e;
  Pack s[6];
  load_tensor<Dim>(block.state.deviator, e, s);
  const Pack p = load(block.state.pressure.data() + e);
  add_half(block.stress_work, e, w.stress_work + w.now.work(s, p));
  add_half(block.viscous_work, e, w.viscous_work);
  store(block.viscous_pressure.data() + e, w.q);
  store_stable_step<Shape<Dim>>(block, e, w.norm, w.rho, load(block.state.bulk.data() + e), w.rate);
  Pack node[Shape<Dim>::kCorners][Dim];
  corner_forces(w, s, p + w.q, lane.step.thickness, node);
  guard_shapes<Dim>(block, e, w.norm, w.now.mode, lane.step, node);
  add_to_nodes(node, e, lane.step.sums);
}

}  // namespace

template <int Dim>
void advance_one_point(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  constexpr int kGroups = kTile / kLanes;
  OnePointWork<Dim> work[kGroups];
  MaterialTile tile;
  open_tile(block, index, tile);
  for (int g = 0; g < kGroups; ++g) {
    kinematics(OnePointLane<Dim>{block, step, tile.first + g * kLanes}, g * kLanes, tile, work[g]);
  }
  block.material->update(tile, step.dt);
  for (int g = 0; g < kGroups; ++g) {
    dynamics(OnePointLane<Dim>{block, step, tile.first + g * kLanes}, work[g]);
  }
}

template void advance_one_point(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_one_point(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
