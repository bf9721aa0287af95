// Two faces with a soft layer over their spring: per k their pressure is s g + (1 - s) <g - d>, the
// slope of their energy s g^2/2 + (1 - s) <g - d>^2/2 by area. Flat faces show both as they are;
// wedges, whose force has all of the potential's share, push by minus the gradient of the energy,
// found here by central differences, of second order in the difference, corner by corner.
#include "contact/geometry/soft_layer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "contact/geometry/particle_face.hpp"

namespace brunt {
namespace {

constexpr SoftLayer kLayer{0.1, 0.02};

Real pressure(Real g) {
  return kLayer.softness * g + (1 - kLayer.softness) * std::max(g - kLayer.depth, 0.0);
}
Real energy(Real g) {
  const Real firm = std::max(g - kLayer.depth, 0.0);
  return 0.5 * (kLayer.softness * g * g + (1 - kLayer.softness) * firm * firm);
}

FacePlane<3> square(Real z, bool up) {
  FacePlane<3> face;
  face.n_corners = 4;
  const std::array<Vec3, 4> corner = {{{0, 0, z}, {1, 0, z}, {1, 1, z}, {0, 1, z}}};
  for (std::size_t c = 0; c < 4; ++c) face.corner[c] = corner[up ? c : 3 - c];
  refresh(face);
  return face;
}

FacePlane<2> edge(const Vec<2>& a, const Vec<2>& b) {
  FacePlane<2> face;
  face.n_corners = 2;
  face.corner = {a, b};
  refresh(face);
  return face;
}

TEST(SoftLayer, FlatFacesHaveItsPressureAndItsEnergy) {
  for (const Real g : {0.005, 0.019, 0.021, 0.05, 0.3}) {
    SCOPED_TRACE(g);
    Planes<3> space;
    ASSERT_EQ(layered_planes<3>(square(0, true), square(-g, false), {}, kLayer, space, {}), 1);
    EXPECT_NEAR(space[0].volume, pressure(g), 1e-14);
    EXPECT_NEAR(space[0].energy, energy(g), 1e-14);
    EXPECT_NEAR(space[0].layered, g, 1e-14);
    Planes<2> plane;
    const Section section{Geometry::plane_strain, 1};
    ASSERT_EQ(
        layered_planes<2>(edge({1, 0}, {0, 0}), edge({0, -g}, {1, -g}), section, kLayer, plane, {}),
        1);
    EXPECT_NEAR(plane[0].volume, pressure(g), 1e-14);
    EXPECT_NEAR(plane[0].energy, energy(g), 1e-14);
  }
}

// With s = 1 or deeper than d by far, and the barrier as it is: what lies over it takes nothing
// off.
TEST(SoftLayer, LeavesTheBarrierAsItIs) {
  const FaceBarrier barrier{0.1};
  for (const Real g : {0.05, 0.15, 0.3}) {
    Planes<3> plane;
    ASSERT_EQ(layered_planes<3>(square(0, true), square(-g, false), {}, kLayer, plane,
                                {.barrier = barrier}),
              1);
    EXPECT_NEAR(plane[0].volume, pressure(g) + barrier.pressure(g), 1e-13);
    EXPECT_NEAR(plane[0].energy, energy(g) + barrier.energy(g), 1e-13);
    EXPECT_NEAR(plane[0].mean_slope, barrier.tangent(g), 1e-12);
    EXPECT_DOUBLE_EQ(plane[0].barrier.strength, barrier.strength);
  }
}

template <int Dim>
struct Pair {
  FacePlane<Dim> lower, upper;
  Section section;
  FaceBarrier barrier;
  Planes<Dim> planes;

  Real energy() {
    refresh(lower), refresh(upper);
    const int n = layered_planes<Dim>(lower, upper, section, kLayer, planes, {.barrier = barrier});
    return n == 1 ? planes[0].energy : std::numeric_limits<Real>::quiet_NaN();
  }
};

/// Corners pushed as records do: volume along the normal by weight, and the pushes.
template <int Dim>
void expect_gradient(Pair<Dim> pair) {
  ASSERT_GT(pair.energy(), 0);
  const auto plane = pair.planes[0];
  ASSERT_EQ(plane.share, 1);
  const Real d = 1e-7;
  for (const bool upper : {false, true}) {
    auto& face = upper ? pair.upper : pair.lower;
    for (std::size_t k = 0; k < static_cast<std::size_t>(face.n_corners); ++k) {
      const Real weight = upper ? plane.upper_weight[k] : -plane.lower_weight[k];
      const Vec<Dim> force = weight * plane.volume * plane.normal +
                             (upper ? plane.upper_push[k] : plane.lower_push[k]);
      for (int c = 0; c < Dim; ++c) {
        const Real at = face.corner[k][c];
        face.corner[k][c] = at + d;
        const Real more = pair.energy();
        face.corner[k][c] = at - d;
        const Real less = pair.energy();
        face.corner[k][c] = at;
        // d over 2 cm of the layer, where the second derivative jumps.
        EXPECT_NEAR(-(more - less) / (2 * d), force[c], 1e-5 * plane.volume) << upper << k << c;
      }
    }
  }
}

// Faces that lean and go into each other by a part of their length: beyond the layer or not.
TEST(SoftLayer, WedgesPushByMinusTheGradientOfTheEnergy) {
  std::mt19937_64 generator(20261123);
  const auto random = [&](Real least, Real most) {
    return std::uniform_real_distribution<Real>(least, most)(generator);
  };
  for (int k = 0; k < 20; ++k) {
    SCOPED_TRACE(k);
    const Real lean = random(0.1, 0.6), tip = random(0.02, 0.1), x = random(0.2, 0.3);
    Pair<2> line;
    line.section = {k % 2 == 0 ? Geometry::plane_strain : Geometry::axisymmetric, 1};
    if (k % 3 == 0) line.barrier = {0.05};
    line.lower = edge({2, 0}, {0.1, 0});
    const Vec<2> at(x, -tip);
    line.upper = edge(at, at + Vec<2>(std::cos(lean), std::sin(lean)));
    expect_gradient(line);

    Pair<3> area;
    area.section = {Geometry::three_d, 1};
    area.lower.n_corners = area.upper.n_corners = 4;
    if (k % 3 == 0) area.barrier = {0.05};
    const Eigen::AngleAxis<Real> tilt(lean, Vec3(0.3, 1, 0).normalized());
    for (std::size_t c = 0; c < 4; ++c) {
      const Real u = c == 1 || c == 2 ? 1 : 0, v = c >= 2 ? 1 : 0;
      area.lower.corner[c] = Vec3(2 * u, 2 * v, 0);
      area.upper.corner[c] = Vec3(x, 0.3, -tip) + tilt * Vec3(-u, v, 0) + Vec3(1, 0, 0);
    }
    refresh(area.lower), refresh(area.upper);
    expect_gradient(area);
  }
}

TEST(SoftLayer, ParticlesHaveItToo) {
  const ParticleSpring spring{2, 3, 0.05, kLayer};
  for (const Real d : {0.004, 0.019, 0.03, 0.049, 0.07}) {
    const Real deep = std::max(d - 0.05, 0.0);
    EXPECT_NEAR(spring.force(d), 2 * pressure(d) + 3 * deep * deep * deep / 2.5e-3, 1e-15);
    const Real h = 1e-6;
    EXPECT_NEAR((spring.energy(d + h) - spring.energy(d - h)) / (2 * h), spring.force(d), 1e-9);
  }
}

// Pressed through the layer by a damper at its most, and back, faces lose 2 s k d^2: the triangle
// below it, twice. From 2 d on the damper is that of the spring below.
TEST(SoftLayer, TakesNoMoreThanTheEnergyOfItsDamper) {
  Real sum = 0;
  const int n = 1000;
  for (int i = 0; i < n; ++i) sum += kLayer.most_damped((i + 0.5) * 3 * 0.02 / n) * 3 * 0.02 / n;
  EXPECT_NEAR(2 * sum, 2 * 0.1 * 0.02 * 0.02, 1e-8);
  EXPECT_EQ(kLayer.damped(0.02), 1);
  EXPECT_DOUBLE_EQ(kLayer.damped(0.03), 0.5);
  EXPECT_EQ(kLayer.damped(0.04), 0);
}

}  // namespace
}  // namespace brunt
