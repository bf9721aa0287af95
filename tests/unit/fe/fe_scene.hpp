#pragma once
/// Small meshes and a velocity Verlet loop for the tests of fe/.
#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/materials/catalog.hpp"
#include "fe/finite_elements.hpp"

namespace brunt::testing {

/// An elastic material with p = K (rho/rho0 - 1).
inline Material elastic(Real young, Real poisson, Real density) {
  Material material;
  material.name = "elastic";
  material.density = density;
  material.shear = young / (2 * (1 + poisson));
  material.bulk = young / (3 * (1 - 2 * poisson));
  material.strength = make_strength(NoStrength{}, {material.shear, 0, 0});
  material.eos = make_eos(LinearEos{}, {material.density, material.bulk});
  return material;
}

/// Copper of Johnson & Cook 1983 that yields and heats under Mie-Gruneisen pressure.
inline Material copper() {
  Material material = elastic(124e9, 0.34, 8960);
  material.thermal = true;
  material.specific_heat = SpecificHeat(383);
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025, law.m = 1.09, law.T_melt = 1356;
  material.strength = make_strength(law, {material.shear, material.density * 383, 0.9});
  MieGruneisen eos;
  eos.c0 = 3940, eos.s = 1.49, eos.gamma0 = 2;
  material.eos = make_eos(eos, {material.density, material.bulk});
  return material;
}

struct Variant {
  Geometry geometry = Geometry::three_d;
  Integration integration = Integration::one_point;
};
inline std::string name_of(const Variant& v) {
  static const char* geometry[] = {"three_d", "plane_strain", "axisymmetric"};
  static const char* integration[] = {"one_point", "q1p0", "full"};
  return std::string(geometry[static_cast<int>(v.geometry)]) + "_" +
         integration[static_cast<int>(v.integration)];
}
inline std::vector<Variant> variants_of(int dim) {
  std::vector<Variant> all;
  for (const auto i : {Integration::one_point, Integration::q1p0, Integration::full}) {
    if (dim == 3) all.push_back({Geometry::three_d, i});
    if (dim == 2) all.push_back({Geometry::plane_strain, i});
    if (dim == 2) all.push_back({Geometry::axisymmetric, i});
  }
  return all;
}

template <int Dim>
struct Mesh {
  Points<Dim> points;
  ElementSet<Dim> set;
};

/// A box of cells; inner nodes are moved at random by up to `distortion` of a cell.
template <int Dim>
Mesh<Dim> box_mesh(std::array<int, Dim> cells, Vec<Dim> corner, Vec<Dim> size,
                   Real distortion = 0) {
  Mesh<Dim> mesh;
  std::array<int, 3> n = {0, 0, 0};
  for (int j = 0; j < Dim; ++j) n[j] = cells[j];
  const auto index = [&](int i, int j, int k) { return (k * (n[1] + 1) + j) * (n[0] + 1) + i; };
  mesh.points.resize((n[0] + 1) * (n[1] + 1) * (n[2] + 1));
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> uniform(-1, 1);
  for (int k = 0; k <= n[2]; ++k) {
    for (int j = 0; j <= n[1]; ++j) {
      for (int i = 0; i <= n[0]; ++i) {
        const std::array<int, 3> at = {i, j, k};
        const LocalIndex node = index(i, j, k);
        mesh.points.id[node] = static_cast<GlobalId>(node);
        for (int c = 0; c < Dim; ++c) {
          const Real cell = size[c] / n[c];
          bool inner = true;
          for (int d = 0; d < Dim; ++d) inner = inner && at[d] > 0 && at[d] < n[d];
          const Real move = inner ? distortion * cell * uniform(random) : 0;
          mesh.points.x[node][c] = corner[c] + cell * at[c] + move;
        }
      }
    }
  }
  constexpr int kCube[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (int k = 0; k < std::max(n[2], 1); ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        std::array<LocalIndex, Shape<Dim>::kCorners> corners;
        for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
          corners[I] = index(i + kCube[I][0], j + kCube[I][1], k + kCube[I][2]);
        }
        mesh.set.corners.push_back(corners);
      }
    }
  }
  const std::size_t count = mesh.set.corners.size();
  mesh.set.id.resize(count);
  std::iota(mesh.set.id.begin(), mesh.set.id.end(), GlobalId{0});
  mesh.set.body.assign(count, 0);
  mesh.set.piece.assign(count, 0);
  return mesh;
}

/// One box-shaped cell with its corners moved at random by up to `distortion`.
template <int Dim>
Mesh<Dim> cell_mesh(Vec<Dim> size, Real distortion, unsigned seed, Real radius = 0) {
  std::array<int, Dim> one;
  one.fill(1);
  Vec<Dim> corner = Vec<Dim>::Zero();
  corner[0] = radius;
  Mesh<Dim> mesh = box_mesh<Dim>(one, corner, size);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<Real> uniform(-distortion, distortion);
  for (auto& x : mesh.points.x) {
    for (int i = 0; i < Dim; ++i) x[i] += size[i] * uniform(random);
  }
  return mesh;
}

template <int Dim>
std::unique_ptr<FiniteElements<Dim>> make_body(Mesh<Dim> mesh, const Material& material,
                                               const Variant& variant, ElementOptions options = {},
                                               Real depth = 0.7) {
  mesh.set.material = &material;
  mesh.set.options = options;
  mesh.set.options.integration = variant.integration;
  return std::make_unique<FiniteElements<Dim>>(
      std::move(mesh.points), std::vector<ElementSet<Dim>>{mesh.set}, variant.geometry, depth);
}

using Boxes = Mesh<3>;

/// The boxes of a mesh, cut into tetrahedra.
inline Boxes cut(const Boxes& boxes) {
  Boxes mesh;
  mesh.points = boxes.points;
  mesh.set.options.type = 1;
  std::vector<int> corners;
  for (const auto& box : boxes.set.corners) {
    const std::vector<int> nodes(box.begin(), box.end());
    formulation(Tet4{}).cut_box(nodes, corners);
  }
  for (std::size_t k = 0; k < corners.size(); k += 4) {
    mesh.set.corners.push_back(
        std::array<LocalIndex, 4>{corners[k], corners[k + 1], corners[k + 2], corners[k + 3]});
    mesh.set.id.push_back(k / 4);
  }
  mesh.set.body.assign(mesh.set.id.size(), 0);
  mesh.set.piece.assign(mesh.set.id.size(), 0);
  return mesh;
}

/// A body of the tetrahedra of cut boxes.
inline std::unique_ptr<FiniteElements<3>> tets(const Boxes& boxes, const Material& material,
                                               bool adiabatic = false) {
  Boxes mesh = cut(boxes);
  mesh.set.material = &material;
  mesh.set.adiabatic = adiabatic;
  return std::make_unique<FiniteElements<3>>(
      std::move(mesh.points), std::vector<ElementSet<3>>{mesh.set}, Geometry::three_d, 1);
}

/// Velocity Verlet without supports or loads.
template <int Dim>
void step_free(FiniteElements<Dim>& body, Real dt) {
  Points<Dim>& p = body.points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    p.v[k] += 0.5 * dt * p.a[k];
    p.x[k] += dt * p.v[k];
    p.f[k].setZero();
  }
  body.update_state(dt);
  body.add_internal_forces(dt);
  for (LocalIndex k = 0; k < p.size(); ++k) {
    p.a[k] = p.f[k] / p.mass[k];
    p.v[k] += 0.5 * dt * p.a[k];
  }
}

/// Moves the points to given places in one step.
template <int Dim>
void step_to(FiniteElements<Dim>& body, const std::vector<Vec<Dim>>& x, Real dt) {
  Points<Dim>& p = body.points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    p.v[k] = (x[k] - p.x[k]) / dt;
    p.x[k] = x[k];
    p.f[k].setZero();
  }
  body.update_state(dt);
  body.add_internal_forces(dt);
}

/// What velocity Verlet keeps: 1/2 m v(n-1/2) . v(n+1/2) = 1/2 m (v.v - (dt a/2)^2) [J].
template <int Dim>
Real kinetic_energy(const Points<Dim>& p, Real dt) {
  ExactSum sum;
  for (LocalIndex k = 0; k < p.size(); ++k) {
    const Vec<Dim> half = 0.5 * dt * p.a[k];
    sum.add(0.5 * p.mass[k] * (p.v[k] - half).dot(p.v[k] + half));
  }
  return sum.value();
}

template <int Dim>
Totals<Dim> totals_of(const FiniteElements<Dim>& body) {
  Totals<Dim> totals;
  totals.bodies.resize(1);
  body.add_totals(totals);
  return totals;
}

/// Cauchy stress of a material point without viscosity [Pa], SymmetricIndex.
inline std::array<Real, 6> stress_at(const MaterialState& state, std::size_t k) {
  std::array<Real, 6> s;
  for (int i = 0; i < 6; ++i) s[i] = state.deviator[i][k] - (i < 3 ? state.pressure[k] : 0);
  return s;
}

}  // namespace brunt::testing
