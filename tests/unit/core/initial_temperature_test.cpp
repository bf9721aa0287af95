#include "core/materials/initial_temperature.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace brunt {
namespace {

InitialTemperature along_x(Real slope) {
  InitialTemperature field;
  field.body = 3;
  field.origin = Vec3(1, 0, 0);
  field.value = [slope](const Vec3& place) { return 300 + slope * place[0]; };
  field.material = "copper";
  return field;
}

std::string said_at(const InitialTemperature& field, const Vec3& position) {
  try {
    field.at(position);
  } catch (const InitialTemperatureError& error) {
    EXPECT_EQ(error.body, 3U);
    return error.what();
  }
  return "";
}

TEST(InitialTemperature, IsOfTheAbsolutePlace) { EXPECT_EQ(along_x(100).at(Vec3(0.5, 7, 8)), 450); }

TEST(InitialTemperature, WhatNoBodyBeginsWithIsSaidWithItsPlace) {
  EXPECT_EQ(said_at(along_x(-1000), Vec3(0, 2, 0)),
            "is -700 K, below 0 K, at (1, 2, 0) m; an expression takes metres and gives kelvins");
  EXPECT_EQ(said_at(along_x(NAN), Vec3(0, 2, 0)),
            "is no number, at (1, 2, 0) m; an expression takes metres and gives kelvins");
  InitialTemperature melts = along_x(1200);
  EXPECT_EQ(melts.at(Vec3::Zero()), 1500);
  melts.melting = 1356;
  EXPECT_EQ(said_at(melts, Vec3::Zero()),
            "is 1500 K, and 'copper' melts at T_melt = 1356 K, where it has no strength, at "
            "(1, 0, 0) m; an expression takes metres and gives kelvins");
}

}  // namespace
}  // namespace brunt
