#include "app/loop/step_check.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>

#include "app/ranks/gather_state.hpp"
#include "core/state_hash.hpp"

namespace brunt {

namespace {
constexpr Real kSpeed = 1e-4;  // [m/s] strains of 1e-6 and less, far from yield
constexpr int kSteps = 80;     // a step 0.1 % too long grows by exp(0.09) a step
constexpr int kRests = 5;
constexpr Real kGrowth = 100;      // what modes that beat with each other stay below
constexpr Real kPrecision = 2e-3;  // of a margin, relative

/// The step limit of a group, of all ranks.
template <int Dim>
StepLimit step_limit_of(const Solid<Dim>& solid, const Communicator& ranks) {
  StepLimit step_limit = solid.stable_step();
  step_limit.reason = "";  // no pointer goes from rank to rank
  return ranks.reduce(step_limit, [](StepLimit& a, const StepLimit& b) { a.take(b); });
}

/// A number of -1 .. 1 that is a function of a point and a direction alone.
Real random_of(GlobalId id, int direction) {
  EntityHash hash(id);
  hash.add(static_cast<Real>(direction));
  return static_cast<Real>(hash.value() >> 11) * 0x1p-52 - 1;
}

template <int Dim>
void evaluate(Scene<Dim>& scene, Solid<Dim>& solid, Real dt) {
  for (auto& f : solid.points().f) f.setZero();
  scene.refresh_motion();
  solid.renew_lists();
  solid.update_state(dt);
  solid.refresh_state();
  solid.add_internal_forces(dt);
}

/// The largest part of v that changes its sign from step to step, as what is unstable does; what
/// grows smoothly, as where a body buckles or relaxes, has next to none.
template <int Dim>
Real largest_alternation(const std::vector<Vec<Dim>>& v, const std::vector<Vec<Dim>>& before,
                         std::span<const Vec<Dim>> now) {
  Real largest = 0;
  for (std::size_t i = 0; i < v.size(); ++i) {
    largest = std::max(largest, (0.25 * (now[i] - 2 * v[i] + before[i])).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Forces [N] on the owned points at rest, where rate-dependent stress has relaxed.
template <int Dim>
std::vector<Vec<Dim>> forces_at_rest(Scene<Dim>& scene, Solid<Dim>& solid, Real dt) {
  auto& points = solid.points();
  for (auto& v : points.v) v.setZero();
  for (int k = 0; k < kRests; ++k) evaluate(scene, solid, dt);
  return {points.f.begin(), points.f.begin() + points.n_owned};
}

/// True where random motion of the group grows in steps of dt, to and fro.
template <int Dim>
bool grows(Scene<Dim>& scene, Solid<Dim>& solid, Real dt) {
  auto& points = solid.points();
  const auto n = points.owned();
  const auto at_rest = forces_at_rest(scene, solid, dt);
  for (std::size_t i = 0; i < n; ++i) {
    if (points.mass[i] == 0) continue;
    for (int d = 0; d < Dim; ++d) points.v[i][d] = kSpeed * random_of(points.id[i], d);
  }
  std::vector<Vec<Dim>> v(points.v.begin(), points.v.begin() + points.n_owned), before = v;
  for (int step = 0; step < kSteps; ++step) {
    const Real alternation = largest_alternation<Dim>(v, before, std::span(points.v).first(n));
    if (!(scene.ranks->max(alternation) < kGrowth * kSpeed)) return true;
    std::swap(v, before);
    std::copy_n(points.v.begin(), n, v.begin());
    for (std::size_t i = 0; i < n; ++i) points.move(i, dt * points.v[i]);
    evaluate(scene, solid, dt);
    for (std::size_t i = 0; i < n; ++i) {
      if (points.mass[i] > 0) points.v[i] += dt / points.mass[i] * (points.f[i] - at_rest[i]);
    }
  }
  return false;
}

/// All that a group carries from step to step, of all ranks.
template <int Dim>
class Kept {
 public:
  Kept(const Solid<Dim>& solid, const Communicator& ranks) {
    std::vector<StateTable> mine;
    solid.save_state(mine);
    all_ = of_all_ranks(mine, ranks);
  }
  void restore(Solid<Dim>& solid) const {
    solid.load_state(StateTables(all_));
    solid.rearrange();
  }

 private:
  std::vector<StateTable> all_;
};
}  // namespace

template <int Dim>
std::vector<StepMargin> find_step_margins(Scene<Dim>& scene) {
  std::vector<StepMargin> margins;
  for (auto& solid : scene.solids) {
    if (solid->rides()) continue;  // their nodes move them
    const StepLimit step_limit = step_limit_of(*solid, *scene.ranks);
    if (!std::isfinite(step_limit.step)) continue;  // rigid
    const Kept<Dim> kept(*solid, *scene.ranks);
    Real stable = 0.25, unstable = 4;
    while (unstable - stable > kPrecision * stable) {
      const Real middle = std::sqrt(stable * unstable);
      (grows(scene, *solid, middle * step_limit.step) ? unstable : stable) = middle;
      kept.restore(*solid);
    }
    margins.push_back({scene.body_names[step_limit.body], stable});
  }
  scene.refresh_motion();
  return margins;
}

namespace {
RunWarning warning_of(const std::string& body, Real margin) {
  std::ostringstream text;
  text.precision(3);
  text << body << ": is stable up to " << margin << " times its step limit; try a `time.safety` of "
       << 0.9 * margin;
  return {"time.check_step", text.str()};
}
}  // namespace

std::vector<RunWarning> StepCheck::take(const std::vector<StepMargin>& found) {
  std::vector<RunWarning> warnings;
  for (const auto& [body, margin] : found) {
    const auto is_body = [&name = body](const auto& one) { return one.first == name; };
    auto at = std::find_if(margins_.begin(), margins_.end(), is_body);
    if (at == margins_.end()) at = margins_.insert(margins_.end(), {body, kInfinity});
    if (margin < 1 && at->second >= 1) warnings.push_back(warning_of(body, margin));
    at->second = std::min(at->second, margin);
  }
  return warnings;
}

std::vector<RunWarning> StepCheck::warnings() const {
  std::vector<RunWarning> warnings;
  for (const auto& [body, margin] : margins_) {
    if (margin < 1) warnings.push_back(warning_of(body, margin));
  }
  return warnings;
}

std::string StepCheck::saved() const {
  std::ostringstream text;
  text.precision(17);
  for (const auto& [body, margin] : margins_) text << margin << ' ' << body << '\n';
  return text.str();
}

void StepCheck::restore(const std::string& text) {
  margins_.clear();
  std::istringstream lines(text);
  Real margin = 0;
  for (std::string body; lines >> margin && lines.get() && std::getline(lines, body);) {
    margins_.emplace_back(body, margin);
  }
}

template std::vector<StepMargin> find_step_margins<2>(Scene<2>&);
template std::vector<StepMargin> find_step_margins<3>(Scene<3>&);

}  // namespace brunt
