#include "core/boundaries/motion.hpp"

#include <utility>

namespace brunt {

void describe(Schema& s, PrescribedMotion& motion) {
  s.words({"fix", "components that do not move"}, motion.fix, s.axes());
  s.components({"velocity", "prescribed velocity, each component or free"}, motion.velocity,
               {"m/s", {}, between(-1e5, 1e5)}, kTimeOrPlace);
}

template <int Dim>
MotionSupport<Dim>::MotionSupport(const PrescribedMotion& motion, Patch<Dim> on)
    : patch(std::move(on)) {
  for (const auto& axis : motion.fix) {
    const int c = axis[0] - 'x';
    if (c < Dim) velocity[c] = [](Real, const Vec3&) { return 0.0; };
  }
  for (std::size_t c = 0; motion.velocity && c < motion.velocity->size() && c < Dim; ++c) {
    if ((*motion.velocity)[c]) velocity[c] = function_of(*(*motion.velocity)[c]);
  }
}

template <int Dim>
void MotionSupport<Dim>::start() {
  if (!patch.acts(0)) return;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const Vec3 place = patch.place(k);
    for (int c = 0; c < Dim; ++c) {
      if (velocity[c]) patch.points->v[patch.point(k)][c] = (*velocity[c])(0, place);
    }
  }
}

template <int Dim>
void MotionSupport<Dim>::impose(Real time, Real dt) {
  if (!patch.acts(time)) return;
  const bool begins = !patch.acts(time - dt);
  auto& points = *patch.points;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const std::size_t i = patch.point(k);
    const Vec3 place = patch.place(k);
    Vec<Dim> change = Vec<Dim>::Zero();  // of the motion that was predicted
    for (int c = 0; c < Dim; ++c) {
      if (!velocity[c]) continue;
      const Real old = points.a[i][c];
      const Real v_start = points.v[i][c] - 0.5 * dt * old;
      const Real v_half = (*velocity[c])(time - 0.5 * dt, place);
      const Real needed = 2 * (v_half - v_start) / dt;
      reaction[k][c] += points.mass[i] * (needed - old);
      // What begins to hold a point that moves takes its kinetic energy at once.
      const Real taken = dt * dt / 8 * points.mass[i] * (needed * needed - old * old);
      (begins ? work[k] : points.integration[i]) += begins ? -taken : taken;
      points.a[i][c] = needed;
      change[c] = dt * (v_half - points.v[i][c]);
      points.v[i][c] = v_half;
    }
    points.move(i, change);
  }
}

template <int Dim>
void MotionSupport<Dim>::take_reactions(Real time, Real dt) {
  auto& points = *patch.points;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    const std::size_t i = patch.point(k);
    const Vec3 place = patch.place(k);
    Vec<Dim> now = Vec<Dim>::Zero();
    for (int c = 0; c < Dim && patch.acts(time); ++c) {
      if (!velocity[c]) continue;
      const Real v_end = (*velocity[c])(time, place);
      const Real needed = 2 * (v_end - points.v[i][c]) / dt;
      now[c] = points.mass[i] * needed - points.f[i][c];
      points.f[i][c] = points.mass[i] * needed;
    }
    work[k] += 0.5 * dt * points.v[i].dot(reaction[k] + now);
    reaction[k] = now;
  }
}

template <int Dim>
void MotionSupport<Dim>::add_totals(Totals<Dim>& totals) const {
  for (const Real one : work) totals.add(Column::boundary, -one);
}

template struct MotionSupport<2>;
template struct MotionSupport<3>;

}  // namespace brunt
// Tested by tests/unit/app/supports_test.cpp.
