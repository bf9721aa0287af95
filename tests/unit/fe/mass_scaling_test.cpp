// Mass scaling: the step of an element goes with the root of its mass, so that one of step s gets
// (T/s)^2 of its mass for a step of T, exactly; heat is stored in the material alone.
#include "fe/mass_scaling.hpp"

#include <gtest/gtest.h>

#include "tests/unit/fe/fe_scene.hpp"

namespace brunt {
namespace {

using namespace testing;

template <int Dim>
std::unique_ptr<FiniteElements<Dim>> layers_of(const Variant& variant, Real least_step) {
  // Three layers of which the middle one is a tenth as thick.
  std::array<int, Dim> cells;
  cells.fill(2);
  cells[0] = 3;
  Vec<Dim> low = Vec<Dim>::Zero(), size = Vec<Dim>::Constant(2e-3);
  low[0] = 1e-3, size[0] = 3e-3;
  auto mesh = box_mesh<Dim>(cells, low, size);
  for (auto& x : mesh.points.x) {
    const Real at = (x[0] - 1e-3) / 1e-3;
    x[0] = 1e-3 + 1e-3 * (at < 1.5 ? at : at - 0.9);
  }
  mesh.set.conducts = true;
  ElementOptions options;
  options.least_step = least_step;
  return make_body<Dim>(mesh, copper(), variant, options);
}

template <int Dim>
void expect_the_step_and_no_more(const Variant& variant) {
  const auto plain = layers_of<Dim>(variant, 0);
  const Real shortest = plain->stable_step().step, wanted = 2 * shortest;
  const auto scaled = layers_of<Dim>(variant, wanted);
  EXPECT_NEAR(scaled->stable_step().step, wanted, 1e-12 * wanted);
  Real added = 0, mass = 0;
  std::size_t n_scaled = 0;
  for (std::size_t b = 0; b < plain->blocks().size(); ++b) {
    const auto &before = plain->blocks()[b], &after = scaled->blocks()[b];
    for (std::size_t e = 0; e < static_cast<std::size_t>(before.n); ++e) {
      const Real ratio = std::max(1.0, wanted / before.stable_step[e]);
      EXPECT_NEAR(after.mass[e], before.mass[e] * ratio * ratio, 1e-12 * after.mass[e]);
      EXPECT_NEAR(after.material_mass(e), before.mass[e], 1e-15 * after.mass[e]);
      added += after.mass[e] - before.mass[e], mass += before.mass[e];
      n_scaled += ratio > 1 ? 1 : 0;
    }
  }
  const AddedMass sums = scaled->added_mass(0);
  EXPECT_NEAR(sums.added, added, 1e-12 * mass);
  EXPECT_NEAR(sums.material, mass, 1e-12 * mass);
  EXPECT_EQ(sums.n_scaled, n_scaled);
  EXPECT_EQ(n_scaled, std::size_t{Dim == 3 ? 4 : 2});
  // Points carry it all, and no more heat.
  Real of_points = 0;
  for (const Real m : scaled->points().mass) of_points += m;
  EXPECT_NEAR(of_points, mass + added, 1e-12 * mass);
  for (LocalIndex i = 0; i < plain->points().size(); ++i) {
    EXPECT_NEAR(scaled->points().capacity[i], plain->points().capacity[i],
                1e-14 * plain->points().capacity[i]);
  }
}

TEST(MassScaling, GivesTheWantedStepAndNothingElse) {
  for (const auto& variant : variants_of(3)) {
    SCOPED_TRACE(name_of(variant));
    expect_the_step_and_no_more<3>(variant);
  }
  for (const auto& variant : variants_of(2)) {
    SCOPED_TRACE(name_of(variant));
    expect_the_step_and_no_more<2>(variant);
  }
}

TEST(MassScaling, OfEnoughStepAddsNothing) {
  const auto plain = layers_of<3>({}, 0);
  const auto same = layers_of<3>({}, 0.99 * plain->stable_step().step);
  EXPECT_EQ(same->points().mass, plain->points().mass);
  EXPECT_EQ(same->added_mass(0).added, 0);
}

}  // namespace
}  // namespace brunt
