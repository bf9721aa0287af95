#pragma once
/// The spring-slider of Coulomb friction, and how its plane turns (docs/theory/contact.md (C27),
/// (C28)).
#include <algorithm>
#include <array>
#include <cmath>

#include "core/simd.hpp"
#include "core/types.hpp"

namespace brunt {

/// A step of a spring-slider: elastic up to `limit`, then sliding along itself.
template <int Dim>
struct Slide {
  Vec<Dim> traction;  ///< [Pa] at the end
  Vec<Dim> slip;      ///< [m] what of the displacement was no stretch of the spring
  bool slips = false;
};

/// Traction that resists after a relative displacement, by return mapping.
///   t* = t - k du;  |t*| <= limit: t* sticks, else t = limit t*/|t*| and the rest of du is slip
/// The work -(t_old + t_new)/2 . du is exactly what the spring stores, |t|^2/2k, plus the heat
/// -(t_old + t_new)/2 . slip.
/// before [Pa] in the present plane;  stiffness [Pa/m], > 0;  du [m];  limit [Pa], >= 0
template <int Dim>
Slide<Dim> slide(const Vec<Dim>& before, Real stiffness, const Vec<Dim>& du, Real limit) {
  Slide<Dim> step;
  const Vec<Dim> trial = before - stiffness * du;
  const Real size = trial.norm();
  step.slips = size > limit;
  step.traction = step.slips ? Vec<Dim>(limit / size * trial) : trial;
  step.slip = (step.traction - trial) / stiffness;
  return step;
}

/// The part of a damper's traction with which both stay within the limit; |spring| <= limit.
template <int Dim>
Vec<Dim> within_limit(const Vec<Dim>& spring, const Vec<Dim>& damper, Real limit) {
  if ((spring + damper).squaredNorm() <= limit * limit) return damper;
  const Real a = damper.squaredNorm(), b = spring.dot(damper);
  if (!(a > 0)) return damper;  // the spring alone may round to more than the limit
  const Real c = std::min(spring.squaredNorm() - limit * limit, 0.0);
  return Vec<Dim>(std::max(std::sqrt(b * b - a * c) - b, 0.0) / a * damper);
}

/// The turn of a contact's plane from one step to the next: the shortest that takes the old normal
/// to the new one, then a spin about the new normal. Exact where both bodies turn as one.
template <int Dim>
class PlaneTurn;

template <>
class PlaneTurn<2> {
 public:
  PlaneTurn(const Vec<2>& from, const Vec<2>& to)
      : cosine_(from.dot(to)), sine_(from[0] * to[1] - from[1] * to[0]) {}
  Real cosine() const { return cosine_; }
  Vec<2> tilted(const Vec<2>& v) const {
    return Vec<2>(cosine_ * v[0] - sine_ * v[1], sine_ * v[0] + cosine_ * v[1]);
  }
  Vec<2> operator()(const Vec<2>& v) const { return tilted(v); }
  /// Three of them.
  std::array<Vec<2>, 3> operator()(const std::array<Vec<2>, 3>& v) const {
    return {tilted(v[0]), tilted(v[1]), tilted(v[2])};
  }

 private:
  Real cosine_, sine_;
};

template <>
class PlaneTurn<3> {
 public:
  PlaneTurn(const Vec3& from, const Vec3& to)
      : normal_(to), axis_(from.cross(to)), cosine_(from.dot(to)), part_(1 / (1 + cosine_)) {}
  Real cosine() const { return cosine_; }
  /// Rodrigues' formula for the shortest turn; cosine() > -1.
  Vec3 tilted(const Vec3& v) const {
    const Vec3 once = axis_.cross(v);
    return v + once + part_ * axis_.cross(once);
  }
  /// The same of four vectors, by component.
  BRUNT_INLINE std::array<Pack, 3> tilted(const std::array<Pack, 3>& v) const {
    const auto once = crossed(axis_, v), twice = crossed(axis_, once);
    return {v[0] + once[0] + part_ * twice[0], v[1] + once[1] + part_ * twice[1],
            v[2] + once[2] + part_ * twice[2]};
  }
  /// The spin that follows, by any positive multiples of its cosine and sine; none if both are 0.
  void spin(Real cosine, Real sine) {
    const Real size = std::sqrt(cosine * cosine + sine * sine);
    if (!(size > 0)) return;
    spin_cosine_ = cosine / size, spin_sine_ = sine / size;
  }
  Vec3 operator()(const Vec3& v) const {
    const Vec3 t = tilted(v);
    const Vec3 along = normal_.dot(t) * normal_;
    return along + spin_cosine_ * (t - along) + spin_sine_ * normal_.cross(t);
  }
  /// The same of three vectors side by side, with the bits of each alone.
  BRUNT_INLINE std::array<Vec3, 3> operator()(const std::array<Vec3, 3>& v) const {
    std::array<Pack, 3> t;
    for (int c = 0; c < 3; ++c) t[slot_of(c)] = Pack{v[0][c], v[1][c], v[2][c], 0};
    t = tilted(t);
    const auto beside = crossed(normal_, t);
    const Pack height = normal_[0] * t[0] + normal_[1] * t[1] + normal_[2] * t[2];
    std::array<Vec3, 3> turned;
    for (int c = 0; c < 3; ++c) {
      const auto k = slot_of(c);
      const Pack along = height * normal_[c];
      const Pack now = along + spin_cosine_ * (t[k] - along) + spin_sine_ * beside[k];
      turned[0][c] = now[0], turned[1][c] = now[1], turned[2][c] = now[2];
    }
    return turned;
  }

 private:
  /// a x w of four vectors, by component.
  BRUNT_INLINE static std::array<Pack, 3> crossed(const Vec3& a, const std::array<Pack, 3>& w) {
    return {a[1] * w[2] - a[2] * w[1], a[2] * w[0] - a[0] * w[2], a[0] * w[1] - a[1] * w[0]};
  }

  Vec3 normal_, axis_;
  Real cosine_, part_, spin_cosine_ = 1, spin_sine_ = 0;
};

/// Torque of a force f at an arm r, and what a turn w does to an arm: a number in 2D.
inline Real cross(const Vec<2>& r, const Vec<2>& f) { return r[0] * f[1] - r[1] * f[0]; }
inline Vec3 cross(const Vec3& r, const Vec3& f) { return r.cross(f); }
inline Vec<2> turn(Real w, const Vec<2>& r) { return Vec<2>(-w * r[1], w * r[0]); }
inline Vec3 turn(const Vec3& w, const Vec3& r) { return w.cross(r); }

}  // namespace brunt
