/// Eight elements at a time have the bits of four: each lane is one element, and none looks at
/// another (core/simd.hpp). Boxes with nodes moved at random, thrown about until they flow and some
/// are crushed flat enough for the guard of shapes, are advanced beside themselves by both kernels,
/// with the forces of each corner in a row of its own: state, works, stable steps and forces agree
/// bit for bit, of all integrations, geometries and hourglass controls.
#include "core/wide_lanes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "fe/conduction.hpp"
#include "fe/element_step.hpp"
#include "fe/element_values.hpp"
#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

template <int Dim, class V>
void advance(ElementBlock<Dim>& block, int tile, const ElementStep<Dim>& step) {
  if (block.gauss == 1) {
    advance_one_point<Dim, V>(block, tile, step);
  } else {
    advance_gauss<Dim, V>(block, tile, step);
  }
}

/// Bits of what a step leaves in a block, and on its corners.
template <int Dim, class V>
std::vector<std::uint64_t> stepped(ElementBlock<Dim>& block, ElementStep<Dim> step) {
  std::vector<std::uint64_t> bits;
  const auto bit = [&](Real value) { bits.push_back(std::bit_cast<std::uint64_t>(value)); };
  const std::size_t elements = slot_of(block.elements_per_tile());
  const std::size_t corners = elements * Shape<Dim>::kCorners;
  std::vector<std::uint16_t> place(corners);
  for (std::size_t k = 0; k < corners; ++k) {
    place[k] = static_cast<std::uint16_t>(k * kSumRow);
  }
  for (int tile = 0; tile < block.n_tiles(); ++tile) {
    std::vector<Real> row(corners * kSumRow, 0.0);
    step.sums = {place.data(), slot_of(tile) * elements, row.data()};
    advance<Dim, V>(block, tile, step);
    for (const Real force : row) bit(force);
  }
  for (LocalIndex e = 0; e < block.n; ++e) {
    visit_element(block, slot_of(e), [&](Real value, FieldUse) { bit(value); });
  }
  return bits;
}

/// Steps of displacements at random, of up to `part` of a cell each.
template <int Dim>
void expect_bits_of_four(const Material& material, const Variant& variant,
                         const ElementOptions& options, Real part) {
  std::array<int, Dim> cells;
  cells.fill(Dim == 3 ? 5 : 9);
  const auto body =
      make_body<Dim>(box_mesh<Dim>(cells, Vec<Dim>::Constant(0.1), Vec<Dim>::Constant(0.5), 0.2),
                     material, variant, options);
  Points<Dim> points = body->points();
  ElementBlock<Dim> four = body->blocks()[0], eight = body->blocks()[0];
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> uniform(-part * 0.5 / cells[0], part * 0.5 / cells[0]);
  ElementStep<Dim> step;
  step.dt = 1e-7;
  step.thickness = thickness_of(variant.geometry, 0.7);
  for (int n = 0; n < 20; ++n) {
    for (std::size_t k = 0; k < points.x.size(); ++k) {
      for (int i = 0; i < Dim; ++i) points.v[k][i] = uniform(random) / step.dt;
      points.x[k] += step.dt * points.v[k];
    }
    step.x = points.x.data(), step.v = points.v.data(), step.x_start = points.x_start.data();
    const auto of_four = stepped<Dim, Pack>(four, step);
    ASSERT_EQ((stepped<Dim, Wide>(eight, step)), of_four) << "step " << n;
  }
}

template <int Dim>
void expect_bits_of_all() {
  const Material metal = copper(), stiff = elastic(200e9, 0.3, 7850);
  for (const Variant& variant : variants_of(Dim)) {
    SCOPED_TRACE(name_of(variant));
    for (const Material* material : {&metal, &stiff}) {
      for (const Hourglass& control :
           {Hourglass{ViscousHourglass{}}, Hourglass{StiffnessHourglass{}},
            Hourglass{AssumedStrainHourglass{}}}) {
        ElementOptions options;
        options.hourglass = control;
        expect_bits_of_four<Dim>(*material, variant, options, 1e-3);
        expect_bits_of_four<Dim>(*material, variant, options, 0.1);
      }
    }
  }
}

TEST(WideLanes, HexesHaveTheBitsOfFour) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  expect_bits_of_all<3>();
}
TEST(WideLanes, ConductingHexesHaveTheBitsOfFour) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  const Mesh<3> mesh = box_mesh<3>({2, 2, 2}, Vec3::Zero(), Vec3(0.01, 0.02, 3), 0.3);
  std::vector<LocalIndex> corner;
  for (const auto& cell : mesh.set.corners) corner.insert(corner.end(), cell.begin(), cell.end());
  std::vector<Real> temperature, of_four(128), of_eight(128);
  for (std::size_t i = 0; i < mesh.points.x.size(); ++i) {
    temperature.push_back(300 + 50 * std::sin(7.0 * static_cast<Real>(i)));
  }
  const std::array<Real, 8> k{1, 2, 4, 50, 386, 1e-3, 0, 7};
  ConductionStep<3> step;
  step.x = mesh.points.x.data(), step.temperature = temperature.data();
  conduct_hexes<Wide>(corner.data(), k.data(), step, of_eight.data());
  conduct_hexes<Pack>(corner.data(), k.data(), step, of_four.data());
  conduct_hexes<Pack>(corner.data() + 32, k.data() + 4, step, of_four.data() + 64);
  for (std::size_t n = 0; n < of_four.size(); ++n) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(of_eight[n]), std::bit_cast<std::uint64_t>(of_four[n]));
  }
}
TEST(WideLanes, QuadsHaveTheBitsOfFour) {
  if (!can_run_wide()) GTEST_SKIP() << "no AVX-512 here";
  expect_bits_of_all<2>();
}

}  // namespace
}  // namespace brunt
