// docs/theory/sph.md (S26) to (S28).
// The watch may never let a pair through that came into reach unlisted. Random motions of a cloud:
// whenever covers() holds, every pair now within reach was within reach + skin when the list was
// built, by brute force. And it must not ask for a search where none is due: a cloud that moves as
// one, and a large body that turns by less than its zones deform.
#include "sph/list_watch.hpp"

#include <gtest/gtest.h>

#include "sample.hpp"

namespace brunt {
namespace {

TEST(ListWatch, LetsNoPairThrough) {
  int held = 0, refused = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    auto points = test::lattice<2>({16, 12}, 1.0, 1.0, 0.4, seed);
    const std::vector<Real> reach(points.x.size(), 1.2);
    const Real skin = 0.3;
    ListWatch<2> watch;
    watch.start(points.x, points.body, reach, skin);
    const auto start = points.x;
    const auto kick = test::lattice<2>({16, 12}, 1.0, 1.0, 0.5, 1000 + seed).x;
    const Real strength = 0.01 * seed, shear = 0.002 * seed;
    for (std::size_t i = 0; i < start.size(); ++i) {
      points.x[i] += strength * (kick[i] - test::lattice<2>({16, 12}, 1.0, 1.0).x[i]);
      points.x[i] += Vec<2>(shear * start[i][1] + 3.0, 0.05 * shear * start[i][0]);
    }
    if (!watch.covers(points.x, reach)) {
      ++refused;
      continue;
    }
    ++held;
    for (std::size_t i = 0; i < start.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if ((points.x[i] - points.x[j]).norm() < 2.4) {
          EXPECT_LE((start[i] - start[j]).norm(), 2.4 + skin);
        }
      }
    }
  }
  EXPECT_GT(held, 5);
  EXPECT_GT(refused, 5);
}

TEST(ListWatch, FarPartsMayTurnAgainstEachOther) {
  auto points = test::lattice<2>({200, 4}, 1.0, 1.0);
  const std::vector<Real> reach(points.x.size(), 1.2);
  ListWatch<2> watch;
  watch.start(points.x, points.body, reach, 0.3);
  const auto start = points.x;
  const auto turn = [&](Real angle) {  // [rad], and far away
    for (std::size_t i = 0; i < start.size(); ++i) {
      points.x[i] = start[i] + Vec<2>(1e6 - angle * start[i][1], angle * start[i][0]);
    }
  };
  // 0.01 rad: the ends move by 2 against each other, zones (10 wide for two) by 0.1
  turn(0.01);
  EXPECT_TRUE(watch.covers(points.x, reach));
  turn(0.04);
  EXPECT_FALSE(watch.covers(points.x, reach));
  points.x = start;
  EXPECT_TRUE(watch.covers(points.x, reach));
  const std::vector<Real> grown(points.x.size(), 1.36);
  EXPECT_FALSE(watch.covers(points.x, grown));
}

}  // namespace
}  // namespace brunt
