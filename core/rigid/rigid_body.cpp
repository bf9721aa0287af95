#include "core/rigid/rigid_body.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace brunt {

namespace {
/// The turn by a rotation vector [rad].
Eigen::Quaternion<Real> exponential(const Vec3& theta) {
  const Real half = 0.5 * theta.norm();
  const Real ratio = half > 0 ? 0.5 * std::sin(half) / half : 0.5;
  return {std::cos(half), ratio * theta[0], ratio * theta[1], ratio * theta[2]};
}
}  // namespace

Vec3 RigidBody::over_inertia(const Vec3& vector) const {
  const Mat3 r = rotation();
  return r * (inverse_inertia * (r.transpose() * vector));
}

void RigidBody::kick(Real dt) {
  v += 0.5 * dt * a;
  momentum += 0.5 * dt * torque;
}

Vec3 RigidBody::drift(Real dt) {
  x += dt * v;
  const Mat3 before = rotation();
  const Vec3 body_momentum = before.transpose() * momentum;
  const Vec3 first = inverse_inertia * body_momentum;
  // A fixed point: each pass is nearer by a factor of about dt |W| / 2, for stable steps 0.1.
  constexpr int kMost = 100;
  Vec3 theta = dt * first;
  for (int pass = 0; pass < kMost; ++pass) {
    const Vec3 last = inverse_inertia * (exponential(theta).conjugate() * body_momentum);
    const Vec3 next = 0.5 * dt * (first + last);
    const bool settled = (next - theta).squaredNorm() <= 2e-31 * next.squaredNorm();
    theta = next;
    if (settled) break;
  }
  turn = (turn * exponential(theta)).normalized();
  const Real angle = theta.norm();
  if (!(angle > 0)) return Vec3::Zero();
  return before * (chord_rate(angle, dt) / angle * theta);
}

Real RigidBody::kick_energy() const {
  return mass * a.squaredNorm() + torque.dot(over_inertia(torque));
}

Real RigidBody::kinetic(Real dt) const {
  return 0.5 * (mass * v.squaredNorm() + momentum.dot(spin())) - 0.125 * dt * dt * kick_energy();
}

Real RigidBody::fastest_spin() const {
  return momentum.norm() * Eigen::SelfAdjointEigenSolver<Mat3>(inverse_inertia).eigenvalues()[2];
}

Vec3 rotation_vector(const Eigen::Quaternion<Real>& turn) {
  const Real sign = turn.w() < 0 ? -1 : 1;
  const Vec3 axis = sign * turn.vec();
  const Real sine = axis.norm();
  if (!(sine > 0)) return Vec3::Zero();
  return 2 * std::atan2(sine, sign * turn.w()) / sine * axis;
}

Real compliance_at(const Vec3& arm, Real mass, const Mat3& inverse_inertia) {
  Mat3 cross;
  cross << 0, -arm[2], arm[1], arm[2], 0, -arm[0], -arm[1], arm[0], 0;
  const Mat3 turning = cross.transpose() * inverse_inertia * cross;
  const Mat3 symmetric = 0.5 * (turning + turning.transpose());
  return 1 / mass + Eigen::SelfAdjointEigenSolver<Mat3>(symmetric).eigenvalues()[2];
}

void SurfaceSprings::add(const Vec3& arm, Real area) {
  Eigen::Matrix<Real, 3, 6> motion = Eigen::Matrix<Real, 3, 6>::Zero();
  motion.leftCols<3>().setIdentity();
  motion.rightCols<3>() << 0, arm[2], -arm[1], -arm[2], 0, arm[0], arm[1], -arm[0], 0;
  sum_ += area * motion.transpose() * motion;
  area_ += area;
}

Real SurfaceSprings::compliance(Real mass, const Mat3& inverse_inertia) const {
  Eigen::Matrix<Real, 6, 6> root = Eigen::Matrix<Real, 6, 6>::Zero();
  root.topLeftCorner<3, 3>() = Mat3::Identity() / std::sqrt(mass);
  root.bottomRightCorner<3, 3>() =
      Eigen::SelfAdjointEigenSolver<Mat3>(inverse_inertia).operatorSqrt();
  const Eigen::Matrix<Real, 6, 6> all = root * sum_ * root,
                                  symmetric = 0.5 * (all + all.transpose());
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix<Real, 6, 6>>(symmetric, Eigen::EigenvaluesOnly)
             .eigenvalues()[5] /
         area_;
}

}  // namespace brunt
