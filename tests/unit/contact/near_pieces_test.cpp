// Boxes that are left out meet none that their piece may touch: against all pairs, in random
// scenes.
#include "contact/search/near_pieces.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace brunt {
namespace {

using Boxes = std::vector<SearchBox<3>>;

struct Scene {
  Boxes boxes;
  std::vector<PieceKey> piece;
  std::vector<LocalIndex> near(const std::function<bool(PieceKey, PieceKey)>& may_meet) const {
    const auto piece_of = [&](std::size_t i) { return piece[i]; };
    return near_pieces<3>(boxes, piece_of, may_meet, SearchMode::grid);
  }
};

/// Some pieces of boxes of a side of 1 m in clouds of `width` [m] about places of their own.
Scene clouds(unsigned seed, int n_pieces, int n_boxes, Real width, Real apart) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<Real> in(-1, 1);
  const auto point = [&](Real scale) {
    return Vec3(scale * Vec3(in(random), in(random), in(random)));
  };
  Scene scene;
  for (int p = 0; p < n_pieces; ++p) {
    const Vec3 center = point(apart);
    for (int i = 0; i < n_boxes; ++i) {
      scene.boxes.push_back(SearchBox<3>::about(center + point(width), 0.5));
      scene.piece.emplace_back(static_cast<Label>(p / 2), static_cast<Label>(p % 2));
    }
  }
  return scene;
}

TEST(NearPieces, LeaveOutNothingThatMeets) {
  std::size_t left_out = 0, met = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Scene scene = clouds(seed, 6, 40, 4, 10);
    // Bodies 0 and 1 may not touch; pieces of body 2 touch themselves.
    const auto may_meet = [](PieceKey a, PieceKey b) {
      if (a == b) return a.first == 2;
      return a.first + b.first != 1;
    };
    const auto near = scene.near(may_meet);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    const std::set<LocalIndex> kept(near.begin(), near.end());
    left_out += scene.boxes.size() - kept.size();
    for (std::size_t i = 0; i < scene.boxes.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!may_meet(scene.piece[j], scene.piece[i])) continue;
        if (!scene.boxes[i].meets(scene.boxes[j])) continue;
        ++met;
        EXPECT_EQ(kept.count(static_cast<LocalIndex>(i)), 1u);
        EXPECT_EQ(kept.count(static_cast<LocalIndex>(j)), 1u);
      }
    }
  }
  EXPECT_GT(met, 1000u);
  EXPECT_GT(left_out, 1000u);
}

// A column of 100 boxes on one wide box, which its lowest two meet.
TEST(NearPieces, OfAColumnAreItsFoot) {
  Scene scene;
  for (int i = 0; i < 100; ++i) {
    scene.boxes.push_back(SearchBox<3>::about(Vec3(0, 0, i), 0.6));
    scene.piece.emplace_back(Label{0}, Label{0});
  }
  scene.boxes.push_back(SearchBox<3>::about(Vec3(0, 0, -10), 10.5));
  scene.piece.emplace_back(Label{1}, Label{0});
  const auto others = [](PieceKey a, PieceKey b) { return a != b; };
  EXPECT_EQ(scene.near(others), (std::vector<LocalIndex>{0, 1, 100}));
  const auto all = [](PieceKey, PieceKey) { return true; };
  EXPECT_EQ(scene.near(all).size(), 101u);
  // What has no box meets nothing.
  scene.boxes.back() = SearchBox<3>::empty();
  EXPECT_TRUE(scene.near(others).empty());
}

}  // namespace
}  // namespace brunt
