/// Masses, volumes and internal forces of single elements.
/// - dV/dx: an element under uniform pressure p pushes its corners with f_iI = p dV/dx_iI. Scaling
///   the coordinates by 0.9 about the origin gives p = K (0.9^-3 - 1) (0.9^-2 in plane strain).
///   dV/dx by central differences of element_volume, step 1e-5 of the size: V is a cubic, its
///   difference quotient errs by V'''h^2/6 <= 1e-10 relative, and round-off 1e-16/1e-5 = 1e-11.
/// - A cylinder ring 1..3, height 2, has mass rho pi (9 - 1) 2.
#include <gtest/gtest.h>

#include "core/errors.hpp"
#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

template <int Dim>
void expect_pressure_forces() {
  const Material material = elastic(1.0, 0.3, 1.0);
  for (const Variant& variant : variants_of(Dim)) {
    SCOPED_TRACE(name_of(variant));
    ElementOptions options;
    options.bulk_viscosity = {0, 0};
    auto body =
        make_body(cell_mesh<Dim>(Vec<Dim>::Ones(), 0.2, 3, 1.0), material, variant, options);
    Points<Dim>& points = body->points();
    for (auto& x : points.x) x *= 0.9;
    body->add_internal_forces(1e-3);
    const int power = variant.geometry == Geometry::plane_strain ? 2 : 3;
    const Real p = material.bulk * (std::pow(0.9, -power) - 1);
    const Thickness thickness = thickness_of(variant.geometry, 0.7);
    const bool one_point = variant.integration == Integration::one_point;
    const auto x = corner_positions(body->blocks()[0], 0, points);
    for (int I = 0; I < Shape<Dim>::kCorners; ++I) {
      for (int i = 0; i < Dim; ++i) {
        auto plus = x, minus = x;
        plus[I][i] += 1e-5;
        minus[I][i] -= 1e-5;
        const Real slope = (element_volume<Dim>(plus, one_point, thickness) -
                            element_volume<Dim>(minus, one_point, thickness)) /
                           2e-5;
        const LocalIndex node = body->blocks()[0].corner[I];
        EXPECT_NEAR(points.f[node][i], p * slope, 1e-9 * p);
      }
    }
  }
}
TEST(element_block, pressure_forces_are_gradients_of_volume_3d) { expect_pressure_forces<3>(); }
TEST(element_block, pressure_forces_are_gradients_of_volume_2d) { expect_pressure_forces<2>(); }

TEST(element_block, masses_are_exact) {
  const Material material = elastic(1.0, 0.3, 2.5);
  for (const Variant& variant : variants_of(2)) {
    SCOPED_TRACE(name_of(variant));
    auto body = make_body(box_mesh<2>({4, 3}, {1.0, 0.0}, {2.0, 2.0}, 0.2), material, variant);
    const bool ring = variant.geometry == Geometry::axisymmetric;
    const Real expected = ring ? 2.5 * kPi * 8 * 2 : 2.5 * 0.7 * 4;
    Real sum = 0;
    for (const Real m : body->points().mass) sum += m;
    EXPECT_NEAR(sum, expected, 1e-13 * expected);  // 20 sums of rounded volumes
  }
}

TEST(element_block, shares_of_masses_follow_the_formulation) {
  // One ring element 0..1: equal shares for one point; int N_I 2 pi r dr dz = pi/6 at the axis and
  // pi/3 outside for q1p0, which a plane wave along the axis needs.
  const Material material = elastic(1.0, 0.3, 1.0);
  for (const Variant& variant : variants_of(2)) {
    if (variant.geometry != Geometry::axisymmetric) continue;
    auto body = make_body(cell_mesh<2>({1.0, 1.0}, 0.0, 1), material, variant);
    const bool equal = variant.integration == Integration::one_point;
    EXPECT_NEAR(body->points().mass[0], equal ? kPi / 4 : kPi / 6, 1e-14);
    EXPECT_NEAR(body->points().mass[1], equal ? kPi / 4 : kPi / 3, 1e-14);
  }
}

TEST(element_block, an_element_without_volume_is_refused) {
  const Material material = elastic(1.0, 0.3, 1.0);
  Mesh<3> mesh = cell_mesh<3>(Vec<3>::Ones(), 0.0, 1);
  std::swap(mesh.set.corners[0][1], mesh.set.corners[0][3]);
  std::swap(mesh.set.corners[0][5], mesh.set.corners[0][7]);
  mesh.set.id[0] = 41;
  try {
    make_body(mesh, material, {});
    FAIL() << "no error";
  } catch (const PhysicsError& error) {
    EXPECT_EQ(error.failure().quantity, "volume");
    EXPECT_EQ(error.failure().entity, "element 41");
    EXPECT_NEAR(error.failure().value, -1.0, 1e-14);
  }
}

}  // namespace
}  // namespace brunt
