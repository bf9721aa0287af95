// Saved, loaded into a fresh body and carried on, finite elements keep every bit of the run that
// was never stopped, whatever the formulation.
#include <gtest/gtest.h>

#include "tests/unit/fe/fe_scene.hpp"

namespace brunt {
namespace {

using namespace testing;

template <int Dim>
std::unique_ptr<FiniteElements<Dim>> thrown_body(const Material& material, const Variant& variant) {
  std::array<int, Dim> cells;
  cells.fill(3);
  Vec<Dim> corner = Vec<Dim>::Zero();
  corner[0] = 1e-3;
  auto mesh = box_mesh<Dim>(cells, corner, Vec<Dim>::Constant(3e-3), 0.1);
  mesh.set.adiabatic = true;
  auto body = make_body<Dim>(std::move(mesh), material, variant);
  auto& p = body->points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    for (int c = 0; c < Dim; ++c) p.v[k][c] = -2e5 * (p.x[k][c] - 1e-3);
  }
  return body;
}

template <int Dim>
void expect_the_same_after_a_split(const Variant& variant) {
  const Material material = copper();
  const auto whole = thrown_body<Dim>(material, variant);
  const auto advance = [](FiniteElements<Dim>& body, int steps) {
    for (int n = 0; n < steps; ++n) step_free(body, 0.5 * body.stable_step().step);
  };
  advance(*whole, 20);
  std::vector<StateTable> tables;
  whole->save_state(tables);
  const auto again = thrown_body<Dim>(material, variant);
  again->load_state(StateTables(std::move(tables)));
  EXPECT_EQ(again->stable_step().step, whole->stable_step().step);
  EXPECT_EQ(totals_of(*again).state_hash, totals_of(*whole).state_hash);
  advance(*whole, 20);
  advance(*again, 20);
  EXPECT_EQ(again->points().x, whole->points().x);
  EXPECT_EQ(again->points().v, whole->points().v);
  EXPECT_EQ(again->stable_step().step, whole->stable_step().step);
  const auto a = totals_of(*again), b = totals_of(*whole);
  EXPECT_EQ(a.state_hash, b.state_hash);
  for (int c = 0; c < kColumns; ++c) {
    EXPECT_EQ(a.value(static_cast<Column>(c)), b.value(static_cast<Column>(c)));
  }
  EXPECT_GT(b.value(Column::plastic_heat), 0);
}

TEST(FiniteElementsState, TheSameBitsAfterASplit) {
  for (const auto& variant : variants_of(3)) {
    SCOPED_TRACE(name_of(variant));
    expect_the_same_after_a_split<3>(variant);
  }
  for (const auto& variant : variants_of(2)) {
    SCOPED_TRACE(name_of(variant));
    expect_the_same_after_a_split<2>(variant);
  }
}

TEST(FiniteElementsState, AnElementWithoutARowIsRefused) {
  const Material material = copper();
  const auto body = thrown_body<3>(material, {});
  std::vector<StateTable> tables;
  body->save_state(tables);
  for (auto& table : tables) {
    if (table.name == "points") continue;
    table.id.back() = 4711;
  }
  EXPECT_THROW(body->load_state(StateTables(std::move(tables))), StateError);
}

}  // namespace
}  // namespace brunt
