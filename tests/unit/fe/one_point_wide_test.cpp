/// The two kernels of one-point elements give the same bits: of a distorted, moving block that
/// flows or bends, state, works, stable steps and forces after three steps.
#include "fe/one_point_wide.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <numeric>

#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

template <int Dim>
using OnePointKernel = void (*)(ElementBlock<Dim>&, int, const ElementStep<Dim>&);

/// All bits that three steps leave.
template <int Dim>
std::vector<std::uint64_t> bits_after(const Material& material, Geometry geometry,
                                      OnePointKernel<Dim> kernel) {
  std::array<int, Dim> cells;
  cells.fill(5);
  Vec<Dim> corner = Vec<Dim>::Zero();
  corner[0] = 1;
  Mesh<Dim> mesh = box_mesh<Dim>(cells, corner, Vec<Dim>::Constant(1.0), 0.2);
  mesh.set.material = &material;
  mesh.set.adiabatic = true;
  const Thickness thickness = thickness_of(geometry, 0.7);
  ElementBlock<Dim> block = make_block(mesh.set, mesh.points, thickness);
  Points<Dim>& points = mesh.points;
  const std::vector<Vec<Dim>> start = points.x;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> uniform(-400, 400);
  for (auto& v : points.v) {
    for (int i = 0; i < Dim; ++i) v[i] = uniform(random);
  }
  const std::size_t rows = block.corner.size();
  std::vector<std::uint16_t> place(rows);
  std::vector<Real> force(rows * kSumRow<Dim>, 0.0);
  for (std::size_t c = 0; c < rows; ++c) place[c] = static_cast<std::uint16_t>(c * kSumRow<Dim>);
  const Real dt = 2e-6;
  for (int n = 0; n < 3; ++n) {
    for (std::size_t k = 0; k < points.x.size(); ++k) points.x[k] += dt * points.v[k];
    const ElementStep<Dim> step{points.x.data(),
                                points.v.data(),
                                start.data(),
                                thickness,
                                dt,
                                {place.data(), 0, force.data()},
                                nullptr};
    for (int t = 0; t < block.n_tiles(); ++t) kernel(block, t, step);
  }
  std::vector<std::uint64_t> bits;
  const auto add = [&](const std::vector<Real>& field) {
    for (const Real value : field) {
      bits.emplace_back();
      std::memcpy(&bits.back(), &value, sizeof value);
    }
  };
  add(force);
  for (const auto& component : block.state.deviator) add(component);
  for (const auto* field :
       {&block.state.pressure, &block.state.bulk, &block.state.eps_p, &block.state.temperature,
        &block.hourglass, &block.viscous_pressure, &block.stress_work, &block.hourglass_work,
        &block.viscous_work, &block.stable_step}) {
    add(*field);
  }
  return bits;
}

template <int Dim>
void expect_same_kernels(Geometry geometry) {
  for (const bool flows : {true, false}) {
    const Material material = flows ? copper() : elastic(124e9, 0.34, 8960);
    const auto narrow = bits_after<Dim>(material, geometry, &advance_one_point_narrow<Dim>);
    const auto wide = bits_after<Dim>(material, geometry, &advance_one_point_wide<Dim>);
    EXPECT_EQ(narrow, wide) << flows;
    EXPECT_GT(narrow.size(), 500u);
  }
}

TEST(one_point_wide, same_bits_3d) {
  if (!has_wide_registers()) GTEST_SKIP() << "no wide kernel, or no processor for it";
  expect_same_kernels<3>(Geometry::three_d);
}
TEST(one_point_wide, same_bits_2d) {
  if (!has_wide_registers()) GTEST_SKIP() << "no wide kernel, or no processor for it";
  expect_same_kernels<2>(Geometry::plane_strain);
  expect_same_kernels<2>(Geometry::axisymmetric);
}

}  // namespace
}  // namespace brunt
