// Where the surface of a facet ends. A box of 2 x 1 x 1 quads ends at its edges, of 90 degrees, and
// not between the two quads of a side. A strip that bends by 30 degrees goes on, by 50 it ends if
// it turns away, and goes on if it turns up: nothing gets in over an inner edge. What has no
// neighbour ends.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/open_surface.hpp"

namespace brunt {
namespace {

template <int Dim>
Facet<Dim> facet(const std::array<LocalIndex, Facet<Dim>::kNodes>& node) {
  Facet<Dim> made;
  made.node = node;
  return made;
}

TEST(SurfaceBorders, OfABoxAreItsEdges) {
  // Points (i, j, k), i = 0 .. 2, number i + 3 j + 6 k; the top of two quads and the side at x = 2.
  std::vector<Vec3> x;
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 3; ++i) x.emplace_back(i, j, k);
    }
  }
  std::vector<Facet<3>> facets = {facet<3>({6, 7, 10, 9}), facet<3>({7, 8, 11, 10}),
                                  facet<3>({2, 5, 11, 8})};
  mark_borders<3>(facets, x);
  EXPECT_EQ(facets[0].borders, 0b1101);  // goes on behind its second edge alone
  EXPECT_EQ(facets[1].borders, 0b0111);  // and this before its fourth: the side turns away
  EXPECT_EQ(facets[2].borders, 0b1111);
}

TEST(SurfaceBorders, OfAStripFollowItsBend) {
  const auto bent = [](Real degrees) {
    const Real a = degrees * kPi / 180;
    const std::vector<Vec<2>> x = {Vec<2>(1, 0), Vec<2>(0, 0), Vec<2>(-std::cos(a), -std::sin(a))};
    std::vector<Facet<2>> facets = {facet<2>({0, 1}), facet<2>({1, 2})};  // normals up
    mark_borders<2>(facets, x);
    return std::array<int, 2>{facets[0].borders, facets[1].borders};
  };
  EXPECT_EQ(bent(30), (std::array<int, 2>{0b01, 0b10}));
  EXPECT_EQ(bent(50), (std::array<int, 2>{0b11, 0b11}));
  EXPECT_EQ(bent(-50), (std::array<int, 2>{0b01, 0b10}));
}

TEST(SurfaceBorders, OfATriangleAloneAreAllOfThem) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  std::vector<Facet<3>> facets = {facet<3>({0, 1, 2, -1})};
  mark_borders<3>(facets, x);
  EXPECT_EQ(facets[0].borders, 0b0111);
}

// Two sides that share an edge, edge 0 of the first and edge 0 of the second, at 20 and 40 degrees.
TEST(SurfaceBorders, OfABladeAreMarkedAsSuch) {
  const auto sides = [](Real degrees) {
    const Real w = std::tan(0.5 * degrees * kPi / 180);
    const std::vector<Vec3> x = {{0, 0, 1},  {0, 0, 0},   {w, -1, 0},
                                 {w, -1, 1}, {-w, -1, 0}, {-w, -1, 1}};
    std::vector<Facet<3>> facets = {facet<3>({1, 0, 3, 2}), facet<3>({0, 1, 4, 5})};
    mark_borders<3>(facets, x);
    return std::array<int, 2>{facets[0].borders, facets[1].borders};
  };
  const std::array<int, 2> sharp = sides(20), blunt = sides(40);
  EXPECT_EQ(sharp, (std::array<int, 2>{0b00011111, 0b00011111}));
  EXPECT_EQ(blunt, (std::array<int, 2>{0b00001111, 0b00001111}));
}

// A needle of square section whose sides lean by 10 degrees against its axis: sides that share
// nothing but the point stand opposite each other, and its base has the right angles of a box less
// those 10 degrees. A box is as sharp as all that is blunter.
TEST(SurfaceSharpness, IsThatOfTheSharpestCorner) {
  const Real a = 10 * kPi / 180, h = 1 / std::tan(a);
  const std::vector<Vec3> x = {{0, 0, h}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  std::vector<Facet<3>> facets = {facet<3>({1, 2, 0, -1}), facet<3>({2, 3, 0, -1}),
                                  facet<3>({3, 4, 0, -1}), facet<3>({4, 1, 0, -1}),
                                  facet<3>({1, 4, 3, 2})};
  mark_sharpness<3>(facets, x);
  for (std::size_t f = 0; f < 4; ++f) EXPECT_NEAR(facets[f].sharpness, std::sin(a), 1e-15);
  EXPECT_NEAR(facets[4].sharpness, std::sin(0.5 * (0.5 * kPi - a)), 1e-15);
  std::vector<Facet<3>> plate = {facet<3>({1, 2, 3, 4})};
  mark_sharpness<3>(plate, x);
  EXPECT_EQ(plate[0].sharpness, kBoxSharpness);
}

}  // namespace
}  // namespace brunt
