#pragma once
/// Bodies that were written and read back are the same, bit for bit.
#include <gtest/gtest.h>

#include "core/view.hpp"

namespace brunt::test {

inline void expect_same(const std::vector<Field>& a, const std::vector<Field>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].components, b[i].components);
    EXPECT_EQ(a[i].values, b[i].values) << a[i].name;
  }
}

inline void expect_same(const BodyView& a, const BodyView& b) {
  EXPECT_EQ(a.body, b.body);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.connectivity, b.connectivity);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.point_radius, b.point_radius);
  expect_same(a.point_fields, b.point_fields);
  expect_same(a.cell_fields, b.cell_fields);
}

}  // namespace brunt::test
