// Faces push each other, by a share of their force, by minus the gradient of
//   U/k = ramp omega int (G^2/2 + barrier) dA, G = cos(th/2) g,
// which is (1 + cos th)/4 volume * penetration of the common plane without a barrier, since the
// penetration where the push acts is int g^2 dA / int g dA then. The gradient is found here by
// central differences of U, corner by corner: of second order in the difference d, whose rounding
// is 1e-16 U/d. In 2D the breadth of an axisymmetric deck is 2 pi r of the plane itself.
#include "contact/geometry/overlap_push.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brunt {
namespace {

template <int Dim>
struct Pair {
  FacePlane<Dim> lower, upper;
  Section section;
  Real opening = 0;
  FaceBarrier barrier;
  Real limit = kInfinity;

  Planes<Dim> planes;
  int meet() {
    refresh(lower), refresh(upper);
    return common_planes<Dim>(lower, upper, section, planes,
                              {.opening = opening, .barrier = barrier, .limit = limit});
  }
  Real energy() {
    const int n = meet();
    Real sum = 0;
    for (int i = 0; i < n; ++i) {
      const auto& plane = planes[static_cast<std::size_t>(i)];
      sum += plane.energy;
      if (barrier.onset > 0) continue;
      const Real linear = 0.25 * (1 + plane.facing) * plane.volume * plane.penetration;
      EXPECT_NEAR(plane.energy, linear, 1e-13 * linear);
    }
    return sum;
  }
  Vec<Dim>& corner(std::size_t i) {
    const auto n = static_cast<std::size_t>(lower.n_corners);
    return i < n ? lower.corner[i] : upper.corner[i - n];
  }
  std::size_t n_corners() const {
    return static_cast<std::size_t>(lower.n_corners + upper.n_corners);
  }
};

/// Force per k by the potential on corner i of a pair with one plane, freed of the share.
template <int Dim>
Vec<Dim> by_potential(const Pair<Dim>& pair, std::size_t i) {
  const auto& plane = pair.planes[0];
  const auto n = static_cast<std::size_t>(pair.lower.n_corners);
  const Real weight = i < n ? -plane.lower_weight[i] : plane.upper_weight[i - n];
  const Vec<Dim> push = i < n ? plane.lower_push[i] : plane.upper_push[i - n];
  return weight * plane.volume * plane.normal + push / plane.share;
}

template <int Dim>
void expect_gradient(Pair<Dim> pair, const std::string& name) {
  ASSERT_EQ(pair.meet(), 1) << name;
  ASSERT_TRUE(pair.planes[0].share > 0) << name;
  const Real d = 1e-7;
  Real largest = 0;
  std::vector<Vec<Dim>> force;
  for (std::size_t i = 0; i < pair.n_corners(); ++i) {
    force.push_back(by_potential(pair, i));
    largest = std::max(largest, force.back().norm());
  }
  for (std::size_t i = 0; i < pair.n_corners(); ++i) {
    for (int c = 0; c < Dim; ++c) {
      const Real at = pair.corner(i)[c];
      pair.corner(i)[c] = at + d;
      const Real more = pair.energy();
      pair.corner(i)[c] = at - d;
      const Real less = pair.energy();
      pair.corner(i)[c] = at;
      // d/L of lengths L down to 1 cm, where the second derivative of a fade jumps.
      EXPECT_NEAR(-(more - less) / (2 * d), force[i][c], 1e-5 * largest) << name << i << c;
    }
  }
}

Vec3 moment_of(const Vec3& x, const Vec3& f) { return x.cross(f); }

class Random {
 public:
  Real operator()(Real least, Real most) {
    return std::uniform_real_distribution<Real>(least, most)(generator_);
  }
  Vec3 nearby(Real size) {
    return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)};
  }

 private:
  std::mt19937_64 generator_{20261122};
};

/// A square or a triangle of size 1, distorted and warped a little, and another that leans by up to
/// 80 degrees and goes into it by up to 0.3.
Pair<3> random_pair(Random& random, int n_lower, int n_upper) {
  Pair<3> pair;
  pair.section = {Geometry::three_d, 1};
  pair.lower.n_corners = n_lower, pair.upper.n_corners = n_upper;
  pair.lower.corner[3].setZero(), pair.upper.corner[3].setZero();
  const Real lean = random(0.02, 1.4), turn = random(0, 2 * kPi);
  const Eigen::AngleAxis<Real> tilt(lean, Vec3(std::cos(turn), std::sin(turn), 0));
  const Vec3 at(random(-0.4, 0.4), random(-0.4, 0.4), random(-0.3, 0.2));
  const std::array<Vec3, 4> square = {
      {{-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {-0.5, 0.5, 0}}};
  for (std::size_t c = 0; c < 4; ++c) {
    if (static_cast<int>(c) < n_lower) pair.lower.corner[c] = square[c] + random.nearby(0.03);
    if (static_cast<int>(c) >= n_upper) continue;
    pair.upper.corner[c] = at + tilt * square[3 - c] + random.nearby(0.03);
  }
  return pair;
}

/// Two faces that overlap by 0.05 to 0.3 at their edges, as deep, nearly parallel; all edges are
/// borders. Those that run the same way are more than half a face apart: nearer ones share what
/// moves them (flush_borders_test.cpp).
Pair<3> borders_that_meet(Random& random) {
  auto pair = random_pair(random, 4, 4);
  const Real beside = random(0.65, 0.95), sign = random(-1, 1);
  const Vec3 at(random(0.7, 0.95), std::copysign(beside, sign), -random(0.05, 0.3));
  const Eigen::AngleAxis<Real> tilt(random(0.002, 0.2), random.nearby(1).normalized());
  for (std::size_t c = 0; c < 4; ++c) {
    const Vec3 across(pair.lower.corner[3 - c][0], pair.lower.corner[3 - c][1], 0);
    pair.upper.corner[c] = at + tilt * across;
  }
  pair.lower.borders = pair.upper.borders = 15;
  return pair;
}

/// Of 400 pairs as make(k) says most push by their potential, and many of these fade.
template <class Make>
void expect_gradients_that_fade(const Make& make) {
  int found = 0, fading = 0;
  for (int k = 0; k < 400; ++k) {
    auto pair = make(k);
    if (k % 2 == 0) pair.barrier = {0.05};
    if (k % 3 == 0) pair.limit = 0.2;  // they fade by their depth too
    if (pair.meet() != 1 || !(pair.planes[0].share > 0)) continue;
    ++found;
    fading += pair.planes[0].ramp < 1 ? 1 : 0;
    expect_gradient(pair, std::to_string(k) + " ");
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(fading, 50);
}

TEST(OverlapPush, IsTheGradientWhereBordersFade) {
  Random random;
  expect_gradients_that_fade([&](int) { return borders_that_meet(random); });
}

TEST(OverlapPush, IsTheGradientWhereBordersFadeInTwoDimensions) {
  Random random;
  expect_gradients_that_fade([&](int k) {
    Pair<2> pair;
    pair.section = {k % 2 == 0 ? Geometry::axisymmetric : Geometry::plane_strain, 0.7};
    const Vec<2> at(2.4 - random(0.02, 0.3), -random(0.02, 0.3));
    pair.lower.corner = {Vec<2>(2.4, 0), Vec<2>(1.5, random(-0.02, 0.02))};
    pair.upper.corner = {at, at + Vec<2>(1, random(-0.1, 0.1))};
    pair.lower.borders = pair.upper.borders = 3;
    return pair;
  });
}

TEST(OverlapPush, IsTheGradientOfThePotentialInThreeDimensions) {
  Random random;
  int found = 0;
  for (int k = 0; k < 400; ++k) {
    auto pair = random_pair(random, k % 3 == 0 ? 3 : 4, k % 5 == 0 ? 3 : 4);
    pair.opening = k % 4 == 0 ? -0.01 : 0.0;
    if (k % 2 == 0) pair.barrier = {0.08};
    if (pair.meet() != 1 || !(pair.planes[0].share > 0) || pair.planes[0].volume < 1e-3) continue;
    ++found;
    expect_gradient(pair, std::to_string(k) + " ");
  }
  EXPECT_GT(found, 100);
}

TEST(OverlapPush, IsTheGradientOfThePotentialInTwoDimensions) {
  Random random;
  int found = 0;
  for (int k = 0; k < 400; ++k) {
    Pair<2> pair;
    pair.section = {k % 2 == 0 ? Geometry::axisymmetric : Geometry::plane_strain, 0.7};
    pair.opening = k % 4 == 0 ? -0.01 : 0.0;
    if (k % 2 == 0) pair.barrier = {0.08};
    const Real lean = random(-1.4, 1.4);
    const Vec<2> along(std::cos(lean), std::sin(lean));
    const Vec<2> at(random(1.6, 2.4), random(-0.3, 0.2));
    pair.lower.corner = {Vec<2>(2.5, random(-0.1, 0.1)), Vec<2>(1.5, random(-0.1, 0.1))};
    pair.upper.corner = {at - 0.5 * along, at + 0.5 * along};
    if (pair.meet() != 1 || !(pair.planes[0].share > 0) || pair.planes[0].volume < 1e-3) continue;
    ++found;
    expect_gradient(pair, std::to_string(k) + " ");
  }
  EXPECT_GT(found, 100);
}

TEST(OverlapPush, BordersWithoutRoomLeaveNumbers) {
  // Opposite by 60 degrees: 1 - cos^2 is left of the overlap, and nothing is divided by no room.
  for (const Real room : {0.0, -1e-20, 1e-300}) {
    BorderFade<3> fade;
    fade.add(0, 2, 0.5, {.volume = 1, .size = room});
    EXPECT_EQ(fade.factor, 0.75) << room;
    ASSERT_EQ(fade.n, 1) << room;
    EXPECT_EQ(fade.by_volume, 0) << room;
    EXPECT_EQ(fade.pair[0].by_room, 0) << room;
    EXPECT_EQ(fade.pair[0].by_facing, -2 * 0.5 / 0.75) << room;
  }
  // By 13 degrees, nothing is.
  BorderFade<3> nearly;
  nearly.add(0, 2, 0.975, {.volume = 1});
  EXPECT_EQ(nearly.factor, 0);
  BorderFade<3> opposite;
  opposite.add(0, 2, 1, {.volume = 1});
  EXPECT_EQ(opposite.factor, 0);
}

TEST(OverlapPush, HasNoResultantAndNoMoment) {
  // Sums of eight forces of size N about points of size 1 round to some 1e-15 N.
  Random random;
  int found = 0;
  for (int k = 0; k < 2000; ++k) {
    auto pair = random_pair(random, k % 3 == 0 ? 3 : 4, k % 5 == 0 ? 3 : 4);
    if (k % 2 == 0) pair.barrier = {0.05};
    if (k % 4 < 2) pair.lower.borders = pair.upper.borders = 15;
    if (pair.meet() != 1 || !(pair.planes[0].share > 0) || pair.planes[0].volume < 1e-4) continue;
    ++found;
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    for (std::size_t i = 0; i < pair.n_corners(); ++i) {
      const Vec3 f = by_potential(pair, i);
      force += f;
      moment += moment_of(pair.corner(i), f);
    }
    EXPECT_LT(force.norm(), 1e-14 * pair.planes[0].volume) << k;
    EXPECT_LT(moment.norm(), 1e-14 * pair.planes[0].volume) << k;
  }
  EXPECT_GT(found, 500);
}

}  // namespace
}  // namespace brunt
