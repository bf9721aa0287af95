// A field that waits has, when it is read, the values that it would have had at once: both are the
// same function of an entity, so bit for bit.
#include "core/view_fields.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "core/materials/state_fields.hpp"

namespace brunt {
namespace {

/// Entities: none, part of a part, parts, and some more than that.
constexpr std::size_t kCounts[] = {0, 1, kFieldPart - 1, kFieldPart, 7 * kFieldPart + 3};

std::vector<Field> fields_of(std::size_t n, bool may_wait) {
  WantedFields wanted;
  wanted.may_wait = may_wait;
  std::vector<Field> fields;
  FieldAdder adder(wanted, fields);
  const auto number = std::make_shared<std::vector<Real>>(n);
  for (std::size_t k = 0; k < n; ++k) (*number)[k] = 1.0 / (3.0 + static_cast<Real>(k));
  adder.add("density", n, [number](std::size_t k) { return (*number)[k]; });
  adder.add("velocity", n, [number](std::size_t k) -> Vec<2> {
    return {(*number)[k], -(*number)[k]};
  });
  adder.add("stress", n, [number](std::size_t k) {
    const Real s = (*number)[k];
    return std::array<Real, 6>{s, 2 * s, 3 * s, 4 * s, 5 * s, 6 * s};
  });
  return fields;
}

TEST(ViewFields, WaitingOrNotHaveTheSameValues) {
  for (const std::size_t n : kCounts) {
    const auto at_once = fields_of(n, false);
    auto waiting = fields_of(n, true);
    ASSERT_EQ(at_once.size(), 3U);
    for (std::size_t f = 0; f < at_once.size(); ++f) {
      EXPECT_FALSE(at_once[f].fill);
      EXPECT_EQ(at_once[f].values.size(), n * slot_of(at_once[f].components));
      EXPECT_EQ(waiting[f].size(), at_once[f].size());
      EXPECT_TRUE(waiting[f].values.empty());
      make_values(waiting[f]);
      EXPECT_EQ(waiting[f].values, at_once[f].values) << at_once[f].name;
      make_values(waiting[f]);  // nothing is left to do
      EXPECT_EQ(waiting[f].size(), at_once[f].size());
    }
  }
}

TEST(ViewFields, PartsAreAllValuesOnce) {
  for (const bool may_wait : {false, true}) {
    for (const Field& field : fields_of(7 * kFieldPart + 3, may_wait)) {
      std::vector<Real> found(field.size(), -1);
      for_parts(field, [&found](std::size_t at, std::span<const Real> part) {
        for (std::size_t i = 0; i < part.size(); ++i) found[at + i] = part[i];
      });
      const auto again = fields_of(7 * kFieldPart + 3, false);
      EXPECT_EQ(found, field_named(again, field.name)->values);
    }
  }
}

TEST(ViewFields, APlanesVectorsHaveAThirdComponent) {
  const auto fields = fields_of(2, false);
  EXPECT_EQ(field_named(fields, "velocity")->values,
            (std::vector<Real>{1.0 / 3, -1.0 / 3, 0, 1.0 / 4, -1.0 / 4, 0}));
}

TEST(ViewFields, OnlyWhatIsWantedIsAdded) {
  WantedFields wanted;
  wanted.names = std::vector<std::string>{"velocity"};
  std::vector<Field> fields;
  FieldAdder adder(wanted, fields);
  adder.add("density", 1, [](std::size_t) -> Real { return 1; });
  adder.add("velocity", 1, [](std::size_t) -> Vec<3> { return {1, 2, 3}; });
  ASSERT_EQ(fields.size(), 1U);
  EXPECT_EQ(fields[0].values, (std::vector<Real>{1, 2, 3}));
}

// s = (2, -1, -1) + shear (3, 0, 0): s:s = 6 + 2 x 9, von Mises sqrt(3/2 x 24) = 6; stress s - p.
TEST(ViewFields, StressOfAState) {
  MaterialState state;
  const Real deviator[] = {2, -1, -1, 3, 0, 0};
  for (std::size_t i = 0; i < 6; ++i) state.deviator[i] = {deviator[i]};
  state.pressure = {10}, state.temperature = {300}, state.eps_p = {0.5};
  std::vector<Field> fields;
  const WantedFields all;
  FieldAdder adder(all, fields);
  add_state_fields(
      adder, 1, [&state](std::size_t k, const auto& value) { return value(state, k); },
      [&state](auto member) { return !(state.*member).empty(); }, false);
  ASSERT_EQ(fields.size(), 4U);  // no temperature: the body's own is another
  EXPECT_EQ(field_named(fields, "stress")->values, (std::vector<Real>{-8, -11, -11, 3, 0, 0}));
  EXPECT_EQ(field_named(fields, "pressure")->values, (std::vector<Real>{10}));
  EXPECT_EQ(field_named(fields, "von_mises")->values, (std::vector<Real>{6}));
  EXPECT_EQ(field_named(fields, "eps_p")->values, (std::vector<Real>{0.5}));
}

}  // namespace
}  // namespace brunt
