// A face that is 2 m wide now and was `start` at time 0 is split where its warp is beyond 12 % of
// the smaller width: of 0.5 m 60 mm, of 4 m the 240 mm that its width now allows.
#include "contact/surfaces/start_warp.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

FacePlane<3> plane_of(Real warp, Real start) {
  FacePlane<3> plane;
  plane.corner = {Vec3(0, 0, warp), {2, 0, -warp}, {2, 2, warp}, {0, 2, -warp}};
  refresh(plane);
  ContactFace<3> face;
  face.area_start = start * start;
  compare_with_start(face, plane);
  return plane;
}

TEST(StartWarp, IsMeasuredByTheSmallerOfTheWidthsNowAndAtTimeZero) {
  EXPECT_TRUE(plane_of(0.059, 0.5).simple);
  EXPECT_FALSE(plane_of(0.061, 0.5).simple);
  EXPECT_TRUE(plane_of(0.23, 4).simple);
  EXPECT_FALSE(plane_of(0.25, 4).simple);
  EXPECT_TRUE(plane_of(0.0024, 0.5).flat);
  EXPECT_FALSE(plane_of(0.0026, 0.5).flat);
}

}  // namespace
}  // namespace brunt
