#include "app/deck/columns.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/ledger.hpp"

namespace brunt::deck {
namespace {

TEST(Columns, EachHasTheUnitOfItsPattern) {
  EXPECT_STREQ(unit_of_column("time"), "s");
  EXPECT_STREQ(unit_of_column("step"), "1");
  EXPECT_STREQ(unit_of_column("momentum.z"), "kg m/s");
  EXPECT_STREQ(unit_of_column("energy.created"), "J");
  EXPECT_STREQ(unit_of_column("energy.drift"), "1");
  EXPECT_STREQ(unit_of_column("heat.stored"), "J");
  EXPECT_STREQ(unit_of_column("body.bar.heat"), "J");
  EXPECT_STREQ(unit_of_column("body.wheel.spin.z"), "rad/s");
  EXPECT_STREQ(unit_of_column("contact.bar-anvil.friction_heat"), "W");
  EXPECT_STREQ(unit_of_column("section.middle.moment.x"), "N m");
}

// The motion of a rigid body has its heat as boundary.BODY.motion.heat_rate.
TEST(Columns, NamesMayHaveDots) {
  EXPECT_STREQ(unit_of_column("boundary.tool.motion.heat_rate"), "W");
}

TEST(Columns, AProbeHasTheUnitOfItsField) {
  EXPECT_STREQ(unit_of_column("probe.top.pressure"), "Pa");
  EXPECT_STREQ(unit_of_column("probe.top.velocity.magnitude"), "m/s");
  EXPECT_STREQ(unit_of_column("probe.top.colour"), "any");
}

TEST(Columns, WhatIsNoColumnIsNotFound) {
  for (const char* name : {"", "energy", "energy.", "energy.kinetics", "momentum.w", "momentum.xy",
                           "body.mass", "body..mass", "body.bar.force", "body.bar.force.", "probe.",
                           "probe.top", "contact.pair.area.x"}) {
    EXPECT_EQ(column_info(name), nullptr) << name;
  }
}

TEST(Columns, PatternsAreToldOnceWithAMeaning) {
  std::set<std::string_view> patterns;
  for (const auto& column : kHistoryColumns) {
    EXPECT_TRUE(patterns.insert(column.pattern).second) << column.pattern;
    EXPECT_STRNE(column.meaning, "") << column.pattern;
  }
}

// HistoryColumns adds the energies by their numbers in the ledger.
TEST(Columns, EachEnergyOfTheLedgerHasOne) {
  for (int c = 0; c < kColumns; ++c) {
    const std::string name = "energy." + std::string(column_name(static_cast<Column>(c)));
    EXPECT_NE(column_info(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace brunt::deck
