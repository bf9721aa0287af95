// What a rank writes of a body. Values of other ranks' points: tests/parallel/ranks.sh.
#include "app/watch/frame_piece.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

TEST(FramePiece, LeavesOutCopiesThatNoCellTouches) {
  BodyView view;
  view.corners = 2;
  view.position = {0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0};
  view.point_owned = {0, 0, 1, 1};  // point 5 is a copy for nothing; 7 has no cell, but is owned
  view.point_fields = {{"id", 1, {5, 6, 7, 8}}};
  view.point_mass = {0.5, 0.6, 0.7, 0.8};
  view.connectivity = {1, 3};
  view.cell_fields = {{"id", 1, {0}}};
  const BodyView piece = frame_piece(view, Partition{std::vector<std::int32_t>(9, 0)}, lone_rank());
  EXPECT_EQ(piece.position, (std::vector<Real>{1, 0, 0, 2, 0, 0, 3, 0, 0}));
  EXPECT_EQ(piece.point_owned, (std::vector<char>{0, 1, 1}));
  EXPECT_EQ(piece.point_fields.at(0).values, (std::vector<Real>{6, 7, 8}));
  EXPECT_EQ(piece.point_mass, (std::vector<Real>{0.6, 0.7, 0.8}));
  EXPECT_EQ(piece.connectivity, (std::vector<std::int64_t>{0, 2}));
  EXPECT_EQ(piece.cell_fields.size(), 1u);
}

TEST(FramePiece, HasNoCellFieldsWithoutCells) {
  BodyView view;
  view.corners = 2;
  view.position = {0, 0, 0};
  view.point_owned = {1};
  view.point_fields = {{"id", 1, {5}}};
  view.cell_fields = {{"eps_p", 1, {}}};
  const BodyView piece = frame_piece(view, Partition{std::vector<std::int32_t>(9, 0)}, lone_rank());
  EXPECT_TRUE(piece.cell_fields.empty());
  EXPECT_EQ(piece.position, view.position);
}

TEST(FramePiece, TellsTheRankOfAllThatItHas) {
  BodyView view;
  view.position.assign(12, 0.0);
  view.corners = 4, view.connectivity = {0, 1, 2, 3};
  add_owner(view, 2);
  EXPECT_EQ(field_named(view.point_fields, "rank")->values, std::vector<Real>(4, 2.0));
  EXPECT_EQ(field_named(view.cell_fields, "rank")->values, std::vector<Real>(1, 2.0));
  BodyView particles;
  particles.position.assign(3, 0.0);
  add_owner(particles, 1);
  EXPECT_EQ(field_named(particles.point_fields, "rank")->values, std::vector<Real>(1, 1.0));
  EXPECT_TRUE(particles.cell_fields.empty());
  BodyView none;
  add_owner(none, 1);
  EXPECT_TRUE(none.point_fields.empty());
}

}  // namespace
}  // namespace brunt
