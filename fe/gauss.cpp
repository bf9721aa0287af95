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
BRUNT_INLINE Modal<Dim, Pack> moved_back(const GaussWork<Dim>& w, Real part) {
  Modal<Dim, Pack> r;
  for (int m = 0; m < Shape<Dim>::kModes; ++m) {
    for (int i = 0; i < Dim; ++i) r.m[m][i] = w.c.m[m][i] - part * w.u.m[m][i];
  }
  return r;
}

template <int Dim>
BRUNT_INLINE void load_modes(const Group<Dim>& group, GaussWork<Dim>& w) {
  const LocalIndex* corner = group.block.corner.data() + group.e * Shape<Dim>::kCorners;
  Pack node[Shape<Dim>::kCorners][Dim];
  gather<Dim>(corner, group.step.x, node);
  w.c = modes_of<Dim>(node);
  gather<Dim>(corner, group.step.v, node);
  w.u = modes_of<Dim>(node);
  for (auto& mode : w.u.m) {
    for (int i = 0; i < Dim; ++i) mode[i] = group.step.dt * mode[i];
  }
}

/// Halves of the works of the forces at n; ratios before the step.
template <int Dim>
BRUNT_INLINE void book_old_forces(const Group<Dim>& group, MaterialTile& tile, GaussWork<Dim>& w) {
  const ElementBlock<Dim>& block = group.block;
  const Modal<Dim, Pack> c = moved_back(w, 1.0);
  PressureWork pressure{group.mean};
  w.stress_work = broadcast<Pack>(0);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    GaussPoint<Dim> point;
    evaluate(c, w.u, group.step.thickness, g, point);
    const std::size_t k = group.point + kLanes * g;
    Pack s[6];
    load_tensor<Dim>(block.state.deviator, k, s);
    w.stress_work += point.work(s);
    pressure.add(point.volume(), load(block.state.pressure.data() + k), point.dilatation());
    store(tile.ratio_old + group.at + kLanes * g,
          point.volume() / load(block.reference_volume.data() + k));
  }
  w.stress_work += pressure.work();
  w.viscous_work = -load(block.viscous_pressure.data() + group.e) * pressure.dilatation;
  if (!group.mean) return;
  const Pack ratio = pressure.volume / load(block.element_volume.data() + group.e);
  for (int g = 0; g < kGauss<Dim>; ++g) store(tile.ratio_old + group.at + kLanes * g, ratio);
}

/// Strain increments and rotations at mid-step; the volumetric strain rate of the element.
template <int Dim>
BRUNT_INLINE void deform(const Group<Dim>& group, MaterialTile& tile, GaussWork<Dim>& w) {
  ElementBlock<Dim>& block = group.block;
  const Modal<Dim, Pack> c = moved_back(w, 0.5);
  Pack volume = broadcast<Pack>(0), dilatation = broadcast<Pack>(0);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    GaussPoint<Dim> point;
    evaluate(c, w.u, group.step.thickness, g, point);
    volume += point.volume();
    dilatation += point.dilatation();
    const Pack inverse = 1.0 / point.determinant;
    Pack L[Dim][Dim], hoop = broadcast<Pack>(0);
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) L[i][j] = point.G[i][j] * inverse;
    }
    if constexpr (Dim == 2) hoop = point.hoop / point.thickness;
    store_strain<Dim>(L, hoop, group.at + kLanes * g, tile);
    Pack s[6];
    const std::size_t k = group.point + kLanes * g;
    load_tensor<Dim>(block.state.deviator, k, s);
    rotate_symmetric(step_rotation(L), s);
    for (int i = 0; i < kTensorSize<Dim>; ++i) store(block.state.deviator[i].data() + k, s[i]);
  }
  const Pack mean = dilatation / volume;
  w.rate = (1.0 / group.step.dt) * mean;
  if (!group.mean) return;
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const int k = group.at + kLanes * g;
    const Pack own =
        load(tile.strain[xx] + k) + load(tile.strain[yy] + k) + load(tile.strain[zz] + k);
    const Pack shift = (1.0 / 3) * (mean - own);
    for (int i = xx; i <= zz; ++i) store(tile.strain[i] + k, load(tile.strain[i] + k) + shift);
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
template <int Dim>
BRUNT_INLINE OperatorNorm<Pack> gauss_norm(const Modal<Dim, Pack>& c, const Thickness& option) {
  Pack E[Shape<Dim>::kActive][Dim];
  volume_gradient(c, E);
  const Pack size = measure<Dim, Pack>(c, E);
  OperatorNorm<Pack> norm = operator_norm<Dim, Pack>(E, size, broadcast<Pack>(0));
  Pack sum = broadcast<Pack>(0);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    Pack J[Dim][Dim], cof[Dim][Dim], square = broadcast<Pack>(0), determinant = square;
    slopes(c, g, J);
    cofactors(J, cof);
    for (int i = 0; i < Dim; ++i) {
      determinant += J[0][i] * cof[0][i];
      for (int j = 0; j < Dim; ++j) square += cof[i][j] * cof[i][j];
    }
    sum += square / determinant;
  }
  const Pack scale =
      vmax(broadcast<Pack>(1), sum / (static_cast<Real>(Shape<Dim>::kCorners) * size * norm.trace));
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
  book_old_forces(group, tile, w);
  deform(group, tile, w);
  Pack volume = broadcast<Pack>(0), dilatation = broadcast<Pack>(0);
  for (int g = 0; g < kGauss<Dim>; ++g) {
    GaussPoint<Dim> point;
    evaluate(w.c, w.u, group.step.thickness, g, point);
    volume += point.volume();
    dilatation += point.dilatation();
    store(tile.ratio + group.at + kLanes * g,
          point.volume() / load(block.reference_volume.data() + group.point + kLanes * g));
  }
  const Pack inverse_reference = 1.0 / load(block.element_volume.data() + group.e);
  w.rho = load(block.mass.data() + group.e) / volume;
  w.norm = gauss_norm(w.c, group.step.thickness);
  const Pack speed = vsqrt((largest_bulk(group) + (4.0 / 3) * block.material->shear) / w.rho);
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.norm.template height<Shape<Dim>>(),
                       speed, w.rate);
  w.viscous_work -= w.q * dilatation;
  for (int g = 0; g < kGauss<Dim>; ++g) {
    const int k = group.at + kLanes * g;
    store(tile.viscous_work + k, 0.5 * w.viscous_work * inverse_reference);
    if (group.mean) store(tile.ratio + k, volume * inverse_reference);
  }
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
      for (int m = Dim; m < Shape<Dim>::kModes - 1; ++m) f.m[m][i] -= slope[m][j] * P;
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
    GaussPoint<Dim> point;
    evaluate(w.c, w.u, group.step.thickness, g, point);
    volume += point.volume();
    sum += point.volume() * load(group.block.state.pressure.data() + group.point + kLanes * g);
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
    GaussPoint<Dim> point;
    evaluate(w.c, w.u, group.step.thickness, g, point);
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
    const std::size_t e = static_cast<std::size_t>(index) * kGroups * kLanes;
    return Group<Dim>{block, step, e + k * kLanes, tile.first + k * kPoints, k * kPoints, mean};
  };
  for (int k = 0; k < kGroups; ++k) kinematics(group(k), tile, work[k]);
  block.material->update(tile, step.dt);
  for (int k = 0; k < kGroups; ++k) dynamics(group(k), work[k]);
}

template <int Dim>
void refresh_box_steps(ElementBlock<Dim>& block, int index, const ElementStep<Dim>& step) {
  const std::size_t first = static_cast<std::size_t>(index) * block.elements_per_tile();
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
      w.norm = gauss_norm(w.c, step.thickness);
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
