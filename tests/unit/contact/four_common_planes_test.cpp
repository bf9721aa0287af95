/// Four pairs of quads side by side have the common planes that each of them has by itself, bit for
/// bit, however many stand beside: which pairs stand side by side depends on lists and ranks, and
/// must not be seen.
#include "contact/geometry/four_common_planes.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace brunt {
namespace {

void expect_bits(Real a, Real b) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(a), std::bit_cast<std::uint64_t>(b)) << a << " " << b;
}
template <class Vector>
void expect_bits_of(const Vector& a, const Vector& b) {
  for (int i = 0; i < static_cast<int>(a.size()); ++i) expect_bits(a[i], b[i]);
}
void expect_same_weights(const std::array<Real, 4>& a, const std::array<Real, 4>& b) {
  for (std::size_t k = 0; k < 4; ++k) expect_bits(a[k], b[k]);
}

void expect_same(const CommonPlane<3>& a, const CommonPlane<3>& b, bool middle) {
  for (const auto of : {&CommonPlane<3>::normal, &CommonPlane<3>::point, &CommonPlane<3>::origin,
                        &CommonPlane<3>::axis_1, &CommonPlane<3>::axis_2}) {
    expect_bits_of(a.*of, b.*of);
  }
  if (middle) expect_bits_of(a.middle, b.middle);
  for (const auto of :
       {&CommonPlane<3>::facing, &CommonPlane<3>::ramp, &CommonPlane<3>::ramp_growth,
        &CommonPlane<3>::fade, &CommonPlane<3>::area, &CommonPlane<3>::volume,
        &CommonPlane<3>::energy, &CommonPlane<3>::energy_by_fade, &CommonPlane<3>::energy_by_facing,
        &CommonPlane<3>::penetration, &CommonPlane<3>::deepest, &CommonPlane<3>::layered,
        &CommonPlane<3>::mean_slope, &CommonPlane<3>::share}) {
    expect_bits(a.*of, b.*of);
  }
  EXPECT_EQ(a.ordinal, b.ordinal);
  expect_bits(a.barrier.onset, b.barrier.onset);
  expect_bits(a.barrier.strength, b.barrier.strength);
  expect_bits(a.barrier.growth, b.barrier.growth);
  expect_same_weights(a.lower_weight, b.lower_weight);
  expect_same_weights(a.upper_weight, b.upper_weight);
  expect_same_weights(a.lower_at_middle, b.lower_at_middle);
  expect_same_weights(a.upper_at_middle, b.upper_at_middle);
  ASSERT_EQ(a.polygon.size, b.polygon.size);
  for (int i = 0; i < a.polygon.size; ++i) {
    expect_bits_of(a.polygon[i], b.polygon[i]);
    EXPECT_EQ(a.polygon.side[slot_of(i)], b.polygon.side[slot_of(i)]);
  }
  if (!(a.share > 0)) return;
  for (std::size_t k = 0; k < 4; ++k) {
    expect_bits_of(a.lower_push[k], b.lower_push[k]);
    expect_bits_of(a.upper_push[k], b.upper_push[k]);
  }
}

class Scene {
 public:
  std::mt19937_64 random{7};

  Real noise(Real by) { return std::uniform_real_distribution<Real>(-by, by)(random); }
  bool one_in(int n) { return std::uniform_int_distribution<int>(1, n)(random) == 1; }
  /// A quad of about a size before or behind z = 0, turned any way about z and little about others.
  FacePlane<3> quad(Real size, bool up, Real tilt) {
    const Eigen::Quaternion<Real> turn(1, noise(tilt), noise(tilt), noise(2));
    const Vec3 at(noise(0.3), noise(0.3), noise(0.02));
    FacePlane<3> face;
    for (int c = 0; c < 4; ++c) {
      const Real x = c == 1 || c == 2 ? 0.5 : -0.5, y = c > 1 ? 0.5 : -0.5;
      const Vec3 corner(x + noise(0.1), (up ? y : -y) + noise(0.1), noise(0.01));
      face.corner[slot_of(c)] = at + turn.normalized() * (size * corner);
    }
    if (one_in(8)) face.borders = 0b1111;
    if (one_in(8)) face.sharpness = 0.5 * kBoxSharpness;
    refresh(face);
    return face;
  }
};

TEST(FourCommonPlanes, HaveTheBitsOfEach) {
  Scene scene;
  int pressing = 0, within = 0, cut = 0, shared = 0, apart = 0;
  for (int round = 0; round < 4000; ++round) {
    std::array<FacePlane<3>, 4> lower, upper;
    std::array<CommonPlane<3>, 4> plane;
    std::array<QuadPair, 4> pair{};
    const int n = 1 + round % 4;
    for (std::size_t k = 0; k < slot_of(n); ++k) {
      const Real tilt = scene.one_in(4) ? 0.6 : scene.one_in(2) ? 0.0 : 0.05;
      do lower[k] = scene.quad(scene.one_in(2) ? 0.3 : 1.0, true, tilt);
      while (!lower[k].simple);
      do upper[k] = scene.quad(scene.one_in(2) ? 4.0 : 1.0, false, tilt);
      while (!upper[k].simple);
      PlaneNeeds needs{.middle = scene.one_in(2),
                       .opening = scene.one_in(3) ? -0.01 : 0.0,
                       .barrier = FaceBarrier::before(scene.one_in(2) ? 1.0 : 0.1),
                       .limit = 1};
      pair[k] = {&lower[k], &upper[k], needs, &plane[k]};
    }
    four_common_planes(pair, n);
    for (std::size_t k = 0; k < slot_of(n); ++k) {
      SCOPED_TRACE(k);
      Planes<3> alone;
      const int found = common_planes<3>(lower[k], upper[k], Section{}, alone, pair[k].needs);
      ASSERT_EQ(pair[k].presses, found == 1);
      apart += found == 0;
      if (found == 0) continue;
      expect_same(plane[k], alone[0], pair[k].needs.middle);
      ++pressing;
      shared += alone[0].share > 0;
      const auto& sides = alone[0].polygon.side;
      const bool any_cut = std::find(sides.begin(), sides.begin() + alone[0].polygon.size,
                                     Polygon::kCut) != sides.begin() + alone[0].polygon.size;
      cut += any_cut;
      within += !any_cut && alone[0].polygon.size == 4;
    }
  }
  for (const int often : {pressing, within, cut, shared, apart}) EXPECT_GT(often, 200);
}

}  // namespace
}  // namespace brunt
