// Four faces at once are within reach of a particle where each of them is by itself, whatever side
// it is on: quads and boxes at random about it, also such without area, and points that lie on the
// sides of the boxes.
#include "contact/evaluate/near_faces.hpp"

#include <gtest/gtest.h>

#include <random>

namespace brunt {
namespace {

/// One particle at x with faces about it.
Entities<3> about(const Vec3& x, Real radius, std::mt19937_64& random) {
  std::uniform_real_distribution<Real> noise(-1, 1);
  const auto any = [&] { return Vec3(noise(random), noise(random), noise(random)); };
  Entities<3> entities;
  entities.particles.emplace_back().radius = radius;
  entities.nodes.x.push_back(x);
  entities.nodes.v.emplace_back(Vec3::Zero());
  entities.nodes.mass.push_back(1);
  for (int f = 0; f < 4; ++f) {
    FacePlane<3> plane;
    const Vec3 at = x + 3 * radius * any();
    for (auto& corner : plane.corner) corner = at + any();
    if (random() % 10 == 0) plane.corner.fill(at);
    refresh(plane);
    SearchBox<3> box = box_of(plane, 0);
    const std::size_t c = random() % 3;
    const Real side = x[static_cast<int>(c)] + (random() % 2 == 0 ? 1.0 : -1.0) * radius;
    if (random() % 4 == 0) box.lo[c] = side;
    if (random() % 4 == 0) box.hi[c] = side;
    entities.planes.push_back(plane);
    entities.boxes.push_back(box);
  }
  return entities;
}

TEST(NearFaces, FourAtOnceAreAsEach) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<Real> noise(-1, 1);
  int reached = 0, before = 0, touching = 0;
  for (int trial = 0; trial < 10000; ++trial) {
    const Real radius = std::pow(10.0, noise(random));
    const Vec3 x(noise(random), noise(random), noise(random));
    const Entities<3> entities = about(x, radius, random);
    const Present<3> now(entities, Section{Geometry::three_d}, 0);
    const LocalIndex faces[] = {2, 0, 3, 1};
    const Real farthest = 1.1 * radius;
    const FourReaches four = reaches_of(entities, faces, now, farthest);
    for (int k = 0; k < kLanes; ++k) {
      const auto& plane = entities.planes[slot_of(faces[k])];
      const auto& box = entities.boxes[slot_of(faces[k])];
      const Real in_front = plane.normal.dot(x - plane.center);
      const Reach one = reach_of<3>(plane, box, now, in_front);
      EXPECT_EQ(four.in_front[k], in_front);
      EXPECT_EQ((four.any >> k & 1U) != 0, one.any);
      EXPECT_EQ((four.before >> k & 1U) != 0, one.before);
      const bool touches = !(now.about.squared_distance(box) > farthest * farthest);
      EXPECT_EQ((four.touches >> k & 1U) != 0, touches);
      reached += one.any ? 1 : 0, before += one.before ? 1 : 0, touching += touches ? 1 : 0;
    }
    if (HasFailure()) break;
  }
  for (const int seen : {reached, before, touching}) {
    EXPECT_GT(seen, 2000);
    EXPECT_LT(seen, 38000);
  }
}

}  // namespace
}  // namespace brunt
