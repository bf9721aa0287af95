/// A quad that is in no list has no plane, but what it says of steps and of how long lists hold is,
/// bit for bit, what it says where it has one: which faces are listed depends on the skin, and no
/// answer may. Quads and triangles at random, held ones and such without an area among them, are
/// moved at random; listed are all, none, or some of them at random.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>

#include "tests/unit/contact/contact_scene.hpp"

namespace brunt {
namespace {

using testing::ContactScene;

struct Faces {
  ContactScene<3> scene;
  std::vector<Surface<3>*> surfaces;
  std::unique_ptr<Entities<3>> entities;

  explicit Faces(unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<Real> noise(0, 1);
    for (int body = 0; body < 3; ++body) {
      auto& group = scene.add_group();
      for (int k = 0; k < 7; ++k) {
        std::vector<Vec3> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        if (k == 3) corners.pop_back();
        if (k == 4) corners[2] = corners[0];
        for (auto& corner : corners) {
          if (k != 4) corner += 0.2 * Vec3(noise(random), noise(random), noise(random));
          corner += Vec3(2 * k, 2 * body, 0);
        }
        scene.add_face(group, corners, (1 + noise(random)) * 1e9, 1 + noise(random), 1);
      }
      group.surface.held = body == 2;
    }
    for (auto& one : scene.groups) surfaces.push_back(&one.surface);
    const PairTable pairs(scene.options, surfaces, {"a", "b", "c"});
    entities =
        std::make_unique<Entities<3>>(surfaces, pairs, Section{}, ContactRanks{}, RigidSprings{});
    entities->refresh_planes();
  }
  /// size  [1] of the motion: up to a third of a face
  void move(unsigned seed, Real size = 1) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<Real> noise(-1, 1);
    for (auto& x : entities->nodes.x)
      x += 0.3 * size * Vec3(noise(random), noise(random), noise(random));
    entities->refresh_planes();
  }
};

Eigen::Index slot(std::size_t c) { return static_cast<Eigen::Index>(c); }

void expect_bits(Real a, Real b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << " " << b;
}

// What moves little says next to nothing, and most of it is passed by.
TEST(UnlistedFaces, BoundStepsAndListsAsListedOnesDo) {
  constexpr std::array<Real, 4> kSizes = {1, 0.1, 1e-3, 0};
  int bound_by_unlisted = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const Real size = kSizes[seed % kSizes.size()];
    Faces all(seed);
    const std::size_t n = all.entities->faces.size();
    all.entities->mark_planes(std::vector<char>(n, 1));
    EXPECT_TRUE(all.entities->unlisted.empty());
    all.move(seed, size);
    for (const int part : {0, 1, 2, 3, 4}) {
      Faces some(seed);
      std::mt19937_64 random(seed + part);
      std::vector<char> in_lists(n, 0);
      for (auto& one : in_lists) one = part > 0 && random() % 4 < unsigned(part) ? 1 : 0;
      some.entities->mark_planes(in_lists);
      some.move(seed, size);
      expect_bits(some.entities->warped, all.entities->warped);
      const StepLimit &limit = some.entities->surface_limit, &same = all.entities->surface_limit;
      EXPECT_LT(same.step, kInfinity);
      expect_bits(limit.step, same.step);
      EXPECT_EQ(limit.entity, same.entity);
      const auto& unlisted = some.entities->unlisted;
      if (part == 0) {
        EXPECT_EQ(unlisted.size(), 18u);  // all but the triangles
      }
      for (const auto& quad : unlisted) {
        bound_by_unlisted += some.entities->faces[slot_of(quad.face)].id == limit.entity ? 1 : 0;
      }
    }
  }
  EXPECT_GT(bound_by_unlisted, 300);
}

// Quads in lists have what each face has by itself before there are lists.
TEST(ListedQuads, HaveThePlanesThatFacesHaveByThemselves) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Faces one_by_one(seed), listed(seed);
    auto &expected = *one_by_one.entities, &found = *listed.entities;
    const std::size_t n = expected.faces.size();
    found.mark_planes(std::vector<char>(n, 1));
    EXPECT_EQ(found.listed_quads.size(), 20u);  // 18 in fours
    EXPECT_EQ(found.listed_others.size(), 3u);
    const Real size = seed % 2 == 0 ? 1 : 1e-3;
    one_by_one.move(seed, size), listed.move(seed, size);
    expected.refresh_reaches(), found.refresh_reaches();
    expect_bits(found.surface_limit.step, expected.surface_limit.step);
    EXPECT_EQ(found.surface_limit.entity, expected.surface_limit.entity);
    Real warped = 0;
    for (std::size_t f = 0; f < n; ++f) {
      const auto &plane = found.planes[f], &same = expected.planes[f];
      warped = std::max(warped, same.warp - found.shapes[f].warp);
      expect_bits(plane.area, same.area);
      expect_bits(plane.warp, same.warp);
      EXPECT_EQ(plane.simple, same.simple);
      EXPECT_EQ(plane.flat, same.flat);
      for (std::size_t c = 0; c < 3; ++c) {
        expect_bits(plane.normal[slot(c)], same.normal[slot(c)]);
        expect_bits(plane.center[slot(c)], same.center[slot(c)]);
        for (std::size_t k = 0; k < slot_of(same.n_corners); ++k) {
          expect_bits(plane.corner[k][slot(c)], same.corner[k][slot(c)]);
        }
        expect_bits(found.boxes[f].lo[c], expected.boxes[f].lo[c]);
        expect_bits(found.boxes[f].hi[c], expected.boxes[f].hi[c]);
        expect_bits(found.reaches[f].lo[c], expected.reaches[f].lo[c]);
        expect_bits(found.reaches[f].hi[c], expected.reaches[f].hi[c]);
      }
    }
    expect_bits(found.warped, warped);
  }
}

// What asks for the planes of all faces between two builds of lists gets them.
TEST(UnlistedFaces, HavePlanesWhereTheyAreAskedFor) {
  Faces all(1), none(1);
  const std::size_t n = all.entities->faces.size();
  none.entities->mark_planes(std::vector<char>(n, 0));
  all.move(2), none.move(2);
  none.entities->refresh_unlisted_planes();
  for (std::size_t f = 0; f < n; ++f) {
    expect_bits(none.entities->planes[f].area, all.entities->planes[f].area);
    for (std::size_t c = 0; c < 3; ++c) {
      expect_bits(none.entities->boxes[f].lo[c], all.entities->boxes[f].lo[c]);
      expect_bits(none.entities->boxes[f].hi[c], all.entities->boxes[f].hi[c]);
    }
  }
}

}  // namespace
}  // namespace brunt
