// The step that particles allow against the largest frequency of the operator that is coded,
// found by power iteration: v <- -dF/(m dt) of a body without stress, whose positions stay. The
// Rayleigh quotient comes from below, after 150 iterations within 2 % (8x8x4: 1.6 % of what 1,600
// give). Leapfrog is stable to 2/omega. Lattices keep 2 % to spare for that; disordered bodies come
// nearer, and `time.safety` of 0.9 covers them.
//
// docs/theory/sph.md (S21) to (S25).
// Two layers a distance d apart strain by the difference of their velocities over d, whatever the
// kernel: omega = 2 c/d, dt = d/c, where kernels of 1.7 spacings would allow 1.54 d/c.
#include <gtest/gtest.h>

#include <cmath>

#include "sample.hpp"

namespace brunt {
namespace {

using test::elastic_material;
using test::kDensity;
using test::kDp;

/// Hexagonal layers (2D) or their closest packing (3D), dp^Dim of volume a particle.
template <int Dim>
Points<Dim> hexagonal(std::array<int, Dim> n) {
  auto points = test::lattice<Dim>(n, kDp, kDensity * std::pow(kDp, Dim));
  const Real a = kDp * (Dim == 2 ? std::sqrt(2 / std::sqrt(3.0)) : std::pow(2.0, 1.0 / 6));
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    int c[3] = {0, 0, 0}, rest = static_cast<int>(i);
    for (std::size_t d = 0; d < Dim; ++d) c[d] = rest % n[d], rest /= n[d];
    points.x[i][0] = a * (c[0] + 0.5 * ((c[1] + c[2]) % 2));
    points.x[i][1] = a * (std::sqrt(3.0) / 2) * (c[1] + (c[2] % 2) / 3.0);
    if (Dim == 3) points.x[i][Dim - 1] = a * std::sqrt(2.0 / 3) * c[2];
    points.x_start[i] = points.x[i];
  }
  return points;
}

template <int Dim>
Points<Dim> body_of(std::array<int, Dim> n, bool hexagons, Real noise) {
  if (hexagons) return hexagonal<Dim>(n);
  return test::lattice<Dim>(n, kDp, kDensity * std::pow(kDp, Dim), noise);
}

/// 2/omega over the step limit without viscosity.
template <int Dim>
Real stable_step_limits(Points<Dim> body, const Material& material, SphOptions options) {
  options.viscosity = {0, 0};
  auto solid = test::particles<Dim>(std::move(body), kDp, material, options);
  auto& points = solid->points();
  constexpr Real dt = 1e-15;
  std::mt19937_64 random(3);
  std::vector<Vec<Dim>> v(points.x.size()), force(points.x.size(), Vec<Dim>::Zero());
  for (auto& one : v) {
    for (int d = 0; d < Dim; ++d) one[d] = static_cast<Real>(random() >> 11) * 0x1p-53 - 0.5;
  }
  Real lambda = 0;
  for (int iteration = 0; iteration < 150; ++iteration) {
    Real square = 0;
    for (const auto& one : v) square += one.squaredNorm();
    for (std::size_t i = 0; i < v.size(); ++i) {
      points.v[i] = v[i] /= std::sqrt(square);
      points.f[i].setZero();
    }
    solid->renew_lists();
    solid->update_state(dt);
    solid->add_internal_forces(dt);
    lambda = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Vec<Dim> next = (force[i] - points.f[i]) / (dt * points.mass[i]);
      force[i] = points.f[i];
      lambda += next.dot(v[i]);
      v[i] = next;
    }
  }
  return 2 / std::sqrt(lambda) / solid->stable_step().step;
}

struct Smoothed {
  KernelKind kernel;
  Real smoothing;
};
constexpr Smoothed kAll[] = {
    {KernelKind::cubic, 1.7},       {KernelKind::cubic, 1.2},       {KernelKind::quadratic, 1.2},
    {KernelKind::hyperbolic, 1.2},  {KernelKind::wendland_c2, 1.7}, {KernelKind::wendland_c4, 1.7},
    {KernelKind::wendland_c2, 1.3},
};

template <int Dim>
void expect_stable(const std::vector<std::array<int, Dim>>& bodies, Real nu) {
  const auto material = elastic_material(kDensity, 200e9, nu);
  for (const auto& [kernel, smoothing] : kAll) {
    SphOptions options;
    options.kernel = kernel, options.smoothing = smoothing;
    for (const auto& n : bodies) {
      for (const bool hexagons : {false, true}) {
        EXPECT_GT(stable_step_limits<Dim>(body_of<Dim>(n, hexagons, 0), *material, options), 1.02)
            << static_cast<int>(kernel) << " " << smoothing << ", " << n[0] << " x " << n[1]
            << " x " << n[Dim - 1] << (hexagons ? " hexagonal" : "");
      }
      EXPECT_GT(stable_step_limits<Dim>(body_of<Dim>(n, false, 0.15), *material, options), 1)
          << static_cast<int>(kernel) << " " << smoothing << ", " << n[0] << " x " << n[1] << " x "
          << n[Dim - 1] << " disordered";
    }
  }
}

TEST(StepBound, HoldsInThePlane) {
  expect_stable<2>({{10, 1}, {10, 2}, {10, 3}, {10, 4}, {2, 2}, {3, 3}}, 0.3);
  expect_stable<2>({{10, 2}, {2, 2}}, 0);
  expect_stable<2>({{10, 2}, {2, 2}}, 0.45);
}

TEST(StepBound, HoldsInSpace) {
  expect_stable<3>({{5, 5, 1}, {5, 5, 2}, {5, 2, 2}, {2, 2, 2}, {3, 3, 3}}, 0.3);
}

TEST(StepBound, HoldsInSpaceLong) {
  expect_stable<3>({{7, 7, 2}, {7, 7, 3}, {7, 7, 4}, {8, 3, 3}, {8, 4, 4}, {6, 6, 6}}, 0.3);
  expect_stable<3>({{5, 5, 2}, {6, 2, 2}, {2, 2, 2}}, 0.45);
}

// Sheets and rods whose particles lie up to a third or half a spacing off their plane: the normal
// strains in part (docs/theory/sph.md (S9a)).
TEST(StepBound, HoldsForWarpedSheets) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  for (const auto& [kernel, smoothing] : kAll) {
    SphOptions options;
    options.kernel = kernel, options.smoothing = smoothing;
    for (const Real noise : {0.3, 0.5}) {
      for (const std::array<int, 3> n : {std::array<int, 3>{5, 5, 1}, {8, 1, 1}}) {
        const Real limits = stable_step_limits<3>(body_of<3>(n, false, noise), *material, options);
        EXPECT_GT(limits, 1) << static_cast<int>(kernel) << " " << smoothing << ", " << n[0]
                             << " x " << n[1] << ", " << noise;
      }
      EXPECT_GT(stable_step_limits<2>(body_of<2>({10, 1}, false, noise), *material, options), 1);
    }
  }
}

// Bodies of any thickness but two or three layers have the limit of before: half of the undamped
// limit.
TEST(StepBound, ThickBodiesTakeTheStepOfTheirKernels) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const Real c = std::sqrt((material->bulk + 4.0 / 3 * material->shear) / kDensity);
  SphOptions options;
  options.viscosity = {0, 0};
  auto cube = test::particles<3>(body_of<3>({6, 6, 6}, false, 0), kDp, *material, options);
  cube->renew_lists();
  cube->update_state(1e-15);
  for (auto& f : cube->points().f) f.setZero();
  cube->add_internal_forces(1e-15);
  EXPECT_NEAR(cube->stable_step().step, 0.5 * 1.81 * 1.7 * kDp / c, 1e-12 * kDp / c);
}

/// Largest speed [m/s] after 600 of its own steps of a body whose particles had up to 1 mm/s each.
template <int Dim>
Real speed_after(std::array<int, Dim> n, Real alpha) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  SphOptions options;
  options.viscosity = {alpha, 2 * alpha};
  auto solid = test::particles<Dim>(body_of<Dim>(n, false, 0), kDp, *material, options);
  auto& points = solid->points();
  std::mt19937_64 random(5);
  for (auto& v : points.v) {
    for (int d = 0; d < Dim; ++d) {
      v[d] = 1e-3 * (2 * (static_cast<Real>(random() >> 11) * 0x1p-53) - 1);
    }
  }
  test::step(*solid, 1e-12);
  for (int k = 0; k < 600; ++k) test::step(*solid, solid->stable_step().step);
  Real largest = 0;
  for (const auto& v : points.v) largest = std::max(largest, v.norm());
  return largest;
}

// Viscosity shortens the limit; the step limit knows it. What it damps can only fall, and without
// it one particle may come to have the energy of some others: tenfold is far from what an
// instability makes of 600 steps.
TEST(StepBound, HoldsWithViscosity) {
  for (const Real alpha : {0.0, 0.1, 0.3, 1.0}) {
    for (const int layers : {1, 2, 3, 4}) {
      EXPECT_LT(speed_after<2>({10, layers}, alpha), alpha > 0 ? 2e-3 : 1e-2) << alpha << layers;
    }
    EXPECT_LT(speed_after<2>({2, 2}, alpha), alpha > 0 ? 2e-3 : 1e-2) << alpha;
    EXPECT_LT(speed_after<3>({4, 4, 2}, alpha), alpha > 0 ? 2e-3 : 1e-2) << alpha;
    EXPECT_LT(speed_after<3>({4, 2, 2}, alpha), alpha > 0 ? 2e-3 : 1e-2) << alpha;
  }
}

}  // namespace
}  // namespace brunt
