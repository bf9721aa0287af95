// Conduction of particles: what the Laplacian of T = (x - x_i)^2, which is 2, comes out as on a
// lattice and on a disturbed one; how solutions converge; conservation; two materials.
// On a lattice the pair form is exact for squares, and the layers at surfaces leave an error of
// first order. On a disturbed one its error at a point is that of the disturbance, at any spacing,
// and so solutions converge to those of a conductivity that is some per cent smaller.
#include "sph/conduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "tests/support/eigenvalues.hpp"
#include "tests/unit/sph/sample.hpp"

namespace brunt::test {
namespace {

constexpr Real kConductivity = 40, kHeat = 3e6;  // [W/m/K], [J/m^3/K]

std::unique_ptr<Material> conductor(Real k = kConductivity, Real heat = kHeat) {
  auto material = elastic_material(1000, 1e9, 0.3);
  material->thermal = true;
  material->specific_heat = SpecificHeat(heat / 1000);
  material->conductivity.constant = k;
  return material;
}

/// Particles that never move; those beyond `split` along x are of the second material.
template <int Dim>
std::unique_ptr<SphParticles<Dim>> still(Points<Dim> points, Real dp, const Material& first,
                                         const Material* second = nullptr, Real split = 0,
                                         Real smoothing = 1.2) {
  std::vector<ParticleSet> sets(second ? 2 : 1);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    sets[s].material = s == 0 ? &first : second;
    sets[s].conducts = sets[s].held = true;
    sets[s].options.smoothing = smoothing;
  }
  for (LocalIndex i = 0; i < points.size(); ++i) {
    const bool beyond = second && points.x[static_cast<std::size_t>(i)][0] > split;
    sets[beyond ? 1 : 0].particle.push_back(i);
  }
  const std::vector<Real> spacing(points.x.size(), dp);
  return std::make_unique<SphParticles<Dim>>(std::move(points), spacing, std::move(sets));
}

template <int Dim>
const std::vector<Real>& heat_rates(SphParticles<Dim>& solid, const std::vector<Real>& T) {
  auto& points = solid.points();
  points.temperature = T;
  std::fill(points.heat_rate.begin(), points.heat_rate.end(), 0.0);
  std::fill(points.conductance.begin(), points.conductance.end(), 0.0);
  solid.renew_lists();
  solid.update_state(1);
  solid.add_conduction(1);
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

/// Root mean square of (Laplacian of (x - x_i)^2)/2 - 1 over particles i well inside.
template <int Dim>
Real laplacian_error(int n, Real noise) {
  const Real dp = 1.0 / n;
  std::array<int, Dim> cells;
  cells.fill(n);
  const auto material = conductor();
  auto solid = still<Dim>(lattice<Dim>(cells, dp, 1000 * std::pow(dp, Dim), noise), dp, *material);
  auto& points = solid->points();
  Real sum = 0;
  int count = 0;
  for (std::size_t i = 0; i < points.x.size() && count < 60; ++i) {
    if ((points.x[i].array() - 0.5).abs().maxCoeff() > 0.5 - 4 * dp) continue;
    std::vector<Real> T;
    for (const auto& x : points.x) T.push_back((x[0] - points.x[i][0]) * (x[0] - points.x[i][0]));
    const Real laplacian = heat_rates(*solid, T)[i] / (kConductivity * std::pow(dp, Dim));
    sum += (laplacian / 2 - 1) * (laplacian / 2 - 1);
    ++count;
  }
  return std::sqrt(sum / count);
}

TEST(SphConduction, LaplacianOfASquare) {
  EXPECT_LT(laplacian_error<2>(12, 0), 1e-12);
  EXPECT_LT(laplacian_error<3>(10, 0), 1e-12);
  for (const Real noise : {0.05, 0.1}) {
    const Real coarse = laplacian_error<2>(12, noise), fine = laplacian_error<2>(24, noise);
    std::printf("noise %.2f: rms error of the Laplacian %.4f at n = 12, %.4f at n = 24\n", noise,
                coarse, fine);
    EXPECT_LT(coarse, noise);
    EXPECT_LT(fine, noise);
  }
}

/// What a rod of n x m particles conducts of what its material does: the mean over the particles of
/// a section of (Laplacian of x^2)/2, far from the ends. Pairs within the section carry nothing.
Real conductivity_of_rod(int n, int m, Real smoothing) {
  const auto material = conductor();
  auto solid = still<3>(lattice<3>({15, n, m}, 1, 1000), 1, *material, nullptr, 0, smoothing);
  auto& points = solid->points();
  std::vector<Real> T;
  for (const auto& x : points.x) T.push_back((x[0] - 7.5) * (x[0] - 7.5));
  const auto& q = heat_rates(*solid, T);
  Real sum = 0;
  for (std::size_t i = 0; i < q.size(); ++i)
    sum += std::fabs(points.x[i][0] - 7.5) < 0.1 ? q[i] : 0;
  std::printf("%d x %d, smoothing %.1f: %.4f\n", n, m, smoothing,
              sum / (2 * kConductivity * n * m));
  return sum / (2 * kConductivity * n * m);
}

// Edges and faces miss neighbours, and what is left conducts as much: exactly where all particles
// of a section have the same neighbours, else up to what the mean of powers falls short of the
// largest eigenvalue of their moments, and the geometric mean of the arithmetic one. With B in
// place of completeness a rod of 2 x 2 conducted 1.40 of its material, one of 6 x 6 0.96.
TEST(SphConduction, RodsConductWhatTheirMaterialDoes) {
  for (const Real smoothing : {1.2, 1.7}) {
    for (const auto& [n, m] : {std::pair{1, 1}, {2, 1}, {2, 2}}) {
      EXPECT_NEAR(conductivity_of_rod(n, m, smoothing), 1, 0.003) << n << " x " << m;
    }
    for (const auto& [n, m] : {std::pair{3, 3}, {4, 1}, {4, 4}, {6, 6}, {10, 2}, {10, 10}}) {
      EXPECT_NEAR(conductivity_of_rod(n, m, smoothing), 1, 0.012) << n << " x " << m;
    }
  }
}

// A plate of n layers: the slowest decay of a difference across it over 2 - 2 cos(pi/n), that of n
// cells. Two layers are as fast as their pairs alone make it.
TEST(SphConduction, HeatCrossesThinPlates) {
  for (const auto& [n, least, most] :
       {std::tuple{2, 0.78, 1.16}, {3, 0.97, 1.1}, {4, 0.99, 1.05}, {6, 0.99, 1.02}}) {
    for (const Real smoothing : {1.2, 1.7}) {
      const auto material = conductor();
      auto solid = still<3>(lattice<3>({11, 11, n}, 1, 1000), 1, *material, nullptr, 0, smoothing);
      auto& points = solid->points();
      std::vector<std::size_t> column;
      for (std::size_t i = 0; i < points.x.size(); ++i) {
        if (points.x[i][0] == 5.5 && points.x[i][1] == 5.5) column.push_back(i);
      }
      // The rates of one warm layer after another are the columns of what the layers do together.
      Eigen::MatrixXd rates(n, n);
      for (int layer = 0; layer < n; ++layer) {
        std::vector<Real> T;
        for (const auto& x : points.x) T.push_back(std::fabs(x[2] - (layer + 0.5)) < 0.1 ? 1 : 0);
        const auto& q = heat_rates(*solid, T);
        for (int k = 0; k < n; ++k) rates(k, layer) = -q[column[static_cast<std::size_t>(k)]];
      }
      const Eigen::VectorXd modes = symmetric_eigenvalues_of(rates);
      const Real ratio = modes[1] / (kConductivity * (2 - 2 * std::cos(kPi / n)));
      std::printf("%d layers, smoothing %.1f: %.3f\n", n, smoothing, ratio);
      EXPECT_GT(ratio, least) << n << " layers, smoothing " << smoothing;
      EXPECT_LT(ratio, most) << n << " layers, smoothing " << smoothing;
    }
  }
}

/// Relative error of the rate at which cos(pi x) decays in an insulated unit square: pi^2 alpha.
Real decay_error(int n, Real noise) {
  const Real dp = 1.0 / n;
  const auto material = conductor();
  auto solid = still<2>(lattice<2>({n, n}, dp, 1000 * dp * dp, noise), dp, *material);
  auto& points = solid->points();
  std::vector<Real> T;
  for (const auto& x : points.x) T.push_back(std::cos(kPi * x[0]));
  const auto amplitude = [&] {
    Real sum = 0;
    for (std::size_t i = 0; i < T.size(); ++i) sum += T[i] * std::cos(kPi * points.x[i][0]);
    return sum;
  };
  const Real start = amplitude(), end = 0.1 / (kPi * kPi * kConductivity / kHeat);
  heat_rates(*solid, T);
  const int steps = static_cast<int>(std::ceil(end / (0.5 * step_of(points))));
  for (int k = 0; k < steps; ++k) {
    const auto& q = heat_rates(*solid, T);
    for (std::size_t i = 0; i < T.size(); ++i) T[i] += end / steps * q[i] / points.capacity[i];
  }
  return -std::log(amplitude() / start) / 0.1 - 1;
}

TEST(SphConduction, SolutionsConvergeOnLattices) {
  for (const Real noise : {0.0, 0.05, 0.1}) {
    const Real coarse = decay_error(10, noise), fine = decay_error(20, noise),
               finest = decay_error(40, noise);
    std::printf("noise %.2f: error of the decay %.4f, %.4f, %.4f at n = 10, 20, 40\n", noise,
                coarse, fine, finest);
    if (noise == 0) {
      EXPECT_LT(std::fabs(coarse), 0.015);
      EXPECT_LT(std::fabs(finest), 0.3 * std::fabs(coarse));  // first order: 1/4
    }
    // Displacements of +-5 and +-10 % of the spacing cost 1 and 2.5 % of the conductivity.
    EXPECT_LT(std::fabs(finest), 0.01 + 0.2 * noise);
  }
}

TEST(SphConduction, HeatIsConservedAndEvenTemperaturesStay) {
  const auto material = conductor(), other = conductor(3);
  auto solid = still<3>(lattice<3>({6, 6, 6}, 1, 1000, 0.2), 1, *material, other.get(), 2.7);
  std::vector<Real> T(solid->points().x.size(), 351.7);
  for (const Real q : heat_rates(*solid, T)) EXPECT_EQ(q, 0);
  for (std::size_t i = 0; i < T.size(); ++i) T[i] = 300 + static_cast<Real>(i * 7919 % 100);
  Real sum = 0, size = 0;
  for (const Real q : heat_rates(*solid, T)) sum += q, size += std::fabs(q);
  EXPECT_LT(std::fabs(sum), 1e-14 * size);
}

// Two materials, k2 = 1e-6 k1, between 100 and 0: q = 100/(L1/k1 + L2/k2). The interface lies
// midway between two columns, whose conductivity is the harmonic mean; the second neighbours, that
// conduct across the interface as if half the way were good, shorten the poor side by some tenths
// of a spacing of its 20.
TEST(SphConduction, OneMaterialConductsAMillionTimesBetter) {
  const auto good = conductor(50, 1e6), poor = conductor(50e-6, 1);
  auto solid = still<2>(lattice<2>({40, 8}, 1, 1000), 1, *good, poor.get(), 20);
  auto& points = solid->points();
  std::vector<Real> T(points.x.size(), 50.0), q;
  for (int step = 0; step < 8000; ++step) {
    for (std::size_t i = 0; i < T.size(); ++i) {
      if (points.x[i][0] < 1) T[i] = 100;
      if (points.x[i][0] > 39) T[i] = 0;
    }
    q = heat_rates(*solid, T);
    const Real dt = step_of(points);
    for (std::size_t i = 0; i < T.size(); ++i) {
      if (points.x[i][0] < 1 || points.x[i][0] > 39) continue;
      T[i] += dt * q[i] / points.capacity[i];
      ASSERT_GE(T[i], -1e-9);
      ASSERT_LE(T[i], 100 + 1e-9);
    }
  }
  Real flow = 0;
  for (std::size_t i = 0; i < T.size(); ++i) flow += points.x[i][0] > 39 ? q[i] : 0;
  const Real exact = 8 * 100 / (19.5 / 50 + 19.5 / 50e-6);
  std::printf("k ratio 1e6: flux %.4f of the exact one\n", flow / exact);
  EXPECT_NEAR(flow / exact, 1, 0.03);
}

// Every third step conducts; in between its rates and conductances stay, whatever temperatures do.
TEST(SphConduction, RatesStayUntilTheNextEvaluation) {
  const auto material = conductor();
  auto solid = still<2>(lattice<2>({6, 6}, 1, 1000), 1, *material);
  auto& points = solid->points();
  points.keep_conduction();
  points.conduction_steps = 3;
  std::vector<std::vector<Real>> rates, conductances;
  for (std::int64_t step = 0; step < 7; ++step) {
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.temperature[i] = 300 + static_cast<Real>(step + 1) * points.x[i].squaredNorm();
    }
    solid->renew_lists();
    solid->update_state(1);
    points.evaluates_conduction = step % 3 == 0;
    points.begin_heat_rates();
    solid->add_conduction(1);
    rates.push_back(points.heat_rate), conductances.push_back(points.conductance);
  }
  EXPECT_EQ(rates[1], rates[0]);
  EXPECT_EQ(rates[2], rates[0]);
  EXPECT_EQ(rates[5], rates[3]);
  EXPECT_EQ(conductances[2], conductances[0]);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    EXPECT_NEAR(rates[3][i], 4 * rates[0][i], 1e-9 * std::fabs(rates[0][i]));  // linear in T
    EXPECT_NEAR(rates[6][i], 7 * rates[0][i], 1e-9 * std::fabs(rates[0][i]));
  }
}

}  // namespace
}  // namespace brunt::test
