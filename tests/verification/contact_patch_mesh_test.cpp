// The patch test of contact on meshes that a deck does not make: 4 elements
// along a side on 6, inner nodes displaced by up to a fifth of an element, all of it turned by
// 0.3 rad, and rings. Elements at the contact keep their depth: the spring of a face is that of the
// element behind it, phi M/h, so that an even push over unequal depths has unequal gaps, which
// nodes that faces share cannot have (distorted too, stresses differ by 6 %;
// docs/decisions/009-patch-test-distorted-mesh.md).
// Two blocks, one on the other, are squeezed by moving the outer face of one along the axis; the
// faces there slide freely, the sides are free. The exact stress is uniform, a push along the axis
// and nothing across (but nu of it out of a plane that keeps its width), and the faces' inner nodes
// balance it on any mesh whose forces are exact for linear fields. Gate: 1e-10 of the push, the
// page's, strains being 4e-5: what a strain leaves that comes and goes while the blocks are
// squeezed is of third order. Axisymmetric one-point elements are not here: they measure 2 pi r A,
// whose nodal forces under an even push are not the integrals of r N_I that contact gives (fe
// kinematics_test.cpp).
#include <gtest/gtest.h>

#include <cmath>

#include "contact/manager/manager.hpp"
#include "tests/unit/fe/fe_scene.hpp"

namespace brunt::test {
namespace {
using namespace brunt::testing;

constexpr Real kYoung = 1e6, kDensity = 1000;  // [Pa], [kg/m^3]
constexpr Real kDamping = 100;                 // [1/s]
constexpr Real kSpeed = 1e-4, kSqueezing = 2;  // [m/s], [s]
constexpr Real kRamp = 0.5, kEnd = 10;         // [s]

/// Speed of the outer face [m/s].
Real speed_at(Real t) {
  const Real rising = std::min(t / kRamp, 1.0), falling = std::min((kSqueezing - t) / kRamp, 1.0);
  return kSpeed * std::max(std::min(rising, falling), 0.0);
}

template <int Dim>
using Matrix = Eigen::Matrix<Real, Dim, Dim>;

Matrix<2> turn(const Vec<2>&, Real angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }
Matrix<3> turn(const Vec3&, Real angle) {
  return Eigen::AngleAxisd(angle, Vec3(2, 1, 0.5).normalized()).toRotationMatrix();
}

/// Two blocks with sides of 1 m, the second on the first along the last axis.
template <int Dim>
struct Blocks {
  Material material = elastic(kYoung, 0.3, kDensity);
  std::unique_ptr<FiniteElements<Dim>> block[2];
  std::unique_ptr<ContactManager<Dim>> contact;
  /// Nodes of the outer face of each along the last axis, and of the sides across which the other
  /// axes begin: these slide in their planes, so that the blocks widen away from the same planes.
  std::vector<LocalIndex> held[2][Dim];
  Matrix<Dim> Q;
  bool ring;

  Blocks(const Variant& variant, Real angle, Real radius)
      : ring(variant.geometry == Geometry::axisymmetric) {
    Q = turn(Vec<Dim>(), angle);
    for (const int b : {0, 1}) {
      std::array<int, Dim> cells;
      cells.fill(b == 0 ? 4 : 6);
      Vec<Dim> corner = Vec<Dim>::Zero();
      corner[0] = radius, corner[Dim - 1] = b;
      auto mesh = box_mesh<Dim>(cells, corner, Vec<Dim>::Ones());
      distort(b, cells[0], corner, mesh.points.x);
      for (std::size_t i = 0; i < mesh.points.x.size(); ++i) {
        auto& x = mesh.points.x[i];
        for (int c = 0; c < Dim; ++c) {
          const Real place = c == Dim - 1 ? 2.0 * b : corner[c];
          if (x[c] == place) held[b][c].push_back(static_cast<LocalIndex>(i));
        }
        x = Q * x;
        mesh.points.id[i] += static_cast<GlobalId>(b) << 20;
        mesh.points.body[i] = static_cast<Label>(b);
      }
      for (auto& id : mesh.set.id) id += static_cast<GlobalId>(b) << 20;
      mesh.set.body.assign(mesh.set.body.size(), static_cast<Label>(b));
      block[b] = make_body(std::move(mesh), material, variant, {}, 1);
    }
    contact = std::make_unique<ContactManager<Dim>>(
        ContactOptions{}, variant.geometry,
        std::vector<Surface<Dim>*>{&block[0]->surface(), &block[1]->surface()},
        std::vector<std::string>{"lower", "upper"});
    contact->rearrange();
  }

  /// Moves nodes that are inside the block, and not of an element at the contact.
  static void distort(int b, int cells, const Vec<Dim>& corner, std::vector<Vec<Dim>>& x) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<Real> uniform(-0.2 / cells, 0.2 / cells);
    for (auto& place : x) {
      const Vec<Dim> in = place - corner;  // [0, 1]
      const Real to_contact = b == 0 ? 1 - in[Dim - 1] : in[Dim - 1];
      if (in.minCoeff() < 0.5 / cells || in.maxCoeff() > 1 - 0.5 / cells) continue;
      if (to_contact < 1.5 / cells) continue;
      for (int c = 0; c < Dim; ++c) place[c] += uniform(random);
    }
  }

  void step(Real t, Real dt) {
    for (auto& body : block) {
      auto& p = body->points();
      for (std::size_t i = 0; i < p.x.size(); ++i) p.move(i, dt * p.v[i]);
      for (auto& f : p.f) f.setZero();
    }
    contact->add_forces(dt);
    for (auto& body : block) body->add_internal_forces(dt);
    for (const int b : {0, 1}) {
      auto& p = block[b]->points();
      for (std::size_t i = 0; i < p.x.size(); ++i) {
        p.v[i] = (1 - kDamping * dt) * p.v[i] + dt / p.mass[i] * p.f[i];
      }
      for (int c = 0; c < Dim; ++c) {
        if (c == 0 && ring) continue;
        const Real wanted = b == 1 && c == Dim - 1 ? -speed_at(t) : 0.0;
        const Vec<Dim> across = Q.col(c);
        for (const LocalIndex i : held[b][c]) p.v[i] += (wanted - p.v[i].dot(across)) * across;
      }
    }
  }

  void squeeze() {
    Real longest = std::min(block[0]->stable_step().step, block[1]->stable_step().step);
    longest = std::min(longest, contact->stable_step().step);
    const int steps = static_cast<int>(std::ceil(kEnd / (0.7 * longest)));
    for (int n = 0; n < steps; ++n) step(n * kEnd / steps, kEnd / steps);
  }
};

Mat3 tensor(const std::array<Real, 6>& s) {
  Mat3 m;
  m << s[xx], s[xy], s[zx], s[xy], s[yy], s[yz], s[zx], s[yz], s[zz];
  return m;
}

template <int Dim>
void expect_uniform(const Variant& variant, Real angle, Real radius) {
  SCOPED_TRACE(name_of(variant) + " radius " + std::to_string(radius));
  Blocks<Dim> blocks(variant, angle, radius);
  blocks.squeeze();
  Mat3 Q = Mat3::Identity();
  Q.template topLeftCorner<Dim, Dim>() = blocks.Q;
  // Along the blocks' own axes, which small strains have turned by nothing.
  Mat3 least = Mat3::Constant(kInfinity), most = -least;
  for (const auto& body : blocks.block) {
    const auto& all = body->blocks()[0];
    for (LocalIndex e = 0; e < all.n; ++e) {
      for (int g = 0; g < all.gauss; ++g) {
        const Mat3 s = Q.transpose() * tensor(stress_at(all.state, all.point(e, g))) * Q;
        least = least.cwiseMin(s), most = most.cwiseMax(s);
      }
    }
  }
  const Real push = -least(Dim - 1, Dim - 1);
  EXPECT_GT(push, 50);  // E of 75e-6 less what the springs of contact take
  EXPECT_LT(push, 82);
  EXPECT_LT((most - least).maxCoeff(), 1e-10 * push);
  Mat3 across = most;
  across(Dim - 1, Dim - 1) = 0;
  if (variant.geometry == Geometry::plane_strain) across(2, 2) += 0.3 * push;
  EXPECT_LT(across.cwiseAbs().maxCoeff(), 1e-4 * push);  // of strains squared
}

TEST(ContactPatchOfMeshes, DistortedAndTurnedInThePlane) {
  for (const auto how : {Integration::one_point, Integration::q1p0, Integration::full}) {
    expect_uniform<2>({Geometry::plane_strain, how}, 0.3, 0);
  }
}
TEST(ContactPatchOfMeshes, DistortedAndTurnedInSpace) {
  for (const auto how : {Integration::one_point, Integration::q1p0}) {
    expect_uniform<3>({Geometry::three_d, how}, 0.3, 0);
  }
}
TEST(ContactPatchOfMeshes, DistortedRingsAndCylinders) {
  for (const Real radius : {0.0, 0.5}) {
    expect_uniform<2>({Geometry::axisymmetric, Integration::q1p0}, 0, radius);
  }
}

}  // namespace
}  // namespace brunt::test
