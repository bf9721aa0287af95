// Half thicknesses of closed rigid bodies against closed forms: t/2 of a plate, s tan(a/2) of a
// wedge of angle a at s from its tip, half the wall of a tube and a ball's radius.
#include "core/rigid/half_thickness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace brunt {
namespace {

constexpr Real kMost = 2;  // [m]

template <int Dim>
struct Body {
  std::vector<Vec<Dim>> x;
  std::vector<Facet<Dim>> facets;

  void find() { find_half_thickness<Dim>(x, kMost, facets); }
};

void expect_half(Real found, Real expected, const std::string& what = "") {
  if (std::isinf(expected)) {
    EXPECT_EQ(found, expected) << what;
  } else {
    EXPECT_NEAR(found, expected, 1e-12) << what;  // lengths of 10, rounded
  }
}

/// Corners of a polygon run counter-clockwise.
void add_polygon(const std::vector<Vec<2>>& corners, Label piece, Body<2>& body) {
  const auto first = static_cast<LocalIndex>(body.x.size());
  const auto n = static_cast<LocalIndex>(corners.size());
  body.x.insert(body.x.end(), corners.begin(), corners.end());
  for (LocalIndex i = 0; i < n; ++i) {
    auto& facet = body.facets.emplace_back();
    facet.node = {first + i, first + (i + 1) % n};
    facet.piece = piece;
  }
}

/// A box of n x n x 1 cells, of quads, or of two triangles each.
Body<3> box(const Vec3& size, int n, bool triangles) {
  Body<3> body;
  const auto node = [&](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j <= n; ++j) {
      for (int i = 0; i <= n; ++i) {
        body.x.push_back(size.cwiseProduct(Vec3(Real(i) / n, Real(j) / n, k)));
      }
    }
  }
  const auto add = [&](int a, int b, int c, int d) {
    if (!triangles) body.facets.emplace_back().node = {a, b, c, d};
    if (triangles) body.facets.emplace_back().node = {a, b, c, -1};
    if (triangles) body.facets.emplace_back().node = {a, c, d, -1};
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      add(node(i, j, 0), node(i, j + 1, 0), node(i + 1, j + 1, 0), node(i + 1, j, 0));
      add(node(i, j, 1), node(i + 1, j, 1), node(i + 1, j + 1, 1), node(i, j + 1, 1));
    }
    add(node(i, 0, 0), node(i + 1, 0, 0), node(i + 1, 0, 1), node(i, 0, 1));
    add(node(i + 1, n, 0), node(i, n, 0), node(i, n, 1), node(i + 1, n, 1));
    add(node(0, i + 1, 0), node(0, i, 0), node(0, i, 1), node(0, i + 1, 1));
    add(node(n, i, 0), node(n, i + 1, 0), node(n, i + 1, 1), node(n, i, 1));
  }
  return body;
}

TEST(HalfThickness, OfPlatesAnyHowCut) {
  const Vec3 size(9, 8, 0.3);
  for (const int n : {1, 3, 40}) {
    for (const bool triangles : {false, true}) {
      auto body = box(size, n, triangles);
      body.find();
      std::size_t sides = 0;
      for (const auto& facet : body.facets) {
        const auto z = [&](std::size_t c) {
          return body.x[static_cast<std::size_t>(facet.node[c])][2];
        };
        const bool side = z(0) != z(1) || z(1) != z(2);
        sides += side ? 1 : 0;
        expect_half(facet.half_thickness, side ? kInfinity : 0.15, std::to_string(n));
      }
      EXPECT_EQ(sides, static_cast<std::size_t>(4 * n * (triangles ? 2 : 1)));
    }
  }
}

TEST(HalfThickness, OfTurnedPlatesInThePlane) {
  for (const Real angle : {0.0, 0.3, 2.0}) {
    const Vec<2> along(std::cos(angle), std::sin(angle)), up(-along[1], along[0]);
    Body<2> body;
    add_polygon({Vec<2>(0, 0), 20 * along, 20 * along + 3 * up, 3 * up}, 0, body);
    body.find();
    const Real expected[] = {1.5, kInfinity, 1.5, kInfinity};
    for (std::size_t f = 0; f < 4; ++f) {
      expect_half(body.facets[f].half_thickness, expected[f]);
    }
  }
}

// The places nearest to the tip are half an eighth of the facet from it; sharp edges of more than
// 30 degrees are no plates.
TEST(HalfThickness, WedgesOfLessThanThirtyDegreesArePlates) {
  for (const Real degrees : {5.0, 20.0, 29.0, 31.0, 60.0, 90.0}) {
    const Real angle = degrees * kPi / 180, length = 40;
    Body<2> body;
    add_polygon(
        {Vec<2>(0, 0), Vec<2>(length, 0), length * Vec<2>(std::cos(angle), std::sin(angle))}, 0,
        body);
    body.find();
    const Real half = degrees < 30 ? length / 16 * std::tan(angle / 2) : kInfinity;
    expect_half(body.facets[0].half_thickness, half, std::to_string(degrees));
    expect_half(body.facets[2].half_thickness, half, std::to_string(degrees));
  }
}

TEST(HalfThickness, OfATubeAndARod) {
  constexpr int kSides = 64;
  for (const bool tube : {true, false}) {
    std::vector<Vec<2>> outer, inner;
    for (int i = 0; i < kSides; ++i) {
      const Real angle = 2 * kPi * i / kSides;
      outer.emplace_back(std::cos(angle), std::sin(angle));
      inner.emplace_back(0.9 * std::cos(angle), -0.9 * std::sin(angle));
    }
    Body<2> body;
    add_polygon(outer, 0, body);
    if (tube) add_polygon(inner, 0, body);
    body.find();
    const Real apothem = std::cos(kPi / kSides);
    for (const auto& facet : body.facets) {
      expect_half(facet.half_thickness, tube ? 0.05 * apothem : apothem);
    }
  }
}

// Open surfaces, faces of elements, and another piece that lies behind.
TEST(HalfThickness, OfNothingElse) {
  Body<2> body;
  const std::vector<Vec<2>> plate = {{0, 0}, {5, 0}, {5, 0.5}, {0, 0.5}};
  add_polygon(plate, 0, body);
  add_polygon({{0, -1}, {5, -1}, {5, -0.5}, {0, -0.5}}, 1, body);
  for (std::size_t f = 4; f < 8; ++f) body.facets[f].open = true;
  body.find();
  for (std::size_t f = 0; f < 8; ++f) {
    EXPECT_EQ(body.facets[f].half_thickness, f == 0 || f == 2 ? 0.25 : kInfinity) << f;
  }
  for (auto& facet : body.facets) facet.stiffness = 1, facet.half_thickness = 7;
  body.find();
  for (const auto& facet : body.facets) EXPECT_EQ(facet.half_thickness, kInfinity);
  for (auto& facet : body.facets) facet.compliance = 1;  // of free rigid bodies
  body.find();
  EXPECT_EQ(body.facets[0].half_thickness, 0.25);
}

}  // namespace
}  // namespace brunt
