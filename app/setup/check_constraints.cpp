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
  Window(const Constraint<Dim>& a, const Constraint<Dim>& b, Real end)
      : from(std::max(a.from, b.from)), to(std::min({a.to, b.to, end})) {}
  bool empty() const { return !(from < to); }
  std::array<Real, 3> times() const { return {from, 0.5 * (from + to), to}; }
};

template <int Dim>
Vec3 place_of(const Constraint<Dim>& constraint, const Scene<Dim>& scene, LocalIndex point) {
  Vec3 place = Vec3::Zero();
  place.template head<Dim>() =
      constraint.points->x_start[static_cast<std::size_t>(point)] + scene.origin;
  return place;
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

/// True where all values are numbers; else the first that is not is reported.
template <int Dim>
bool check_values(const LoadedDeck& loaded, const Scene<Dim>& scene,
                  const Constraint<Dim>& constraint, std::vector<DeckProblem>& problems) {
  const Window<Dim> window(constraint, constraint, loaded.deck.time.end);
  bool all = true;
  for (int c = 0; c < Dim; ++c) {
    const auto& velocity = constraint.velocity[static_cast<std::size_t>(c)];
    if (!velocity) continue;
    const auto bad = [&]() -> std::string {
      for (const LocalIndex point : some_of(constraint.chosen)) {
        const Vec3 place = place_of(constraint, scene, point);
        for (const Real time : window.times()) {
          const Real value = (*velocity)(time, place);
          if (!std::isfinite(value)) {
            return (std::isnan(value) ? "is not a number " : "is infinite ") +
                   at_text(time, place, Dim);
          }
        }
      }
      return "";
    }();
    if (bad.empty()) continue;
    all = false;
    problems.push_back(
        loaded.places.problem("boundaries." + constraint.name + ".velocity." + std::to_string(c),
                              bad + "; t is in s, and x, y, z are the place at time 0 in m"));
  }
  return all;
}

/// Points that both have, of the same group.
template <int Dim>
std::vector<LocalIndex> shared_points(const Constraint<Dim>& a, const Constraint<Dim>& b) {
  std::vector<LocalIndex> first = a.chosen, second = b.chosen, shared;
  if (a.points != b.points) return shared;
  std::sort(first.begin(), first.end());
  std::sort(second.begin(), second.end());
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(shared));
  return shared;
}

template <int Dim>
void check_pair(const LoadedDeck& loaded, const Scene<Dim>& scene, const Constraint<Dim>& a,
                const Constraint<Dim>& b, std::vector<DeckProblem>& problems) {
  const Window<Dim> window(a, b, loaded.deck.time.end);
  if (window.empty()) return;
  const auto shared = shared_points(a, b);
  for (int c = 0; c < Dim; ++c) {
    const auto k = static_cast<std::size_t>(c);
    if (!a.velocity[k] || !b.velocity[k]) continue;
    for (const LocalIndex point : some_of(shared)) {
      for (const Real time : window.times()) {
        const Vec3 place = place_of(a, scene, point);
        const Real first = (*a.velocity[k])(time, place), second = (*b.velocity[k])(time, place);
        constexpr Real kRoundOff = 1e-9;
        if (std::fabs(first - second) <= kRoundOff * std::max(std::fabs(first), std::fabs(second)))
          continue;
        const std::string axis(1, "xyz"[c]);
        problems.push_back(loaded.places.problem(
            "boundaries." + b.name, "shares " + std::to_string(shared.size()) + " points with '" +
                                        a.name + "', and they move along " + axis + " at " +
                                        deck::short_text(second) + " m/s here and at " +
                                        deck::short_text(first) + " m/s there; leave " + axis +
                                        " free in one of them, or choose other points"));
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
  const auto& constraints = scene.supports.constraints();
  std::vector<const Constraint<Dim>*> sound;
  for (const auto& constraint : constraints) {
    if (check_values(loaded, scene, constraint, problems)) sound.push_back(&constraint);
  }
  for (std::size_t j = 0; j < sound.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) check_pair(loaded, scene, *sound[i], *sound[j], problems);
  }
}

template void check_constraints<2>(const LoadedDeck&, const Scene<2>&, std::vector<DeckProblem>&);
template void check_constraints<3>(const LoadedDeck&, const Scene<3>&, std::vector<DeckProblem>&);

}  // namespace brunt
