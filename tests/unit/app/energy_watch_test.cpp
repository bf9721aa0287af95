// What the watch counts as energy that nobody put in, by hand-made ledgers.
#include "app/watch/energy_watch.hpp"

#include <gtest/gtest.h>

namespace brunt {
namespace {

EnergyLook look_of(std::size_t bodies, Real kinetic) {
  EnergyLook look;
  look.bodies.resize(bodies);
  look.columns[static_cast<std::size_t>(Column::kinetic)] = kinetic;
  return look;
}

TEST(EnergyWatch, WhatASpringGivesBackIsItsOwnAndWhatItGivesBeyondIsCreated) {
  EnergyWatch watch(1);
  auto look = look_of(1, 100);
  look.bodies[0].artificial_stress = 30;
  watch.keep(look);
  look.bodies[0].artificial_stress = 0;  // all of it came back
  EXPECT_EQ(sum(watch.created(look)), 0);
  look.bodies[0].artificial_stress = -2;
  const auto created = watch.created(look);
  ASSERT_EQ(created.size(), 1u);
  EXPECT_EQ(created[0].source, EnergySource::artificial_stress);
  EXPECT_EQ(created[0].body, Label{0});
  EXPECT_EQ(created[0].energy, 2);
}

TEST(EnergyWatch, WhatHoldsNothingCreatesAllThatItGives) {
  EnergyWatch watch(1);
  auto look = look_of(1, 100);
  look.bodies[0].viscosity = 8, look.bodies[0].integration = 3;
  look.columns[static_cast<std::size_t>(Column::contact_pairs)] = 5;
  watch.keep(look);
  look.bodies[0].viscosity = 7, look.bodies[0].integration = -1;      // 1 and 4 less
  look.columns[static_cast<std::size_t>(Column::contact_pairs)] = 3;  // 2 less, above zero still
  const auto created = watch.created(look);
  ASSERT_EQ(created.size(), 3u);
  EXPECT_EQ(created[0].source, EnergySource::integration);  // largest first
  EXPECT_EQ(created[0].energy, 4);
  EXPECT_EQ(created[1].source, EnergySource::contact_pairs);
  EXPECT_EQ(created[1].energy, 2);
  EXPECT_FALSE(created[1].body);
  EXPECT_EQ(created[2].energy, 1);
}

TEST(EnergyWatch, StressesMayGiveBackWhatViscosityHeatedTheirEquationOfStateBy) {
  EnergyWatch watch(1);
  auto look = look_of(1, 100);
  look.bodies[0].viscosity = look.bodies[0].absorbed = 30, look.bodies[0].stress_work = -20;
  watch.keep(look);
  EXPECT_EQ(sum(watch.created(look)), 0);
  look.bodies[0].stress_work = -32;  // 2 more than there was
  EXPECT_EQ(sum(watch.created(look)), 2);
  look.bodies[0].absorbed = 0;  // a pressure of the volume alone gives nothing back
  EXPECT_EQ(sum(watch.created(look)), 32);
}

TEST(EnergyWatch, OneBodysGainIsNotSetOffAgainstAnothersLoss) {
  EnergyWatch watch(2);
  auto look = look_of(2, 100);
  look.bodies[0].artificial_stress = -6, look.bodies[1].artificial_stress = 6;
  look.bodies[0].kinetic = 20, look.bodies[1].kinetic = 80;
  watch.keep(look);
  const auto created = watch.created(look);
  EXPECT_EQ(sum(created), 6);
  // 6 of the scene's 100, but 6 of the 20 that this body has.
  const auto worst = watch.share(look, created);
  EXPECT_EQ(worst.body, Label{0});
  EXPECT_DOUBLE_EQ(worst.share, 0.3);
}

TEST(EnergyWatch, ABodyThatHardlyTakesPartIsMeasuredAgainstATenthOfTheScene) {
  EnergyWatch watch(1);
  auto look = look_of(1, 100);
  look.bodies[0].kinetic = 1e-6, look.bodies[0].artificial_stress = -0.1;
  EXPECT_DOUBLE_EQ(watch.share(look, watch.created(look)).share, 0.01);
}

TEST(EnergyWatch, TheLargestEnergyIsNeverThatOfARunawayColumn) {
  EnergyWatch watch(1);
  auto look = look_of(1, 2);
  look.bodies[0].artificial_stress = -1000;
  look.columns[static_cast<std::size_t>(Column::artificial_stress)] = -1000;
  EXPECT_EQ(watch.largest(look), 2);
  watch.start(3);  // rounding
  EXPECT_EQ(watch.largest(look), 3);
}

TEST(EnergyWatch, WhatIsLargestIsKeptAtLooksAlone) {
  EnergyWatch watch(0);
  watch.keep(look_of(0, 5));
  EXPECT_EQ(watch.largest(look_of(0, 9)), 9);  // a row in between
  EXPECT_EQ(watch.largest(look_of(0, 1)), 5);
}

TEST(EnergyWatch, HourglassEnergyIsMeasuredAgainstTheLargestWorkOfTheBodysStresses) {
  EnergyWatch watch(1);
  auto look = look_of(1, 100);
  look.bodies[0].stress_work = 20, look.bodies[0].hourglass = 3;
  watch.keep(look);
  look.bodies[0].stress_work = 1;  // what was strained elastically has sprung back
  EXPECT_DOUBLE_EQ(watch.hourglass_share(look, 0), 0.15);
  look.bodies[0].hourglass = 0.9;  // less than a hundredth of the scene
  EXPECT_EQ(watch.hourglass_share(look, 0), 0);
}

}  // namespace
}  // namespace brunt
