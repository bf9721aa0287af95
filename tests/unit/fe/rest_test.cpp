/// Tiles that lie still are left out of a step, which must be nobody's to see (fe/rest.hpp).
/// - A step of what lies still is the identity, bit by bit: volumes at time 0 are found by the
///   arithmetic of the kernels, so that their ratio is 1, and strain, rotation and rates are of
///   velocities of 0. Distorted cells, whose volumes are no round numbers, show a rounding of any.
/// - A column that is struck at one end is stepped beside itself with all tiles awake: places,
///   velocities and states agree in every bit, while the tiles ahead of the wave are left out. A
///   step carries forces over one layer of cells, so that after n steps all but the n layers next
///   to the end rest.
#include <gtest/gtest.h>

#include <bit>

#include "fe/element_values.hpp"
#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

template <int Dim>
std::vector<std::uint64_t> bits_of(FiniteElements<Dim>& body) {
  std::vector<std::uint64_t> bits;
  const FiniteElements<Dim>& seen = body;
  for (const auto& block : seen.blocks()) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      visit_element(block, slot_of(e), [&](Real value, FieldUse) {
        bits.push_back(std::bit_cast<std::uint64_t>(value));
      });
    }
  }
  for (LocalIndex k = 0; k < body.points().size(); ++k) {
    for (int i = 0; i < Dim; ++i) {
      bits.push_back(std::bit_cast<std::uint64_t>(body.points().x[k][i]));
      bits.push_back(std::bit_cast<std::uint64_t>(body.points().v[k][i]));
    }
  }
  return bits;
}

template <int Dim>
std::size_t tiles_at_rest(FiniteElements<Dim>& body) {
  const FiniteElements<Dim>& seen = body;
  std::size_t n = 0;
  for (const auto& block : seen.blocks()) {
    n += slot_of(std::count(block.rest.begin(), block.rest.end(), Rest::unstrained));
  }
  return n;
}

template <int Dim>
void expect_identity(FiniteElements<Dim>& body) {
  step_free(body, 1e-6);
  const auto before = bits_of(body);
  const std::size_t tiles = body.blocks()[0].rest.size();  // which wakes them
  EXPECT_EQ(tiles_at_rest(body), 0u);
  step_free(body, 2e-6);
  EXPECT_EQ(bits_of(body), before);
  EXPECT_EQ(tiles_at_rest(body), tiles);
  for (const auto& force : body.points().f) EXPECT_EQ(force, Vec<Dim>(Vec<Dim>::Zero()));
}

template <int Dim>
Mesh<Dim> distorted_box() {
  std::array<int, Dim> cells;
  cells.fill(5);
  auto mesh = box_mesh<Dim>(cells, Vec<Dim>::Constant(0.1), Vec<Dim>::Constant(0.7), 0.25);
  for (auto& x : mesh.points.x) {
    const Real wide = 1 + 0.3 * x[1], lean = 0.17 * x[0];
    x[0] *= wide;
    x[1] += lean;
  }
  return mesh;
}

template <int Dim>
void expect_identities(const Material& material) {
  const auto mesh = distorted_box<Dim>();
  for (const auto& variant : variants_of(Dim)) {
    SCOPED_TRACE(name_of(variant));
    expect_identity(*make_body<Dim>(mesh, material, variant));
    if (variant.integration != Integration::one_point) continue;
    for (const Hourglass& control : {Hourglass{ViscousHourglass{}}, Hourglass{StiffnessHourglass{}},
                                     Hourglass{AssumedStrainHourglass{}}}) {
      ElementOptions options;
      options.hourglass = control;
      expect_identity(*make_body<Dim>(mesh, material, variant, options));
    }
  }
}

TEST(Rest, AStepLeavesWhatLiesStillAsItIs) {
  const Material steel = elastic(207e9, 0.29, 7830), metal = copper();
  for (const Material* material : {&steel, &metal}) {
    expect_identities<2>(*material);
    expect_identities<3>(*material);
    expect_identity(*tets(distorted_box<3>(), *material));
  }
}

TEST(Rest, WhatAWaveHasNotReachedIsLeftOutUnseen) {
  const Material metal = copper();
  const auto mesh = box_mesh<3>({4, 4, 32}, Vec3::Zero(), {0.4, 0.4, 3.2}, 0.1);
  for (const auto& variant : variants_of(3)) {
    SCOPED_TRACE(name_of(variant));
    const auto some = make_body<3>(mesh, metal, variant), all = make_body<3>(mesh, metal, variant);
    for (auto* body : {some.get(), all.get()}) {
      Points<3>& points = body->points();
      for (LocalIndex k = 0; k < points.size(); ++k) {
        if (points.x[k][2] == 0) points.v[k][2] = 30;
      }
    }
    const std::size_t in_tile = slot_of(all->blocks()[0].elements_per_tile());
    for (std::size_t step = 1; step <= 20; ++step) {
      all->blocks();  // wakes them
      step_free(*some, 5e-6);
      step_free(*all, 5e-6);
      ASSERT_EQ(bits_of(*some), bits_of(*all)) << "step " << step;
      const std::size_t reached = (step * 16 + in_tile - 1) / in_tile;
      EXPECT_EQ(tiles_at_rest(*some), 512 / in_tile - reached) << "step " << step;
    }
  }
}

}  // namespace
}  // namespace brunt
