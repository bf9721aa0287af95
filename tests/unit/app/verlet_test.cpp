// Velocity Verlet on one harmonic oscillator, m = k = 1. With a constant step the scheme keeps
//   m v(n-1/2).v(n+1/2)/2 + k x(n)^2/2 - (work booked as 1/2 (f(n) + f(n+1)) dx)
// to rounding, and its period is 2 pi (1 - (w dt)^2/24). With a changing step the column
// `integration` takes what the change leaves, and the sum still closes to rounding.
#include "app/loop/verlet.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace brunt {
namespace {

struct Oscillator {
  Points<2> points;
  Real work = 0;  // minus 1/2 (f(n) + f(n+1)) dx
  Real dt_last = 0;

  Oscillator() {
    points.resize(1);
    points.mass[0] = 1;
    points.x[0] = Vec<2>(1, 0);
    points.a[0] = -points.x[0];
  }
  void step(Real dt) {
    const Vec<2> x_old = points.x[0], f_old = points.a[0];
    predict(points, dt, dt_last);
    points.f[0] -= points.x[0];
    work -= 0.5 * (f_old + points.f[0]).dot(points.x[0] - x_old);
    correct(points, dt);
    dt_last = dt;
  }
  Real kinetic() const {
    return 0.5 * (points.v[0].squaredNorm() - 0.25 * dt_last * dt_last * points.a[0].squaredNorm());
  }
  Real total() const { return kinetic() + work + points.integration[0]; }
};

TEST(Verlet, EnergyClosesToRoundOffForAnySteps) {
  Oscillator constant, changing;
  for (int n = 0; n < 10000; ++n) {
    constant.step(0.1);
    changing.step(0.1 + 0.05 * std::sin(0.7 * n));
  }
  EXPECT_NEAR(constant.total(), 0, 1e-12);
  EXPECT_NEAR(changing.total(), 0, 1e-12);
}

TEST(Verlet, PeriodIsOfSecondOrder) {
  Oscillator o;
  const Real dt = 0.1;
  Real crossing = 0;
  for (int n = 0, found = 0; found < 10; ++n) {
    const Real before = o.points.x[0][0];
    o.step(dt);
    const Real after = o.points.x[0][0];
    // downward crossings of zero come once a period, the first a quarter after the start
    if (before > 0 && after <= 0) {
      ++found;
      crossing = dt * (n + before / (before - after));
    }
  }
  // linear interpolation of the crossing errs by less than dt^3
  EXPECT_NEAR(crossing / (2 * kPi * 9.25), 1 - dt * dt / 24, 2e-5);
}

TEST(Verlet, PointsWithoutMassKeepTheirVelocity) {
  Points<3> points;
  points.resize(1);
  points.v[0] = Vec3(1, 2, 3);
  predict(points, 0.5, 0.0);
  points.f[0] = Vec3(10, 0, 0);
  correct(points, 0.5);
  EXPECT_EQ(points.x[0], Vec3(0.5, 1, 1.5));
  EXPECT_EQ(points.v[0], Vec3(1, 2, 3));
}

}  // namespace
}  // namespace brunt
