// Saved, loaded into a fresh group and carried on, particles keep every bit of the run that was
// never stopped, with every option that carries something of its own.
#include <gtest/gtest.h>

#include "tests/unit/sph/sample.hpp"

namespace brunt {
namespace {

template <int Dim>
std::unique_ptr<SphParticles<Dim>> thrown(const Material& material, const SphOptions& options) {
  std::array<int, Dim> n;
  n.fill(Dim == 3 ? 6 : 12);
  const Real dp = 1e-3;
  auto points = test::lattice<Dim>(n, dp, material.density * std::pow(dp, Dim), 0.1);
  for (std::size_t i = 0; i < points.x.size(); ++i) {
    for (int c = 0; c < Dim; ++c) points.v[i][c] = (c == 1 ? 4e4 : -6e4) * points.x[i][c];
  }
  return test::particles<Dim>(std::move(points), dp, material, options);
}

using test::totals;

template <int Dim>
void expect_the_same_after_a_split(const SphOptions& options) {
  const auto material = test::copper();
  const auto advance = [](SphParticles<Dim>& solid, int steps) {
    for (int n = 0; n < steps; ++n) test::step(solid, 0.5 * solid.stable_step().step);
  };
  const auto whole = thrown<Dim>(*material, options);
  advance(*whole, 15);
  std::vector<StateTable> tables;
  whole->save_state(tables);
  const auto again = thrown<Dim>(*material, options);
  again->load_state(StateTables(std::move(tables)));
  again->rearrange();
  EXPECT_EQ(again->stable_step().step, whole->stable_step().step);
  EXPECT_EQ(totals(*again).state_hash, totals(*whole).state_hash);
  advance(*whole, 15);
  advance(*again, 15);
  EXPECT_EQ(again->points().x, whole->points().x);
  EXPECT_EQ(again->points().v, whole->points().v);
  EXPECT_EQ(again->stable_step().step, whole->stable_step().step);
  const auto a = totals(*again), b = totals(*whole);
  EXPECT_EQ(a.state_hash, b.state_hash);
  for (int c = 0; c < kColumns; ++c) {
    EXPECT_EQ(a.value(static_cast<Column>(c)), b.value(static_cast<Column>(c)));
  }
  EXPECT_GT(b.value(Column::plastic_heat), 0);
}

TEST(SphParticlesState, TheSameBitsAfterASplit) {
  const SphOptions plain = test::all_pair_sums();
  expect_the_same_after_a_split<2>(plain);
  expect_the_same_after_a_split<3>(plain);
  SphOptions all;
  all.adaptive_h = true, all.xsph = 0.3, all.artificial_stress = 0.2;
  expect_the_same_after_a_split<2>(all);
  expect_the_same_after_a_split<3>(all);
}

TEST(SphParticlesState, AParticleWithoutARowIsRefused) {
  const auto material = test::copper();
  const auto solid = thrown<2>(*material, {});
  std::vector<StateTable> tables;
  solid->save_state(tables);
  for (auto& table : tables) {
    if (table.name == "particles.state") table.id.front() = 4711;
  }
  EXPECT_THROW(solid->load_state(StateTables(std::move(tables))), StateError);
}

}  // namespace
}  // namespace brunt
