// An open surface has two sides: 1e5 particles shot at a sheet of triangles, thin
// as nothing, at twenty times their speed of sound, from both sides and from 0 to 89 degrees off
// its normal: none passes (the default test shoots 1,600), nor through a row of edges in the plane.
// Behind it they belong to the side from which they came, and around its rim they may go to the
// other.
#include <gtest/gtest.h>

#include <random>

#include "core/open_surface.hpp"
#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::add_sheet;
using testing::ContactScene;

// rho = 1000 kg/m^3, M = 1e9 Pa: c = 1000 m/s; spacing 1 mm.
constexpr Real kDensity = 1000, kModulus = 1e9, kSound = 1000, kSpacing = 1e-3;
constexpr Real kMass = kDensity * kSpacing * kSpacing * kSpacing;
constexpr Real kFar = 12 * kSpacing;  // from one shot to the next

/// A flat rigid sheet of 2 n n triangles over [-size, size]^2 with shared points, facing up.
void add_open_sheet(ContactScene<3>& scene, int n, Real size) {
  auto& group = scene.add_group();
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      scene.add_point(group, size * Vec3(2.0 * i / n - 1, 2.0 * j / n - 1, 0), 0);
    }
  }
  for (LocalIndex j = 0; j < n; ++j) {
    for (LocalIndex i = 0; i < n; ++i) {
      const LocalIndex a = j * (n + 1) + i, b = a + n + 1;
      for (const auto& corners : {std::array{a, a + 1, b + 1, -1}, {a, b + 1, b, -1}}) {
        auto& facet = group.surface.facets.emplace_back();
        facet.node = corners;
        scene.name(group, facet, 0, 0);
      }
    }
  }
  mark_open<3>(group.surface.facets);
}

/// The same in the plane: a row of n edges.
void add_open_sheet(ContactScene<2>& scene, int n, Real size) {
  add_sheet(scene, n, -size, 2 * size, 0, true, 0, 0);
  mark_open<2>(scene.groups.back().surface.facets);
}

template <int Dim>
Real step_of(const ContactScene<Dim>& scene) {
  return std::min(0.9 * scene.contact->stable_step().step, 0.7 * kSpacing / kSound);
}

/// Where a shot stands along the sheet, and a unit vector along it.
Vec3 place_of(int i, int j, Vec3) { return {i * kFar, j * kFar, 0}; }
Vec<2> place_of(int i, int, Vec<2>) { return {i * kFar, 0}; }
Vec3 along(Real around, Vec3) { return {std::cos(around), std::sin(around), 0}; }
Vec<2> along(Real around, Vec<2>) { return {std::cos(around) < 0 ? -1 : 1, 0}; }

/// Shoots row * row particles, or in the plane row.
template <int Dim>
void shoot_from_both_sides(int row) {
  ContactScene<Dim> scene;
  // At 89 degrees a particle flies 0.14 m before it touches, and as far again.
  add_open_sheet(scene, 16, 0.5 * row * kFar + 0.4);
  auto& group = scene.add_group();
  std::mt19937_64 random(11);
  std::uniform_real_distribution<Real> height(0.51, 2.5), angle(0, 89 * M_PI / 180),
      around(0, 2 * M_PI);
  std::vector<Real> side;
  for (int j = 0; j < (Dim == 3 ? row : 1); ++j) {
    for (int i = 0; i < row; ++i) {
      side.push_back(random() % 2 ? 1.0 : -1.0);
      Vec<Dim> start = place_of(i - row / 2, j - row / 2, Vec<Dim>());
      start[Dim - 1] = side.back() * height(random) * kSpacing;
      scene.add_particle(group, start, kSpacing / 2, kModulus, Dim == 3 ? kMass : kMass / kSpacing);
      const Real tilt = angle(random), turn = around(random);
      group.points.v.back() = 20 * kSound *
                              (std::sin(tilt) * along(turn, Vec<Dim>()) -
                               side.back() * std::cos(tilt) * Vec<Dim>::Unit(Dim - 1));
    }
  }
  scene.start();
  Real dt = 0;
  const auto all_left = [&] {
    for (std::size_t i = 0; i < side.size(); ++i) {
      const bool leaves = side[i] * group.points.v[i][Dim - 1] > 0;
      if (!leaves || side[i] * group.points.x[i][Dim - 1] < 0.5 * kSpacing) return false;
    }
    return true;
  };
  int steps = 0;
  for (; steps < 20000 && !(steps % 50 == 0 && all_left()); ++steps) {
    dt = step_of(scene);
    scene.step(dt);
  }
  int passed = 0;
  Real fastest = 0;
  for (std::size_t i = 0; i < side.size(); ++i) {
    passed += side[i] * group.points.x[i][Dim - 1] > 0 ? 0 : 1;
    fastest = std::max(fastest, group.points.v[i].norm());
  }
  EXPECT_TRUE(all_left());
  EXPECT_EQ(passed, 0);
  // The scheme's own error in a barrier that stiffens within a few steps.
  EXPECT_LT(fastest, 1.02 * 20 * kSound);
}

TEST(OpenSurface, NothingPassesAtTwentyTimesTheSpeedOfSound) { shoot_from_both_sides<3>(40); }
TEST(OpenSurface, NothingPassesARowOfEdges) { shoot_from_both_sides<2>(1600); }
TEST(OpenSurface, LongNothingOf1e5PassesAtTwentyTimesTheSpeedOfSound) {
  shoot_from_both_sides<3>(317);
}

// Round the rim: a particle that is held to no side while it is beside the rim rests on the back
// of the sheet as it would on its front.
TEST(OpenSurface, TheRimLetsRound) {
  ContactScene<3> scene;
  add_open_sheet(scene, 2, 5 * kSpacing);
  auto& group = scene.add_group();
  scene.add_particle(group, Vec3(4 * kSpacing, 0, 0.45 * kSpacing), kSpacing / 2, kModulus, kMass);
  scene.start();
  scene.evaluate();
  EXPECT_GT(group.points.f[0][2], 0);
  // Out over the rim, down beside it and back under the sheet.
  std::vector<Vec3> way = {{5.3, 0, 0.3}, {5.4, 0, 0}, {5.3, 0, -0.3}, {4, 0, -0.45}};
  for (const Vec3& place : way) {
    group.points.x[0] = kSpacing * place;
    scene.evaluate();
  }
  EXPECT_LT(group.points.f[0][2], 0);
  EXPECT_NEAR(group.points.f[0][2], -0.5 * kModulus * kSpacing * 0.05 * kSpacing,
              1e-9 * kModulus * kSpacing * kSpacing);
}

TEST(OpenSurface, ClosedPiecesHaveOneSide) {
  // A tetrahedron beside a single triangle, two pieces of one body.
  std::vector<Facet<3>> facets(5);
  const std::array<std::array<LocalIndex, 4>, 5> corners = {
      {{0, 2, 1, -1}, {0, 1, 3, -1}, {1, 2, 3, -1}, {0, 3, 2, -1}, {4, 5, 6, -1}}};
  for (std::size_t f = 0; f < 5; ++f) facets[f].node = corners[f];
  facets[4].piece = 1;
  mark_open<3>(facets);
  for (std::size_t f = 0; f < 4; ++f) EXPECT_FALSE(facets[f].open);
  EXPECT_TRUE(facets[4].open);
}

}  // namespace
}  // namespace brunt
