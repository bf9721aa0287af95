// Views of several ranks in one: by ids, points as their owners have them.
#include "core/merge_views.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(MergeViews, TakesPointsFromTheirOwnersByIds) {
  BodyView first, second;
  first.body = "bar";
  first.corners = second.corners = 2;
  first.position = {3, 0, 0, 1, 0, 0, 99, 0, 0};
  first.point_owned = {1, 1, 0};  // the copy of point 2 has old values
  first.point_fields = {{"id", 1, {3, 1, 2}}, {"velocity", 1, {30, 10, 99}}};
  first.point_mass = {0.3, 0.1, 99};
  first.connectivity = {2, 0};
  first.cell_fields = {{"id", 1, {8}}};
  first.cell_volume = {0.8};
  second.position = {2, 0, 0, 99, 0, 0};
  second.point_owned = {1, 0};
  second.point_fields = {{"id", 1, {2, 1}}, {"velocity", 1, {20, 99}}};
  second.point_mass = {0.2, 99};
  second.connectivity = {1, 0, 0, -1};  // -1: no corner
  second.cell_fields = {{"id", 1, {7, 9}}};
  second.cell_volume = {0.7, 0.9};
  const BodyView merged = merge_views({first, second});
  EXPECT_EQ(merged.body, "bar");
  EXPECT_EQ(merged.position, (std::vector<Real>{1, 0, 0, 2, 0, 0, 3, 0, 0}));
  EXPECT_EQ(merged.point_fields.at(1).values, (std::vector<Real>{10, 20, 30}));
  EXPECT_EQ(merged.point_mass, (std::vector<Real>{0.1, 0.2, 0.3}));
  EXPECT_EQ(merged.connectivity, (std::vector<std::int64_t>{0, 1, 1, 2, 1, -1}));
  EXPECT_EQ(merged.cell_fields.at(0).values, (std::vector<Real>{7, 8, 9}));
  EXPECT_EQ(merged.cell_volume, (std::vector<Real>{0.7, 0.8, 0.9}));
  EXPECT_TRUE(merged.point_owned.empty());
}

TEST(MergeViews, TakesFieldsFromPartsThatHaveEntities) {
  BodyView none, particles;
  particles.position = {1, 2, 3};
  particles.point_fields = {{"id", 1, {4}}, {"density", 1, {1000}}};
  particles.point_radius = {0.5};
  const BodyView merged = merge_views({none, particles, none});
  EXPECT_EQ(merged.corners, 0);
  EXPECT_EQ(merged.point_fields.size(), 2u);
  EXPECT_EQ(merged.point_radius, particles.point_radius);
  EXPECT_TRUE(merge_views({none}).position.empty());
}

// Of what has wholly eroded nothing is left on any rank; a copy of another's point is nobody's.
TEST(MergeViews, KeepsTheNamesOfFieldsWhereNothingIsLeft) {
  BodyView none, gone, copy;
  gone.corners = copy.corners = 8;
  gone.point_fields = copy.point_fields = {{"id", 1, {}}, {"velocity", 3, {}}};
  gone.cell_fields = copy.cell_fields = {{"id", 1, {}}, {"stress", 6, {}}};
  copy.position = {1, 2, 3};
  copy.point_owned = {0};
  copy.point_fields = {{"id", 1, {4}}, {"velocity", 3, {7, 8, 9}}};
  const BodyView merged = merge_views({none, gone, copy});
  ASSERT_EQ(merged.point_fields.size(), 2u);
  EXPECT_EQ(merged.point_fields[1].name, "velocity");
  EXPECT_EQ(merged.point_fields[1].components, 3);
  EXPECT_TRUE(merged.point_fields[1].values.empty());
  ASSERT_EQ(merged.cell_fields.size(), 2u);
  EXPECT_EQ(merged.cell_fields[1].name, "stress");
  EXPECT_TRUE(merged.cell_fields[1].values.empty());
}

}  // namespace
}  // namespace brunt
