// Sums over pairs in single precision against those in double.
#include "sph/pair_precision.hpp"

#include <gtest/gtest.h>

#include "core/errors.hpp"
#include "sample.hpp"

namespace brunt {
namespace {

using test::elastic_material;
using test::kDensity;
using test::kDp;
using test::lattice;
using test::particles;

SphOptions single(SphOptions options) {
  options.pair_precision = PairPrecision::single_precision;
  return options;
}

// A step is 2^-22 of the unit, a power of two at most a spacing: differences are exact to half a
// step on either side, 1e-3 m or 1e9 m from the origin, and across the wrap at 2^32 steps.
TEST(PairPrecision, PositionsInStepsHaveExactDifferences) {
  const SingleUnit unit(1.5e-3);
  EXPECT_EQ(unit.length, 0x1p-10);
  const Real step = unit.length / SinglePairs::kSteps;
  for (const Real origin : {0.0, 1e-3, -512 * unit.length, 511.999 * unit.length, 1e5}) {
    for (const Real arm : {1.7e-3, -1.1e-4, 3e-3}) {
      const auto a = static_cast<std::uint32_t>(unit.steps(origin));
      const auto b = static_cast<std::uint32_t>(unit.steps(origin + arm));
      EXPECT_NEAR(static_cast<std::int32_t>(b - a) * step, arm, step + 1e-15 * std::fabs(origin));
    }
  }
}

// v = A x gives L = A: 60 terms that are each rounded at 2^-24 = 6e-8, over a moment matrix of a
// condition below 10: below 1e-5 of |A|, and far from the origin as near.
TEST(PairPrecision, GradientOfALinearField) {
  const SphOptions options = single(test::elastic_options());
  EXPECT_LT(test::linear_field_error<2>(options), 1e-5);
  EXPECT_LT(test::linear_field_error<3>(options), 1e-5);
  EXPECT_LT(test::linear_field_error<3>(options, 100), 1e-5);
}

/// Forces after some steps of a block that strikes itself and is pressed as a whole.
template <int Dim>
std::vector<Vec<Dim>> forces(const SphOptions& options, Real squeeze, Real* magnitude = nullptr) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  std::array<int, Dim> n;
  n.fill(Dim == 2 ? 14 : 8);
  auto points = lattice<Dim>(n, kDp, kDensity * std::pow(kDp, Dim), 0.05);
  const Real end = n[0] * kDp;
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    points.v[i] = -squeeze * points.x[i];
    points.v[i][0] += 20 * std::sin(3 * points.x[i][0] / end);
  }
  auto solid = particles<Dim>(std::move(points), kDp, *material, options);
  const Real dt = 2e-8;
  for (int k = 0; k < 5; ++k) test::step<Dim>(*solid, dt);
  if (magnitude != nullptr) {
    // of a pair: the pressure over a face of a particle
    const auto totals = test::totals(*solid);
    const Real volume = std::pow(end, Dim);
    const Real density = totals.value(Column::internal) / volume;  // [J/m^3] p^2/2K
    *magnitude = std::sqrt(2 * material->bulk * density) * std::pow(kDp, Dim - 1);
  }
  return solid->points().f;
}

// Of the force that a face of a particle carries, sums in single precision are wrong by a few
// times 2^-24 times the root of the terms, 1e-6; in a large pressure that is nearly the same
// everywhere the forces cancel, and the error is of the pressure all the same.
template <int Dim>
void expect_near_double(const SphOptions& options, Real squeeze) {
  Real magnitude = 0;
  const auto exact = forces<Dim>(options, squeeze, &magnitude);
  const auto sums = forces<Dim>(single(options), squeeze);
  ASSERT_GT(magnitude, 0);
  Real worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    worst = std::max(worst, (sums[i] - exact[i]).norm());
  }
  EXPECT_LT(worst, 1e-5 * magnitude);
  EXPECT_GT(worst, 0);  // it is another sum
}
TEST(PairPrecision, ForcesAreThoseOfDoubleToAMillionth) {
  for (const Real squeeze : {1e3, 1e5}) {
    expect_near_double<2>(test::all_pair_sums(), squeeze);
    expect_near_double<3>(test::all_pair_sums(), squeeze);
    expect_near_double<3>({}, squeeze);
  }
}

// The unit of length follows the spacing: particles of a nanometre, whose h^-5 no float holds.
TEST(PairPrecision, LengthsNeedNotBeNearAMetre) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  for (const Real dp : {1e-9, 1e3}) {
    auto points = lattice<3>({6, 6, 6}, dp, kDensity * dp * dp * dp, 0.1);
    for (std::size_t i = 0; i < points.x.size(); ++i) points.v[i] = Vec3(points.x[i][1], 0, 0) / dp;
    auto solid = particles<3>(std::move(points), dp, *material, single({}));
    solid->renew_lists();
    solid->update_state(1e-12);
    for (const auto& state : solid->states()) {
      EXPECT_NEAR(dp * state.velocity_gradient[1], 1, 1e-5);
    }
  }
}

// Bits: skin, rebuild at every step and threads change none.
TEST(PairPrecision, SkinCadenceAndThreadsChangeNoBit) {
  const SphOptions options = single(test::all_pair_sums());
  const auto reference = test::impact_hash(options, 0.2, false, 1);
  EXPECT_EQ(test::impact_hash(options, 0.0, false, 1), reference);
  EXPECT_EQ(test::impact_hash(options, 0.5, false, 2), reference);
  EXPECT_EQ(test::impact_hash(options, 0.2, true, 2), reference);
}

// Positions are told apart modulo 512 units: what has grown beyond is told, not summed wrongly.
TEST(PairPrecision, SmoothingLengthsBeyondItsReachAreTold) {
  const auto material = elastic_material(kDensity, 200e9, 0.3);
  auto solid =
      particles<2>(lattice<2>({4, 4}, kDp, kDensity * kDp * kDp), kDp, *material, single({}));
  solid->check(0, {"a"});
  SphOptions wide = single({});
  wide.smoothing = 200;  // of units of a spacing at most
  solid = particles<2>(lattice<2>({4, 4}, kDp, kDensity * kDp * kDp), kDp, *material, wide);
  EXPECT_THROW(solid->check(0, {"a"}), PhysicsError);
}

}  // namespace
}  // namespace brunt
