/// The linear tetrahedron with averaged volumes: docs/theory/elements.md, section 8.
#include "fe/elements/tet4.hpp"

#include <algorithm>

#include "fe/conduction_kernel.hpp"
#include "fe/fetch_group.hpp"
#include "fe/mechanical_heat.hpp"

namespace brunt {
namespace {

constexpr int kCorners = Tet4::kCorners;

/// One configuration of four elements, and the gradient of the displacement of the step at it.
struct Configuration {
  Pack B[kCorners][3];  ///< [m^2] dV/dx_I
  Pack volume;          ///< [m^3]
  Pack G[3][3];         ///< [m^3] sum u (x) B

  /// x  edges from corner 0 to the others [m], u  their change in the step
  BRUNT_INLINE Configuration(const Pack (&x)[3][3], const Pack (&u)[3][3]) {
    constexpr Real sixth = 1.0 / 6;
    for (int k = 0; k < 3; ++k) {
      Pack cross[3];
      set_cross(x[(k + 1) % 3], x[(k + 2) % 3], cross);
      for (int j = 0; j < 3; ++j) B[k + 1][j] = sixth * cross[j];
    }
    for (int j = 0; j < 3; ++j) B[0][j] = -(B[1][j] + B[2][j] + B[3][j]);
    volume = x[0][0] * B[1][0] + x[0][1] * B[1][1] + x[0][2] * B[1][2];
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        G[i][j] = u[0][i] * B[1][j] + u[1][i] * B[2][j] + u[2][i] * B[3][j];
      }
    }
  }
  /// Work of the stress s - p on the displacement of the step [J].
  BRUNT_INLINE Pack work(const Pack (&s)[6], Pack p) const {
    return double_dot(s, G) - p * trace(G);
  }
  BRUNT_INLINE OperatorNorm<Pack> norm() const {
    const Pack scale = 1.0 / (volume * volume);
    Pack g[3][3];
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) {
        Pack sum = B[0][i] * B[0][j];
        for (int I = 1; I < kCorners; ++I) sum += B[I][i] * B[I][j];
        g[i][j] = g[j][i] = scale * sum;
      }
    }
    return {trace(g), largest_eigenvalue(g), broadcast<Pack>(0)};
  }
};

BRUNT_INLINE void gather_edges(const LocalIndex* corner, const Vec3* field, Real factor,
                               Pack (&edge)[3][3]) {
  Pack node[kCorners][3];
  gather<3>(corner, field, node);
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) edge[k][i] = factor * (node[k + 1][i] - node[0][i]);
  }
}
/// The edges before a part of the step.
BRUNT_INLINE void move_back(const Pack (&x)[3][3], const Pack (&u)[3][3], Real part,
                            Pack (&out)[3][3]) {
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 3; ++i) out[k][i] = x[k][i] - part * u[k][i];
  }
}

/// What kinematics hand to forces, of four elements.
struct TetWork {
  Pack B[kCorners][3], G[3][3];  ///< at n+1
  OperatorNorm<Pack> norm;
  Pack height;
  Pack rho, rate, q;               ///< [kg/m^3], [1/s], [Pa]
  Pack stress_work, viscous_work;  ///< [J] halves of the old forces
};

struct Lane {
  ElementBlock<3>& block;
  const ElementStep<3>& step;
  std::size_t e;  ///< first of four elements
};

/// Mean ratio of the volumes about the corners.
BRUNT_INLINE Pack mean_ratio(const Lane& lane) {
  Pack ratio[kCorners];
  gather_temperature(lane.block.corner.data() + lane.e * kCorners, lane.step.node_ratio, ratio);
  return 0.25 * ((ratio[0] + ratio[1]) + (ratio[2] + ratio[3]));
}

/// Strain increment and rotation at mid-step; the dilatation is that of the mean ratio.
BRUNT_INLINE void deform(const Lane& lane, const Configuration& mid, Pack dilatation, int at,
                         MaterialTile& tile) {
  const Pack inverse = 1.0 / mid.volume;
  Pack L[3][3], s[6];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) L[i][j] = mid.G[i][j] * inverse;
  }
  const auto rotation = step_rotation(L);
  load_tensor<3>(lane.block.state.deviator, lane.e, s);
  rotate_symmetric(rotation, s);
  for (int k = 0; k < 6; ++k) store(lane.block.state.deviator[k].data() + lane.e, s[k]);
  store_strain<3>(L, broadcast<Pack>(0), at, tile);
  Pack own = load(tile.strain[xx] + at) + load(tile.strain[yy] + at) + load(tile.strain[zz] + at);
  const Pack shift = (1.0 / 3) * (dilatation - own);
  for (int i = xx; i <= zz; ++i) store(tile.strain[i] + at, load(tile.strain[i] + at) + shift);
}

BRUNT_INLINE void kinematics(const Lane& lane, int at, MaterialTile& tile, TetWork& w) {
  ElementBlock<3>& block = lane.block;
  const LocalIndex* corner = block.corner.data() + lane.e * kCorners;
  Pack x[3][3], u[3][3], back[3][3], s[6];
  gather_edges(corner, lane.step.x, 1, x);
  gather_edges(corner, lane.step.v, lane.step.dt, u);
  move_back(x, u, 1, back);
  const Configuration old(back, u);
  load_tensor<3>(block.state.deviator, lane.e, s);
  w.stress_work = old.work(s, load(block.state.pressure.data() + lane.e));
  w.viscous_work = -load(block.viscous_pressure.data() + lane.e) * trace(old.G);

  const Pack ratio_old = load(block.volume_ratio.data() + lane.e), ratio = mean_ratio(lane);
  store(block.volume_ratio.data() + lane.e, ratio);
  store(tile.ratio_old + at, ratio_old);
  store(tile.ratio + at, ratio);
  const Pack dilatation = 2.0 * (ratio - ratio_old) / (ratio + ratio_old);
  move_back(x, u, 0.5, back);
  deform(lane, Configuration(back, u), dilatation, at, tile);

  const Configuration now(x, u);
  w.norm = now.norm();
  w.rho = load(block.mass.data() + lane.e) / now.volume;
  w.rate = (1.0 / lane.step.dt) * dilatation;
  const Pack bulk = load(block.state.bulk.data() + lane.e);
  const Pack speed = vsqrt((bulk + (4.0 / 3) * block.material->shear) / w.rho);
  w.height = w.norm.height<Tet4>();
  w.q = bulk_viscosity(block.options.bulk_viscosity, w.rho, w.height, speed, w.rate);
  w.viscous_work -= w.q * trace(now.G);
  const Pack inverse_reference = 1.0 / load(block.element_volume.data() + lane.e);
  store(tile.viscous_work + at, 0.5 * w.viscous_work * inverse_reference);
  for (int i = 0; i < 3; ++i) {
    for (int I = 0; I < kCorners; ++I) w.B[I][i] = now.B[I][i];
    for (int j = 0; j < 3; ++j) w.G[i][j] = now.G[i][j];
  }
}

/// New halves of the works, forces and stable step of four elements.
BRUNT_INLINE void dynamics(const Lane& lane, const TetWork& w) {
  ElementBlock<3>& block = lane.block;
  const std::size_t e = lane.e;
  Pack s[6], sigma[3][3], node[kCorners][3];
  load_tensor<3>(block.state.deviator, e, s);
  const Pack p = load(block.state.pressure.data() + e);
  add_half(block.stress_work, e, w.stress_work + double_dot(s, w.G) - p * trace(w.G));
  add_half(block.viscous_work, e, w.viscous_work);
  store(block.viscous_pressure.data() + e, w.q);
  store_stable_step<Tet4>(block, e, w.norm, w.height, w.rho, load(block.state.bulk.data() + e),
                          w.rate);
  stress_matrix(s, p + w.q, sigma);
  for (int I = 0; I < kCorners; ++I) {
    for (int i = 0; i < 3; ++i) {
      node[I][i] = -(sigma[i][0] * w.B[I][0] + sigma[i][1] * w.B[I][1] + sigma[i][2] * w.B[I][2]);
    }
  }
  add_to_nodes(node, mechanical_heat<Pack>(block, e, lane.step.dt), e, lane.step.sums);
}

Real tet_volume(CornerPlaces<3> x) {
  return (x[1] - x[0]).dot((x[2] - x[0]).cross(x[3] - x[0])) / 6;
}

class TetFormulation final : public Formulation<3> {
 public:
  const ElementType& type() const override { return kElementType<Tet4>; }
  int material_points(const ElementOptions&) const override { return 1; }
  bool averages_volumes() const override { return true; }

  /// A cone from the corner of the least number over the faces that do not have it, each cut from
  /// its own least number: six tetrahedra, whose diagonals both boxes of a face agree on (after
  /// Dompierre, Labbe, Vallet & Camarero 1999).
  void cut_box(std::span<const int> box, std::vector<int>& corners) const override {
    const auto apex = std::min_element(box.begin(), box.end());
    for (const auto& face : Hex8::kFace) {
      std::array<int, 4> node;
      for (std::size_t i = 0; i < 4; ++i) node[i] = box[face[i]];
      if (std::find(node.begin(), node.end(), *apex) != node.end()) continue;
      std::rotate(node.begin(), std::min_element(node.begin(), node.end()), node.end());
      // Seen from the apex, inside, a face runs clockwise.
      corners.insert(corners.end(), {node[0], node[2], node[1], *apex});
      corners.insert(corners.end(), {node[0], node[3], node[2], *apex});
    }
  }
  PartVolumes part_volumes(CornerPlaces<3> x, const Thickness&) const override {
    return {{tet_volume(x)}, 1};
  }
  std::array<PartVolumes, kLanes> parts_of_four(const ElementBlock<3>& block, std::size_t e,
                                                const Points<3>& points,
                                                const Thickness& thickness) const override {
    std::array<PartVolumes, kLanes> of;
    for (auto& parts : of) {
      parts =
          part_volumes(corner_positions(block, static_cast<LocalIndex>(e++), points), thickness);
    }
    return of;
  }
  Real volume(CornerPlaces<3> x, bool, const Thickness&) const override { return tet_volume(x); }
  Real step_volume(CornerPlaces<3> x, const Thickness&) const override { return tet_volume(x); }
  std::array<Real, kLanes> step_volumes(const ElementBlock<3>& block, std::size_t e,
                                        const Points<3>& points, const Thickness&) const override {
    std::array<Real, kLanes> volume;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      volume[lane] = tet_volume(corner_positions(block, static_cast<LocalIndex>(e + lane), points));
    }
    return volume;
  }
  unsigned have_volume(const ElementBlock<3>& block, std::size_t e, const Points<3>& points,
                       const Thickness& thickness) const override {
    const auto volume = step_volumes(block, e, points, thickness);
    unsigned bits = 0;
    for (unsigned lane = 0; lane < kLanes; ++lane) bits |= (volume[lane] > 0 ? 1U : 0U) << lane;
    return bits;
  }
  Real add_corner_volumes(CornerPlaces<3> x, const Thickness&, Real factor,
                          Real* sum) const override {
    const Real whole = tet_volume(x);
    for (int I = 0; I < kCorners; ++I) sum[I] += 0.25 * factor * whole;
    return whole;
  }
  Vec3 material_place(CornerPlaces<3> x, int, int) const override {
    return 0.25 * ((x[0] + x[1]) + (x[2] + x[3]));
  }
  void start(const Points<3>&, ElementBlock<3>&) const override {}

  void write_corner_volumes(const ElementBlock<3>& block, int tile, const Vec3* x,
                            Real* corner_volume) const override {
    for (int k = 0; k < kTile; k += kLanes) {
      const std::size_t e = slot_of(tile) * kTile + slot_of(k);
      Pack edge[3][3], cross[3];
      gather_edges(block.corner.data() + e * kCorners, x, 1, edge);
      set_cross(edge[1], edge[2], cross);
      const Pack part =
          (1.0 / 24) * (edge[0][0] * cross[0] + edge[0][1] * cross[1] + edge[0][2] * cross[2]);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        std::fill_n(corner_volume + (e + lane) * kCorners, kCorners, part[lane]);
      }
    }
  }
  void advance(ElementBlock<3>& block, int index, const ElementStep<3>& step) const override {
    constexpr int kGroups = kTile / kLanes;
    TetWork work[kGroups];
    MaterialTile tile;
    open_tile(block, index, tile);
    for (int g = 0; g < kGroups; ++g) {
      const Lane lane{block, step, tile.first + g * kLanes};
      fetch_ahead(block, lane.e, step);
      kinematics(lane, g * kLanes, tile, work[g]);
    }
    block.material->update(tile, step.dt);
    for (int g = 0; g < kGroups; ++g) {
      dynamics(Lane{block, step, tile.first + g * kLanes}, work[g]);
    }
  }
  void refresh_stable_steps(ElementBlock<3>& block, int tile,
                            const ElementStep<3>& step) const override {
    for (int k = 0; k < kTile; k += kLanes) {
      const std::size_t e = slot_of(tile) * kTile + slot_of(k);
      const LocalIndex* corner = block.corner.data() + e * kCorners;
      Pack x[3][3], u[3][3];
      gather_edges(corner, step.x, 1, x);
      gather_edges(corner, step.v, step.dt, u);
      const Configuration now(x, u);
      const Pack rho = load(block.mass.data() + e) / load(block.element_volume.data() + e);
      const OperatorNorm<Pack> norm = now.norm();
      store_stable_step<Tet4>(block, e, norm, norm.height<Tet4>(), rho,
                              load(block.state.bulk.data() + e),
                              (1.0 / step.dt) * trace(now.G) / now.volume);
    }
  }
  void conduct(ElementBlock<3>& block, std::size_t e,
               const ConductionStep<3>& step) const override {
    for (std::size_t four = 0; four < kGroup; four += kLanes) conduct_four(block, e + four, step);
  }
  static void conduct_four(ElementBlock<3>& block, std::size_t e, const ConductionStep<3>& step) {
    Pack x[3][3];
    const LocalIndex* const corner = block.corner.data() + e * kCorners;
    gather_edges(corner, step.x, 1, x);
    const Configuration now(x, x);
    const Pack inverse = 1.0 / now.volume;
    Pack K[kCorners][kCorners], T[kCorners];
    for (int I = 0; I < kCorners; ++I) {
      for (int J = I + 1; J < kCorners; ++J) {
        K[I][J] = inverse * (now.B[I][0] * now.B[J][0] + now.B[I][1] * now.B[J][1] +
                             now.B[I][2] * now.B[J][2]);
      }
    }
    gather_temperature(corner, step.temperature, T);
    exchange_heat(K, conductivity(block.material->conductivity, T), T,
                  step.corner_heat + 2 * kCorners * e);
  }
  void interpolate_temperature(ElementBlock<3>& block, std::size_t e,
                               const Real* temperature) const override {
    mean_temperature<kCorners>(block, e, temperature);
  }
};
}  // namespace

const Formulation<3>& formulation(Tet4) {
  static const TetFormulation tet;
  return tet;
}

}  // namespace brunt
