#pragma once
/// One-point elements, Flanagan & Belytschko 1981, in modal coordinates, lanes_of<V> at a time.
/// docs/theory/elements.md (E1) to (E3).
#include "fe/fetch_group.hpp"
#include "fe/hourglass_control.hpp"
#include "fe/mechanical_heat.hpp"
#include "fe/shape_guard.hpp"

namespace brunt {

// Eight lanes are compiled with other flags than the rest of the program; both see these alike.
static_assert(sizeof(Vec<2>) == 16 && sizeof(Vec<3>) == 24 && alignof(Vec<2>) == 16 &&
              alignof(Vec<3>) == 8);

namespace one_point {

template <int Dim, class V>
BRUNT_INLINE void load_modes(const OnePointLane<Dim, V>& lane, Modal<Dim, V>& c, Modal<Dim, V>& u) {
  const LocalIndex* corner = lane.block.corner.data() + lane.e * Shape<Dim>::kCorners;
  V node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, lane.step.x, node);
  c = modes_of<Dim>(node);
  gather<Dim>(corner, lane.step.v, node);
  u = modes_of<Dim>(node, lane.step.dt);
}

template <int Dim, class V>
BRUNT_INLINE Modal<Dim, V> moved_back(const Modal<Dim, V>& c, const Modal<Dim, V>& u, Real part) {
  Modal<Dim, V> r;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) r.m[m][i] = c.m[m][i] - part * u.m[m][i];
  }
  return r;
}

/// Halves of the works that the forces at n do on the displacement of the step.
template <int Dim, class V>
BRUNT_INLINE void book_old_forces(const OnePointLane<Dim, V>& lane,
                                  const OnePointConfiguration<Dim, V>& old,
                                  OnePointWork<Dim, V>& w) {
  const ElementBlock<Dim>& block = lane.block;
  V s[6];
  load_tensor<Dim>(block.state.deviator, lane.e, s);
  w.stress_work = old.work(s, load_as<V>(block.state.pressure.data() + lane.e));
  w.viscous_work = -load_as<V>(block.viscous_pressure.data() + lane.e) * old.dilatation();
}

/// Strain increment and rotation at mid-step: fills the tile, rotates the deviator.
template <int Dim, class V>
BRUNT_INLINE void deform(const OnePointLane<Dim, V>& lane, const OnePointConfiguration<Dim, V>& mid,
                         int at, MaterialTile& tile, OnePointWork<Dim, V>& w) {
  ElementBlock<Dim>& block = lane.block;
  V L[Dim][Dim], hoop = broadcast<V>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = mid.G[i][j] * mid.inverse;
  }
  if constexpr (Dim == 2) hoop = mid.inverse * mid.G_hoop / mid.thickness;
  store_strain<Dim>(L, hoop, at, tile);

  const auto rotation = step_rotation(L);
  V s[6];
  load_tensor<Dim>(block.state.deviator, lane.e, s);
  rotate_symmetric(rotation, s);
  for (int k = 0; k < kTensorSize<Dim>; ++k) store(block.state.deviator[k].data() + lane.e, s[k]);

  w.rate = (1.0 / lane.step.dt) * (trace(L) + hoop);
  const V bulk = load_as<V>(block.state.bulk.data() + lane.e);
  w.speed = vsqrt((bulk + (4.0 / 3) * block.material->shear) / w.rho);
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.height, w.speed, w.rate);
}

/// Strain, rotation and ratios of four elements for the material; works of the old forces.
template <int Dim, class V>
BRUNT_INLINE void kinematics(const OnePointLane<Dim, V>& lane, int at, MaterialTile& tile,
                             OnePointWork<Dim, V>& w) {
  const ElementBlock<Dim>& block = lane.block;
  const Thickness& thickness = lane.step.thickness;
  Modal<Dim, V> c, u;
  load_modes(lane, c, u);
  evaluate(c, u, thickness, w.now);
  OnePointConfiguration<Dim, V> old, mid;
  evaluate(moved_back<Dim>(c, u, 0.5), u, thickness, mid);
  evaluate_start(moved_back<Dim>(c, u, 1.0), u, w.now, mid, thickness, old);
  book_old_forces(lane, old, w);

  const V reference = load_as<V>(block.element_volume.data() + lane.e);
  store(tile.ratio_old + at, old.volume() / reference);
  store(tile.ratio + at, w.now.volume() / reference);
  w.rho = load_as<V>(block.mass.data() + lane.e) * w.now.inverse_volume();
  w.norm = operator_norm<Dim, V>(w.now.E, w.now.inverse, w.now.hoop_gradient(thickness));
  w.height = w.norm.template height<Shape<Dim>>();
  w.mode_square = dot<Dim>(w.now.mode, w.now.mode);
  deform(lane, mid, at, tile, w);
  resist_hourglasses(lane, old, mid, c, u, w);
  w.viscous_work -= w.q * w.now.dilatation();
  store(tile.viscous_work + at, 0.5 * w.viscous_work / reference);
}

/// Forces of four elements on their corners, from the stress at n+1 and hourglass control.
template <int Dim, class V>
BRUNT_INLINE void corner_forces(const OnePointWork<Dim, V>& w, const V (&s)[6], V p,
                                const Thickness& thickness, V (&node)[Shape<Dim>::kCorners][Dim]) {
  V sigma[Dim][Dim];
  stress_matrix(s, p, sigma);
  if constexpr (Dim == 2) {
    for (auto& row : sigma) {
      for (V& component : row) component *= w.now.thickness;
    }
  }
  Modal<Dim, V> f;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) {
      f.m[m][i] = m < Shape<Dim>::kModes - 1 ? w.hourglass[m][i] : broadcast<V>(0);
      if (m >= Shape<Dim>::kActive) continue;
      for (int j = 0; j < Dim; ++j) f.m[m][i] = vfnma(sigma[i][j], w.now.E[m][j], f.m[m][i]);
    }
  }
  if constexpr (Dim == 2) {
    f.m[Shape<2>::kModes - 1][0] -= (0.25 * thickness.radial) * w.now.measure * (s[zz] - p);
  }
  for (int i = 0; i < Dim; ++i) to_corners(f, i, node);
}

/// New halves of the works, forces and stable step of four elements.
template <int Dim, class V>
BRUNT_INLINE void dynamics(const OnePointLane<Dim, V>& lane, OnePointWork<Dim, V>& w) {
  ElementBlock<Dim>& block = lane.block;
  const std::size_t e = lane.e;
  V s[6];
  load_tensor<Dim>(block.state.deviator, e, s);
  const V p = load_as<V>(block.state.pressure.data() + e);
  add_half(block.stress_work, e, w.stress_work + w.now.work(s, p));
  add_half(block.viscous_work, e, w.viscous_work);
  store(block.viscous_pressure.data() + e, w.q);
  store_stable_step<Shape<Dim>>(block, e, w.norm, w.height, w.rho,
                                load_as<V>(block.state.bulk.data() + e), w.rate);
  V node[Shape<Dim>::kCorners][Dim];
  corner_forces(w, s, p + w.q, lane.step.thickness, node);
  guard_shapes<Dim>(block, e, w.norm, w.mode_square, lane.step, node);
  add_to_nodes(node, mechanical_heat<V>(block, e, lane.step.dt), e, lane.step.sums);
}

}  // namespace one_point

template <int Dim, class V>
void advance_one_point(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  constexpr int kLanesOfV = lanes_of<V>, kGroups = kTile / kLanesOfV;
  OnePointWork<Dim, V> work[kGroups];
  MaterialTile tile;
  open_tile(block, index, tile);
  for (int g = 0; g < kGroups; ++g) {
    const OnePointLane<Dim, V> lane{block, step, tile.first + g * kLanesOfV};
    fetch_ahead(block, lane.e, step);
    one_point::kinematics(lane, g * kLanesOfV, tile, work[g]);
  }
  block.material->update(tile, step.dt);
  for (int g = 0; g < kGroups; ++g) {
    one_point::dynamics(OnePointLane<Dim, V>{block, step, tile.first + g * kLanesOfV}, work[g]);
  }
}

}  // namespace brunt
// Tested by tests/unit/fe/wide_lanes_test.cpp.
