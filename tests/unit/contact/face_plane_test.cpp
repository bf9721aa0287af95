// A quad whose corners stand alternately w over and under a plane has warp w; it is split beyond 5
// % of sqrt(area), or where it is not convex. Halves add up to the area of the quad's projection.
#include "contact/geometry/face_plane.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

FacePlane<3> quad(const std::array<Vec3, 4>& corners) {
  FacePlane<3> face;
  face.corner = corners;
  refresh(face);
  return face;
}

FacePlane<3> warped(Real w) { return quad({Vec3(0, 0, w), {2, 0, -w}, {2, 2, w}, {0, 2, -w}}); }

TEST(FacePlane, MeanPlaneOfAWarpedQuad) {
  const auto face = warped(0.23);
  EXPECT_NEAR(face.warp, 0.23, 1e-15);
  EXPECT_NEAR(face.area, 4, 1e-15);
  EXPECT_LT((face.normal - Vec3::UnitZ()).norm(), 1e-15);
  EXPECT_LT((face.center - Vec3(1, 1, 0)).norm(), 1e-15);
  EXPECT_TRUE(face.simple);           // 0.23 <= 0.12 * 2
  EXPECT_FALSE(warped(0.25).simple);  // 0.25 > 0.12 * 2
  EXPECT_FALSE(face.flat);
  EXPECT_TRUE(warped(0.009).flat);  // 0.009 <= 0.005 * 2
}

// A fan of triangles has the vector area of its border, whatever lies in its middle.
TEST(FacePlane, SplitsIntoFourTrianglesAboutItsCentre) {
  auto face = warped(0.25);
  face.borders = 0b0110;
  const auto parts = split(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(parts[i].corner[0], face.corner[i]);
    EXPECT_EQ(parts[i].corner[1], face.corner[(i + 1) % 4]);
    EXPECT_EQ(parts[i].corner[2], face.center);
    EXPECT_EQ(parts[i].borders, face.borders >> i & 1);
    sum += parts[i].area * parts[i].normal;
  }
  EXPECT_LT((sum - face.area * face.normal).norm(), 1e-15);
}

TEST(FacePlane, TrianglesOfAConcaveQuadThatAreTurnedOverAreNone) {
  const auto face = quad({Vec3(0, 0, 0), {4, 0, 0}, {1, 1, 0}, {0, 4, 0}});
  EXPECT_FALSE(face.simple);
  const auto parts = split(face);
  for (const std::size_t i : {0, 3}) EXPECT_NEAR(parts[i].normal[2], 1, 1e-15);
  for (const std::size_t i : {1, 2}) EXPECT_EQ(parts[i].area, 0);  // beyond the inward corner
}

TEST(FacePlane, FaceWithoutAreaOrWithANaNIsNone) {
  EXPECT_EQ(quad({Vec3(1, 1, 1), {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).area, 0);
  const auto broken = quad({Vec3(0, 0, std::nan("")), {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
  EXPECT_EQ(broken.area, 0);
  EXPECT_EQ(broken.normal.norm(), 0);
}

TEST(FacePlane, EdgeHasTheBodyOnItsLeft) {
  FacePlane<2> edge;
  edge.corner = {Vec<2>(0, 0), Vec<2>(2, 0)};
  refresh(edge);
  EXPECT_EQ(edge.normal, Vec<2>(0, -1));
  EXPECT_EQ(edge.area, 2);
  const auto box = box_of(edge, 0.5);
  EXPECT_EQ(box.lo[0], -0.5);
  EXPECT_EQ(box.hi[1], 0.5);
}

}  // namespace
}  // namespace brunt
