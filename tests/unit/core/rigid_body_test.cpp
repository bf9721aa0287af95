// Free turning against closed forms and an independent integration; momentum, energy,
// orthogonality.
#include "core/rigid/rigid_body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>

namespace brunt {
namespace {

RigidBody body_of(const Vec3& principal, const Vec3& spin) {
  RigidBody body;
  body.mass = 2;
  body.inertia = principal.asDiagonal();
  body.inverse_inertia = body.inertia.inverse();
  body.momentum = body.inertia * spin;
  return body;
}

// A symmetric top, J = (A, A, C): seen from space its axis turns about L at the rate |L|/A, and the
// top turns about its axis besides. After a time t the axis is that of the start turned about L by
// |L| t/A. The scheme is of second order: its angle is wrong by less than (|W| dt)^2/12 of itself.
TEST(RigidBody, SymmetricTopPrecesses) {
  const Real A = 1.3, C = 0.4, dt = 1e-3, turns = 20;
  const Vec3 spin(3, 0, 8);
  auto body = body_of(Vec3(A, A, C), spin);
  const Real rate = body.momentum.norm() / A;
  const Vec3 about = body.momentum.normalized();
  const int steps = static_cast<int>(turns * 2 * kPi / rate / dt);
  for (int n = 0; n < steps; ++n) body.drift(dt);
  const Real angle = rate * dt * steps;
  const Vec3 expected = Eigen::AngleAxis<Real>(angle, about) * Vec3::UnitZ();
  const Real error = (body.rotation().col(2) - expected).norm();
  const Real wdt = spin.norm() * dt;
  EXPECT_LT(error, wdt * wdt / 12 * angle);
  EXPECT_GT(rate * dt * steps, 100);  // it has turned, and the bound says something
}

// About its middle axis a body tumbles. With I1 < I2 < I3, energy T and momentum L, L^2 > 2 T I2:
// the spin about the second axis is periodic (Landau & Lifshitz, Mechanics, section 37),
//   period = 4 K(k) sqrt(I1 I2 I3 / ((I3 - I2) (L^2 - 2 T I1))),
//   k^2 = (I2 - I1) (2 T I3 - L^2) / ((I3 - I2) (L^2 - 2 T I1)).
TEST(RigidBody, TumblesWithThePeriodOfJacobi) {
  const Vec3 I(1, 2, 3.5);
  const Real dt = 1e-3;
  auto body = body_of(I, Vec3(1e-3, 5, 0.02));
  const Real L2 = body.momentum.squaredNorm();
  const Real T2 = body.momentum.dot(body.spin());
  ASSERT_GT(L2, T2 * I[1]);
  const Real k2 = (I[1] - I[0]) * (T2 * I[2] - L2) / ((I[2] - I[1]) * (L2 - T2 * I[0]));
  const Real period = 4 * std::comp_ellint_1(std::sqrt(k2)) *
                      std::sqrt(I.prod() / ((I[2] - I[1]) * (L2 - T2 * I[0])));
  // Times at which the spin about the second axis, as the body sees it, passes zero upwards.
  std::vector<Real> crossings;
  Real before = 0;
  for (int n = 0; crossings.size() < 6; ++n) {
    ASSERT_LT(n, 100000);
    const Real now = (body.rotation().transpose() * body.spin())[1];
    if (n > 0 && before < 0 && now >= 0) {
      crossings.push_back(dt * (n - 1 + before / (before - now)));
    }
    before = now;
    body.drift(dt);
  }
  // Second order: (|W| dt)^2 = 2.5e-5; the period depends on how near it starts to the axis, by the
  // logarithm alone.
  EXPECT_NEAR((crossings.back() - crossings.front()) / 5, period, 1e-5 * period);
}

/// What Euler's equations say, by the classical Runge-Kutta rule: a program of its own.
struct EulerEquations {
  Mat3 inertia, inverse;
  struct State {
    Vec3 spin;                 // in the body
    std::array<Real, 4> turn;  // quaternion w, x, y, z
  };
  State rate(const State& s) const {
    const Vec3 W = s.spin;
    const auto& q = s.turn;
    return {inverse * (-W.cross(inertia * W)),
            {0.5 * (-q[1] * W[0] - q[2] * W[1] - q[3] * W[2]),
             0.5 * (q[0] * W[0] + q[2] * W[2] - q[3] * W[1]),
             0.5 * (q[0] * W[1] + q[3] * W[0] - q[1] * W[2]),
             0.5 * (q[0] * W[2] + q[1] * W[1] - q[2] * W[0])}};
  }
  static State moved(const State& s, const State& rate, Real dt) {
    State to{s.spin + dt * rate.spin, s.turn};
    for (std::size_t c = 0; c < 4; ++c) to.turn[c] += dt * rate.turn[c];
    return to;
  }
  State step(const State& s, Real dt) const {
    const State a = rate(s), b = rate(moved(s, a, dt / 2)), c = rate(moved(s, b, dt / 2)),
                d = rate(moved(s, c, dt));
    State to = s;
    to.spin += dt / 6 * (a.spin + 2 * b.spin + 2 * c.spin + d.spin);
    for (std::size_t k = 0; k < 4; ++k) {
      to.turn[k] += dt / 6 * (a.turn[k] + 2 * b.turn[k] + 2 * c.turn[k] + d.turn[k]);
    }
    return to;
  }
};

// The attitude at a time, tumbling, against Runge-Kutta in steps a hundred times finer (its own
// error is below 1e-10): halved steps, a quarter of the error.
TEST(RigidBody, ConvergesToEulersEquationsWithTheSquareOfTheStep) {
  const Vec3 I(1, 2, 3.5), spin(0.5, 5, 0.3);
  const Real end = 4, finest = 2.5e-5;
  EulerEquations euler{Mat3(I.asDiagonal()), Mat3(I.asDiagonal()).inverse()};
  EulerEquations::State exact{spin, {1, 0, 0, 0}};
  for (int n = 0; n < static_cast<int>(std::lround(end / finest)); ++n) {
    exact = euler.step(exact, finest);
  }
  const auto& q = exact.turn;
  const Mat3 attitude = Eigen::Quaternion<Real>(q[0], q[1], q[2], q[3]).toRotationMatrix();
  std::array<Real, 3> error{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Real dt = 0.01 / (1 << k);
    auto body = body_of(I, spin);
    for (int n = 0; n < static_cast<int>(std::lround(end / dt)); ++n) body.drift(dt);
    error[k] = (body.rotation() - attitude).norm();
  }
  EXPECT_NEAR(error[0] / error[1], 4, 0.3);
  EXPECT_NEAR(error[1] / error[2], 4, 0.1);
  EXPECT_LT(error[2], 1e-2);
}

// Ten thousand radians of tumbling in steps of 0.05 rad: the momentum is the state itself, the
// energy is kept by the rule, and the quaternion is made of length 1 in every step. What is left is
// rounding, which grows with the root of the number of steps at most: sqrt(2e5) 2e-16 = 1e-13.
TEST(RigidBody, KeepsMomentumEnergyAndOrthogonality) {
  auto body = body_of(Vec3(1, 2, 3.5), Vec3(0.01, 5, 0.02));
  const Vec3 momentum = body.momentum;
  const Real energy = body.kinetic(0.01);
  Real worst = 0;
  for (int n = 0; n < 200000; ++n) {
    body.drift(0.01);
    worst = std::max(worst, std::fabs(body.kinetic(0.01) / energy - 1));
  }
  EXPECT_EQ(body.momentum, momentum);
  EXPECT_LT(worst, 1e-12);
  const Mat3 R = body.rotation();
  EXPECT_LT((R.transpose() * R - Mat3::Identity()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(R.determinant(), 1, 1e-15);
}

// Arms move along chords: r(n+1) - r(n) = dt w x (r(n) + r(n+1))/2, whatever the angle of the step.
TEST(RigidBody, TellsTheRateOfItsChords) {
  auto body = body_of(Vec3(1, 2, 3.5), Vec3(3, 5, -2));
  for (const Real dt : {1e-6, 0.01, 0.1}) {
    const Vec3 start(0.3, -0.7, 0.2);
    const Vec3 before = body.rotation() * start;
    const Vec3 w = body.drift(dt);
    const Vec3 after = body.rotation() * start;
    EXPECT_LT((after - before - dt * w.cross(0.5 * (before + after))).norm(), 4e-16) << dt;
  }
}

// A turn without end about one axis is exact: its angle is |W| t, whatever the step.
TEST(RigidBody, TurnsAboutAPrincipalAxisExactly) {
  auto body = body_of(Vec3(1, 2, 3), Vec3(0, 0, 2));
  for (int n = 0; n < 10; ++n) body.drift(0.1);
  EXPECT_LT((rotation_vector(body.turn) - Vec3(0, 0, 2)).norm(), 1e-14);
  for (int n = 0; n < 10; ++n) body.drift(0.1);  // 4 rad is the same as 4 - 2 pi
  EXPECT_LT((rotation_vector(body.turn) - Vec3(0, 0, 4 - 2 * kPi)).norm(), 1e-14);
}

// A constant torque T about a principal axis: angle T t^2/(2 J). Kicks and drifts of velocity
// Verlet are exact for it: angle(n) = sum dt (L(0) + (k + 1/2) dt T)/J = T t^2/(2J). Its energy: J
// w^2/2 = T angle, and the scheme's own differs by dt^2 T^2/(8 J).
TEST(RigidBody, TorquesTurnIt) {
  const Real dt = 0.01, T = 3, J = 2;
  auto body = body_of(Vec3(1, J, 3), Vec3::Zero());
  body.torque = Vec3(0, T, 0);
  for (int n = 0; n < 50; ++n) {
    body.kick(dt);
    body.drift(dt);
    body.kick(dt);
  }
  const Real t = 0.5, angle = T * t * t / (2 * J);
  EXPECT_LT((rotation_vector(body.turn) - Vec3(0, angle, 0)).norm(), 1e-14);
  EXPECT_NEAR(body.kinetic(dt), T * angle - dt * dt * T * T / (8 * J), 1e-14);
  EXPECT_NEAR(body.fastest_spin(), T * t, 1e-14);  // the least moment of inertia is 1
}

// A unit force along e at an arm r accelerates the point of it along itself by
// e.e/m + (r x e).I^-1 (r x e): the largest over directions, found by trying many.
TEST(RigidBody, ComplianceIsTheLargestOverDirections) {
  const Mat3 inverse = Mat3(Vec3(1, 2, 5).asDiagonal()).inverse();
  const Vec3 r(0.4, -0.3, 0.9);
  const Real found = compliance_at(r, 2, inverse);
  Real largest = 0;
  for (int i = 0; i < 200; ++i) {
    for (int j = 0; j < 400; ++j) {
      const Real a = kPi * i / 200, b = 2 * kPi * j / 400;
      const Vec3 e(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      const Vec3 arm = r.cross(e);
      largest = std::max(largest, 0.5 + arm.dot(inverse * arm));
    }
  }
  EXPECT_LE(largest, found + 1e-14);
  EXPECT_NEAR(largest, found, 1e-3 * found);  // directions are 0.016 rad apart
}

}  // namespace
}  // namespace brunt
