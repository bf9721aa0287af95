// One quad at a time, two at a time, and its triangles one after another give the same bits:
// quads at random from flat to crossed, tiny and huge, with corners that coincide, and points that
// lie on corners, edges, diagonals and centres, or far away. So do many faces at once, triangles
// among them.
#include "contact/geometry/nearest_quads.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "contact/geometry/nearest_triangle.hpp"
#include "core/wide_lanes.hpp"

namespace brunt {
namespace {

void expect_same_number(Real a, Real b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << " " << b;
}

void expect_same(const NearestPoint<3>& a, const NearestPoint<3>& b) {
  for (int c = 0; c < 3; ++c) {
    expect_same_number(a.point[c], b.point[c]);
    expect_same_number(a.normal[c], b.normal[c]);
  }
  for (std::size_t c = 0; c < 4; ++c) expect_same_number(a.weight[c], b.weight[c]);
  expect_same_number(a.distance, b.distance);
  EXPECT_EQ(a.feature, b.feature);
  EXPECT_EQ(a.corner, b.corner);
  EXPECT_EQ(a.smooth, b.smooth);
}

/// Of triangle k of a quad with these weights, what of the quad is nearest.
void set_feature(const std::array<Real, 3>& w, int k, NearestPoint<3>& nearest) {
  const int next = (k + 1) % 4;
  nearest.smooth = w[0] != 0 && w[1] != 0 && w[2] != 0;
  if (w[2] != 0) return;
  if (w[0] != 0 && w[1] != 0) {
    nearest.feature = Feature::edge;
    nearest.corner = {k, next};
  } else {
    nearest.feature = Feature::vertex;
    nearest.corner.fill(w[0] != 0 ? k : next);
  }
}

NearestPoint<3> one_by_one(const FacePlane<3>& face, const Vec3& x) {
  NearestPoint<3> nearest;
  nearest.point.setZero(), nearest.normal.setZero();
  nearest.smooth = false;
  Real least = kInfinity;
  for (int k = 0; k < 4; ++k) {
    const auto a = slot_of(k), b = slot_of((k + 1) % 4);
    const Place<Real> t[3] = {place(face.corner[a]), place(face.corner[b]), place(face.center)};
    const auto found = nearest_on(t, place(x));
    if (!(found.squared_distance < least)) continue;
    least = found.squared_distance;
    nearest = NearestPoint<3>();
    nearest.distance = std::sqrt(least);
    nearest.point = Vec3(found.point.x, found.point.y, found.point.z);
    nearest.normal = Vec3(found.normal.x, found.normal.y, found.normal.z).normalized();
    const auto& w = found.weight;
    nearest.weight.fill(0.25 * w.z);
    nearest.weight[a] += w.x, nearest.weight[b] += w.y;
    set_feature({w.x, w.y, w.z}, k, nearest);
  }
  return nearest;
}

/// A quad, or a triangle, and a point that often lies where several of its parts are as near.
struct Scene {
  FacePlane<3> face;
  Vec3 x;

  Scene(std::mt19937_64& random, bool quad) {
    std::uniform_real_distribution<Real> noise(-1, 1);
    const auto any = [&] { return Vec3(noise(random), noise(random), noise(random)); };
    const Real rough = std::pow(10.0, 3 * noise(random) - 3);
    const Real size = std::pow(10.0, random() % 4 == 0 ? 60 * noise(random) : noise(random));
    const Vec3 at = random() % 2 == 0 ? Vec3(Vec3::Zero()) : Vec3(100 * size * any());
    const std::array<Vec3, 4> square{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    for (std::size_t c = 0; c < 4; ++c) {
      face.corner[c] = at + size * square[c];
      if (random() % 4 != 0) face.corner[c] += size * rough * any();
    }
    if (random() % 8 == 0) face.corner[random() % 4] = face.corner[random() % 4];
    if (random() % 50 == 0) face.corner.fill(at);
    if (!quad) face.n_corners = 3, face.corner[3].setZero();
    refresh(face);
    const Real along = random() % 2 == 0 ? 0.5 : 0.5 + noise(random);
    const std::array<Vec3, 6> from{face.corner[0], face.corner[1], face.corner[2],
                                   face.corner[3], face.center,    at};
    x = from[random() % 6] + along * (from[random() % 6] - from[random() % 6]);
    if (random() % 2 == 0) x += size * std::pow(10.0, 4 * noise(random)) * face.normal;
    if (random() % 4 == 0) x += size * any();
  }
};

TEST(NearestQuads, OneAndTwoAtATimeAreAsOneByOne) {
  std::mt19937_64 random(7);
  std::array<int, 3> features{};
  int nowhere = 0, creased = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    std::vector<Scene> scenes;
    std::vector<NearQuery<3>> queries;
    for (std::size_t k = 0; k < 1 + random() % 20; ++k) scenes.emplace_back(random, true);
    for (const auto& scene : scenes) queries.push_back({&scene.face, scene.x});
    std::vector<NearestPoint<3>> one(scenes.size()), two(scenes.size());
    nearest_on_quads<Pack>(queries.data(), queries.size(), one.data());
    if (can_run_wide()) nearest_on_quads<Wide>(queries.data(), queries.size(), two.data());
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      const auto expected = one_by_one(scenes[k].face, scenes[k].x);
      ++features[slot_of(expected.feature)];
      nowhere += expected.distance == kInfinity ? 1 : 0;
      creased += expected.feature == Feature::face && !expected.smooth ? 1 : 0;
      expect_same(one[k], expected);
      if (can_run_wide()) expect_same(two[k], expected);
      expect_same(nearest_point<3>(scenes[k].face, scenes[k].x), expected);
    }
    if (HasFailure()) break;
  }
  for (const int seen : {features[0], features[1], features[2], nowhere, creased}) {
    EXPECT_GT(seen, 100);
  }
}

TEST(NearestQuads, ManyFacesAtOnceAreAsEach) {
  std::mt19937_64 random(8);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<Scene> scenes;
    std::vector<NearQuery<3>> queries;
    for (std::size_t k = 0; k < random() % 12; ++k) scenes.emplace_back(random, random() % 3 != 0);
    for (const auto& scene : scenes) queries.push_back({&scene.face, scene.x});
    std::vector<NearestPoint<3>> found(scenes.size());
    nearest_points<3>(queries, found.data());
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      expect_same(found[k], nearest_point<3>(scenes[k].face, scenes[k].x));
    }
    if (HasFailure()) break;
  }
}

TEST(NearestQuads, InThePlaneManyAreAsEach) {
  FacePlane<2> face;
  face.corner = {Vec<2>(0, 0), Vec<2>(1, 0.5)};
  refresh(face);
  std::vector<NearQuery<2>> queries;
  for (int i = -3; i < 9; ++i) queries.push_back({&face, Vec<2>(0.2 * i, 0.3)});
  std::vector<NearestPoint<2>> found(queries.size());
  nearest_points<2>(queries, found.data());
  for (std::size_t k = 0; k < queries.size(); ++k) {
    const auto one = nearest_point<2>(face, queries[k].x);
    expect_same_number(found[k].distance, one.distance);
    EXPECT_EQ(found[k].feature, one.feature);
    EXPECT_EQ(found[k].point, one.point);
  }
}

}  // namespace
}  // namespace brunt
