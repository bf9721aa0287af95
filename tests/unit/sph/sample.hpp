#pragma once
/// Small scenes of particles for the tests: lattices, materials, and the loop of the scheme.
#include <omp.h>

#include <functional>
#include <memory>
#include <random>

#include "core/materials/catalog.hpp"
#include "sph/particles.hpp"

namespace brunt::test {

inline constexpr Real kDp = 1e-3;         // [m]
inline constexpr Real kDensity = 7850.0;  // [kg/m^3]

inline std::unique_ptr<Material> elastic_material(Real density, Real E, Real nu) {
  auto material = std::make_unique<Material>();
  material->name = "elastic";
  material->density = density;
  material->bulk = E / (3 * (1 - 2 * nu));
  material->shear = E / (2 * (1 + nu));
  material->strength = make_strength(NoStrength{}, {material->shear, 0, 0});
  material->eos = make_eos(LinearEos{}, {density, material->bulk});
  return material;
}

/// Cubic kernel over 1.2 spacings with artificial stress: all sums of a pair are there.
inline SphOptions all_pair_sums() {
  SphOptions options;
  options.smoothing = 1.2;
  options.artificial_stress = 0.3;
  return options;
}

/// Nothing but elasticity: no viscosity, no artificial stress.
inline SphOptions elastic_options() {
  SphOptions options;
  options.smoothing = 1.2;
  options.artificial_stress = 0;
  options.viscosity = {0, 0};
  return options;
}

/// OFHC copper of Johnson & Cook 1983, adiabatic.
inline std::unique_ptr<Material> copper() {
  auto material = elastic_material(8960, 124e9, 0.34);
  material->name = "copper";
  material->thermal = true;
  material->specific_heat = SpecificHeat(383);
  JohnsonCook law;
  law.A = 90e6, law.B = 292e6, law.n = 0.31, law.C = 0.025, law.m = 1.09, law.T_melt = 1356;
  material->strength = make_strength(law, {material->shear, material->density * 383, 0.9});
  return material;
}

/// n particles along each axis from 0.5 dp on, displaced by up to `noise` dp along each axis.
template <int Dim>
Points<Dim> lattice(std::array<int, Dim> n, Real dp, Real mass, Real noise = 0, unsigned seed = 1) {
  Points<Dim> points;
  LocalIndex count = 1;
  for (const int k : n) count *= k;
  points.resize(count);
  std::mt19937_64 random(seed);
  const auto deviate = [&] { return 2 * (static_cast<Real>(random() >> 11) * 0x1p-53) - 1; };
  for (LocalIndex i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    LocalIndex rest = i;
    for (int d = 0; d < Dim; ++d) {
      const int cells = n[static_cast<std::size_t>(d)];
      points.x[k][d] = dp * (rest % cells + 0.5 + noise * deviate());
      rest /= cells;
    }
    points.x_start[k] = points.x[k];
    points.id[k] = static_cast<GlobalId>(i);
    points.mass[k] = mass;
  }
  return points;
}

template <int Dim>
std::unique_ptr<SphParticles<Dim>> particles(Points<Dim> points, Real dp, const Material& material,
                                             const SphOptions& options, Real depth = 1) {
  ParticleSet set;
  set.material = &material, set.options = options;
  set.temperature = 298, set.adiabatic = material.thermal;
  for (LocalIndex i = 0; i < points.size(); ++i) set.particle.push_back(i);
  const std::vector<Real> spacing(points.x.size(), dp);
  std::vector<ParticleSet> sets;
  sets.push_back(std::move(set));
  return std::make_unique<SphParticles<Dim>>(std::move(points), spacing, std::move(sets), depth);
}

/// One step of velocity Verlet; `impose` sets positions and velocities between predict and forces.
template <int Dim>
void step(SphParticles<Dim>& solid, Real dt,
          const std::function<void(Points<Dim>&)>& impose = nullptr) {
  auto& points = solid.points();
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i] += 0.5 * dt * points.a[i];
    points.x[i] += dt * points.v[i];
    points.f[i].setZero();
  }
  if (impose) impose(points);
  solid.renew_lists();
  solid.update_state(dt);
  solid.add_internal_forces(dt);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.a[i] = points.f[i] / points.mass[i];
    points.v[i] += 0.5 * dt * points.a[i];
  }
}

template <int Dim>
Totals<Dim> totals(const SphParticles<Dim>& solid) {
  Totals<Dim> totals;
  totals.bodies.resize(1);
  solid.add_totals(totals);
  return totals;
}

/// The gradient of v = A x on displaced particles, `origin` [m] off: the largest error of a
/// component over |A|.
template <int Dim>
Real linear_field_error(const SphOptions& options, Real origin = 0) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  std::array<int, Dim> n;
  n.fill(Dim == 2 ? 12 : 8);
  auto points = lattice<Dim>(n, kDp, kDensity * std::pow(kDp, Dim), 0.2);
  Eigen::Matrix<Real, Dim, Dim> A;
  for (int i = 0; i < Dim; ++i) {
    for (int j = 0; j < Dim; ++j) A(i, j) = 1.0 + 2.5 * i - 1.75 * j + 0.3 * i * j;
  }
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i] = A * points.x[i];
    points.x[i][0] += origin;
  }
  auto solid = particles<Dim>(std::move(points), kDp, *material, options);
  solid->renew_lists();
  solid->update_state(1e-12);
  Real worst = 0;
  for (const auto& state : solid->states()) {
    for (int k = 0; k < Dim * Dim; ++k) {
      worst = std::max(worst, std::fabs(state.velocity_gradient[k] - A(k / Dim, k % Dim)));
    }
  }
  return worst / A.norm();
}

/// The state of a block of copper whose halves strike each other, after 40 steps.
/// skin  [smoothing lengths] of the lists, made anew at every step if `always`
inline std::uint64_t impact_hash(const SphOptions& options, Real skin, bool always, int threads,
                                 SearchMode mode = SearchMode::grid) {
  omp_set_num_threads(threads);
  const auto material = copper();
  auto points = lattice<3>({9, 9, 9}, kDp, 8960 * kDp * kDp * kDp, 0.05);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i] = Vec3(0, 0, points.x[i][2] < 4 * kDp ? 150.0 : -150.0);
    points.v[i][0] = 4e4 * (points.x[i][0] - 4.5e-3);
  }
  auto solid = particles<3>(std::move(points), kDp, *material, options);
  solid->set_search(mode);
  solid->set_skin(skin);
  for (int k = 0; k < 40; ++k) {
    if (always) solid->rearrange();
    step<3>(*solid, 0.9 * solid->stable_step().step);
  }
  omp_set_num_threads(1);
  return totals(*solid).state_hash;
}

}  // namespace brunt::test
