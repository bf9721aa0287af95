#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/deck/findings.hpp"
#include "app/setup/scene_checks.hpp"

namespace brunt {

namespace {
constexpr std::size_t kSamples = 200;  // points of a boundary that are looked at

template <int Dim>
struct Window {
  Real from, to;  // [s]
  Window(const Patch<Dim>& a, const Patch<Dim>& b, Real end)
      : from(std::max(a.from, b.from)), to(std::min({a.to, b.to, end})) {}
  bool empty() const { return !(from < to); }
  std::array<Real, 3> times() const { return {from, 0.5 * (from + to), to}; }
};

template <int Dim>
Vec3 place_of(const Patch<Dim>& patch, LocalIndex point) {
  return in_space<Dim>(patch.points->x_start[point] + patch.origin);
}

template <class Points>
std::vector<LocalIndex> some_of(const Points& points) {
  std::vector<LocalIndex> some;
  const std::size_t stride = points.size() / kSamples + 1;
  for (std::size_t i = 0; i < points.size(); i += stride) some.push_back(points[i]);
  if (!points.empty()) some.push_back(points.back());
  return some;
}

std::string at_text(Real time, const Vec3& place, int dim) {
  std::ostringstream out;
  out << "at t = " << deck::time_text(time) << " and (";
  for (int c = 0; c < dim; ++c) out << (c ? ", " : "") << place[c];
  out << ") m";
  return out.str();
}

/// Why a value of a boundary is no number, "" where all are.
template <int Dim>
std::string bad_value(const Patch<Dim>& patch, const FunctionOfTimeAndPlace& function,
                      const deck::Time& times) {
  const Window<Dim> window(patch, patch, times.end);
  for (const LocalIndex point : some_of(patch.chosen)) {
    const Vec3 place = place_of(patch, point);
    for (const Real time : window.times()) {
      const Real value = function(time, place);
      if (std::isfinite(value)) continue;
      return (std::isnan(value) ? "is not a number " : "is infinite ") +
             at_text(times.real(time), place, Dim);
    }
  }
  return "";
}

/// True where all values of a boundary are numbers; else each that is not is reported.
template <int Dim, class Acting>
bool check_values(const LoadedDeck& loaded, const Acting& acting,
                  std::vector<DeckProblem>& problems) {
  bool all = true;
  acting.visit_functions([&](const std::string& key, const FunctionOfTimeAndPlace& function) {
    const std::string bad = bad_value<Dim>(acting.patch, function, loaded.deck.time);
    if (bad.empty()) return;
    all = false;
    problems.push_back(
        loaded.places.problem("boundaries." + acting.patch.name + "." + key,
                              bad + "; t is in s, and x, y, z are the place at time 0 in m"));
  });
  return all;
}

/// Points that both have, of the same group.
template <int Dim>
std::vector<LocalIndex> shared_points(const Patch<Dim>& a, const Patch<Dim>& b) {
  std::vector<LocalIndex> first = a.chosen, second = b.chosen, shared;
  if (a.points != b.points) return shared;
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(shared));
  return shared;
}

template <int Dim>
void check_pair(const LoadedDeck& loaded, const MotionSupport<Dim>& a, const MotionSupport<Dim>& b,
                std::vector<DeckProblem>& problems) {
  const Window<Dim> window(a.patch, b.patch, loaded.deck.time.end);
  if (window.empty()) return;
  const Real speed = loaded.deck.time.process_speed;
  const auto shared = shared_points(a.patch, b.patch);
  for (int c = 0; c < Dim; ++c) {
    const auto k = slot_of(c);
    if (!a.velocity[k] || !b.velocity[k]) continue;
    for (const LocalIndex point : some_of(shared)) {
      for (const Real time : window.times()) {
        const Vec3 place = place_of(a.patch, point);
        const Real first = (*a.velocity[k])(time, place), second = (*b.velocity[k])(time, place);
        constexpr Real kRoundOff = 1e-9;
        if (std::fabs(first - second) <= kRoundOff * std::max(std::fabs(first), std::fabs(second)))
          continue;
        const std::string axis(1, "xyz"[c]);
        problems.push_back(loaded.places.problem(
            "boundaries." + b.patch.name,
            "shares " + std::to_string(shared.size()) + " points with '" + a.patch.name +
                "', and they move along " + axis + " at " + deck::short_text(second / speed) +
                " m/s here and at " + deck::short_text(first / speed) + " m/s there; leave " +
                axis + " free in one of them, or choose other points"));
        return;
      }
    }
  }
}
}  // namespace

template <int Dim>
void check_constraints(const LoadedDeck& loaded, const Scene<Dim>& scene,
                       std::vector<DeckProblem>& problems) {
  if (!(loaded.deck.time.end > 0)) return;  // reported already
  std::vector<const MotionSupport<Dim>*> sound;
  scene.boundaries.each([&](const auto& acting) {
    if constexpr (requires { acting.visit_functions([](const std::string&, const auto&) {}); }) {
      const bool numbers = check_values<Dim>(loaded, acting, problems);
      if constexpr (std::is_same_v<decltype(acting), const MotionSupport<Dim>&>) {
        if (numbers) sound.push_back(&acting);
      }
    }
  });
  for (std::size_t j = 0; j < sound.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) check_pair(loaded, *sound[i], *sound[j], problems);
  }
}

template void check_constraints<2>(const LoadedDeck&, const Scene<2>&, std::vector<DeckProblem>&);
template void check_constraints<3>(const LoadedDeck&, const Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
