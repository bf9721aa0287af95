/// Four quads side by side have the planes and boxes that each of them has by itself, bit for bit:
/// which faces stand side by side depends on ranks and on what is near, and must not be seen. To
/// rounding, 1e-12, they are those of the diagonals, by Eigen.
#include "contact/geometry/four_planes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include "contact/surfaces/start_warp.hpp"

namespace brunt {
namespace {

constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

void expect_bits(Real a, Real b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << " " << b;
}

struct Quad {
  std::array<Vec3, 4> corner;
  Real area_start = 1;
};

/// Handed over with the others a quad gets what it gets by itself, and nothing else is touched.
void expect_all_given(const FourPlanes& found, int lane, const FacePlane<3>& given,
                      const SearchBox<3>& given_box) {
  FacePlane<3> alone;
  found.give(lane, alone);
  const SearchBox<3> box = found.box(lane);
  for (int i = 0; i < 3; ++i) {
    expect_bits(given.center[i], alone.center[i]);
    expect_bits(given.normal[i], alone.normal[i]);
    expect_bits(given_box.lo[slot_of(i)], box.lo[slot_of(i)]);
    expect_bits(given_box.hi[slot_of(i)], box.hi[slot_of(i)]);
  }
  expect_bits(given.area, alone.area);
  expect_bits(given.warp, alone.warp);
  EXPECT_EQ(given.simple, alone.simple);
  EXPECT_EQ(given.flat, alone.flat);
  EXPECT_FALSE(given.rigid);
  EXPECT_EQ(given.n_corners, 4);
}

void expect_same_as_alone(const std::array<Quad, 4>& quads) {
  std::array<Place<Pack>, 4> corner;
  for (std::size_t c = 0; c < 4; ++c) {
    const auto along = [&](int i) {
      return Pack{quads[0].corner[c][i], quads[1].corner[c][i], quads[2].corner[c][i],
                  quads[3].corner[c][i]};
    };
    corner[c] = {along(0), along(1), along(2)};
  }
  const FourPlanes found(corner, Pack{quads[0].area_start, quads[1].area_start, quads[2].area_start,
                                      quads[3].area_start});
  std::array<FacePlane<3>, 4> given;
  std::array<SearchBox<3>, 4> given_box;
  for (std::size_t k = 0; k < 4; ++k) given[k].corner = quads[k].corner;
  found.give({&given[0], &given[1], &given[2], &given[3]},
             {&given_box[0], &given_box[1], &given_box[2], &given_box[3]});
  for (int lane = 0; lane < kLanes; ++lane) {
    SCOPED_TRACE(lane);
    expect_all_given(found, lane, given[slot_of(lane)], given_box[slot_of(lane)]);
    EXPECT_EQ(std::memcmp(given[slot_of(lane)].corner.data(), quads[slot_of(lane)].corner.data(),
                          12 * sizeof(Real)),
              0);
    const Quad& quad = quads[slot_of(lane)];
    FacePlane<3> alone, four;
    alone.corner = four.corner = quad.corner;
    refresh(alone);
    const auto& x = quad.corner;
    const Vec3 twice = (x[2] - x[0]).cross(x[3] - x[1]);
    if (alone.area > 0) {
      const Real scale = (x[2] - x[0]).norm() * (x[3] - x[1]).norm();
      EXPECT_NEAR(alone.area, 0.5 * twice.norm(), 1e-12 * scale);
      EXPECT_NEAR((alone.area * alone.normal - 0.5 * twice).norm(), 0, 1e-12 * scale);
      for (const Vec3& at : x) {
        const Real over = std::fabs((at - alone.center).dot(alone.normal));
        EXPECT_NEAR(over, alone.warp, 1e-12 * (at - Vec3::Zero()).norm());
      }
    }
    ContactFace<3> face;
    face.area_start = quad.area_start;
    compare_with_start(face, alone);
    found.give(lane, four);
    for (int i = 0; i < 3; ++i) {
      expect_bits(four.center[i], alone.center[i]);
      expect_bits(four.normal[i], alone.normal[i]);
    }
    expect_bits(four.area, alone.area);
    expect_bits(four.warp, alone.warp);
    EXPECT_EQ(four.simple, alone.simple);
    EXPECT_EQ(four.flat, alone.flat);
    const SearchBox<3> box = found.box(lane), expected = box_of(alone, 0);
    for (std::size_t i = 0; i < 3; ++i) {
      expect_bits(box.lo[i], expected.lo[i]);
      expect_bits(box.hi[i], expected.hi[i]);
    }
  }
}

TEST(FourPlanes, AreThoseOfEach) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<Real> noise(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    // From nearly flat to concave and crossed, of any size, anywhere.
    const Real rough = std::pow(10.0, 3 * noise(random) - 3),
               size = std::pow(10.0, 6 * noise(random));
    std::array<Quad, 4> quads;
    for (auto& quad : quads) {
      const Vec3 at = 100 * size * Vec3(noise(random), noise(random), noise(random));
      const std::array<Vec3, 4> square{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
      for (std::size_t c = 0; c < 4; ++c) {
        const Vec3 by(noise(random), noise(random), noise(random));
        quad.corner[c] = at + size * (square[c] + rough * by);
      }
      quad.area_start = trial % 3 == 0 ? 0 : size * size * (1 + noise(random));
    }
    expect_same_as_alone(quads);
  }
}

TEST(FourPlanes, WhatHasNoAreaOrIsNoNumberHasNoPlane) {
  std::array<Quad, 4> quads;
  const Quad square{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)}, 1};
  quads.fill(square);
  for (auto& x : quads[0].corner) x.setZero();
  quads[1].corner[2][1] = kNan;
  quads[2].corner = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)};
  expect_same_as_alone(quads);
  quads.fill(square);
  for (auto& x : quads[3].corner) x *= 1e-170;  // its area is below all numbers
  expect_same_as_alone(quads);
}

}  // namespace
}  // namespace brunt
