#include "app/cli/costs.hpp"

#include <sys/resource.h>
#include <algorithm>

#include "app/cli/calibration.hpp"
#include "io/number.hpp"

namespace brunt {

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

template <int Dim>
void fill_costs(const Scene<Dim>& scene, std::int64_t steps, RunSummary& summary) {
  // A scene is searched once when it is built, and again at the start of its run.
  if (scene.contact) {
    const auto builds = static_cast<std::int64_t>(scene.contact->work().builds);
    summary.contact_lists = std::max<std::int64_t>(builds - 1, 0);
  }
  const auto seconds = [&](Phase phase) { return scene.phases.of(phase).seconds; };
  for (int p = 0; p < kPhases; ++p) {
    summary.phases.emplace_back(kPhaseNames[slot_of(p)], seconds(static_cast<Phase>(p)));
  }
  summary.points = static_cast<std::int64_t>(scene.n_points());
  summary.elements = static_cast<std::int64_t>(scene.n_elements());
  summary.particles = static_cast<std::int64_t>(scene.n_particles());
  summary.loop_seconds = scene.loop.seconds;
  // What is spent on neither, on contact and output too, is shared by elements and particles.
  const double own =
      seconds(Phase::particles) + (summary.particles > 0 ? seconds(Phase::search) : 0);
  const double shared = summary.loop_seconds - seconds(Phase::elements) - own;
  const auto count = static_cast<double>(summary.elements + summary.particles);
  if (steps == 0 || count == 0) return;
  const auto n = static_cast<double>(steps);
  if (summary.elements > 0) {
    const auto elements = static_cast<double>(summary.elements);
    summary.ns_element_step = 1e9 * (seconds(Phase::elements) / elements + shared / count) / n;
  }
  if (summary.particles > 0) {
    const auto particles = static_cast<double>(summary.particles);
    summary.ns_particle_step = 1e9 * (own / particles + shared / count) / n;
  }
}

template <int Dim>
void fill_step_bounds(const Scene<Dim>& scene, const Clock& clock, RunSummary& summary) {
  const auto shares = clock.bounds().sorted();
  Real steps = 0;
  for (const auto& share : shares) steps += static_cast<Real>(share.steps);
  for (const auto& share : shares) {
    std::string what = share.reason;
    if (what != "max_step") what += " of " + scene.body_names[share.body];
    summary.step_bounds.emplace_back(what, static_cast<Real>(share.steps) / steps);
  }
}

std::string step_bounds_line(const std::vector<std::pair<std::string, Real>>& bounds) {
  constexpr Real kLeast = 0.01;
  std::string line = "steps bounded by";
  Real others = 0;
  const char* separator = " ";
  for (const auto& [what, part] : bounds) {
    if (part < kLeast) {
      others += part;
      continue;
    }
    line += separator + what + " " + rounded(100 * part, part > 0.99 ? 3 : 2) + " %";
    separator = ", ";
  }
  if (others > 0) line += separator + ("others " + rounded(100 * others, 2) + " %");
  return line;
}

template <int Dim>
void fill_pairs(const Scene<Dim>& scene, const Communicator& ranks, RunSummary& summary) {
  PairCount mine;
  for (const auto& solid : scene.solids) {
    const PairCount count = solid->pair_count();
    mine.in_support += count.in_support, mine.compared += count.compared;
  }
  const auto sum = [&](std::int64_t n) {
    return static_cast<std::int64_t>(ranks.sum(static_cast<std::uint64_t>(n)));
  };
  summary.pairs = {sum(mine.in_support), sum(mine.compared)};
}

void fill_traffic(const Communicator& ranks, std::int64_t steps, RunSummary& summary) {
  summary.ranks = ranks.size();
  constexpr double kMicro = 1e-6;
  const auto own_time = static_cast<std::uint64_t>(processor_seconds() / kMicro);
  summary.cpu_seconds = kMicro * static_cast<double>(ranks.sum(own_time));
  if (ranks.alone() || steps == 0) return;
  const auto sum = [&](std::int64_t mine) {
    return static_cast<double>(ranks.sum(static_cast<std::uint64_t>(mine)));
  };
  const Traffic own = ranks.traffic();
  summary.messages_step = sum(own.messages) / static_cast<double>(steps);
  summary.bytes_step = sum(own.bytes) / static_cast<double>(steps);
  summary.reductions_step = static_cast<double>(own.reductions) / static_cast<double>(steps);
}

template void fill_step_bounds(const Scene<2>&, const Clock&, RunSummary&);
template void fill_step_bounds(const Scene<3>&, const Clock&, RunSummary&);
template void fill_pairs(const Scene<2>&, const Communicator&, RunSummary&);
template void fill_pairs(const Scene<3>&, const Communicator&, RunSummary&);
template void fill_costs(const Scene<2>&, std::int64_t, RunSummary&);
template void fill_costs(const Scene<3>&, std::int64_t, RunSummary&);

}  // namespace brunt
