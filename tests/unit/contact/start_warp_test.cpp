// A face that is 2 m wide now and was `start` at time 0 is split where its warp is beyond 12 % of
// the smaller width: of 0.5 m 60 mm, of 4 m the 240 mm that its width now allows.
#include "contact/surfaces/start_warp.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

bool is_one_plane(Real warp, Real start) {
  FacePlane<3> plane;
  plane.corner = {Vec3(0, 0, warp), {2, 0, -warp}, {2, 2, warp}, {0, 2, -warp}};
  refresh(plane);
  ContactFace<3> face;
  face.area_start = start * start;
  return plane.simple && is_flat_as_of_start(face, plane);
}

TEST(StartWarp, IsMeasuredByTheSmallerOfTheWidthsNowAndAtTimeZero) {
  EXPECT_TRUE(is_one_plane(0.059, 0.5));
  EXPECT_FALSE(is_one_plane(0.061, 0.5));
  EXPECT_TRUE(is_one_plane(0.23, 4));
  EXPECT_FALSE(is_one_plane(0.25, 4));
}

}  // namespace
}  // namespace brunt
