#include "app/deck/gravity.hpp"

#include <algorithm>
#include <cmath>

#include "core/boundaries/function.hpp"

namespace brunt::deck {

namespace {
template <class Is>
bool any_is(const Gravity& gravity, const Is& is) {
  return gravity && std::any_of(gravity->begin(), gravity->end(),
                                [&](const auto& component) { return component && is(*component); });
}

Real value_at(const Varying& component, Real time) {
  return component.is_expression() ? component.evaluate({time, 0, 0, 0}) : component.at(time);
}
}  // namespace

void describe_gravity(Schema& s, Gravity& gravity) {
  s.components({"gravity", "acceleration of all that is free; components may depend on time"},
               gravity, {"m/s^2", {}, between(-1e4, 1e4)}, kTimeOrPlace);
  s.require(!gravity || std::all_of(gravity->begin(), gravity->end(),
                                    [](const auto& component) { return component.has_value(); }),
            "gravity", "a component of an acceleration cannot be free: write 0");
  s.require(!any_is(gravity,
                    [](const Varying& component) {
                      const auto& on = component.depends;
                      return component.is_expression() && (on[1] || on[2] || on[3]);
                    }),
            "gravity", "is one everywhere: of t alone");
}

bool pulls(const Gravity& gravity) {
  return any_is(gravity,
                [](const Varying& one) { return !one.is_constant() || one.constant != 0; });
}

bool is_over_time(const Gravity& gravity) {
  return any_is(gravity, [](const Varying& component) { return !component.is_constant(); });
}

std::array<Real, 3> gravity_at(const Gravity& gravity, Real time) {
  std::array<Real, 3> now{};
  for (std::size_t c = 0; gravity && c < std::min(gravity->size(), now.size()); ++c) {
    if ((*gravity)[c]) now[c] = value_at(*(*gravity)[c], time);
  }
  return now;
}

std::vector<Real> gravity_times(const Gravity& gravity, Real end) {
  constexpr int kParts = 256;
  std::vector<Real> times{0};
  for (int part = 1;
       part <= kParts &&
       any_is(gravity, [](const Varying& component) { return component.is_expression(); });
       ++part) {
    times.push_back(end * part / kParts);
  }
  for (std::size_t c = 0; gravity && c < gravity->size(); ++c) {
    if (!(*gravity)[c]) continue;
    for (const Real bend : (*gravity)[c]->abscissa)
      times.push_back(std::max(0.0, std::min(bend, end)));
  }
  std::sort(times.begin(), times.end());
  return times;
}

std::vector<Real> largest_gravity(const Gravity& gravity, Real end) {
  std::vector<Real> largest(gravity ? gravity->size() : 0);
  Real most = -1;
  for (const Real time : gravity_times(gravity, end)) {
    const auto now = gravity_at(gravity, time);
    Real squared = 0;
    for (const Real one : now) squared += one * one;
    if (!(squared > most)) continue;
    most = squared;
    std::copy_n(now.begin(), std::min(largest.size(), now.size()), largest.begin());
  }
  return largest;
}

}  // namespace brunt::deck
