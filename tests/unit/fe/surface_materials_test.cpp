// What friction asks of the elements behind the facets: means over their material points, of the
// law at each point's state. Linear hardening: flow stress Y + H eps_p.
#include <gtest/gtest.h>

#include "tests/unit/fe/fe_scene.hpp"

namespace brunt::testing {
namespace {

constexpr Real kYield = 1e6, kModulus = 1e7;

template <int Dim>
void expect_materials(const Variant& variant) {
  Material material = elastic(1e9, 0.3, 1000);
  J2 law;
  law.yield = kYield;
  law.hardening.emplace().constant = kModulus;
  material.strength = make_strength(law, {material.shear, 0, 0});
  std::array<int, Dim> cells;
  cells.fill(2);
  auto mesh = box_mesh<Dim>(cells, Vec<Dim>::Constant(1), Vec<Dim>::Constant(1));
  mesh.set.material = &material;
  mesh.set.options.integration = variant.integration;
  mesh.set.temperature = 350;
  FiniteElements<Dim> solid(mesh.points, {mesh.set}, variant.geometry, 1);
  auto& block = solid.blocks().front();
  for (LocalIndex e = 0; e < block.n; ++e) {
    for (int g = 0; g < block.gauss; ++g) {
      block.state.eps_p[block.point(e, g)] = 0.1 * (e + 1) + 0.01 * (g - 0.5 * (block.gauss - 1));
    }
  }
  auto& surface = solid.surface();
  solid.update_state(1);
  EXPECT_TRUE(surface.facet_material.empty());
  surface.needs_material = true;
  solid.update_state(1);
  ASSERT_EQ(surface.facet_material.size(), surface.facets.size());
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto at =
        std::find(block.id.begin(), block.id.begin() + block.n, surface.facets[f].id >> 3);
    const auto e = static_cast<Real>(at - block.id.begin());
    EXPECT_EQ(surface.facet_material[f].temperature, 350);
    EXPECT_NEAR(surface.facet_material[f].flow_stress, kYield + kModulus * 0.1 * (e + 1),
                1e-12 * kModulus);
    EXPECT_EQ(surface.facets[f].temperature, 350);
  }
}

TEST(SurfaceMaterials, AreMeansOverTheElementBehind) {
  for (const auto& variant : variants_of(3)) expect_materials<3>(variant);
  for (const auto& variant : variants_of(2)) expect_materials<2>(variant);
}

TEST(SurfaceMaterials, WhatNeverYieldsHasNoFlowStress) {
  const Material material = elastic(1e9, 0.3, 1000);
  auto mesh = box_mesh<3>({1, 1, 1}, Vec3::Zero(), Vec3::Ones());
  mesh.set.material = &material;
  FiniteElements<3> solid(mesh.points, {mesh.set}, Geometry::three_d, 1);
  solid.surface().needs_material = true;
  solid.update_state(1);
  for (const auto& shown : solid.surface().facet_material) {
    EXPECT_EQ(shown.flow_stress, kInfinity);
  }
}

}  // namespace
}  // namespace brunt::testing
