/// Patch tests and objectivity of the element kernels.
/// - Patch: x = (I + A) X in one step from rest gives the same stress in every point of a distorted
///   mesh: L = D + w = A (I + A/2)^-1 (mid-step), s = 2 G dev (D + (w D - D w)/2), p = K (1/J - 1),
///   J = det(I + A); and no force on inner nodes. Axisymmetric: u_r = a r, u_y = b y, hoop strain
///   that of r. (One-point axisymmetric elements measure 2 pi r A, which on distorted meshes does
///   not sum to the volume of the body: their inner forces vanish only with the mesh size, not
///   tested.) Tolerance 1e-12 of the stress: round-off of some 100 operations on strains of 1e-2.
/// - Rigid spin: a prestressed body turned by hand, 10 turns of 360 steps, changes |sigma|
///   by round-off only: 3600 rotations, orthogonal to 1e-15 each, and strains of 1e-16/step.
/// - The start of a step: what is found from its middle and end is what its positions give, for
///   displacements of up to half an element's size, whatever their modes.
#include <gtest/gtest.h>

#include <random>

#include "fe/one_point_kinematics.hpp"
#include "fe_scene.hpp"

namespace brunt {
namespace {
using namespace testing;

Mat3 in_space(const Eigen::Matrix3d& A) { return A; }
Mat3 in_space(const Eigen::Matrix2d& A) {
  Mat3 B = Mat3::Zero();
  B.topLeftCorner<2, 2>() = A;
  return B;
}

/// A displacement gradient that stretches, shears and turns.
template <int Dim>
Eigen::Matrix<Real, Dim, Dim> gradient() {
  Eigen::Matrix3d A;
  A << 0.010, 0.004, -0.003, 0.002, -0.007, 0.006, 0.001, -0.005, 0.004;
  return A.topLeftCorner<Dim, Dim>();
}

/// Stress after one step x = (I + A) X.
std::array<Real, 6> patch_stress(const Mat3& A, const Material& material) {
  const Mat3 L = A * (Mat3::Identity() + 0.5 * A).inverse();
  const Mat3 at_middle = 0.5 * (L + L.transpose()), w = 0.5 * (L - L.transpose());
  const Mat3 D = at_middle + 0.5 * (w * at_middle - at_middle * w);
  const Real p = material.bulk * (1 / (Mat3::Identity() + A).determinant() - 1);
  const Real third = D.trace() / 3;
  const Real G = 2 * material.shear;
  return {G * (D(0, 0) - third) - p,
          G * (D(1, 1) - third) - p,
          G * (D(2, 2) - third) - p,
          G * D(0, 1),
          G * D(1, 2),
          G * D(2, 0)};
}

template <int Dim>
void expect_patch(Eigen::Matrix<Real, Dim, Dim> A) {
  const Material material = elastic(200e9, 0.3, 7850);
  std::array<int, Dim> cells;
  cells.fill(3);
  Vec<Dim> corner = Vec<Dim>::Zero();
  corner[0] = 1;
  const Mesh<Dim> mesh = box_mesh<Dim>(cells, corner, Vec<Dim>::Constant(2.0), 0.25);
  for (const Variant& variant : variants_of(Dim)) {
    SCOPED_TRACE(name_of(variant));
    const bool ring = variant.geometry == Geometry::axisymmetric;
    Eigen::Matrix<Real, Dim, Dim> B = A;
    if (ring) B(0, 1) = B(1, 0) = 0;  // shear about the axis leaves no uniform stress
    if (ring) B(1, 1) = 0;            // inner forces vanish where sigma_rr = sigma_tt alone acts
    Mat3 full = in_space(B);
    if (ring) full(2, 2) = B(0, 0);
    ElementOptions options;
    options.bulk_viscosity = {0, 0};
    auto body = make_body(mesh, material, variant, options);
    std::vector<Vec<Dim>> x = body->points().x;
    for (auto& place : x) place += B * place;
    step_to(*body, x, 1e-6);
    const auto expected = patch_stress(full, material);
    const auto& block = body->blocks()[0];
    const Real scale = material.bulk * 1e-2;
    for (LocalIndex e = 0; e < block.n; ++e) {
      for (int g = 0; g < block.gauss; ++g) {
        const auto s = stress_at(block.state, block.point(e, g));
        for (int k = 0; k < 6; ++k) ASSERT_NEAR(s[k], expected[k], 1e-12 * scale);
      }
    }
    if (ring && variant.integration == Integration::one_point) continue;
    for (LocalIndex k = 0; k < body->points().size(); ++k) {
      bool inner = true;
      for (int c = 0; c < Dim; ++c) {
        const Real from = mesh.points.x[k][c] - corner[c];
        inner = inner && from > 1e-9 && from < 2 - 1e-9;
      }
      if (!inner) continue;
      // forces of faces of 2/3 x 2/3 cancel; axisymmetric ones are 2 pi r larger
      ASSERT_LT(body->points().f[k].norm(), 20 * 1e-12 * scale);
    }
  }
}
TEST(kinematics, patch_3d) { expect_patch<3>(gradient<3>()); }
TEST(kinematics, patch_2d) { expect_patch<2>(gradient<2>()); }

Eigen::Matrix3d turned(Real angle, const Eigen::Matrix3d&) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
}
Eigen::Matrix2d turned(Real angle, const Eigen::Matrix2d&) {
  return Eigen::Rotation2Dd(angle).toRotationMatrix();
}

Real norm_of(const std::array<Real, 6>& s) {
  Real sum = 0;
  for (int k = 0; k < 6; ++k) sum += (k < 3 ? 1 : 2) * s[k] * s[k];
  return std::sqrt(sum);
}

/// Turns a body by hand from x: ten turns of 360 steps.
template <int Dim>
void spin(FiniteElements<Dim>& body) {
  const std::vector<Vec<Dim>> x = body.points().x;
  std::vector<Vec<Dim>> place(x.size());
  for (int step = 1; step <= 3600; ++step) {
    const Eigen::Matrix<Real, Dim, Dim> R =
        turned(2 * kPi * step / 360, Eigen::Matrix<Real, Dim, Dim>{});
    for (std::size_t k = 0; k < x.size(); ++k) place[k] = R * x[k];
    step_to(body, place, 1e-6);
  }
}

template <int Dim>
void expect_objective(const Eigen::Matrix<Real, Dim, Dim>& A) {
  const Material material = elastic(200e9, 0.3, 7850);
  for (const Variant& variant : variants_of(Dim)) {
    if (variant.geometry == Geometry::axisymmetric) continue;
    SCOPED_TRACE(name_of(variant));
    auto body = make_body(cell_mesh<Dim>(Vec<Dim>::Ones(), 0.1, 5), material, variant);
    std::vector<Vec<Dim>> x = body->points().x;
    for (auto& place : x) place += A * place;
    step_to(*body, x, 1e-6);
    const auto& block = body->blocks()[0];
    std::vector<std::array<Real, 6>> before;
    for (int g = 0; g < block.gauss; ++g) {
      before.push_back(stress_at(block.state, block.point(0, g)));
    }
    spin(*body);
    for (int g = 0; g < block.gauss; ++g) {
      const auto after = stress_at(block.state, block.point(0, g));
      EXPECT_NEAR(norm_of(after) / norm_of(before[g]), 1.0, 1e-8);
      // Hughes-Winget follows the angle itself, so whole turns bring every component back.
      for (int k = 0; k < 6; ++k) {
        EXPECT_NEAR(after[k], before[g][k], 1e-8 * norm_of(before[g]));
      }
    }
  }
}
TEST(kinematics, rigid_spin_keeps_stress_3d) { expect_objective<3>(gradient<3>()); }
TEST(kinematics, rigid_spin_keeps_stress_2d) { expect_objective<2>(gradient<2>()); }

template <int Dim>
void expect_hourglass() {
  // Linear fields are not resisted: gamma . x = 0 to round-off, so the energy is of its square,
  // 1e-30 of k. The checkerboard x h, amplitude d in direction 0, has q = sqrt(corners) d on a box,
  // k = kappa mu tr(G) V, the energy k q^2/2 and forces -k d h; tr(G) = 3/2 (hex) or 2 (quad) for a
  // unit box, V = 0.7 in plane strain. It does not strain the middle of the box.
  const Material material = elastic(200e9, 0.3, 7850);
  const Variant variant{Dim == 3 ? Geometry::three_d : Geometry::plane_strain,
                        Integration::one_point};
  ElementOptions options;
  options.hourglass = StiffnessHourglass{0.05};
  const auto energy = [](const auto& body) { return totals_of(body).value(Column::hourglass); };
  auto distorted = make_body(cell_mesh<Dim>(Vec<Dim>::Ones(), 0.2, 9), material, variant, options);
  std::vector<Vec<Dim>> x = distorted->points().x;
  for (auto& place : x) place = 1.1 * place + Vec<Dim>::Constant(0.3 * place[0]);
  step_to(*distorted, x, 1e-6);
  const Real modulus = 0.05 * material.shear;
  EXPECT_LT(energy(*distorted), 1e-29 * modulus);

  auto body = make_body(cell_mesh<Dim>(Vec<Dim>::Ones(), 0.0, 9), material, variant, options);
  x = body->points().x;
  const Real d = 1e-4;
  std::vector<Real> sign;
  for (auto& place : x) {
    sign.push_back(1);
    for (int j = 0; j < Dim; ++j) sign.back() *= place[j] > 0.5 ? 1 : -1;
    place[0] += d * sign.back();
  }
  step_to(*body, x, 1e-6);
  const Real k = modulus * (Dim == 3 ? 1.5 : 2.0 * 0.7);
  const Real expected = 0.5 * k * Shape<Dim>::kCorners * d * d;
  EXPECT_NEAR(energy(*body), expected, 1e-11 * expected);  // places of 1e-16 over d = 1e-4
  const std::vector<Vec<Dim>> f = body->points().f;
  for (std::size_t i = 0; i < f.size(); ++i) {
    EXPECT_NEAR(f[i][0], -k * d * sign[i], 1e-8 * k * d);  // rounding of the stress, 1e-16 K
    for (int c = 1; c < Dim; ++c) EXPECT_NEAR(f[i][c], 0, 1e-8 * k * d);
  }

  // Ten turns bring the forces back and do no work on the hourglass modes.
  spin(*body);
  for (std::size_t i = 0; i < f.size(); ++i) {
    EXPECT_LT((body->points().f[i] - f[i]).norm(), 1e-7 * k * d);  // strains of 1e-16 a step
  }
  EXPECT_NEAR(energy(*body), expected, 1e-10 * expected);

  // Hourglassed, stretched by a tenth, and no longer hourglassed: nothing is left.
  step_to(*body, x, 1e-6);
  const std::vector<Vec<Dim>> start = body->points().x_start;
  for (auto& place : x) place[1] *= 1.1;
  step_to(*body, x, 1e-6);
  for (std::size_t i = 0; i < x.size(); ++i) x[i][0] = start[i][0];
  step_to(*body, x, 1e-6);
  EXPECT_LT(energy(*body), 1e-20 * expected);
}
TEST(kinematics, hourglass_stiffness_3d) { expect_hourglass<3>(); }
TEST(kinematics, hourglass_stiffness_2d) { expect_hourglass<2>(); }

TEST(kinematics, viscous_hourglass_force) {
  // f_iI = -1/4 Q rho c V^(2/3) (gamma . v_i) gamma_I: the checkerboard with velocity w on a unit
  // cube has gamma . v = 8 w, so the force is 2 Q rho c w on each corner, against the velocity.
  const Material material = elastic(200e9, 0.3, 7850);
  ElementOptions options;
  options.hourglass = ViscousHourglass{0.1};
  auto body = make_body(cell_mesh<3>(Vec<3>::Ones(), 0.0, 9), material, {}, options);
  std::vector<Vec<3>> x = body->points().x;
  const Real w = 1, dt = 1e-6;
  std::vector<Real> sign;
  for (auto& place : x) {
    sign.push_back((place[0] > 0.5 ? 1 : -1) * (place[1] > 0.5 ? 1 : -1) *
                   (place[2] > 0.5 ? 1 : -1));
    place[2] += dt * w * sign.back();
  }
  step_to(*body, x, dt);
  const Real c = std::sqrt(material.modulus() / material.density);
  const Real expected = 2 * 0.1 * material.density * c * w;
  for (std::size_t k = 0; k < x.size(); ++k) {
    // the cube is distorted by dt w = 1e-6 of its size, and gamma with it
    EXPECT_NEAR(body->points().f[k][2], -sign[k] * expected, 1e-5 * expected);
  }
}

template <int Dim>
void expect_start_from_middle_and_end(const Thickness& thickness) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<Real> part(-0.5, 0.5);
  for (int round = 0; round < 100; ++round) {
    Modal<Dim, Real> c, u, start, middle;
    for (int m = 0; m < Shape<Dim>::kModes; ++m) {
      const bool mean = m == Shape<Dim>::kModes - 1;
      for (int i = 0; i < Dim; ++i) {
        c.m[m][i] = 0.2 * part(random) + (m == i ? 1.0 : 0.0) + (mean ? 3.0 : 0.0);
        u.m[m][i] = part(random);
        start.m[m][i] = c.m[m][i] - u.m[m][i];
        middle.m[m][i] = c.m[m][i] - 0.5 * u.m[m][i];
      }
    }
    OnePointConfiguration<Dim, Real> now, mid, expected, old;
    evaluate(c, u, thickness, now);
    evaluate(middle, u, thickness, mid);
    evaluate(start, u, thickness, expected);
    evaluate_start(start, u, now, mid, thickness, old);
    // Sums of some twenty terms of the order of 10.
    constexpr Real kRounding = 1e-13;
    EXPECT_NEAR(old.measure, expected.measure, kRounding);
    for (int i = 0; i < Dim; ++i) {
      for (int j = 0; j < Dim; ++j) EXPECT_NEAR(old.G[i][j], expected.G[i][j], kRounding);
      for (int a = 0; a < Shape<Dim>::kHourglass; ++a) {
        EXPECT_EQ(old.mode[a][i], expected.mode[a][i]);
      }
    }
    if (Dim == 2) {
      EXPECT_EQ(old.thickness, expected.thickness);
      EXPECT_NEAR(old.G_hoop, expected.G_hoop, kRounding);
    }
  }
}
TEST(kinematics, start_from_middle_and_end) {
  expect_start_from_middle_and_end<3>({1, 0});
  expect_start_from_middle_and_end<2>({1, 0});
  expect_start_from_middle_and_end<2>({0, 1});
}

}  // namespace
}  // namespace brunt
