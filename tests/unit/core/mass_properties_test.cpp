// Mass, centre and inertia of closed surfaces against closed forms.
#include "core/rigid/mass_properties.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "core/geometry/mesh.hpp"

namespace brunt {
namespace {

constexpr Real kDensity = 2500;  // [kg/m^3]

template <int Dim>
struct Skin {
  Points<Dim> points;
  std::vector<Facet<Dim>> facets;
  MassProperties properties(Geometry geometry = Geometry::three_d, Real depth = 1) const {
    return mass_properties<Dim>(points, facets, kDensity, geometry, depth);
  }
};

template <int Dim>
Skin<Dim> skin_of(const ShapeKind& kind, std::vector<int> cells,
                  Geometry geometry = Geometry::three_d, std::optional<BodyRotation> rotate = {}) {
  const auto surface =
      surface_of_shape<Dim>({kind, std::move(rotate), {}}, {{}, std::move(cells)}, geometry);
  Skin<Dim> skin;
  skin.points.resize(static_cast<LocalIndex>(surface.nodes.size()));
  skin.points.x = surface.nodes;
  for (const auto& corners : surface.facets) {
    auto& facet = skin.facets.emplace_back();
    for (std::size_t c = 0; c < corners.size(); ++c) facet.node[c] = corners[c];
  }
  return skin;
}

// A box a x b x c: m = rho abc, I_x = m (b^2 + c^2)/12; turned by R: R I R^T. Only rounding is
// left, of sums of some 100 terms.
TEST(MassProperties, OfABoxAreExactHoweverItLies) {
  const Vec3 low(1, -2, 3), size(0.3, 0.2, 0.7);
  const Box box{{1, -2, 3}, {1.3, -1.8, 3.7}};
  const Real mass = kDensity * size.prod();
  Mat3 inertia = Mat3::Zero();
  for (int c = 0; c < 3; ++c) {
    inertia(c, c) = mass / 12 * (size.squaredNorm() - size[c] * size[c]);
  }
  const BodyRotation turn{{1, 2, -0.5}, 0.7, {0, 1, 0}};
  const Vec3 axis = Vec3(1, 2, -0.5).normalized(), about(0, 1, 0);
  const Mat3 rotation = Eigen::AngleAxis<Real>(0.7, axis).toRotationMatrix();
  const Vec3 center = about + rotation * (low + 0.5 * size - about);
  const auto found = skin_of<3>(box, {2, 3, 1}, Geometry::three_d, turn).properties();
  EXPECT_NEAR(found.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(found.area, 2 * (0.06 + 0.14 + 0.21), 1e-12);
  EXPECT_LT((found.center - center).norm(), 1e-12);
  EXPECT_LT((found.inertia - rotation * inertia * rotation.transpose()).norm(),
            1e-12 * inertia.norm());
}

// A prism over the right triangle with legs p and q, t thick, of a polygon's triangles: centroid at
// a third of the legs, m = rho p q t/2, I_z = m (p^2 + q^2)/18, I_x = m (q^2/18 + t^2/12),
// I_xy = + m p q/36.
TEST(MassProperties, OfAPrismOfTrianglesAreExact) {
  const Real p = 0.6, q = 0.3, t = 0.2, mass = kDensity * p * q * t / 2;
  PolygonShape triangle;
  triangle.points = {{0, 0}, {p, 0}, {0, q}};
  triangle.thickness = t;
  const auto found = skin_of<3>(triangle, {1, 1, 1}).properties();
  EXPECT_NEAR(found.mass, mass, 1e-12 * mass);
  EXPECT_LT((found.center - Vec3(p / 3, q / 3, t / 2)).norm(), 1e-13);
  EXPECT_NEAR(found.inertia(2, 2), mass * (p * p + q * q) / 18, 1e-12 * mass);
  EXPECT_NEAR(found.inertia(0, 0), mass * (q * q / 18 + t * t / 12), 1e-12 * mass);
  EXPECT_NEAR(found.inertia(0, 1), mass * p * q / 36, 1e-12 * mass);
}

// A sphere of flat facets is inside the true one: its mass and inertia, 4/3 pi R^3 rho and
// 2/5 m R^2, come nearer with the square of the facets' size: halved facets, a quarter of the
// error.
TEST(MassProperties, OfASphereConvergeWithTheSquareOfItsFacets) {
  const Real R = 0.1, mass = kDensity * 4 / 3 * kPi * R * R * R, inertia = 0.4 * mass * R * R;
  Real last = 0;
  for (const int n : {4, 8, 16}) {
    const auto found = skin_of<3>(Sphere{R, {1, 0, 0}}, {n, n, n}).properties();
    const Real error = 1 - found.inertia(0, 0) / inertia;
    EXPECT_LT(std::fabs(1 - found.mass / mass), error);
    EXPECT_NEAR(found.inertia(0, 1), 0, 1e-12 * inertia);
    if (n > 4) {
      EXPECT_NEAR(last / error, 4, 0.5) << n;
    }
    last = error;
  }
  EXPECT_LT(last, 0.02);
}

// A rectangle a x b of depth d: m = rho abd, I_z = m (a^2 + b^2)/12, and its outline without ends.
TEST(MassProperties, OfAPlaneSectionAreForItsDepth) {
  const Real a = 0.4, b = 0.1, d = 3, mass = kDensity * a * b * d;
  const auto found = skin_of<2>(Box{{1, 1}, {1 + a, 1 + b}}, {3, 1}, Geometry::plane_strain)
                         .properties(Geometry::plane_strain, d);
  EXPECT_NEAR(found.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(found.area, 2 * (a + b) * d, 1e-12);
  EXPECT_LT((found.center - Vec3(1 + a / 2, 1 + b / 2, 0)).norm(), 1e-13);
  EXPECT_NEAR(found.inertia(2, 2), mass * (a * a + b * b) / 12, 1e-12 * mass);
}

// A cone of radius R and height H on the axis: m = rho pi R^2 H/3, its centre H/4 above the base,
// its surface pi R (R + sqrt(R^2 + H^2)).
TEST(MassProperties, OfARingAreThoseOfTheWholeTurn) {
  const Real R = 0.2, H = 0.5, mass = kDensity * kPi * R * R * H / 3;
  PolygonShape cone;
  cone.points = {{0, 1}, {R, 1}, {0, 1 + H}};
  const auto found =
      skin_of<2>(cone, {1, 1}, Geometry::axisymmetric).properties(Geometry::axisymmetric);
  EXPECT_NEAR(found.mass, mass, 1e-12 * mass);
  EXPECT_NEAR(found.area, kPi * R * (R + std::sqrt(R * R + H * H)), 1e-12);
  EXPECT_LT((found.center - Vec3(0, 1 + H / 4, 0)).norm(), 1e-12);
}

TEST(MassProperties, RefuseASurfaceThatIsInsideOut) {
  auto skin = skin_of<2>(Box{{0, 0}, {1, 1}}, {1, 1}, Geometry::plane_strain);
  for (auto& facet : skin.facets) std::swap(facet.node[0], facet.node[1]);
  EXPECT_THROW(skin.properties(Geometry::plane_strain), std::invalid_argument);
}

// An open box without its lid, a x a x h: five faces of centre sum A z / sum A, h/2 of the four
// sides and 0 of the bottom; closed it is the middle. A cone's shell has its centre of area at a
// third of its height, and its volume at a quarter.
TEST(MassProperties, CentreOfAShapeIsThatOfItsVolumeOrWhereItIsOpenOfItsArea) {
  const Real a = 0.2, h = 0.6;
  auto skin = skin_of<3>(Box{{1, 1, 1}, {1 + a, 1 + a, 1 + h}}, {2, 2, 3}, Geometry::three_d);
  const auto center = [](const auto& of, Geometry geometry) {
    return center_of_shape(of.points, std::span(std::as_const(of.facets)), geometry);
  };
  EXPECT_LT((center(skin, Geometry::three_d) - Vec3(1.1, 1.1, 1 + h / 2)).norm(), 1e-13);
  std::erase_if(skin.facets, [&](const auto& facet) {
    return std::all_of(facet.node.begin(), facet.node.end(), [&](const LocalIndex node) {
      return skin.points.x[node][2] > 1 + h - 1e-9;
    });
  });
  for (auto& facet : skin.facets) facet.open = true;
  const Real height = 4 * a * h * (h / 2) / (4 * a * h + a * a);
  EXPECT_LT((center(skin, Geometry::three_d) - Vec3(1.1, 1.1, 1 + height)).norm(), 1e-13);

  PolygonShape cone;
  cone.points = {{0, 1}, {0.3, 1}, {0, 1.6}};
  auto ring = skin_of<2>(cone, {1, 1}, Geometry::axisymmetric);
  EXPECT_LT((center(ring, Geometry::axisymmetric) - Vec<2>(0, 1 + 0.6 / 4)).norm(), 1e-13);
  std::erase_if(ring.facets, [&](const auto& facet) {
    const auto& x = ring.points.x;
    return x[facet.node[0]][1] < 1.001 && x[facet.node[1]][1] < 1.001;
  });
  for (auto& facet : ring.facets) facet.open = true;
  std::erase_if(ring.facets, [&](const auto& facet) {
    return ring.points.x[facet.node[0]][0] + ring.points.x[facet.node[1]][0] < 1e-9;
  });
  EXPECT_LT((center(ring, Geometry::axisymmetric) - Vec<2>(0, 1 + 0.6 / 3)).norm(), 1e-13);
}

}  // namespace
}  // namespace brunt
