// Elements that go: what is left has the surface of a mesh that never had them, no energy is lost
// or made beside the column `eroded`, and nodes about which nothing is left are particles, or
// nothing.
//   Of elements that average volumes about nodes: what goes does no work on what stays. Where no
// node moves, V/V0 and pressure of all that is left are to rounding what they were, and there is no
// rate for viscosity to work on; the volumes about nodes, of the elements that are left, are others
// by tens of percent.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "fe/erosion.hpp"
#include "tests/unit/fe/fe_scene.hpp"

namespace brunt {
namespace {

using namespace testing;

constexpr Real kErodingStep = 2e-8;  // [s]

template <int Dim>
Mesh<Dim> eroding_mesh() {
  std::array<int, Dim> cells;
  cells.fill(3);
  Vec<Dim> corner = Vec<Dim>::Zero();
  corner[0] = 1e-3;
  auto mesh = box_mesh<Dim>(cells, corner, Vec<Dim>::Constant(3e-3), 0.1);
  mesh.set.adiabatic = true;
  return mesh;
}

template <int Dim>
std::unique_ptr<FiniteElements<Dim>> eroding_body(const Material& material, const Variant& variant,
                                                  const Erosion& erosion) {
  ElementOptions options;
  options.erosion = erosion;
  auto body = make_body<Dim>(eroding_mesh<Dim>(), material, variant, options);
  auto& p = body->points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    for (int c = 0; c < Dim; ++c) p.v[k][c] = -1e5 * (p.x[k][c] - 1e-3);
  }
  return body;
}

/// As step_free, with erosion where the time loop has it.
template <int Dim>
void step_eroding(FiniteElements<Dim>& body, Real dt) {
  Points<Dim>& p = body.points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    p.v[k] += 0.5 * dt * p.a[k];
    p.x[k] += dt * p.v[k];
    p.f[k].setZero();
  }
  body.erode(dt);
  body.update_state(dt);
  body.add_internal_forces(dt);
  for (LocalIndex k = 0; k < p.size(); ++k) {
    if (p.mass[k] == 0) continue;
    p.a[k] = p.f[k] / p.mass[k];
    p.v[k] += 0.5 * dt * p.a[k];
  }
}

/// Makes an element strained beyond all bounds.
template <int Dim>
void strain_element(FiniteElements<Dim>& body, GlobalId id) {
  for (auto& block : body.blocks()) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      for (int g = 0; block.id[e] == id && g < block.gauss; ++g) {
        block.state.eps_p[block.point(e, g)] = 100;
      }
    }
  }
}

template <int Dim>
Real energy_of(const FiniteElements<Dim>& body, Real dt) {
  const auto totals = totals_of(body);
  ExactSum sum;
  for (const auto& column : totals.columns) sum.add(column);
  sum.add(kinetic_energy(body.points(), dt));
  return sum.value();
}

template <int Dim>
void expect_the_ledger_closes(const Variant& variant, ErodeTo to) {
  const Material material = copper();
  Erosion erosion;
  erosion.when.strain = 50, erosion.to = to;
  const auto body = eroding_body<Dim>(material, variant, erosion);
  for (int n = 0; n < 10; ++n) step_eroding(*body, kErodingStep);
  const Real before = energy_of(*body, kErodingStep);
  const Real largest = totals_of(*body).value(Column::plastic_heat);
  EXPECT_GT(largest, 0);
  const auto n = static_cast<GlobalId>(body->n_elements());
  // The first, of which a corner is left alone, and one inside; then all.
  for (const std::vector<GlobalId>& going : {std::vector<GlobalId>{0, n / 2}, [n] {
                                               std::vector<GlobalId> all(n);
                                               std::iota(all.begin(), all.end(), GlobalId{0});
                                               return all;
                                             }()}) {
    for (const GlobalId id : going) strain_element(*body, id);
    for (int k = 0; k < 3; ++k) step_eroding(*body, kErodingStep);
    EXPECT_NEAR(energy_of(*body, kErodingStep), before, 1e-12 * (std::abs(before) + largest));
    EXPECT_EQ(body->n_elements(), n - going.size());
    EXPECT_EQ(totals_of(*body).bodies[0].eroded.value(), static_cast<Real>(going.size()));
  }
  EXPECT_TRUE(body->surface().facets.empty());
  const auto particles = static_cast<LocalIndex>(body->surface().particles.size());
  EXPECT_EQ(particles, to == ErodeTo::points ? body->points().size() : 0);
  for (const Real m : body->points().mass) EXPECT_EQ(m > 0, to == ErodeTo::points);
  EXPECT_GT(body->stable_step().step, 0);
  EXPECT_LT(body->stable_step().step, kInfinity);
}

TEST(Erosion, TheLedgerClosesWhateverGoes) {
  for (const ErodeTo to : {ErodeTo::points, ErodeTo::nothing}) {
    for (const auto& variant : variants_of(3)) {
      SCOPED_TRACE(name_of(variant));
      expect_the_ledger_closes<3>(variant, to);
    }
    for (const auto& variant : variants_of(2)) {
      SCOPED_TRACE(name_of(variant));
      expect_the_ledger_closes<2>(variant, to);
    }
  }
}

template <int Dim>
void expect_the_surface_of_what_is_left() {
  const Material material = copper();
  Erosion erosion;
  erosion.when.strain = 50;
  const auto body =
      eroding_body<Dim>(material, {Dim == 2 ? Geometry::plane_strain : Geometry::three_d}, erosion);
  const auto before = body->surface().facets;
  const std::vector<GlobalId> going = {0, 1, static_cast<GlobalId>(body->n_elements()) / 2};
  for (const GlobalId id : going) strain_element(*body, id);
  body->erode(kErodingStep);
  EXPECT_TRUE(body->surface().changed);

  auto mesh = eroding_mesh<Dim>();
  for (auto it = going.rbegin(); it != going.rend(); ++it) {
    const auto at = static_cast<long>(*it);
    mesh.set.corners.erase(mesh.set.corners.begin() + at);
    mesh.set.id.erase(mesh.set.id.begin() + at);
    mesh.set.body.pop_back(), mesh.set.piece.pop_back();
  }
  const auto never =
      make_body<Dim>(mesh, material, {Dim == 2 ? Geometry::plane_strain : Geometry::three_d});
  const auto &now = body->surface().facets, &as_new = never->surface().facets;
  ASSERT_EQ(now.size(), as_new.size());
  std::size_t born = 0;
  for (std::size_t f = 0; f < now.size(); ++f) {
    EXPECT_EQ(now[f].id, as_new[f].id);
    EXPECT_EQ(now[f].node, as_new[f].node);
    EXPECT_EQ(now[f].depth, as_new[f].depth);
    EXPECT_EQ(now[f].stiffness, as_new[f].stiffness);
    EXPECT_EQ(now[f].borders, as_new[f].borders);
    EXPECT_EQ(now[f].sharpness, as_new[f].sharpness);
    const bool known = std::any_of(before.begin(), before.end(),
                                   [&](const auto& one) { return one.id == now[f].id; });
    EXPECT_EQ(now[f].born, !known);
    born += known ? 0 : 1;
  }
  EXPECT_GT(born, 0U);
  EXPECT_EQ(body->surface().died.size(), before.size() + born - now.size());
  body->erode(kErodingStep);
  for (const auto& facet : body->surface().facets) EXPECT_FALSE(facet.born);
}

TEST(Erosion, WhatIsLeftHasTheSurfaceOfAMeshThatNeverHadMore) {
  expect_the_surface_of_what_is_left<2>();
  expect_the_surface_of_what_is_left<3>();
}

TEST(Erosion, AnElementThatIsTurnedInsideOutGoesBeforeItPushes) {
  const Material material = copper();
  for (const auto& variant : variants_of(3)) {
    Erosion erosion;
    erosion.when.inverted = true;
    ElementOptions options;
    options.erosion = erosion;
    const auto body = make_body<3>(box_mesh<3>({2, 1, 1}, Vec3::Zero(), Vec3(2, 1, 1)), material,
                                   variant, options);
    auto& p = body->points();
    for (LocalIndex k = 0; k < p.size(); ++k) {
      p.f[k].setZero();
      if (p.x[k][0] == 0) p.x[k][0] = 1.1, p.v[k][0] = 1.1e3;
    }
    body->erode(1e-3);
    EXPECT_EQ(body->n_elements(), 1U) << name_of(variant);
    body->add_internal_forces(1e-3);
    for (const auto& f : p.f) EXPECT_EQ(f.norm(), 0) << name_of(variant);
    EXPECT_EQ(body->surface().particles.size(), 4U);
  }
}

TEST(Erosion, AStateWithoutSomeElementsLoadsIntoAWholeGroupAndBack) {
  const Material material = copper();
  Erosion erosion;
  erosion.when.strain = 50, erosion.to = ErodeTo::nothing;
  const auto body = eroding_body<3>(material, {}, erosion);
  for (int n = 0; n < 5; ++n) step_eroding(*body, kErodingStep);
  std::vector<StateTable> whole, left;
  body->save_state(whole);
  for (const GlobalId id : {0, 5, 13}) strain_element(*body, static_cast<GlobalId>(id));
  for (int n = 0; n < 5; ++n) step_eroding(*body, kErodingStep);
  body->save_state(left);
  const auto again = eroding_body<3>(material, {}, erosion);
  const StateTables first(whole), second(left);
  again->load_state(second);
  EXPECT_EQ(again->n_elements(), body->n_elements());
  EXPECT_EQ(totals_of(*again).state_hash, totals_of(*body).state_hash);
  again->load_state(first);  // as where a later checkpoint did not fit
  EXPECT_EQ(again->n_elements(), 27U);
  again->load_state(second);
  for (int n = 0; n < 5; ++n) {
    step_eroding(*body, kErodingStep);
    step_eroding(*again, kErodingStep);
  }
  EXPECT_EQ(totals_of(*again).state_hash, totals_of(*body).state_hash);
  EXPECT_EQ(again->points().x, body->points().x);
}

/// Cut boxes, squeezed towards the middle of a side; elements go at a strain of 50.
std::unique_ptr<FiniteElements<3>> eroding_tets(const Material& material) {
  Boxes mesh = cut(eroding_mesh<3>());
  mesh.set.material = &material;
  mesh.set.adiabatic = true;
  mesh.set.options.erosion = Erosion{};
  mesh.set.options.erosion->when.strain = 50;
  auto body = std::make_unique<FiniteElements<3>>(
      std::move(mesh.points), std::vector<ElementSet<3>>{mesh.set}, Geometry::three_d, 1);
  auto& p = body->points();
  for (LocalIndex k = 0; k < p.size(); ++k) {
    for (int c = 0; c < 3; ++c) p.v[k][c] = (c == 1 ? 1e5 : -2e5) * (p.x[k][c] - 1e-3);
  }
  return body;
}

TEST(Erosion, WhatGoesDoesNoWorkOnWhatAveragesVolumesWithIt) {
  const Material material = copper();
  const auto body = eroding_tets(material);
  auto& p = body->points();
  std::vector<Vec3> x = p.x;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> uniform(-1e-4, 1e-4);  // of cells of 1e-3
  for (auto& place : x) place += Vec3(uniform(random), uniform(random), uniform(random));
  step_to(*body, x, kErodingStep);
  for (auto& v : p.v) v.setZero();
  step_to(*body, x, kErodingStep);
  const ElementBlock<3> before = body->blocks()[0];
  const Real most =
      *std::max_element(before.viscous_work.begin(), before.viscous_work.begin() + before.n);
  EXPECT_GT(most, 0);
  const auto n = static_cast<GlobalId>(body->n_elements());
  for (GlobalId id = 0; id < n; id += 3) strain_element(*body, id);
  body->erode(kErodingStep);
  step_to(*body, x, kErodingStep);
  const auto& after = body->blocks()[0];
  ASSERT_EQ(after.n, static_cast<LocalIndex>(n - (n + 2) / 3));
  for (LocalIndex e = 0; e < after.n; ++e) {
    const auto was = static_cast<std::size_t>(after.id[e]);
    ASSERT_EQ(before.id[was], after.id[e]);
    EXPECT_NEAR(after.volume_ratio[e], before.volume_ratio[was], 1e-14);
    EXPECT_NEAR(after.state.pressure[e], before.state.pressure[was], 1e-13 * material.bulk);
    EXPECT_NEAR(after.viscous_pressure[e], 0, 1e-13 * material.bulk);
    EXPECT_NEAR(after.viscous_work[e], before.viscous_work[was], 1e-13 * most);
  }
}

TEST(Erosion, VolumesAboutNodesAreStateAndTheLedgerClosesWithThem) {
  const Material material = copper();
  const auto body = eroding_tets(material), again = eroding_tets(material);
  const auto advance = [](FiniteElements<3>& one, const std::vector<int>& going) {
    for (const int id : going) strain_element(one, static_cast<GlobalId>(id));
    for (int n = 0; n < 5; ++n) step_eroding(one, kErodingStep / 4);
  };
  advance(*body, {});
  const Real before = energy_of(*body, kErodingStep / 4);
  for (const auto& going : {std::vector<int>{}, {0, 5, 13, 80}, {81, 82, 100}}) {
    std::vector<StateTable> tables;
    body->save_state(tables);
    again->load_state(StateTables(std::move(tables)));
    advance(*body, going), advance(*again, going);
    EXPECT_EQ(totals_of(*again).state_hash, totals_of(*body).state_hash);
    EXPECT_EQ(again->points().x, body->points().x);
  }
  EXPECT_EQ(body->n_elements(), 155U);
  EXPECT_NEAR(energy_of(*body, kErodingStep / 4), before, 1e-12 * std::abs(before));
}

/// Four elements at a time have volume where each by itself has, as steps measure it, and where all
/// of its parts have: of 27 (9) elements that are pulled about more and more, until most have none.
template <int Dim>
void expect_same_volumes(const Variant& variant) {
  SCOPED_TRACE(name_of(variant));
  const Material material = elastic(200e9, 0.3, 7850);
  auto body = make_body<Dim>(eroding_mesh<Dim>(), material, variant);
  const Thickness thickness = thickness_of(variant.geometry, 0.7);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> uniform(-1, 1);
  int n_sound = 0, n_gone = 0;
  for (int trial = 0; trial < 40; ++trial) {
    Points<Dim> moved = body->points();
    for (auto& x : moved.x) {
      for (int i = 0; i < Dim; ++i) x[i] += 5e-5 * trial * uniform(random);
    }
    if (trial == 39) moved.x[0][0] = std::numeric_limits<Real>::quiet_NaN();
    for (const auto& block : body->blocks()) {
      for (LocalIndex e = 0; e < block.n; ++e) {
        const auto first = slot_of(e - e % kLanes);
        const unsigned bits = block.formulation->have_volume(block, first, moved, thickness);
        const auto x = corner_positions(block, e, moved);
        const auto parts = block.formulation->part_volumes(x, thickness);
        const bool sound = block.gauss == 1
                               ? block.formulation->step_volume(x, thickness) > 0
                               : std::all_of(parts.part.begin(), parts.part.begin() + parts.n,
                                             [](Real part) { return part > 0; });
        EXPECT_EQ((bits >> (e % kLanes) & 1U) != 0, sound) << trial << " " << e;
        ++(sound ? n_sound : n_gone);
      }
    }
  }
  EXPECT_GT(n_sound, 100);
  EXPECT_GT(n_gone, 20);
}
TEST(Erosion, FourElementsAtATimeHaveVolumeWhereEachHas) {
  for (const auto& variant : variants_of(2)) expect_same_volumes<2>(variant);
  for (const auto& variant : variants_of(3)) expect_same_volumes<3>(variant);
}

}  // namespace
}  // namespace brunt
