/// Fields at a place: shape functions and moving least squares are exact for a + b.x (partition of
/// unity and first moments of their weights), whatever the shape of elements and the order of
/// particles; tolerances are rounding of the inverse map and of a 4 x 4 system.
#include "app/scene/place.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

Real linear(Real x, Real y, Real z) { return 3 - 2 * x + 5 * y + 0.5 * z; }

std::vector<Real> linear_field(const BodyView& view) {
  std::vector<Real> values;
  for (std::size_t i = 0; i < view.position.size(); i += 3) {
    values.push_back(linear(view.position[i], view.position[i + 1], view.position[i + 2]));
  }
  return values;
}

/// Two quadrilaterals side by side, skewed.
BodyView quads() {
  BodyView view;
  view.corners = 4, view.cell_dimension = 2;
  view.position = {0, 0, 0, 1, 0.2, 0, 2, -0.1, 0, 0.1, 1, 0, 1.2, 0.9, 0, 2.1, 1.3, 0};
  view.connectivity = {0, 1, 4, 3, 1, 2, 5, 4};
  return view;
}

/// One hexahedron, its upper face turned and drawn in.
BodyView hex() {
  BodyView view;
  view.corners = 8, view.cell_dimension = 3;
  view.position = {0,   0,   0,   1,   0,   0, 1.1, 1.2, 0.1, 0,   1,   0,
                   0.2, 0.1, 1.1, 0.9, 0.2, 1, 0.8, 0.9, 1.2, 0.1, 0.8, 0.9};
  view.connectivity = {0, 1, 2, 3, 4, 5, 6, 7};
  return view;
}

TEST(Place, IsExactForLinearFieldsInElements) {
  const BodyView plane = quads();
  for (const auto& at : {std::vector<Real>{0.7, 0.6}, {1.6, 0.4}, {1.1, 0.55}}) {
    const Place place = find_place(plane, at);
    EXPECT_EQ(place.points.size(), 4U);
    EXPECT_NEAR(value_at(place, linear_field(plane), false), linear(at[0], at[1], 0), 1e-12);
  }
  EXPECT_EQ(find_place(plane, {0.7, 0.6}).cell, 0U);
  EXPECT_EQ(find_place(plane, {1.6, 0.4}).cell, 1U);
  const BodyView space = hex();
  const Place place = find_place(space, {0.4, 0.7, 0.6});
  EXPECT_EQ(place.points.size(), 8U);
  EXPECT_NEAR(value_at(place, linear_field(space), false), linear(0.4, 0.7, 0.6), 1e-12);
}

TEST(Place, TetrahedraAreToldFromQuads) {
  BodyView view = hex();
  view.corners = 4;
  view.connectivity = {0, 1, 2, 4, 1, 2, 4, 6};
  const Place place = find_place(view, {0.5, 0.3, 0.2});
  EXPECT_EQ(place.cell, 0U);
  EXPECT_EQ(place.points.size(), 4U);
  EXPECT_NEAR(value_at(place, linear_field(view), false), linear(0.5, 0.3, 0.2), 1e-12);
  view.cell_dimension = 0;  // the same as facets of a surface: they hold no place
  EXPECT_EQ(find_place(view, {0.5, 0.3, 0.2}).points.size(), 1U);
}

TEST(Place, AtANodeIsItsValue) {
  const BodyView plane = quads();
  EXPECT_EQ(value_at(find_place(plane, {1.2, 0.9}), {0, 1, 2, 3, 4, 5}, false), 4.0);
}

TEST(Place, IsExactForLinearFieldsAmongParticles) {
  BodyView view;
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 4; ++j) {
      for (int k = 0; k < 3; ++k) {
        const Real shake = 0.07 * std::sin(1.0 + 12.0 * i + 5.0 * j + 3.0 * k);
        view.position.insert(view.position.end(), {i + shake, j - shake, k + 0.5 * shake});
        view.point_radius.push_back(0.5);
      }
    }
  }
  for (const auto& at : {std::vector<Real>{2.3, 1.6, 1.2}, {0.2, 0.1, 0.3}, {4.2, 3.1, 2.0}}) {
    const Place place = find_place(view, at);
    EXPECT_GT(place.points.size(), 4U);
    EXPECT_NEAR(value_at(place, linear_field(view), false), linear(at[0], at[1], at[2]), 1e-11);
  }
}

TEST(Place, OutsideIsTheNearestWithItsDistance) {
  const Place place = find_place(quads(), {2.1, 3.3});
  ASSERT_EQ(place.points.size(), 1U);
  EXPECT_EQ(place.points[0], 5U);
  EXPECT_NEAR(place.point_distance, 2, 1e-12);
  EXPECT_EQ(place.cell, 1U);
  EXPECT_GT(place.cell_distance, 2);
}

}  // namespace
}  // namespace brunt
