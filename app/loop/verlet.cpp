#include "app/loop/verlet.hpp"

#include <algorithm>

#include "core/parallel/threads.hpp"
#include "core/simd.hpp"

namespace brunt {

namespace {
/// Points whose fields are in the first cache at once.
constexpr LocalIndex kRun = 64;
constexpr LocalIndex kRunsWorthThreads = kPointsWorthThreads / kRun;

/// Calls f(first, last) for runs of at most kRun owned points.
template <int Dim, class F>
void for_runs(const Points<Dim>& points, const F& f) {
  const LocalIndex n = points.n_owned;
  for_each((n + kRun - 1) / kRun, kRunsWorthThreads, [n, f](LocalIndex run) {
    f(slot_of(run) * kRun, slot_of(std::min(n, (run + 1) * kRun)));
  });
}

/// Component after component of all points: each moves by itself.
template <int Dim>
Real* values_of(std::vector<Vec<Dim>>& field) {
  static_assert(sizeof(Vec<Dim>) == Dim * sizeof(Real));
  return field.empty() ? nullptr : field.front().data();
}

/// The mass that each value of part `part` of four points has: value j is of point j/Dim.
template <int Dim, int part>
BRUNT_INLINE Pack of_values(Pack mass) {
  constexpr int j = part * kLanes;
  return __builtin_shufflevector(mass, mass, j / Dim, (j + 1) / Dim, (j + 2) / Dim, (j + 3) / Dim);
}

/// a = f/m and v += dt/2 a of part `part` of four points; without mass they keep both.
template <int Dim, int part>
BRUNT_INLINE void correct_part(Pack mass, Real half_dt, const Real* f, Real* a, Real* v) {
  const Pack m = of_values<Dim, part>(mass), none = broadcast<Pack>(0);
  f += part * kLanes, a += part * kLanes, v += part * kLanes;
  const Pack now = load(f) / m;
  store(a, select(m == none, load(a), now));
  store(v, select(m == none, load(v), load(v) + half_dt * now));
}

template <int Dim>
BRUNT_INLINE void correct_four(const Real* mass, Real half_dt, const Real* f, Real* a, Real* v) {
  const Pack m = load(mass);
  correct_part<Dim, 0>(m, half_dt, f, a, v);
  correct_part<Dim, 1>(m, half_dt, f, a, v);
  if constexpr (Dim == 3) correct_part<Dim, 2>(m, half_dt, f, a, v);
}

template <int Dim>
void correct_run(Points<Dim>& points, std::size_t k, std::size_t last, Real half_dt) {
  Real* const a = values_of<Dim>(points.a);
  Real* const v = values_of<Dim>(points.v);
  const Real* const f = values_of<Dim>(points.f);
  for (; k + kLanes <= last; k += kLanes) {
    correct_four<Dim>(points.mass.data() + k, half_dt, f + k * Dim, a + k * Dim, v + k * Dim);
  }
  for (; k < last; ++k) {
    if (points.mass[k] == 0) continue;
    points.a[k] = points.f[k] / points.mass[k];
    points.v[k] += half_dt * points.a[k];
  }
}

template <int Dim>
void predict_run(Points<Dim>& points, std::size_t first, std::size_t last, Real dt, Real change) {
  for (std::size_t k = first; k < last; ++k) {
    points.integration[k] += change * points.mass[k] * points.a[k].squaredNorm();
  }
  Real* const __restrict v = values_of<Dim>(points.v);
  Real* const __restrict x = values_of<Dim>(points.x);
  Real* const __restrict rest = values_of<Dim>(points.x_rest);
  Real* const __restrict f = values_of<Dim>(points.f);
  const Real* const __restrict a = values_of<Dim>(points.a);
  const Real half_dt = 0.5 * dt;
  for (std::size_t j = first * Dim; j < last * Dim; ++j) {
    v[j] += half_dt * a[j];
    move_value(dt * v[j], x[j], rest[j]);
    f[j] = 0;
  }
}
}  // namespace

template <int Dim>
void predict(Points<Dim>& points, Real dt, Real dt_last) {
  const Real change = (dt * dt - dt_last * dt_last) / 8;
  for_runs(points, [&points, dt, change](std::size_t first, std::size_t last) {
    predict_run(points, first, last, dt, change);
  });
  if (points.conducts) points.begin_heat_rates();
}

template <int Dim>
void correct(Points<Dim>& points, Real dt) {
  for_runs(points, [&points, half_dt = 0.5 * dt](std::size_t first, std::size_t last) {
    correct_run(points, first, last, half_dt);
  });
  if (!points.conducts) return;
  for_each(points.n_owned, kPointsWorthThreads, [&points, dt](LocalIndex i) {
    const auto k = slot_of(i);
    points.heat[k] += dt * points.heat_rate[k];
    points.temperature[k] = points.temperature_with(k, points.heat[k]);
  });
}

template void predict<2>(Points<2>&, Real, Real);
template void predict<3>(Points<3>&, Real, Real);
template void correct<2>(Points<2>&, Real);
template void correct<3>(Points<3>&, Real);

}  // namespace brunt
