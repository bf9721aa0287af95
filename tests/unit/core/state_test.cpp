// Tables of state: what is written reads back to the bit, by id, whatever the order and however
// many rows there are besides; what is missing or contradicts itself is named.
#include "core/state.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "core/points_state.hpp"

namespace brunt {
namespace {

Points<2> points_with(std::vector<GlobalId> ids, Real salt) {
  Points<2> points;
  points.resize(static_cast<LocalIndex>(ids.size()));
  points.id = std::move(ids);
  for (std::size_t i = 0; i < points.id.size(); ++i) {
    const Real n = salt + static_cast<Real>(points.id[i]);
    points.mass[i] = n, points.integration[i] = -n;
    points.x[i] = Vec<2>(n, 0.1 * n), points.v[i] = Vec<2>(-n, 1 / n);
    points.a[i] = Vec<2>(3 * n, -0.0), points.f[i] = Vec<2>(n * n, 5e-324);
    points.x_start[i] = Vec<2>(n - 1, n + 1), points.x_rest[i] = Vec<2>(1 / n, -n);
  }
  return points;
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const StateError& error) {
    return error.what();
  }
  return "";
}

TEST(State, PointsAreFoundByIdInAnyOrderAndNumber) {
  const auto saved = points_with({7, 3, 100, 5, 4}, 0.25);
  std::vector<StateTable> tables;
  save_points(saved, tables);
  auto some = points_with({5, 100, 7}, 9000);
  load_points(some, StateTables(tables));
  const auto wanted = points_with({5, 100, 7}, 0.25);
  EXPECT_EQ(some.mass, wanted.mass);
  EXPECT_EQ(some.integration, wanted.integration);
  EXPECT_EQ(some.x, wanted.x);
  EXPECT_EQ(some.x_rest, wanted.x_rest);
  EXPECT_EQ(some.v, wanted.v);
  EXPECT_EQ(some.f, wanted.f);
  EXPECT_EQ(some.x_start, wanted.x_start);
  ASSERT_EQ(some.a, wanted.a);
  EXPECT_TRUE(std::signbit(some.a[0][1]));
}

TEST(State, OnlyOwnedPointsAreSavedAndGhostsAreLoaded) {
  auto saved = points_with({1, 2, 3}, 0.5);
  saved.n_owned = 2;
  std::vector<StateTable> tables;
  save_points(saved, tables);
  EXPECT_EQ(tables.at(0).id, (std::vector<GlobalId>{1, 2}));
  auto other = points_with({3}, 0.5);
  save_points(other, tables);  // the rank that owns the third
  auto loaded = points_with({1, 2, 3}, 70);
  loaded.n_owned = 1;
  load_points(loaded, StateTables(tables));
  EXPECT_EQ(loaded.x, points_with({1, 2, 3}, 0.5).x);
}

TEST(State, WholeNumbersKeepTheirBits) {
  // 0x7ff0... + 1 is a signalling NaN as a double.
  const std::vector<std::uint64_t> numbers = {0, 1, ~std::uint64_t{0}, 0x7ff0000000000001u};
  std::vector<StateTable> tables;
  const auto id = [](std::size_t k) { return static_cast<GlobalId>(k); };
  save_rows(
      "numbers", numbers.size(), id, [&](auto& row, std::size_t k) { row(numbers[k]); }, tables);
  std::vector<std::uint64_t> read(numbers.size());
  load_rows(
      "numbers", read.size(), id, [&](auto& row, std::size_t k) { row(read[k]); },
      StateTables(tables));
  EXPECT_EQ(read, numbers);
}

TEST(State, MissingTablesAndRowsAreNamed) {
  std::vector<StateTable> tables;
  save_points(points_with({1, 2}, 0), tables);
  const StateTables state(tables);
  auto other = points_with({2, 55}, 0);
  const auto row = message_of([&] { load_points(other, state); });
  EXPECT_NE(row.find("'points'"), std::string::npos) << row;
  EXPECT_NE(row.find("55"), std::string::npos) << row;
  const auto table = message_of([&] { (void)state.rows("contact.3"); });
  EXPECT_NE(table.find("'contact.3'"), std::string::npos) << table;
  Points<3> solid;
  solid.resize(1);
  solid.id = {1};
  const auto width = message_of([&] { load_points(solid, state); });
  EXPECT_NE(width.find("14 values"), std::string::npos) << width;
}

TEST(State, RowsThatContradictEachOtherAreRefused) {
  const StateTable a{"t", 2, {1, 2}, {1, 2, 3, 4}}, same{"t", 2, {2}, {3, 4}};
  const StateTable other{"t", 2, {2}, {3, 5}}, wider{"t", 3, {9}, {1, 2, 3}};
  const StateTable shorter{"t", 2, {9}, {1}}, empty{"t", 0, {}, {}};
  EXPECT_EQ(StateTables({a, same}).rows("t").size(), 2u);
  EXPECT_EQ(message_of([&] { StateTables({a, other}); }), "the state 't' has two rows of entity 2");
  for (const auto& wrong : {wider, shorter, empty}) {
    EXPECT_NE(message_of([&] { StateTables({a, wrong}); }), "");
  }
}

}  // namespace
}  // namespace brunt
