#pragma once
#include <cmath>

#include "core/types.hpp"

namespace brunt {

/// One rigid body that follows its forces: velocity Verlet for its centre and for its turning, with
/// the angular momentum in space as the state. Between kicks it turns freely by the rule that keeps
/// momentum and energy, both to round-off (Simo & Wong 1991, their ALGO_C1):
///   R(n+1) = R(n) exp(theta),  theta = dt/2 (W(n) + W(n+1)),  W = J^-1 R^T L
/// In 2D it lives in the plane z = 0, and its momentum along z.
struct RigidBody {
  Real mass = 0;                             ///< [kg]
  Mat3 inertia = Mat3::Identity();           ///< [kg m^2] J, about the centre, as it lay at time 0
  Mat3 inverse_inertia = Mat3::Identity();   ///< [1/kg/m^2]
  Vec3 x = Vec3::Zero();                     ///< [m] centre of mass
  Vec3 v = Vec3::Zero();                     ///< [m/s] at the half step between kicks
  Vec3 a = Vec3::Zero();                     ///< [m/s^2] at the last full step
  Eigen::Quaternion<Real> turn{1, 0, 0, 0};  ///< R, from how it lay at time 0; of length 1
  Vec3 momentum = Vec3::Zero();              ///< [kg m^2/s] L, angular, about the centre
  Vec3 torque = Vec3::Zero();                ///< [N m] about the centre at the last full step

  Mat3 rotation() const { return turn.toRotationMatrix(); }
  /// I^-1 of a vector in space: omega [rad/s] of the momentum.
  Vec3 over_inertia(const Vec3& vector) const;
  Vec3 spin() const { return over_inertia(momentum); }  ///< [rad/s]
  /// v and L by half a step of the accelerations that the last full step had.
  void kick(Real dt);
  /// Moves and turns for a step. Returns the rate of the chords [rad/s]: w of
  /// r(n+1) - r(n) = dt w x (r(n) + r(n+1))/2 for every arm r, along the axis of the turn.
  Vec3 drift(Real dt);
  /// Kinetic energy [J] that the scheme keeps at a whole step: of its half steps before and after,
  ///   m v(n-1/2).v(n+1/2)/2 + L(n-1/2).I^-1 L(n+1/2)/2,  for steps of dt.
  Real kinetic(Real dt) const;
  /// [J s^-2] what a change of the step leaves in kinetic(): this times (dt^2 - dt_last^2)/8.
  Real kick_energy() const;
  /// [rad/s] no lower than the rate at which it can turn without a torque: |L| / least inertia.
  Real fastest_spin() const;
};

/// The rate of the chords of a turn by an angle in dt about an axis: 2 tan(angle/2)/dt along it.
inline Real chord_rate(Real angle, Real dt) { return 2 * std::tan(0.5 * angle) / dt; }

/// Axis times angle [rad] of a turn, the angle in [0, pi].
Vec3 rotation_vector(const Eigen::Quaternion<Real>& turn);

/// [1/kg] largest inverse mass, of all directions, with which a free body meets a force at an arm
/// from its centre: 1/m + the largest eigenvalue of [r]^T I^-1 [r].
Real compliance_at(const Vec3& arm, Real mass, const Mat3& inverse_inertia);

/// Integrals over the surface of a free body of what springs alike in all directions do to it, from
/// places with their areas: [1, -[r]; [r], -[r][r]] of arms r from the centre.
class SurfaceSprings {
 public:
  /// arm [m];  area [m^2]
  void add(const Vec3& arm, Real area);
  /// [1/kg] largest eigenvalue of M^-1 K of springs of 1 Pa/m, by area: springs k on all of its
  /// surface A have a frequency^2 of k A times that at most.
  Real compliance(Real mass, const Mat3& inverse_inertia) const;

 private:
  Real area_ = 0;
  Eigen::Matrix<Real, 6, 6> sum_ = Eigen::Matrix<Real, 6, 6>::Zero();
};

}  // namespace brunt
