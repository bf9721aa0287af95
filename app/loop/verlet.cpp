#include "app/loop/verlet.hpp"

#include <algorithm>

#include "core/parallel/threads.hpp"

namespace brunt {

template <int Dim>
void predict(Points<Dim>& points, Real dt, Real dt_last) {
  const Real change = (dt * dt - dt_last * dt_last) / 8;
  for_each(points.n_owned, kPointsWorthThreads, [&points, dt, change](LocalIndex i) {
    const auto k = slot_of(i);
    points.integration[k] += change * points.mass[k] * points.a[k].squaredNorm();
    points.v[k] += 0.5 * dt * points.a[k];
    points.move(k, dt * points.v[k]);
    points.f[k].setZero();
  });
  if (!points.conducts) return;
  const auto n = points.n_owned;
  std::fill_n(points.heat_rate.begin(), n, 0.0);
  std::fill_n(points.conductance.begin(), n, 0.0);
}

template <int Dim>
void correct(Points<Dim>& points, Real dt) {
  for_each(points.n_owned, kPointsWorthThreads, [&points, dt](LocalIndex i) {
    const auto k = slot_of(i);
    if (points.mass[k] == 0) return;
    points.a[k] = points.f[k] / points.mass[k];
    points.v[k] += 0.5 * dt * points.a[k];
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
