/// Particles that lie still are left out of a step, which must be nobody's to see
/// (sph/still_zones.hpp).
/// A bar that is struck at one end is stepped beside itself with lists built anew at every step,
/// after which all particles are computed: places, velocities, forces and states agree in every
/// bit, while particles ahead of the wave are left out. A step carries strain over one support of
/// 2 h and forces over another; a zone is 4 h wide, and those that touch a stirred one are
/// computed: after n steps no particle beyond 4 h n + 8 h from the end may have been computed.
#include <gtest/gtest.h>

#include <bit>

#include "sample.hpp"
#include "sph/particle_values.hpp"

namespace brunt {
namespace {

template <int Dim>
std::vector<std::uint64_t> bits_of(SphParticles<Dim>& solid) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](Real value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); };
  const auto add_state = [&](const auto& value, FieldUse) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Real>) {
      add(value);
    } else {
      for (int d = 0; d < Dim; ++d) add(value[d]);
    }
  };
  for (std::size_t i = 0; i < solid.states().size(); ++i) {
    visit_particle(solid.states()[i], test::kDp, solid.artificial_of(i), add_state);
  }
  for (const auto& block : solid.blocks()) {
    for (std::size_t slot = 0; slot < block.set.particle.size(); ++slot) {
      visit_slot(block, slot, add_state);
    }
  }
  for (std::size_t i = 0; i < solid.points().x.size(); ++i) {
    for (int d = 0; d < Dim; ++d) {
      add(solid.points().x[i][d]), add(solid.points().v[i][d]), add(solid.points().f[i][d]);
    }
  }
  return bits;
}

/// A bar along x of some lattice, its first three layers at 100 m/s.
template <int Dim>
std::unique_ptr<SphParticles<Dim>> struck_bar(const Material& material, const SphOptions& options,
                                              std::array<int, Dim> n, Real noise) {
  auto points =
      test::lattice<Dim>(n, test::kDp, material.density * std::pow(test::kDp, Dim), noise);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    if (points.x[i][0] < 3 * test::kDp) points.v[i][0] = 100;
  }
  return test::particles<Dim>(std::move(points), test::kDp, material, options);
}

template <int Dim>
void expect_same_as_all_computed(const SphOptions& options, std::array<int, Dim> n,
                                 Real noise = 0.1) {
  const auto material = test::copper();
  const auto bar = struck_bar<Dim>(*material, options, n, noise);
  const auto all = struck_bar<Dim>(*material, options, n, noise);
  const Real h = options.smoothing * test::kDp;
  const std::size_t layer = bar->points().x.size() / slot_of(n[0]);
  for (int k = 1; k <= 12; ++k) {
    const Real dt = 0.5 * bar->stable_step().step;
    EXPECT_EQ(all->stable_step().step, bar->stable_step().step);
    all->rearrange();
    test::step(*bar, dt), test::step(*all, dt);
    EXPECT_EQ(all->n_left_out(), 0u);
    ASSERT_EQ(bits_of(*bar), bits_of(*all)) << "step " << k;
    if (k == 1) continue;  // computes all
    const Real reached = 3.5 * test::kDp + 4 * h * k + 8 * h;
    const auto beyond = std::max(0.0, n[0] - reached / test::kDp);
    EXPECT_GE(bar->n_left_out(), static_cast<std::size_t>(beyond) * layer) << "step " << k;
    EXPECT_LT(bar->n_left_out(), (slot_of(n[0]) - 3) * layer);
  }
}

TEST(StillZones, ABarIsComputedFromItsStruckEndOn) {
  const SphOptions plain = test::all_pair_sums();
  expect_same_as_all_computed<3>(plain, {80, 4, 4});
  expect_same_as_all_computed<2>(plain, {90, 5});
  SphOptions other;
  other.adaptive_h = true, other.artificial_stress = 0.2, other.correction = false;
  expect_same_as_all_computed<3>(other, {80, 4, 4});
  expect_same_as_all_computed<2>(other, {90, 5});
}

// One and two layers, whose neighbourhoods are thin and have axes of their own; XSPH.
TEST(StillZones, ThinBodiesToo) {
  expect_same_as_all_computed<3>({}, {70, 4, 1});
  expect_same_as_all_computed<3>({}, {70, 2, 2});
  expect_same_as_all_computed<2>({}, {90, 1});
  SphOptions moved;
  moved.xsph = 0.5;
  expect_same_as_all_computed<3>(moved, {70, 4, 4});
}

TEST(StillZones, InSinglePrecisionToo) {
  SphOptions single = test::all_pair_sums();
  single.pair_precision = PairPrecision::single_precision;
  expect_same_as_all_computed<3>(single, {80, 4, 4});
}

// On a lattice with 2 h = 3 dp many pairs stand on the rim of the support, where single precision
// and double choose otherwise: XSPH, which sums in double, must leave the rows as they are.
TEST(StillZones, OnTheRimOfSupportsInSinglePrecision) {
  SphOptions single;
  single.pair_precision = PairPrecision::single_precision;
  single.xsph = 0.5, single.smoothing = 1.5;
  expect_same_as_all_computed<3>(single, {80, 4, 4}, 0);
  expect_same_as_all_computed<2>(single, {90, 5}, 0);
}

// Nothing moves: after the step that computes all, none is computed, and all bits stay.
TEST(StillZones, ABodyAtRestStaysAsItIs) {
  const auto material = test::copper();
  auto points = test::lattice<3>({10, 10, 10}, test::kDp, 8960e-9, 0.1);
  const auto block = test::particles<3>(std::move(points), test::kDp, *material, {});
  test::step(*block, 1e-8);
  const auto before = bits_of(*block);
  for (int k = 0; k < 3; ++k) {
    test::step(*block, 2e-8);
    EXPECT_EQ(block->n_left_out(), 1000u);
    EXPECT_EQ(bits_of(*block), before);
  }
  block->points().v[0][1] = 1e-30;
  test::step(*block, 2e-8);
  EXPECT_LT(block->n_left_out(), 1000u);
}

}  // namespace
}  // namespace brunt
