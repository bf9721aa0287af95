// A frame with a value that is no finite number, or none in single precision, is refused.
#include "app/watch/frame_check.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "core/errors.hpp"

namespace brunt {
namespace {

BodyView view_with(Real value) {
  BodyView view;
  view.body = "bar";
  view.position = {0, 1, 2};
  view.point_fields.push_back({"velocity", 3, {0, value, 0}});
  return view;
}

std::string said(const BodyView& view, const ContactView& contact = {}) {
  try {
    refuse_no_numbers({view}, contact, lone_rank());
  } catch (const PhysicsError& error) {
    return error.what();
  }
  return "";
}

TEST(FrameCheck, NamesTheBodyAndTheField) {
  EXPECT_EQ(said(view_with(1e30)), "");
  const auto nan = said(view_with(std::numeric_limits<Real>::quiet_NaN()));
  EXPECT_NE(nan.find("body bar, a frame: velocity is no finite number"), std::string::npos) << nan;
  EXPECT_NE(said(view_with(1e39)), "");  // infinite in the file
  EXPECT_NE(said(view_with(kInfinity)), "");
}

TEST(FrameCheck, LooksAtContactsToo) {
  ContactView contact;
  contact.pressure = {kInfinity};
  EXPECT_NE(said(view_with(0), contact).find("contact"), std::string::npos);
}

}  // namespace
}  // namespace brunt
