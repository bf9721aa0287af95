// Fields of points: whatever is listed in visit_fields has room, goes where its point goes, and is
// found again in rows, hashes and copies.
#include "core/points.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/points_state.hpp"

namespace brunt {
namespace {

SpecificHeat rising() {
  Varying cp;
  cp.over = Varying::Over::temperature;
  cp.abscissa = {300, 400}, cp.ordinate = {500, 600};
  return SpecificHeat(cp);
}

/// Points with all fields there are; every value is another one.
Points<3> full(LocalIndex n) {
  Points<3> points;
  points.resize(n);
  points.conduct(std::vector<Real>(points.x.size(), 300.0));
  points.keep_conduction();
  points.vary_capacities({rising()});
  int next = 1;
  Points<3>::visit_fields(points, [&](auto& field, FieldUse) {
    using T = typename std::remove_cvref_t<decltype(field)>::value_type;
    for (auto& value : field) {
      if constexpr (std::is_arithmetic_v<T>) {
        value = static_cast<T>(next++);
      } else {
        for (int c = 0; c < T::SizeAtCompileTime; ++c) value[c] = next++;
      }
    }
  });
  return points;
}

std::uint64_t hash_of(const Points<3>& points, std::size_t i) {
  EntityHash hash(points.id[i]);
  hash_values<3>(hash, [&](const auto& add) {
    Points<3>::visit_fields(points, [&](const auto& field, FieldUse use) { add(field[i], use); });
  });
  return hash.value();
}

/// f(field of a, field of b) of all fields, in their order.
template <class F>
void visit_both(Points<3>& a, const Points<3>& b, const F& f) {
  int at = 0;
  Points<3>::visit_fields(a, [&](auto& field, FieldUse use) {
    int other = 0;
    Points<3>::visit_fields(b, [&](const auto& same, FieldUse) {
      if (other++ != at) return;
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(field)>,
                                   std::remove_cvref_t<decltype(same)>>) {
        f(field, same, use);
      }
    });
    ++at;
  });
}

TEST(Points, EveryFieldGoesWithItsPoint) {
  const auto all = full(5);
  const std::vector<LocalIndex> places = {4, 1, 2};
  auto some = all.subset(places, 2);
  EXPECT_EQ(some.n_owned, 2);
  int fields = 0;
  visit_both(some, all, [&](const auto& field, const auto& from, FieldUse) {
    ++fields;
    ASSERT_EQ(field.size(), places.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      EXPECT_EQ(field[k], from[static_cast<std::size_t>(places[k])]) << fields;
    }
  });
  EXPECT_EQ(fields, 22);
  EXPECT_EQ(some.specific_heats.size(), 1u);
  EXPECT_TRUE(some.keeps_conduction);
}

TEST(Points, WhatTheyDoNotHaveStaysEmpty) {
  Points<2> points;
  points.resize(3);
  EXPECT_TRUE(points.temperature.empty() && points.kept_rate.empty());
  points.conduct({300, 310, 320});
  EXPECT_EQ(points.temperature, points.start_temperature);
  EXPECT_EQ(points.heat, std::vector<Real>(3, 0.0));
  EXPECT_TRUE(points.kept_rate.empty() && points.specific_heat.empty());
  points.vary_capacities({rising()});
  EXPECT_EQ(points.specific_heat, std::vector<std::int32_t>(3, -1));
}

TEST(Points, CopiesHaveEveryFieldTheirOwnersHave) {
  auto points = full(2);
  points.append_ghost(77, 3, 4, 5.0, Vec3(1, 2, 3), Vec3(4, 5, 6));
  Points<3>::visit_fields(points,
                          [&](const auto& field, FieldUse) { EXPECT_EQ(field.size(), 3u); });
  EXPECT_EQ(points.id[2], 77u);
  EXPECT_EQ(points.x[2], points.x_start[2]);
  EXPECT_EQ(points.a[2], Vec3(0, 0, 0));
  EXPECT_EQ(points.specific_heat[2], -1);
}

/// What is saved reads back, what is not stays; the hash sees what it says it sees, and no more.
TEST(Points, RowsAndHashesHaveWhatTheListSays) {
  const auto all = full(3);
  std::vector<StateTable> tables;
  save_points(all, tables);
  const StateTables read(tables);
  auto other = full(3);
  Points<3>::visit_fields(other, [&](auto& field, FieldUse) {
    if (static_cast<const void*>(&field) == &other.id) return;
    for (auto& value : field) value *= 0;
  });
  load_points(other, read);
  visit_both(other, all, [&](const auto& field, const auto& saved, FieldUse use) {
    if (static_cast<const void*>(&field) == &other.id) return;
    EXPECT_EQ(field == saved, use.saved);
  });
  std::set<std::uint64_t> hashes = {hash_of(all, 1)};
  std::size_t hashed = 0;
  auto changed = all;
  Points<3>::visit_fields(changed, [&](auto& field, FieldUse use) {
    if (static_cast<const void*>(&field) == &changed.id) return;
    const auto kept = field[1];
    field[1] += field[1];
    EXPECT_EQ(hashes.insert(hash_of(changed, 1)).second, use.hashed);
    hashed += use.hashed;
    field[1] = kept;
  });
  EXPECT_EQ(hashed, 6u);  // x, v, a, heat and the two that are kept between evaluations
}

TEST(Points, CopiedFieldsPassThroughDoubles) {
  const auto all = full(2);
  auto other = full(2);
  other.x[1].setZero(), other.v[1].setZero(), other.temperature[1] = 0;
  std::vector<Real> message(16, -1.0);
  Real* out = message.data();
  Points<3>::visit_fields(all,
                          copied_in([&](const auto& field) { out = write_value(field[1], out); }));
  EXPECT_EQ(out - message.data(), 7);
  const Real* in = message.data();
  Points<3>::visit_fields(other, copied_in([&](auto& field) { in = read_value(in, field[1]); }));
  EXPECT_EQ(other.x[1], all.x[1]);
  EXPECT_EQ(other.v[1], all.v[1]);
  EXPECT_EQ(other.temperature[1], all.temperature[1]);
}

}  // namespace
}  // namespace brunt
