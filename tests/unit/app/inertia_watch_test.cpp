// Kinetic energy over the work of stresses, at the end and of integrals over time, by hand.
#include "app/watch/inertia_watch.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

EnergyLook look_of(std::vector<std::pair<Real, Real>> kinetic_and_work) {
  EnergyLook look;
  for (const auto& [kinetic, work] : kinetic_and_work) {
    look.bodies.emplace_back();
    look.bodies.back().kinetic = kinetic, look.bodies.back().stress_work = work;
  }
  return look;
}

const std::vector<std::string> kBodies = {"tool", "block", "plate"};

TEST(InertiaWatch, SharesAreOfTheEndAndOfMeans) {
  InertiaWatch watch(3);
  watch.look(look_of({{9, 0}, {2, 10}, {1, 20}}), 1);
  watch.look(look_of({{9, 0}, {6, 40}, {3, 60}}), 3);
  const auto shares = watch.shares(kBodies, look_of({{9, 0}, {4, 50}, {0, 50}}));
  ASSERT_EQ(shares.size(), 3u);  // the tool is rigid: its stresses do no work
  EXPECT_EQ(shares[0].body, "block");
  EXPECT_EQ(shares[0].end, 4.0 / 50);
  EXPECT_EQ(shares[0].mean, (2.0 * 1 + 6 * 2) / (10 * 1 + 40 * 2));
  EXPECT_EQ(shares[1].body, "plate");
  EXPECT_EQ(shares[1].end, 0);
  EXPECT_EQ(shares[2].body, "all");
  EXPECT_EQ(shares[2].end, 4.0 / 100);
  EXPECT_EQ(shares[2].mean, (3.0 * 1 + 9 * 2) / (30 * 1 + 100 * 2));
}

TEST(InertiaWatch, LooksTwiceAtAStepCountOnce) {
  InertiaWatch once(1), twice(1);
  const auto look = look_of({{2, 10}});
  once.look(look, 1), twice.look(look, 1), twice.look(look, 1);
  EXPECT_EQ(once.shares({"a"}, look)[0].mean, twice.shares({"a"}, look)[0].mean);
}

TEST(InertiaWatch, ARestartGoesOn) {
  InertiaWatch whole(1), first(1), second(1);
  whole.look(look_of({{2, 10}}), 1), first.look(look_of({{2, 10}}), 1);
  std::vector<StateTable> tables;
  first.save_state(tables);
  second.load_state(StateTables(tables));
  const auto end = look_of({{6, 40}});
  whole.look(end, 3), second.look(end, 3);
  EXPECT_EQ(whole.shares({"a"}, end)[0].mean, second.shares({"a"}, end)[0].mean);
}

TEST(InertiaWatch, WarnsAboveAPartInTwentyOfWhatIsMadeFaster) {
  const std::vector<InertiaShare> shares = {{"a", 0.049, 0.049}, {"b", 0, 0.06}, {"c", 0.06, 0}};
  EXPECT_TRUE(inertia_warnings(shares, 1).empty());
  const auto warnings = inertia_warnings(shares, 10);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].id, "time.process_speed");
  EXPECT_TRUE(warnings[0].text.starts_with("b: kinetic energy is 0 % at the end, 6 %"));
  EXPECT_TRUE(warnings[1].text.starts_with("c: "));
  EXPECT_EQ(distortion_text(1), "");
  EXPECT_NE(distortion_text(10).find("100 times"), std::string::npos);
}

}  // namespace
}  // namespace brunt
