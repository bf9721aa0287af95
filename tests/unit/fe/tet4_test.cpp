/// The linear tetrahedron with volumes averaged about nodes.
/// - Boxes are cut into six tetrahedra that fill them and agree on faces: then the outer facets of
///   a mesh of n boxes are the two halves of each outer face of theirs, and no others.
/// - Patch: x = (I + A) X in one step from rest: L = A (I + A/2)^-1 (mid-step), s = 2 G dev(D +
///   (w D - D w)/2), p = K (1/J - 1), J = det(I + A), since all volumes change alike; no force on
///   inner nodes. Tolerance 1e-12 of the stress: round-off of some 100 operations on strains of
///   1e-2.
/// - Volumes: the pressure is that of the mean ratio. Where inner nodes move at random the squares
/// of
///   ratios of the elements are at least ten times those of the means over some 65 elements about
///   the nodes of one: 3 motions a node change 1 volume, not 6.
/// - Tube: plane strain, radii a and b, pressure p inside: the bore widens by
///     u = (1 + nu) p a/(E (b^2 - a^2)) ((1 - 2 nu) a^2 + b^2)   (Lame 1852)
///   and where the volume cannot change its walls have to become thinner by just that much. 48 x 6
///   boxes: of the polygon and its chords 2 %, at any nu. Elements with volumes of their own would
///   widen by a small part of it at nu = 0.499.
/// - Energy: what velocity Verlet keeps and the work of the forces on it sum to nothing but
///   round-off, also where pressure is of other elements' volumes.
/// - Conduction: K_IJ of a linear temperature g.x send no heat to inner nodes, and through a face
/// of
///   area A of a bar k A |g|.
#include <gtest/gtest.h>

#include "core/geometry/grid.hpp"
#include "fe/conduction.hpp"
#include "tests/unit/fe/fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;
TEST(Tet4, SixFillABoxAndAgreeOnFaces) {
  const Material material = elastic(200e9, 0.3, 7850);
  const auto body = tets(box_mesh<3>({3, 4, 2}, Vec3::Zero(), {3, 4, 2}, 0.2), material);
  EXPECT_EQ(body->n_elements(), 6U * 24U);
  Real volume = 0, mass = 0;
  const auto& block = body->blocks()[0];
  EXPECT_EQ(block.corners, 4);
  for (LocalIndex e = 0; e < block.n; ++e) volume += block.element_volume[e];
  for (const Real m : body->points().mass) mass += m;
  EXPECT_NEAR(volume, 24, 1e-12 * 24);
  EXPECT_NEAR(mass, 24 * 7850, 1e-12 * 24 * 7850);
  const auto& facets = body->surface().facets;
  EXPECT_EQ(facets.size(), 2U * 2U * (12U + 6U + 8U));
  Real area = 0;
  Vec3 closed = Vec3::Zero();
  for (const auto& facet : facets) {
    ASSERT_EQ(facet.n_nodes(), 3);
    const auto at = [&](std::size_t c) {
      return body->points().x[static_cast<std::size_t>(facet.node[c])];
    };
    const Vec3 normal = 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
    EXPECT_GT(normal.dot(at(0) - Vec3(1.5, 2, 1)), 0);  // outward
    closed += normal, area += normal.norm();
    EXPECT_LE(facet.depth, std::sqrt(0.5) + 1e-12);  // the height of half a square
    EXPECT_GT(facet.depth, 0);
  }
  EXPECT_NEAR(area, 2 * (12 + 6 + 8), 1e-12 * 52);
  EXPECT_LT(closed.norm(), 1e-12);
}

TEST(Tet4, AnEvenStrainIsAnEvenStress) {
  const Material material = elastic(200e9, 0.3, 7850);
  Mat3 A;
  A << 0.010, 0.004, -0.003, 0.002, -0.007, 0.006, 0.001, -0.005, 0.004;
  Boxes boxes = box_mesh<3>({3, 3, 3}, Vec3::Zero(), {3, 3, 3}, 0.2);
  boxes.set.options.bulk_viscosity = {0, 0};
  auto mesh = cut(boxes);
  mesh.set.material = &material;
  mesh.set.options.bulk_viscosity = {0, 0};
  FiniteElements<3> body(std::move(mesh.points), {mesh.set}, Geometry::three_d, 1);
  std::vector<Vec3> x = body.points().x;
  for (auto& place : x) place += Vec3(A * place);
  const std::vector<Vec3> start = body.points().x;
  step_to(body, x, 1e-6);
  const Mat3 L = A * (Mat3::Identity() + 0.5 * A).inverse();
  const Mat3 middle = 0.5 * (L + L.transpose()), w = 0.5 * (L - L.transpose());
  const Mat3 D = middle + 0.5 * (w * middle - middle * w);
  const Real p = material.bulk * (1 / (Mat3::Identity() + A).determinant() - 1);
  const Mat3 deviator = 2 * material.shear * (D - D.trace() / 3 * Mat3::Identity());
  const Real scale = material.bulk * 1e-2;
  const auto& block = body.blocks()[0];
  for (LocalIndex e = 0; e < block.n; ++e) {
    const auto s = stress_at(block.state, static_cast<std::size_t>(e));
    const Real expected[6] = {deviator(0, 0) - p, deviator(1, 1) - p, deviator(2, 2) - p,
                              deviator(0, 1),     deviator(1, 2),     deviator(2, 0)};
    for (int k = 0; k < 6; ++k) ASSERT_NEAR(s[k], expected[k], 1e-12 * scale);
  }
  for (std::size_t k = 0; k < start.size(); ++k) {
    const bool inner = start[k].minCoeff() > 0.1 && start[k].maxCoeff() < 2.9;
    if (!inner) continue;
    ASSERT_LT(body.points().f[k].norm(), 1e-11 * scale);
  }
}

TEST(Tet4, AveragedVolumesAreSofterThanThoseOfElements) {
  const Material material = elastic(200e9, 0.3, 7850);
  const auto body = tets(box_mesh<3>({4, 4, 4}, Vec3::Zero(), {4, 4, 4}), material);
  std::vector<Vec3> x = body->points().x;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> uniform(-1e-4, 1e-4);
  for (auto& place : x) {
    if (place.minCoeff() < 0.1 || place.maxCoeff() > 3.9) continue;
    for (int c = 0; c < 3; ++c) place[c] += uniform(random);
  }
  step_to(*body, x, 1e-6);
  const auto& block = body->blocks()[0];
  Real averaged = 0, own = 0, whole = 0;
  for (LocalIndex e = 0; e < block.n; ++e) {
    const auto at = corner_positions(block, e, body->points());
    const Real ratio = block.formulation->volume(at, true, {}) / block.element_volume[e];
    whole += block.element_volume[e] * block.volume_ratio[e];
    averaged += std::pow(block.volume_ratio[e] - 1, 2);
    own += std::pow(ratio - 1, 2);
    // p = K (1/ratio - 1) of the mean, not of the element
    EXPECT_NEAR(block.state.pressure[e], material.bulk * (1 / block.volume_ratio[e] - 1),
                1e-12 * material.bulk);
  }
  // The boundary stands still: the whole volume stays, to the weights of nodes on the boundary.
  EXPECT_NEAR(whole, 64, 64 * 1e-4);
  EXPECT_LT(averaged, 0.1 * own);
}

/// The radial displacement of the bore of a tube under inner pressure over Lame's, once a damped
/// motion has come to rest.
Real bore_of_tube(Real nu) {
  const Real a = 0.01, b = 0.02, length = 0.0015, E = 2e9, pressure = 1e3;
  const Material material = elastic(E, nu, 1200);
  const auto ring = extrude(ring_grid(a, b, 6, 48), length, Layers{});
  Boxes boxes;
  boxes.points.resize(static_cast<LocalIndex>(ring.nodes.size()));
  boxes.points.x = ring.nodes;
  std::iota(boxes.points.id.begin(), boxes.points.id.end(), GlobalId{0});
  for (const auto& hex : ring.elements) boxes.set.corners.push_back(hex);
  const auto body = tets(boxes, material);
  auto& p = body->points();
  std::vector<Vec3> load(p.x.size(), Vec3::Zero());
  for (const auto& facet : body->surface().facets) {
    const auto at = [&](std::size_t c) { return p.x[static_cast<std::size_t>(facet.node[c])]; };
    const auto off = [&](std::size_t c) { return at(c).head<2>().norm() - a; };
    if (std::max({off(0), off(1), off(2)}) > 1e-9) continue;
    const Vec3 out = 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
    for (std::size_t c = 0; c < 3; ++c) {
      load[static_cast<std::size_t>(facet.node[c])] -= pressure / 3 * out;
    }
  }
  const Real rate = 1.5e5;  // about twice the breathing frequency, sqrt(E/rho)/r
  const Real dt = 0.9 * body->stable_step().step;
  for (Real t = 0; t < 2e-4; t += dt) {
    for (std::size_t k = 0; k < p.x.size(); ++k) {
      p.v[k] += dt * (p.a[k] - rate * p.v[k]);
      p.v[k][2] = 0;
      p.x[k] += dt * p.v[k];
      p.f[k] = load[k];
    }
    body->update_state(dt);
    body->add_internal_forces(dt);
    for (std::size_t k = 0; k < p.x.size(); ++k) p.a[k] = p.f[k] / p.mass[k];
  }
  Real sum = 0, n = 0;
  for (std::size_t k = 0; k < p.x.size(); ++k) {
    const Real r = p.x_start[k].head<2>().norm();
    if (r < a + 1e-9) sum += p.x[k].head<2>().norm() - r, n += 1;
  }
  return sum / n /
         ((1 + nu) * pressure * a / (E * (b * b - a * a)) * ((1 - 2 * nu) * a * a + b * b));
}

TEST(Tet4, ATubeWidensThoughItsVolumeCannotChange) {
  EXPECT_NEAR(bore_of_tube(0.3), 1, 0.02);
  EXPECT_NEAR(bore_of_tube(0.499), 1, 0.03);
}

std::unique_ptr<FiniteElements<3>> thrown(const Material& material) {
  auto body = tets(box_mesh<3>({3, 3, 3}, Vec3::Zero(), Vec3::Constant(3e-3), 0.1), material, true);
  auto& p = body->points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    for (int c = 0; c < 3; ++c) p.v[k][c] = (c == 1 ? 1e5 : -2e5) * (p.x[k][c] - 1e-3);
  }
  return body;
}

TEST(Tet4, EnergyIsKept) {
  const Material material = copper();
  const auto body = thrown(material);
  const Real dt = 0.3 * body->stable_step().step;
  step_free(*body, dt);
  const auto energy = [&] {
    const auto totals = totals_of(*body);
    Real sum = kinetic_energy(body->points(), dt);
    for (const Column column : {Column::internal, Column::plastic_heat, Column::viscosity}) {
      sum += totals.value(column);
    }
    return sum;
  };
  const Real start = energy();
  for (int n = 0; n < 200; ++n) step_free(*body, dt);
  EXPECT_NEAR(energy(), start, 1e-12 * start);
  EXPECT_GT(totals_of(*body).value(Column::plastic_heat), 0.05 * start);
}

TEST(Tet4, TheSameBitsAfterASplit) {
  const Material material = copper();
  const auto whole = thrown(material);
  const auto advance = [](FiniteElements<3>& body, int steps) {
    for (int n = 0; n < steps; ++n) step_free(body, 0.5 * body.stable_step().step);
  };
  advance(*whole, 20);
  std::vector<StateTable> tables;
  whole->save_state(tables);
  const auto again = thrown(material);
  again->load_state(StateTables(std::move(tables)));
  EXPECT_EQ(totals_of(*again).state_hash, totals_of(*whole).state_hash);
  advance(*whole, 20);
  advance(*again, 20);
  EXPECT_EQ(again->points().x, whole->points().x);
  EXPECT_EQ(again->points().v, whole->points().v);
  EXPECT_EQ(totals_of(*again).state_hash, totals_of(*whole).state_hash);
}

TEST(Tet4, ALinearTemperatureConductsEvenly) {
  Material material = elastic(200e9, 0.3, 7850);
  material.thermal = true;
  material.specific_heat = SpecificHeat(500);
  material.conductivity.constant = 40;
  Boxes mesh = cut(box_mesh<3>({3, 3, 3}, Vec3::Zero(), {3, 3, 3}, 0.2));
  mesh.set.material = &material;
  mesh.set.conducts = true;
  FiniteElements<3> body(std::move(mesh.points), {mesh.set}, Geometry::three_d, 1);
  auto& p = body.points();
  const Vec3 g(7, -3, 2);
  for (std::size_t i = 0; i < p.x.size(); ++i) p.temperature[i] = 300 + g.dot(p.x[i]);
  std::fill(p.heat_rate.begin(), p.heat_rate.end(), 0.0);
  body.add_conduction(1e-6);
  Real through = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    const bool inner = p.x[i].minCoeff() > 0.1 && p.x[i].maxCoeff() < 2.9;
    if (inner) {
      EXPECT_LT(std::fabs(p.heat_rate[i]), 1e-11 * 40 * 7 * 9);
    }
    // The moment of the heat about the plane x = 0 is the heat that crosses, over all of the bar.
    through += p.x[i][0] * p.heat_rate[i];
  }
  EXPECT_NEAR(through, -40 * g[0] * 27, 1e-11 * 40 * 7 * 27);
  Real capacity = 0;
  for (const Real c : p.capacity) capacity += c;
  EXPECT_NEAR(capacity, 7850 * 500 * 27, 1e-12 * 7850 * 500 * 27);
}

}  // namespace
}  // namespace brunt
