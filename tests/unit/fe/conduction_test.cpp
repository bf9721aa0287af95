// Conduction of elements: fields of degree one give no heat inside, no mode of temperature is free,
// the bound of the step holds on any shape, and materials of very different conductivity.
#include "fe/conduction.hpp"

#include <gtest/gtest.h>

#include "core/simd.hpp"
#include "tests/unit/fe/fe_scene.hpp"

namespace brunt::testing {
namespace {

Material conductor(Real k, Real heat_capacity = 1) {
  Material material = elastic(1e9, 0.3, 1000);
  material.thermal = true;
  material.specific_heat = SpecificHeat(heat_capacity);
  material.conductivity.constant = k;
  return material;
}

template <int Dim>
std::unique_ptr<FiniteElements<Dim>> body_of(Mesh<Dim> mesh, const Material& material,
                                             Geometry geometry) {
  mesh.set.conducts = mesh.set.held = true;
  mesh.set.temperature = 300;
  return make_body(std::move(mesh), material, {geometry, Integration::one_point});
}

/// q [W] of all nodes at temperatures T.
template <int Dim>
std::vector<Real> heat_rates(FiniteElements<Dim>& body, const std::vector<Real>& T) {
  auto& points = body.points();
  points.temperature = T;
  std::fill(points.heat_rate.begin(), points.heat_rate.end(), 0.0);
  std::fill(points.conductance.begin(), points.conductance.end(), 0.0);
  body.add_conduction(1);
  return points.heat_rate;
}

template <int Dim>
Real step_of(const Points<Dim>& points) {
  Real step = kInfinity;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    step = std::min(step, points.capacity[i] / points.conductance[i]);
  }
  return step;
}

/// Largest eigenvalue of C^-1 K [1/s] by power iteration.
template <int Dim>
Real fastest_rate(FiniteElements<Dim>& body) {
  const auto& points = body.points();
  std::vector<Real> T(points.x.size());
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> uniform(-1, 1);
  for (auto& value : T) value = uniform(random);
  Real rate = 0;
  for (int k = 0; k < 400; ++k) {
    const auto q = heat_rates(body, T);
    Real largest = 0;
    for (std::size_t i = 0; i < T.size(); ++i) {
      T[i] = -q[i] / points.capacity[i];
      largest = std::max(largest, std::fabs(T[i]));
    }
    for (auto& value : T) value /= largest;
    rate = largest;
  }
  return rate;
}

template <int Dim>
void expect_patch_test(Geometry geometry) {
  std::array<int, Dim> cells;
  cells.fill(4);
  const auto material = conductor(50);
  auto body = body_of(box_mesh<Dim>(cells, Vec<Dim>::Constant(0.2), Vec<Dim>::Ones(), 0.2),
                      material, geometry);
  auto& points = body->points();
  std::vector<Real> even(points.x.size(), 351.7), linear;
  for (const Real q : heat_rates(*body, even)) EXPECT_EQ(q, 0);
  // In axisymmetry the gradient is along the axis: r has a Laplacian of 1/r.
  for (const auto& x : points.x) {
    linear.push_back(300 + 7 * x[1] + (geometry == Geometry::axisymmetric ? 0 : 3 * x[0]));
  }
  const auto q = heat_rates(*body, linear);
  Real sum = 0, largest = 0;
  for (const Real one : q) sum += one, largest = std::max(largest, std::fabs(one));
  EXPECT_NEAR(sum, 0, 1e-12 * largest);
  for (std::size_t i = 0; i < q.size(); ++i) {
    bool inner = true;
    for (int c = 0; c < Dim; ++c) {
      inner = inner && points.x[i][c] > 0.2 + 1e-9 && points.x[i][c] < 1.2 - 1e-9;
    }
    if (inner) {
      EXPECT_NEAR(q[i], 0, 1e-11 * largest);
    }
  }
}

TEST(FeConduction, FieldsOfDegreeOneHeatNothingInside) {
  expect_patch_test<3>(Geometry::three_d);
  expect_patch_test<2>(Geometry::plane_strain);
  expect_patch_test<2>(Geometry::axisymmetric);
}

TEST(FeConduction, NoModeOfTemperatureIsFree) {
  const auto material = conductor(50);
  auto body = body_of(cell_mesh<3>(Vec3::Ones(), 0.1, 5), material, Geometry::three_d);
  const auto& points = body->points();
  for (int mode = 0; mode < 4; ++mode) {  // the hourglass modes of the cell
    std::vector<Real> T;
    for (const auto& at : points.x) {
      const Real x = at[0] > 0.5 ? 1 : -1, y = at[1] > 0.5 ? 1 : -1, z = at[2] > 0.5 ? 1 : -1;
      T.push_back(mode == 0 ? y * z : mode == 1 ? z * x : mode == 2 ? x * y : x * y * z);
    }
    const auto q = heat_rates(*body, T);
    Real dissipation = 0;
    for (std::size_t i = 0; i < q.size(); ++i) dissipation -= T[i] * q[i];
    EXPECT_GT(dissipation, 0.5 * 50);
  }
}

/// int grad N_I . grad N_J dV [m] of a hex by its definition: at each Gauss point grad N_I =
/// J^-T dN_I/dxi, N_I = (1 + xi_I xi)(1 + eta_I eta)(1 + zeta_I zeta)/8, dV = det J, weights 1.
Eigen::Matrix<Real, 8, 8> products_by_definition(const std::array<Vec3, 8>& x) {
  Eigen::Matrix<Real, 8, 8> K = Eigen::Matrix<Real, 8, 8>::Zero();
  const auto& sign = Shape<3>::kSign;
  for (int g = 0; g < 8; ++g) {
    const Vec3 at = Vec3(sign[g][0], sign[g][1], sign[g][2]) / std::sqrt(3.0);
    Eigen::Matrix<Real, 3, 8> slope;
    for (int I = 0; I < 8; ++I) {
      const Vec3 h(sign[I][0], sign[I][1], sign[I][2]);
      const Vec3 factor = Vec3::Ones() + h.cwiseProduct(at);
      slope.col(I) = Vec3(h[0] * factor[1] * factor[2], h[1] * factor[2] * factor[0],
                          h[2] * factor[0] * factor[1]) /
                     8;
    }
    Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
    for (int I = 0; I < 8; ++I) J += x[slot_of(I)] * slope.col(I).transpose();
    const Eigen::Matrix<Real, 3, 8> gradient = J.inverse().transpose() * slope;
    K += J.determinant() * gradient.transpose() * gradient;
  }
  return K;
}

// Cubes, sheets and needles with corners moved by up to 0.3 of their sides. Heat rates and the
// conductance 1/2 sum_J |K_IJ| agree to rounding of the largest entry, which cancels in some.
TEST(FeConduction, HexesHaveTheProductsOfTheirGradients) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> uniform(-0.3, 0.3);
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1e-3, 1e-3, 1e-6), Vec3(1, 1, 40)}) {
    for (int trial = 0; trial < 50; ++trial) {
      std::array<Vec3, 8> x;
      std::vector<Vec3> nodes;
      std::vector<Real> T;
      for (int I = 0; I < 8; ++I) {
        for (int i = 0; i < 3; ++i) {
          x[slot_of(I)][i] = size[i] * (0.5 * Shape<3>::kSign[I][i] + uniform(random));
        }
        nodes.push_back(x[slot_of(I)]);
        T.push_back(300 + 100 * uniform(random));
      }
      const auto K = products_by_definition(x);
      const std::array<LocalIndex, 32> corner{0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7,
                                              0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
      const std::array<Real, 4> k{1, 50, 386, 1e-3};
      std::array<Real, 64> heat;
      ConductionStep<3> step;
      step.x = nodes.data(), step.temperature = T.data();
      conduct_hexes<Pack>(corner.data(), k.data(), step, heat.data());
      const Real largest = K.cwiseAbs().maxCoeff();
      for (int lane = 0; lane < 4; ++lane) {
        for (int I = 0; I < 8; ++I) {
          Real rate = 0;
          for (int J = 0; J < 8; ++J) rate += K(I, J) * (T[slot_of(I)] - T[slot_of(J)]);
          const Real* const of = &heat[slot_of(16 * lane + 2 * I)];
          const Real scale = k[slot_of(lane)] * largest;
          EXPECT_NEAR(of[0], k[slot_of(lane)] * rate, 1e-12 * scale * 60);
          EXPECT_NEAR(of[1], 0.5 * k[slot_of(lane)] * K.row(I).cwiseAbs().sum(), 1e-12 * scale);
        }
      }
    }
  }
}

// Gershgorin: C/conductance <= 2/lambda_max. Equal to it on sheets, 3/4 of it on cubes, where it
// is the bound beyond which a hot node would turn colder than its neighbours.
TEST(FeConduction, TheStepIsStableOnAnyShape) {
  const auto material = conductor(50);
  const auto fraction = [&](const Vec3& size, Real distortion) {
    auto body = body_of(box_mesh<3>({5, 5, 5}, Vec3::Zero(), size, distortion), material,
                        Geometry::three_d);
    const Real rate = fastest_rate(*body);
    return step_of(body->points()) * rate / 2;
  };
  EXPECT_NEAR(fraction(Vec3(1, 1, 1), 0), 0.75, 0.02);
  EXPECT_NEAR(fraction(Vec3(10, 10, 1), 0), 1, 0.03);
  for (const Vec3& size : {Vec3(1, 1, 1), Vec3(1, 1, 20), Vec3(3, 1, 0.2)}) {
    EXPECT_LE(fraction(size, 0.3), 1 + 1e-9) << size.transpose();
    EXPECT_GT(fraction(size, 0.3), 0.5) << size.transpose();
  }
}

// A rod of two materials, k2 = 1e-6 k1, steady between 100 and 0: q = 100/(L/k1 + L/k2).
TEST(FeConduction, OneMaterialConductsAMillionTimesBetter) {
  const auto good = conductor(50), poor = conductor(50e-6, 1e-6);  // of the same diffusivity
  auto mesh = box_mesh<3>({20, 1, 1}, Vec3::Zero(), Vec3(2, 0.1, 0.1));
  std::vector<ElementSet<3>> sets(2);
  for (std::size_t e = 0; e < 20; ++e) {
    auto& set = sets[e < 10 ? 0 : 1];
    set.material = e < 10 ? &good : &poor;
    set.conducts = set.held = true;
    set.corners.push_back(mesh.set.corners[e]);
    set.id.push_back(e), set.body.push_back(0), set.piece.push_back(0);
  }
  FiniteElements<3> body(std::move(mesh.points), sets, Geometry::three_d, 1);
  auto& points = body.points();
  std::vector<Real> T(points.x.size(), 50.0), q;
  for (int step = 0; step < 3000; ++step) {
    for (std::size_t i = 0; i < T.size(); ++i) {
      if (points.x[i][0] < 1e-9) T[i] = 100;
      if (points.x[i][0] > 2 - 1e-9) T[i] = 0;
    }
    q = heat_rates(body, T);
    const Real dt = step_of(points);
    for (std::size_t i = 0; i < T.size(); ++i) {
      T[i] += dt * q[i] / points.capacity[i];
      ASSERT_GE(T[i], -dt * std::fabs(q[i]) / points.capacity[i] - 1e-9);
      if (points.x[i][0] > 1e-9 && points.x[i][0] < 2 - 1e-9) {
        ASSERT_LE(T[i], 100 + 1e-9);
      }
    }
  }
  Real flow = 0;
  for (std::size_t i = 0; i < T.size(); ++i) flow += points.x[i][0] > 2 - 1e-9 ? q[i] : 0;
  EXPECT_NEAR(flow / (0.01 * 100 / (1 / 50.0 + 1 / 50e-6)), 1, 1e-3);
}

// A table of k over temperature: linear from 10 at 300 K to 30 at 500 K. Steady between these, the
// flux is the mean of k times the gradient, and k^2 is linear in x.
TEST(FeConduction, ConductivityFollowsTheTemperature) {
  Material material = conductor(0);
  material.conductivity.over = Varying::Over::temperature;
  material.conductivity.abscissa = {300, 500}, material.conductivity.ordinate = {10, 30};
  auto body = body_of(box_mesh<3>({20, 1, 1}, Vec3::Zero(), Vec3(1, 0.05, 0.05)), material,
                      Geometry::three_d);
  auto& points = body->points();
  std::vector<Real> T;
  for (const auto& x : points.x) T.push_back(200 + 10 * std::sqrt(100 + 800 * x[0]));
  const auto q = heat_rates(*body, T);
  Real flow = 0;
  for (std::size_t i = 0; i < q.size(); ++i) {
    if (points.x[i][0] > 1 - 1e-9) flow -= q[i];
    if (points.x[i][0] > 1e-9 && points.x[i][0] < 1 - 1e-9) {
      EXPECT_NEAR(q[i], 0, 1e-9);  // k at the mean temperature is exact where k is linear
    }
  }
  EXPECT_NEAR(flow, 20 * 200 * 0.0025, 1e-9);
}

// Elements of 2 x 1 x 1 m, 1000 kg/m^3: each gives its four nodes of the face between them 250 kg.
// Their cp is the mean of both tables: (100 + 500)/2 at 300 K, (300 + 500)/2 at 400 K.
TEST(FeConduction, NodesOfTwoMaterialsMixTheirTables) {
  Material steep = conductor(1), constant = conductor(1, 500);
  Varying given;
  given.over = Varying::Over::temperature;
  given.abscissa = {300, 400}, given.ordinate = {100, 300};
  steep.specific_heat = SpecificHeat(given);
  auto mesh = box_mesh<3>({2, 1, 1}, Vec3::Zero(), Vec3(4, 1, 1));
  std::vector<ElementSet<3>> sets(2);
  for (std::size_t e = 0; e < 2; ++e) {
    auto& set = sets[e];
    set.material = e == 0 ? &steep : &constant;
    set.conducts = set.held = true;
    set.temperature = 300;
    set.corners.push_back(mesh.set.corners[e]);
    set.id.push_back(e), set.body.push_back(0), set.piece.push_back(0);
  }
  const FiniteElements<3> body(std::move(mesh.points), sets, Geometry::three_d, 1);
  const auto& points = body.points();
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    const Real x = points.x[i][0];
    if (x > 3) {
      EXPECT_FALSE(points.capacity_varies(i));
      EXPECT_NEAR(points.capacity[i], 250 * 500, 1e-9);
      continue;
    }
    ASSERT_TRUE(points.capacity_varies(i));
    const Real mass = x < 1 ? 250 : 500, low = x < 1 ? 100 : 300, high = x < 1 ? 300 : 400;
    EXPECT_NEAR(points.capacity[i], mass * low, 1e-9);
    EXPECT_NEAR(points.temperature_with(i, mass * 0.5 * (low + high) * 100), 400, 1e-11);
    EXPECT_NEAR(points.least_capacity(i), mass * low, 1e-9);
  }
}

// Every third step conducts; in between its rates and conductances stay, whatever temperatures do.
TEST(FeConduction, RatesStayUntilTheNextEvaluation) {
  const auto material = conductor(20);
  auto body = body_of(box_mesh<3>({3, 2, 2}, Vec3::Zero(), Vec3(3, 2, 2), 0.2), material,
                      Geometry::three_d);
  auto& points = body->points();
  points.keep_conduction();
  points.conduction_steps = 3;
  std::vector<std::vector<Real>> rates, conductances;
  for (std::int64_t step = 0; step < 7; ++step) {
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.temperature[i] = 300 + static_cast<Real>(step + 1) * points.x[i].squaredNorm();
    }
    points.evaluates_conduction = step % 3 == 0;
    points.begin_heat_rates();
    body->add_conduction(1);
    rates.push_back(points.heat_rate), conductances.push_back(points.conductance);
    const Real sum = std::accumulate(rates.back().begin(), rates.back().end(), 0.0);
    EXPECT_NEAR(sum, 0, 1e-12 * 20 * 17 * 7);  // of the largest coupling and temperature
  }
  EXPECT_EQ(rates[1], rates[0]);
  EXPECT_EQ(rates[2], rates[0]);
  EXPECT_EQ(rates[5], rates[3]);
  EXPECT_EQ(conductances[2], conductances[0]);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    EXPECT_NEAR(rates[3][i], 4 * rates[0][i], 1e-9);  // linear in the temperature
    EXPECT_NEAR(rates[6][i], 7 * rates[0][i], 1e-9);
  }
}

}  // namespace
}  // namespace brunt::testing
