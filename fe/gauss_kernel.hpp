#pragma once
/// Elements with 2^Dim Gauss points: full integration, and q1p0, where one dilatation and one
/// pressure serve the element (mean dilatation, Nagtegaal, Parks & Rice 1974; B-bar, Hughes 1980);
/// lanes_of<V> at a time.
#include "fe/fetch_group.hpp"
#include "fe/gauss_point.hpp"
#include "fe/mechanical_heat.hpp"
#include "fe/shape_guard.hpp"

namespace brunt {
namespace gauss {

/// GaussWork of pressures on the dilatation of the step: one mean pressure, or each its own.
template <class V>
struct PressureWork {
  bool mean;
  V volume = broadcast<V>(0), pressure_volume = broadcast<V>(0);
  V dilatation = broadcast<V>(0), own = broadcast<V>(0);

  BRUNT_INLINE void add(V point_volume, V p, V point_dilatation) {
    volume += point_volume;
    pressure_volume += p * point_volume;
    dilatation += point_dilatation;
    own -= p * point_dilatation;
  }
  BRUNT_INLINE V mean_pressure() const { return pressure_volume / volume; }
  BRUNT_INLINE V work() const { return mean ? -mean_pressure() * dilatation : own; }
};

/// What kinematics hand to forces, of four elements.
template <int Dim, class V>
struct GaussWork {
  Modal<Dim, V> c, u;  ///< [m] position at n+1, displacement of the step
  GaussPoint<Dim, V> now[kGauss<Dim>];
  OperatorNorm<V> norm;
  V height;                     ///< [m] of the norm
  V rho, rate, q;               ///< [kg/m^3], [1/s], [Pa] as in one_point.cpp
  V stress_work, viscous_work;  ///< [J]
};

template <int Dim, class V>
struct Group {
  ElementBlock<Dim>& block;
  const ElementStep<Dim>& step;
  std::size_t e;      ///< first of four elements
  std::size_t point;  ///< first material point: that of Gauss point 0
  int at;             ///< the same within the tile
  bool mean;          ///< q1p0
};

template <int Dim, class V>
BRUNT_INLINE void load_modes(const Group<Dim, V>& group, GaussWork<Dim, V>& w) {
  const LocalIndex* corner = group.block.corner.data() + group.e * Shape<Dim>::kCorners;
  V node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, group.step.x, node);
  w.c = modes_of<Dim>(node);
  gather<Dim>(corner, group.step.v, node);
  w.u = modes_of<Dim>(node, group.step.dt);
}

/// Sums over the Gauss points of four elements.
template <class V>
struct GaussSums {
  PressureWork<V> old;  ///< of the pressures at n
  V stress_work = broadcast<V>(0);
  V mid_volume = broadcast<V>(0), mid_dilatation = broadcast<V>(0);
  V volume = broadcast<V>(0), dilatation = broadcast<V>(0);  ///< at n+1
  V square = broadcast<V>(0);  ///< cofactors squared over the determinant at n+1
};

/// Sum of the squared gradients of a parallelepiped with these slopes, times its determinant.
template <int Dim, class V>
BRUNT_INLINE V squared_cofactors(const V (&cof)[Dim][Dim], V determinant) {
  V square = broadcast<V>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) square += cof[i][j] * cof[i][j];
  }
  return square / determinant;
}

/// At a Gauss point: halves of the works of the forces at n; ratio before the step; then strain
/// increment and rotation at mid-step.
template <int Dim, class V>
BRUNT_INLINE void deform(const Group<Dim, V>& group, const GaussSlopes<Dim, V>& slope, int g,
                         MaterialTile& tile, GaussSums<V>& sums) {
  MaterialState& state = group.block.state;
  const std::size_t k = group.point + kGroup * g;
  const int at = group.at + kGroup * g;
  GaussPoint<Dim, V> point;
  evaluate(slope, 1.0, group.step.thickness, point);
  V s[6];
  load_tensor<Dim>(state.deviator, k, s);
  sums.stress_work += point.work(s);
  sums.old.add(point.volume(), load_as<V>(state.pressure.data() + k), point.dilatation());
  store(tile.ratio_old + at, point.volume() / load_as<V>(group.block.reference_volume.data() + k));

  evaluate(slope, 0.5, group.step.thickness, point);
  sums.mid_volume += point.volume();
  sums.mid_dilatation += point.dilatation();
  const V inverse = 1.0 / point.determinant;
  V L[Dim][Dim], hoop = broadcast<V>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = point.G[i][j] * inverse;
  }
  if constexpr (Dim == 2) hoop = point.hoop / point.thickness;
  store_strain<Dim>(L, hoop, at, tile);
  rotate_symmetric(step_rotation(L), s);
  for (int i = 0; i < kTensorSize<Dim>; ++i) store(state.deviator[i].data() + k, s[i]);
}

/// Gives the points of an element one dilatation and one ratio to time 0.
template <int Dim, class V>
BRUNT_INLINE void share_dilatation(const Group<Dim, V>& group, const GaussSums<V>& sums,
                                   MaterialTile& tile) {
  const V mean = sums.mid_dilatation / sums.mid_volume;
  const V reference = load_as<V>(group.block.element_volume.data() + group.e);
  const V ratio_old = sums.old.volume / reference;
  const V ratio = sums.volume / reference;
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const int k = group.at + kGroup * g;
    const V own = load_as<V>(tile.strain[xx] + k) + load_as<V>(tile.strain[yy] + k) +
                  load_as<V>(tile.strain[zz] + k);
    const V shift = (1.0 / 3) * (mean - own);
    for (int i = xx; i <= zz; ++i)
      store(tile.strain[i] + k, load_as<V>(tile.strain[i] + k) + shift);
    store(tile.ratio_old + k, ratio_old);
    store(tile.ratio + k, ratio);
  }
}

/// Largest bulk modulus of the points of four elements [Pa].
template <int Dim, class V>
BRUNT_INLINE V largest_bulk(const Group<Dim, V>& group) {
  V bulk = load_as<V>(group.block.state.bulk.data() + group.point);
  for (int g = 1; g < kGauss<Dim>; ++g) {
    bulk = vmax(bulk, load_as<V>(group.block.state.bulk.data() + group.point + kGroup * g));
  }
  return bulk;
}

/// Square of the hoop gradient of an axisymmetric element with Gauss points [1/m^2], such that
/// corners times it bounds the hoop work of a corner's motion over the corner's mass:
/// max_I (sum_g w N_I / r^2) / (sum_g w N_I) / corners, over the corners off the axis: those on it
/// do not move radially.
template <class V>
BRUNT_INLINE V hoop_norm(const Modal<2, V>& c, const Thickness& option) {
  V work[4], weight[4];
  for (int I = 0; I < 4; ++I) work[I] = weight[I] = broadcast<V>(0);
  for (int g = 0; g < 4; ++g) {
    V J[2][2], thickness = option.constant + option.radial * c.m[3][0];
    slopes(c, g, J);
    for (int m = 0; m < 3; ++m)
      thickness += (option.radial * kGaussTable<2>.value[g][m]) * c.m[m][0];
    const V volume = thickness * (J[0][0] * J[1][1] - J[0][1] * J[1][0]);
    const V gradient = option.radial / thickness;
    for (int I = 0; I < 4; ++I) {
      const Real N = (1 + Shape<2>::kSign[I][0] * kGaussTable<2>.value[g][0]) *
                     (1 + Shape<2>::kSign[I][1] * kGaussTable<2>.value[g][1]);
      weight[I] += N * volume;
      work[I] += N * volume * (gradient * gradient);
    }
  }
  V corner[4][2], most = broadcast<V>(0);
  to_corners(c, 0, corner);
  for (int I = 0; I < 4; ++I) {
    const auto on_axis = corner[I][0] <= 1e-9 * c.m[3][0];
    most = vmax(most, select(on_axis, broadcast<V>(0), work[I] / weight[I]));
  }
  return 0.25 * most;
}

/// Norm of the gradient operator: that of the mean gradient, scaled up by what the gradients at the
/// Gauss points, each as of the parallelepiped that touches there, exceed it in the mean trace.
/// square: sum of squared_cofactors over the points
template <int Dim, class V>
BRUNT_INLINE OperatorNorm<V> gauss_norm(const Modal<Dim, V>& c, V square, const Thickness& option) {
  V E[Shape<Dim>::kActive][Dim];
  volume_gradient(c, E);
  const V size = measure<Dim, V>(c, E);
  OperatorNorm<V> norm = operator_norm<Dim, V>(E, 1.0 / size, broadcast<V>(0));
  const V scale =
      vmax(broadcast<V>(1), square / (static_cast<Real>(Shape<Dim>::kCorners) * size * norm.trace));
  norm.trace *= scale;
  norm.largest *= scale;
  if constexpr (Dim == 2) {
    if (option.radial > 0) norm.hoop = hoop_norm(c, option);
  }
  return norm;
}

template <int Dim, class V>
BRUNT_INLINE void kinematics(const Group<Dim, V>& group, MaterialTile& tile, GaussWork<Dim, V>& w) {
  const ElementBlock<Dim>& block = group.block;
  const bool ahead = looks_ahead(block, group.e);
  if (ahead) fetch_elements(block, group.e + kTile / kGauss<Dim>, group.step);
  load_modes(group, w);
  GaussSums<V> sums{PressureWork<V>{group.mean}};
  for (int g = 0; g < kGauss<Dim>; ++g) {
    if (ahead) fetch_stress(block, group.point + kTile + kGroup * g);
    const GaussSlopes<Dim, V> slope(w.c, w.u, g);
    deform(group, slope, g, tile, sums);
    GaussPoint<Dim, V>& now = w.now[g];
    evaluate(slope, 0.0, group.step.thickness, now);
    sums.volume += now.volume();
    sums.dilatation += now.dilatation();
    sums.square += squared_cofactors(now.cof, now.determinant);
    store(tile.ratio + group.at + kGroup * g,
          now.volume() / load_as<V>(block.reference_volume.data() + group.point + kGroup * g));
  }
  if (group.mean) share_dilatation(group, sums, tile);
  w.stress_work = sums.stress_work + sums.old.work();
  w.viscous_work = -load_as<V>(block.viscous_pressure.data() + group.e) * sums.old.dilatation;
  w.rate = (1.0 / group.step.dt) * (sums.mid_dilatation / sums.mid_volume);
  w.rho = load_as<V>(block.mass.data() + group.e) / sums.volume;
  w.norm = gauss_norm(w.c, sums.square, group.step.thickness);
  w.height = w.norm.template height<Shape<Dim>>();
  const V speed = vsqrt((largest_bulk(group) + (4.0 / 3) * block.material->shear) / w.rho);
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.height, speed, w.rate);
  w.viscous_work -= w.q * sums.dilatation;
  const V heat = 0.5 * w.viscous_work * (1.0 / load_as<V>(block.element_volume.data() + group.e));
  for (int g = 0; g < kGauss<Dim>; ++g) store(tile.viscous_work + group.at + kGroup * g, heat);
}

/// Adds to the modal forces what the stress s - p does at one Gauss point.
template <int Dim, class V>
BRUNT_INLINE void subtract_stress(const GaussPoint<Dim, V>& point, const V (&s)[6], V p,
                                  const Thickness& option, int g, Modal<Dim, V>& f) {
  V sigma[Dim][Dim];
  stress_matrix(s, p, sigma);
  const auto& slope = kGaussTable<Dim>.slope[g];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      V P = sigma[i][0] * point.cof[0][j];
      for (int k = 1; k < Dim; ++k) P += sigma[i][k] * point.cof[k][j];
      if constexpr (Dim == 2) P *= point.thickness;
      f.m[j][i] -= P;
      for (int m = Dim; m < Shape<Dim>::kModes - 1; ++m) {
        if (!is_flat<Dim>(m, j)) f.m[m][i] -= slope[m][j] * P;
      }
    }
  }
  if constexpr (Dim == 2) {
    const V hoop = option.radial * point.determinant * (s[zz] - p);
    for (int m = 0; m < Shape<2>::kModes; ++m) f.m[m][0] -= kGaussTable<2>.value[g][m] * hoop;
  }
}

/// Mean pressure of four elements at n+1.
template <int Dim, class V>
BRUNT_INLINE V mean_pressure(const Group<Dim, V>& group, const GaussWork<Dim, V>& w) {
  V volume = broadcast<V>(0), sum = broadcast<V>(0);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    volume += w.now[g].volume();
    sum += w.now[g].volume() *
           load_as<V>(group.block.state.pressure.data() + group.point + kGroup * g);
  }
  return sum / volume;
}

/// New halves of the works, forces and stable step of four elements.
template <int Dim, class V>
BRUNT_INLINE void dynamics(const Group<Dim, V>& group, GaussWork<Dim, V>& w) {
  ElementBlock<Dim>& block = group.block;
  const V mean = group.mean ? mean_pressure(group, w) : broadcast<V>(0);
  PressureWork<V> pressure{group.mean};
  Modal<Dim, V> f;
  for (auto& mode : f.m) {
    for (int i = 0; i < Dim; ++i) mode[i] = broadcast<V>(0);
  }
  const bool ahead = looks_ahead(block, group.e);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    if (ahead) fetch_material(block, group.point + kTile + kGroup * g);
    const GaussPoint<Dim, V>& point = w.now[g];
    V s[6];
    load_tensor<Dim>(block.state.deviator, group.point + kGroup * g, s);
    const V p = load_as<V>(block.state.pressure.data() + group.point + kGroup * g);
    w.stress_work += point.work(s);
    pressure.add(point.volume(), p, point.dilatation());
    subtract_stress(point, s, (group.mean ? mean : p) + w.q, group.step.thickness, g, f);
  }
  add_half(block.stress_work, group.e, w.stress_work + pressure.work());
  add_half(block.viscous_work, group.e, w.viscous_work);
  store(block.viscous_pressure.data() + group.e, w.q);
  store_stable_step<Shape<Dim>>(block, group.e, w.norm, w.height, w.rho, largest_bulk(group),
                                w.rate);
  V node[Shape<Dim>::kCorners][Dim];
  for (auto& mode : f.m) {
    for (int i = 0; i < Dim; ++i) mode[i] = (1.0 / Shape<Dim>::kCorners) * mode[i];
  }
  for (int i = 0; i < Dim; ++i) to_corners(f, i, node);
  V mode_square = broadcast<V>(0);
  for (int m = Dim; m < Shape<Dim>::kModes - 1; ++m) {
    for (int i = 0; i < Dim; ++i) mode_square += w.c.m[m][i] * w.c.m[m][i];
  }
  guard_shapes<Dim>(block, group.e, w.norm, mode_square, group.step, node);
  add_to_nodes(node, mechanical_heat<V>(block, group.e, group.step.dt), group.e, group.step.sums);
}

}  // namespace gauss

template <int Dim, class V>
void advance_gauss(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  constexpr int kLanesOfV = lanes_of<V>;
  constexpr int kElements = kTile / kGauss<Dim>;
  const bool mean = block.options.integration == Integration::q1p0;
  gauss::GaussWork<Dim, V> work[kElements / kLanesOfV];
  MaterialTile tile;
  open_tile(block, index, tile);
  const LocalIndex first = index * kElements;
  const auto group = [&](int k) {
    const LocalIndex e = first + k * kLanesOfV;
    const std::size_t point = block.point(e, 0);
    return gauss::Group<Dim, V>{
        block, step, slot_of(e), point, static_cast<int>(point - tile.first), mean};
  };
  for (int k = 0; k < kElements / kLanesOfV; ++k) gauss::kinematics(group(k), tile, work[k]);
  block.material->update(tile, step.dt);
  for (int k = 0; k < kElements / kLanesOfV; ++k) gauss::dynamics(group(k), work[k]);
}

}  // namespace brunt
// Tested by tests/unit/fe/wide_lanes_test.cpp.
