// SphParticles against closed forms. Where each number comes from stands at its test.
#include "sph/particles.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/errors.hpp"
#include "sample.hpp"

namespace brunt {
namespace {

using test::elastic_material;
using test::elastic_options;
using test::kDensity;
using test::kDp;
using test::lattice;
using test::particles;

// The corrected gradient of a linear field is exact on any particles: v = A x gives L = A.
// Round-off of 60 terms times the condition of the moment matrix, below 10 at a corner: 1e-12 of
// |A|.
TEST(SphParticles, GradientOfALinearFieldIsExact) {
  EXPECT_LT(test::linear_field_error<2>(elastic_options()), 1e-12);
  EXPECT_LT(test::linear_field_error<3>(elastic_options()), 1e-12);
}

// What the skin lets into the lists lies beyond the kernel and may add nothing, not even zero times
// it: a layer 2.2 h off, whose velocities and stresses are no numbers, changes no bit of a force.
template <int Dim>
void expect_skin_adds_nothing() {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const SphOptions options = test::all_pair_sums();
  const Real h = options.smoothing * kDp;
  std::array<int, Dim> n;
  n.fill(6);
  const auto forces = [&](Real velocity) {
    auto points = lattice<Dim>(n, kDp, kDensity * std::pow(kDp, Dim));
    std::vector<std::size_t> near, far;
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      const bool last = points.x[i][0] > 5 * kDp;
      (last ? far : near).push_back(i);
      if (last) points.x[i][0] += 2.2 * h - kDp;
      points.v[i].setConstant(10 * std::sin(2000 * points.x[i].sum()));
    }
    std::vector<Real> reach(points.x.size(), h);
    const std::vector<Label> label(points.x.size(), 0);
    const auto lists = shared_neighbours<Dim>(points.x, reach, label, 0.35 * h, points.n_owned, 1,
                                              SearchMode::brute)
                           .list;
    const auto last_of_row = static_cast<std::size_t>(lists.offset[near.back() + 1] - 1);
    EXPECT_EQ(static_cast<std::size_t>(lists.neighbour[last_of_row]), far.back());
    auto solid = particles<Dim>(std::move(points), kDp, *material, options);
    for (const std::size_t i : far) solid->points().v[i].setConstant(velocity);
    for (auto& f : solid->points().f) f.setZero();
    solid->renew_lists();
    solid->update_state(1e-8);
    solid->add_internal_forces(1e-8);
    std::vector<Vec<Dim>> all;
    for (const std::size_t i : near) all.push_back(solid->points().f[i]);
    return all;
  };
  const auto healthy = forces(0), poisoned = forces(std::nan(""));
  for (std::size_t i = 0; i < healthy.size(); ++i) {
    EXPECT_GT(healthy[i].norm(), 0);
    EXPECT_EQ(healthy[i], poisoned[i]);
  }
}
TEST(SphParticles, EntriesOfTheSkinAddNothing) {
  expect_skin_adds_nothing<2>();
  expect_skin_adds_nothing<3>();
}

// docs/theory/sph.md (S11).
// A prescribed rigid rotation turns the stress and does not change it: ten turns at 360
// steps a turn, | |sigma| - |sigma_0| | <= 1e-8 |sigma_0| at every particle. The pressure takes
// part through the density.
TEST(SphParticles, RigidSpinKeepsTheStress) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  auto start = lattice<3>({5, 5, 5}, kDp, kDensity * kDp * kDp * kDp, 0.1);
  const auto x0 = start.x;
  auto solid = particles<3>(std::move(start), kDp, *material, elastic_options());
  auto& state = solid->blocks()[0].state;
  const Real prestress[6] = {100e6, -40e6, -60e6, 30e6, -20e6, 10e6};
  for (std::size_t c = 0; c < 6; ++c) {
    for (std::size_t k = 0; k < x0.size(); ++k) state.deviator[c][k] = prestress[c];
  }
  const auto norm = [&](std::size_t k) {
    Real sum = 3 * state.pressure[k] * state.pressure[k];
    for (std::size_t c = 0; c < 6; ++c) {
      sum += (c < 3 ? 1 : 2) * state.deviator[c][k] * state.deviator[c][k];
    }
    return std::sqrt(sum);
  };
  const Real norm_0 = norm(0), dt = 1e-6;
  const Vec3 axis = Vec3(1, 2, 2) / 3, center = Vec3::Constant(2.5 * kDp);
  const auto placed = [&](int step) {
    return Eigen::AngleAxisd(2 * kPi * step / 360, axis).toRotationMatrix();
  };
  auto& points = solid->points();
  for (int step = 1; step <= 3600; ++step) {
    const Mat3 before = placed(step - 1), after = placed(step);
    for (std::size_t i = 0; i < x0.size(); ++i) {
      points.x[i] = center + after * (x0[i] - center);
      points.v[i] = (after - before) * (x0[i] - center) / dt;
    }
    solid->renew_lists();
    solid->update_state(dt);
  }
  for (std::size_t k = 0; k < x0.size(); ++k) EXPECT_NEAR(norm(k) / norm_0, 1, 1e-8);
}

// An elastic cube with a random velocity field, viscosity and artificial stress on: pair forces are
// opposite, so that the momentum stays within round-off of the sum of |m v|: 1e-13 of it.
// The scheme's energy 1/2 m v(n-1/2).v(n+1/2) plus the booked channels is constant at constant dt
// to round-off: 1e-10 of the starting energy (2000 bookings of 1e-16 each grow as their number).
template <int Dim>
void expect_momentum_and_energy(KernelKind kernel) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  std::array<int, Dim> n;
  n.fill(Dim == 2 ? 10 : 6);
  const Real depth = Dim == 2 ? 0.01 : 1.0;
  const Real mass = kDensity * std::pow(kDp, Dim) * depth;
  auto points = lattice<Dim>(n, kDp, mass, 0.1);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i].setConstant(3.0);
    points.v[i][0] += 40 * std::sin(500 * points.x[i][1]) + 20 * std::cos(700 * points.x[i][0]);
    points.v[i][1] += 30 * std::cos(800 * points.x[i][0]);
  }
  SphOptions options = test::all_pair_sums();
  options.kernel = kernel;
  auto solid = particles<Dim>(std::move(points), kDp, *material, options, depth);
  const auto& now = solid->points();
  const auto momentum = [&] {
    Vec<Dim> p = Vec<Dim>::Zero();
    for (const auto& v : now.v) p += mass * v;
    return p;
  };
  Real scale = 0;
  for (const auto& v : now.v) scale += mass * v.norm();
  const Vec<Dim> momentum_0 = momentum();
  const auto kinetic = [&](Real dt) {  // 1/2 m v(n-1/2).v(n+1/2) = 1/2 m (v^2 - (a dt/2)^2)
    Real sum = 0;
    for (std::size_t i = 0; i < now.x.size(); ++i) {
      sum += 0.5 * mass * (now.v[i].squaredNorm() - 0.25 * dt * dt * now.a[i].squaredNorm());
    }
    return sum;
  };
  const Real dt = 0.5 * solid->stable_step().step;
  const Real energy_0 = kinetic(dt);
  for (int k = 0; k < 200; ++k) test::step<Dim>(*solid, dt);
  const auto totals = test::totals(*solid);
  const Real booked = totals.value(Column::internal) + totals.value(Column::plastic_heat) +
                      totals.value(Column::viscosity) + totals.value(Column::artificial_stress);
  EXPECT_LT((momentum() - momentum_0).norm(), 1e-13 * scale);
  EXPECT_NEAR((kinetic(dt) + booked) / energy_0, 1, 1e-10);
  // each channel has done work, or the balance proves nothing of it
  EXPECT_GT(totals.value(Column::internal), 1e-3 * energy_0);
  EXPECT_GT(totals.value(Column::viscosity), 1e-3 * energy_0);
  EXPECT_GT(std::fabs(totals.value(Column::artificial_stress)), 1e-6 * energy_0);
}
TEST(SphParticles, MomentumAndEnergyClose) {
  expect_momentum_and_energy<2>(KernelKind::cubic);
  expect_momentum_and_energy<2>(KernelKind::hyperbolic);
  expect_momentum_and_energy<3>(KernelKind::wendland_c2);
  expect_momentum_and_energy<3>(KernelKind::quadratic);
}

// Bits: skin, rebuild at every step, brute search and threads change none.
TEST(SphParticles, SkinCadenceAndThreadsChangeNoBit) {
  const auto hash = [](Real skin, bool always, int threads, SearchMode mode = SearchMode::grid) {
    return test::impact_hash(test::all_pair_sums(), skin, always, threads, mode);
  };
  const auto reference = hash(0.2, false, 1);
  EXPECT_EQ(hash(0.05, false, 1), reference);
  EXPECT_EQ(hash(0.5, false, 2), reference);
  EXPECT_EQ(hash(0.2, true, 2), reference);
  EXPECT_EQ(hash(0.2, false, 1, SearchMode::brute), reference);
}

// Two bodies side by side do not feel each other: the forces on the first are those without the
// second, bit for bit.
TEST(SphParticles, BodiesInteractThroughContactOnly) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const auto run = [&](bool both) {
    auto points = lattice<2>({4, both ? 8 : 4}, kDp, kDensity * kDp * kDp);
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      points.body[i] = i < 16 ? 0 : 1;
      points.v[i] = Vec<2>(points.x[i][1] * 1e4, 10.0 * static_cast<Real>(i % 3));
    }
    auto solid = particles<2>(std::move(points), kDp, *material, test::all_pair_sums());
    for (int k = 0; k < 5; ++k) test::step<2>(*solid, 1e-8);
    return solid->points().f;
  };
  const auto alone = run(false), together = run(true);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(alone[i], together[i]);
    EXPECT_GT(alone[i].norm(), 0);
  }
}

// Quick: a plane-strain strip drawn to 10 % with 1 % noise must neither clump nor tear: nearest
// neighbours stay between 0.6 and 1.6 of the mean spacing.
TEST(SphParticles, StripInTensionKeepsItsSpacing) {
  const auto material = elastic_material(1000, 1e7, 0.3);
  auto points = lattice<2>({30, 8}, kDp, 1000 * kDp * kDp, 0.01);
  const Real length = 30 * kDp, c = std::sqrt(material->modulus() / 1000), rate = 0.02 * c / length;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i][0] = rate * (points.x[i][0] - 0.5 * length);
  }
  auto solid = particles<2>(std::move(points), kDp, *material, test::all_pair_sums());
  const Real end = 0.1 / rate;
  Real t = 0;
  while (t < end) {
    const Real dt = 0.9 * solid->stable_step().step;
    t += dt;
    test::step<2>(*solid, dt, [&](Points<2>& p) {
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        const Real from_center = p.x_start[i][0] - 0.5 * length;
        if (std::fabs(from_center) < 0.5 * length - 2 * kDp) continue;
        p.v[i][0] = rate * from_center;
        p.x[i][0] = p.x_start[i][0] + rate * t * from_center;
      }
    });
  }
  const auto& x = solid->points().x;
  Real mean = 0, shortest = kInfinity, longest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    Real nearest = kInfinity;
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (j != i) nearest = std::min(nearest, (x[i] - x[j]).norm());
    }
    mean += nearest / static_cast<Real>(x.size());
    shortest = std::min(shortest, nearest), longest = std::max(longest, nearest);
  }
  EXPECT_GT(shortest, 0.6 * mean);
  EXPECT_LT(longest, 1.6 * kDp);
}

// One particle alone feels nothing; a pair at 1e-9 h has finite forces, opposite to the bit.
TEST(SphParticles, IsolatedParticleAndNearlyCoincidentPair) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  for (const auto kernel : {KernelKind::cubic, KernelKind::hyperbolic, KernelKind::quadratic}) {
    SphOptions options = test::all_pair_sums();
    options.kernel = kernel;
    auto one = lattice<3>({1, 1, 1}, kDp, kDensity * 1e-9);
    one.v[0] = Vec3(1, 2, 3);
    auto alone = particles<3>(std::move(one), kDp, *material, options);
    test::step<3>(*alone, 1e-8);
    EXPECT_EQ(alone->points().f[0], Vec3(0, 0, 0));
    EXPECT_TRUE(std::isfinite(alone->stable_step().step));

    auto two = lattice<3>({2, 1, 1}, kDp, kDensity * 1e-9);
    two.x[1] = two.x[0] + Vec3(1.2e-9 * kDp, 0, 0);
    two.v[0] = Vec3(1, 0, 0);
    auto pair = particles<3>(std::move(two), kDp, *material, options);
    pair->blocks()[0].state.deviator[xx] = std::vector<Real>(kTile, 1e6);
    pair->points().v[0].setZero();
    pair->points().v[1] = Vec3(-1e-9, 0, 0);
    pair->renew_lists();
    pair->update_state(1e-12);
    pair->add_internal_forces(1e-12);
    const auto& f = pair->points().f;
    EXPECT_TRUE(std::isfinite(f[0].norm()));
    EXPECT_GT(f[0].norm(), 0);
    EXPECT_EQ(f[0], -f[1]);
  }
}

/// Accelerations that a small displacement of a lattice of n^3 at rest causes, per displacement.
std::vector<Vec3> stiffness_times(const std::vector<Vec3>& displacement, int n,
                                  const Material& material, const SphOptions& options) {
  constexpr Real dt = 1e-12, mass = kDensity * kDp * kDp * kDp, amplitude = 1e-9 * kDp;
  auto points = lattice<3>({n, n, n}, kDp, mass);
  for (std::size_t i = 0; i < points.x.size(); ++i) points.v[i] = amplitude / dt * displacement[i];
  auto solid = particles<3>(std::move(points), kDp, material, options);
  solid->renew_lists();
  solid->update_state(dt);
  solid->add_internal_forces(dt);
  std::vector<Vec3> result;
  for (const auto& f : solid->points().f) result.push_back(-f / (mass * amplitude));
  return result;
}

// Undamped limit 2/omega_max, in h/c. Endless lattice: at the middle of 11^3, five layers from the
// faces, which is beyond twice the support, a plane wave cos(k.x) is answered by omega^2(k) itself;
// the largest of three directions is the a of A5: 5 %. Free faces and corners are stiffer, their
// gradients being one-sided: omega_max of a free block by power iteration, and the step limit, half
// of a, must stay below its limit.
TEST(SphParticles, UndampedStepLimitOfALattice) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  const Real h_over_c = 1.2 * kDp / std::sqrt(material->modulus() / kDensity);
  for (const auto& [kernel, factor] :
       {std::pair{KernelKind::cubic, 1.81}, std::pair{KernelKind::wendland_c2, 1.73}}) {
    SphOptions options = elastic_options();
    options.kernel = kernel;
    const auto x = lattice<3>({11, 11, 11}, kDp, 1).x;
    const std::size_t middle = x.size() / 2;
    Real largest = 0;
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(1, 1, 1)}) {
      for (Real phase = 0.9; phase < 2.4; phase += 0.1) {
        std::vector<Vec3> wave;
        for (const auto& place : x) {
          wave.push_back(std::cos(phase / kDp * way.dot(place - x[middle])) * way.normalized());
        }
        const auto answer = stiffness_times(wave, 11, *material, options);
        largest = std::max(largest, answer[middle].dot(way.normalized()));
      }
    }
    EXPECT_NEAR(2 / std::sqrt(largest) / h_over_c, factor, 0.05 * factor);

    auto field = lattice<3>({6, 6, 6}, 1, 1, 1.0).x;
    Real omega2 = 0;
    for (int k = 0; k < 60; ++k) {
      field = stiffness_times(field, 6, *material, options);
      Real growth = 0;
      for (const auto& u : field) growth += u.squaredNorm();
      omega2 = std::sqrt(growth);
      for (auto& u : field) u /= omega2;
    }
    const auto rest =
        particles<3>(lattice<3>({6, 6, 6}, kDp, kDensity * 1e-9), kDp, *material, options);
    const Real step_limit = rest->stable_step().step;
    EXPECT_NEAR(step_limit, 0.5 * factor * h_over_c, 1e-12 * h_over_c);
    EXPECT_LT(step_limit, 2 / std::sqrt(omega2));
  }
}

}  // namespace
}  // namespace brunt
