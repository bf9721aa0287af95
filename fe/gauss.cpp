/// Elements with 2^Dim Gauss points: full integration, and q1p0, where one dilatation and one
/// pressure serve the element (mean dilatation, Nagtegaal, Parks & Rice 1974; B-bar, Hughes 1980).
#include "fe/element_step.hpp"
#include "fe/gauss_point.hpp"
#include "fe/shape_guard.hpp"

namespace brunt {
namespace {

/// GaussWork of pressures on the dilatation of the step: one mean pressure, or each its own.
struct PressureWork {
  bool mean;
  Pack volume = broadcast<Pack>(0), pressure_volume = broadcast<Pack>(0);
  Pack dilatation = broadcast<Pack>(0), own = broadcast<Pack>(0);

  BRUNT_INLINE void add(Pack point_volume, Pack p, Pack point_dilatation) {
    volume += point_volume;
    pressure_volume += p * point_volume;
    dilatation += point_dilatation;
    own -= p * point_dilatation;
  }
  BRUNT_INLINE Pack mean_pressure() const { return pressure_volume / volume; }
  BRUNT_INLINE Pack work() const { return mean ? -mean_pressure() * dilatation : own; }
};

/// What kinematics hand to forces, of four elements.
template <int Dim>
struct GaussWork {
  Modal<Dim, Pack> c, u;  ///< [m] position at n+1, displacement of the step
  GaussPoint<Dim> now[kGauss<Dim>];
  OperatorNorm<Pack> norm;
  Pack rho, rate, q;               ///< [kg/m^3], [1/s], [Pa] as in one_point.cpp
  Pack stress_work, viscous_work;  ///< [J]
};

template <int Dim>
struct Group {
  ElementBlock<Dim>& block;
  const ElementStep<Dim>& step;
  std::size_t e;      ///< first of four elements
  std::size_t point;  ///< first material point: that of Gauss point 0
  int at;             ///< the same within the tile
  bool mean;          ///< q1p0
};

template <int Dim>
BRUNT_INLINE void load_modes(const Group<Dim>& group, GaussWork<Dim>& w) {
  const LocalIndex* corner = group.block.corner.data() + group.e * Shape<Dim>::kCorners;
  Pack node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, group.step.x, node);
  w.c = modes_of<Dim>(node);
  gather<Dim>(corner, group.step.v, node);
  w.u = modes_of<Dim>(node, group.step.dt);
}

/// Sums over the Gauss points of four elements.
struct GaussSums {
  PressureWork old;  ///< of the pressures at n
  Pack stress_work = broadcast<Pack>(0);
  Pack mid_volume = broadcast<Pack>(0), mid_dilatation = broadcast<Pack>(0);
  Pack volume = broadcast<Pack>(0), dilatation = broadcast<Pack>(0);  ///< at n+1
  Pack square = broadcast<Pack>(0);  ///< cofactors squared over the determinant at n+1
};

/// Sum of the squared gradients of a parallelepiped with these slopes, times its determinant.
template <int Dim>
BRUNT_INLINE Pack squared_cofactors(const Pack (&cof)[Dim][Dim], Pack determinant) {
  Pack square = broadcast<Pack>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) square += cof[i][j] * cof[i][j];
  }
  return square / determinant;
}

/// At a Gauss point: halves of the works of the forces at n; ratio before the step; then strain
/// increment and rotation at mid-step.
template <int Dim>
BRUNT_INLINE void deform(const Group<Dim>& group, const GaussSlopes<Dim>& slope, int g,
                         MaterialTile& tile, GaussSums& sums) {
  MaterialState& state = group.block.state;
  const std::size_t k = group.point + kLanes * g;
  const int at = group.at + kLanes * g;
  GaussPoint<Dim> point;
  evaluate(slope, 1.0, group.step.thickness, point);
  Pack s[6];
  load_tensor<Dim>(state.deviator, k, s);
  sums.stress_work += point.work(s);
  sums.old.add(point.volume(), load(state.pressure.data() + k), point.dilatation());
  store(tile.ratio_old + at, point.volume() / load(group.block.reference_volume.data() + k));

  evaluate(slope, 0.5, group.step.thickness, point);
  sums.mid_volume += point.volume();
  sums.mid_dilatation += point.dilatation();
  const Pack inverse = 1.0 / point.determinant;
  Pack L[Dim][Dim], hoop = broadcast<Pack>(0);
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) L[i][j] = point.G[i][j] * inverse;
  }
  if constexpr (Dim == 2) hoop = point.hoop / point.thickness;
  store_strain<Dim>(L, hoop, at, tile);
  rotate_symmetric(step_rotation(L), s);
  for (int i = 0; i < kTensorSize<Dim>; ++i) store(state.deviator[i].data() + k, s[i]);
}

/// Gives the points of an element one dilatation and one ratio to time 0.
template <int Dim>
BRUNT_INLINE void share_dilatation(const Group<Dim>& group, const GaussSums& sums,
                                   MaterialTile& tile) {
  const Pack mean = sums.mid_dilatation / sums.mid_volume;
  const Pack reference = load(group.block.element_volume.data() + group.e);
  const Pack ratio_old = sums.old.volume / reference;
  const Pack ratio = sums.volume / reference;
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const int k = group.at + kLanes * g;
    const Pack own =
        load(tile.strain[xx] + k) + load(tile.strain[yy] + k) + load(tile.strain[zz] + k);
    const Pack shift = (1.0 / 3) * (mean - own);
    for (int i = xx; i <= zz; ++i) store(tile.strain[i] + k, load(tile.strain[i] + k) + shift);
    store(tile.ratio_old + k, ratio_old);
    store(tile.ratio + k, ratio);
  }
}

/// Largest bulk modulus of the points of four elements [Pa].
template <int Dim>
BRUNT_INLINE Pack largest_bulk(const Group<Dim>& group) {
  Pack bulk = load(group.block.state.bulk.data() + group.point);
  for (int g = 1; g < kGauss<Dim>; ++g) {
    bulk = vmax(bulk, load(group.block.state.bulk.data() + group.point + kLanes * g));
  }
  return bulk;
}

/// Square of the hoop gradient of an axisymmetric element with Gauss points [1/m^2], such that
/// corners times it bounds the hoop work of a corner's motion over the corner's mass:
/// max_I (sum_g w N_I / r^2) / (sum_g w N_I) / corners, over the corners off the axis: those on it
/// do not move radially.
BRUNT_INLINE Pack hoop_norm(const Modal<2, Pack>& c, const Thickness& option) {
  Pack work[4], weight[4];
  for (int I = 0; I < 4; ++I) work[I] = weight[I] = broadcast<Pack>(0);
  for (int g = 0; g < 4; ++g) {
    Pack J[2][2], thickness = option.constant + option.radial * c.m[3][0];
    slopes(c, g, J);
    for (int m = 0; m < 3; ++m)
      thickness += (option.radial * kGaussTable<2>.value[g][m]) * c.m[m][0];
    const Pack volume = thickness * (J[0][0] * J[1][1] - J[0][1] * J[1][0]);
    const Pack gradient = option.radial / thickness;
    for (int I = 0; I < 4; ++I) {
      const Real N = (1 + Shape<2>::kSign[I][0] * kGaussTable<2>.value[g][0]) *
                     (1 + Shape<2>::kSign[I][1] * kGaussTable<2>.value[g][1]);
      weight[I] += N * volume;
      work[I] += N * volume * (gradient * gradient);
    }
  }
  Pack corner[4][2], most = broadcast<Pack>(0);
  to_corners(c, 0, corner);
  for (int I = 0; I < 4; ++I) {
    const auto on_axis = corner[I][0] <= 1e-9 * c.m[3][0];
    most = vmax(most, select(on_axis, broadcast<Pack>(0), work[I] / weight[I]));
  }
  return 0.25 * most;
}

/// Norm of the gradient operator: that of the mean gradient, scaled up by what the gradients at the
/// Gauss points, each as of the parallelepiped that touches there, exceed it in the mean trace.
/// square: sum of squared_cofactors over the points
template <int Dim>
BRUNT_INLINE OperatorNorm<Pack> gauss_norm(const Modal<Dim, Pack>& c, Pack square,
                                           const Thickness& option) {
  Pack E[Shape<Dim>::kActive][Dim];
  volume_gradient(c, E);
  const Pack size = measure<Dim, Pack>(c, E);
  OperatorNorm<Pack> norm = operator_norm<Dim, Pack>(E, size, broadcast<Pack>(0));
  const Pack scale = vmax(broadcast<Pack>(1),
                          square / (static_cast<Real>(Shape<Dim>::kCorners) * size * norm.trace));
  norm.trace *= scale;
  norm.largest *= scale;
  if constexpr (Dim == 2) {
    if (option.radial > 0) norm.hoop = hoop_norm(c, option);
  }
  return norm;
}

template <int Dim>
BRUNT_INLINE void kinematics(const Group<Dim>& group, MaterialTile& tile, GaussWork<Dim>& w) {
  const ElementBlock<Dim>& block = group.block;
  load_modes(group, w);
  GaussSums sums{PressureWork{group.mean}};
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const GaussSlopes<Dim> slope(w.c, w.u, g);
    deform(group, slope, g, tile, sums);
    GaussPoint<Dim>& now = w.now[g];
    evaluate(slope, 0.0, group.step.thickness, now);
    sums.volume += now.volume();
    sums.dilatation += now.dilatation();
    sums.square += squared_cofactors(now.cof, now.determinant);
    store(tile.ratio + group.at + kLanes * g,
          now.volume() / load(block.reference_volume.data() + group.point + kLanes * g));
  }
  if (group.mean) share_dilatation(group, sums, tile);
  w.stress_work = sums.stress_work + sums.old.work();
  w.viscous_work = -load(block.viscous_pressure.data() + group.e) * sums.old.dilatation;
  w.rate = (1.0 / group.step.dt) * (sums.mid_dilatation / sums.mid_volume);
  w.rho = load(block.mass.data() + group.e) / sums.volume;
  w.norm = gauss_norm(w.c, sums.square, group.step.thickness);
  const Pack speed = vsqrt((largest_bulk(group) + (4.0 / 3) * block.material->shear) / w.rho);
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.norm.template height<Shape<Dim>>(),
                       speed, w.rate);
  w.viscous_work -= w.q * sums.dilatation;
  const Pack heat = 0.5 * w.viscous_work * (1.0 / load(block.element_volume.data() + group.e));
  for (int g = 0; g < kGauss<Dim>; ++g) store(tile.viscous_work + group.at + kLanes * g, heat);
}

/// Adds to the modal forces what the stress s - p does at one Gauss point.
template <int Dim>
BRUNT_INLINE void subtract_stress(const GaussPoint<Dim>& point, const Pack (&s)[6], Pack p,
                                  const Thickness& option, int g, Modal<Dim, Pack>& f) {
  Pack sigma[Dim][Dim];
  stress_matrix(s, p, sigma);
  const auto& slope = kGaussTable<Dim>.slope[g];
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) {
      Pack P = sigma[i][0] * point.cof[0][j];
      for (int k = 1; k < Dim; ++k) P += sigma[i][k] * point.cof[k][j];
      if constexpr (Dim == 2) P *= point.thickness;
      f.m[j][i] -= P;
      for (int m = Dim; m < Shape<Dim>::kModes - 1; ++m) {
        if (!is_flat<Dim>(m, j)) f.m[m][i] -= slope[m][j] * P;
      }
    }
  }
  if constexpr (Dim == 2) {
    const Pack hoop = option.radial * point.determinant * (s[zz] - p);
    for (int m = 0; m < Shape<2>::kModes; ++m) f.m[m][0] -= kGaussTable<2>.value[g][m] * hoop;
  }
}

/// Mean pressure of four elements at n+1.
template <int Dim>
BRUNT_INLINE Pack mean_pressure(const Group<Dim>& group, const GaussWork<Dim>& w) {
  Pack volume = broadcast<Pack>(0), sum = broadcast<Pack>(0);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    volume += w.now[g].volume();
    sum += w.now[g].volume() * load(group.block.state.pressure.data() + group.point + kLanes * g);
  }
  return sum / volume;
}

/// New halves of the works, forces and stable step of four elements.
template <int Dim>
BRUNT_INLINE void dynamics(const Group<Dim>& group, GaussWork<Dim>& w) {
  ElementBlock<Dim>& block = group.block;
  const Pack mean = group.mean ? mean_pressure(group, w) : broadcast<Pack>(0);
  PressureWork pressure{group.mean};
  Modal<Dim, Pack> f;
  for (auto& mode : f.m) {
    for (int i = 0; i < Dim; ++i) mode[i] = broadcast<Pack>(0);
  }
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const GaussPoint<Dim>& point = w.now[g];
    Pack s[6];
    load_tensor<Dim>(block.state.deviator, group.point + kLanes * g, s);
    const Pack p = load(block.state.pressure.data() + group.point + kLanes * g);
    w.stress_work += point.work(s);
    pressure.add(point.volume(), p, point.dilatation());
    subtract_stress(point, s, (group.mean ? mean : p) + w.q, group.step.thickness, g, f);
  }
  add_half(block.stress_work, group.e, w.stress_work + pressure.work());
  add_half(block.viscous_work, group.e, w.viscous_work);
  store(block.viscous_pressure.data() + group.e, w.q);
  store_stable_step<Shape<Dim>>(block, group.e, w.norm, w.rho, largest_bulk(group), w.rate);
  Pack node[Shape<Dim>::kCorners][Dim];
  for (auto& mode : f.m) {
    for (int i = 0; i < Dim; ++i) mode[i] = (1.0 / Shape<Dim>::kCorners) * mode[i];
  }
  for (int i = 0; i < Dim; ++i) to_corners(f, i, node);
  guard_shapes<Dim>(block, group.e, w.norm, w.c.m + Dim, group.step, node);
  add_to_nodes(node, group.e, group.step.sums);
}

}  // namespace

template <int Dim>
void advance_gauss(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  constexpr int kPoints = kLanes * kGauss<Dim>;
  constexpr int kGroups = kTile / kPoints;
  const bool mean = block.options.integration == Integration::q1p0;
  GaussWork<Dim> work[kGroups];
  MaterialTile tile;
  open_tile(block, index, tile);
  const auto group = [&](int k) {
    const std::size_t e = slot_of(index) * kGroups * kLanes;
    return Group<Dim>{block, step, e + k * kLanes, tile.first + k * kPoints, k * kPoints, mean};
  };
  for (int k = 0; k < kGroups; ++k) kinematics(group(k), tile, work[k]);
  block.material->update(tile, step.dt);
  for (int k = 0; k < kGroups; ++k) dynamics(group(k), work[k]);
}

template <int Dim>
void refresh_box_steps(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  const std::size_t first = slot_of(index) * block.elements_per_tile();
  for (int k = 0; k < block.elements_per_tile(); k += kLanes) {
    const std::size_t e = first + k;
    const Group<Dim> group{block, step, e, e * block.gauss, 0, false};
    GaussWork<Dim> w;
    load_modes(group, w);
    Pack E[Shape<Dim>::kActive][Dim], G[Dim][Dim];
    volume_gradient(w.c, E);
    volume_times_gradient<Dim, Pack>(w.u, E, G);
    const Pack size = measure<Dim, Pack>(w.c, E);
    if (block.gauss > 1) {
      Pack square = broadcast<Pack>(0);
      for (int g = 0; g < kGauss<Dim>; ++g) {
        Pack J[Dim][Dim], cof[Dim][Dim];
        slopes(w.c, g, J);
        cofactors(J, cof);
        const Pack determinant = determinant_of<Dim>(J, cof);
        square += squared_cofactors(cof, determinant);
      }
      w.norm = gauss_norm(w.c, square, step.thickness);
    } else {
      Pack hoop = broadcast<Pack>(0);
      if constexpr (Dim == 2) {
        const Thickness& option = step.thickness;
        hoop = 0.5 * option.radial / (option.constant + option.radial * w.c.m[3][0]);
      }
      w.norm = operator_norm<Dim, Pack>(E, size, hoop);
    }
    w.rho = load(block.mass.data() + e) / load(block.element_volume.data() + e);
    const Pack bulk = block.gauss == 1 ? load(block.state.bulk.data() + e) : largest_bulk(group);
    store_stable_step<Shape<Dim>>(block, e, w.norm, w.rho, bulk, (1.0 / step.dt) * trace(G) / size);
  }
}

template void advance_gauss(ElementBlock<2>&, int, const ElementStep<2>&);
template void advance_gauss(ElementBlock<3>&, int, const ElementStep<3>&);
template void refresh_box_steps(ElementBlock<2>&, int, const ElementStep<2>&);
template void refresh_box_steps(ElementBlock<3>&, int, const ElementStep<3>&);

}  // namespace brunt
// Tested by tests/unit/fe/kinematics_test.cpp.
