#include "app/ranks/balance.hpp"

#include <algorithm>
#include <chrono>
#include <span>
#include <utility>

#include "app/ranks/distribute.hpp"
#include "app/ranks/gather_state.hpp"
#include "core/parallel/packing.hpp"

namespace brunt {

namespace {
/// Phases whose seconds are work; ledger and output are not spread by the partition.
constexpr Phase kWork[] = {Phase::step_bound, Phase::search,    Phase::points,
                           Phase::elements,   Phase::particles, Phase::contact};

/// One owned point as all ranks must see it to partition it.
template <int Dim>
struct Weighted {
  GlobalId id;
  Real x[Dim], weight;  // [m], [s]
};

template <int Dim>
Partition partition_of(const std::vector<Weighted<Dim>>& mine, const Communicator& ranks) {
  std::vector<Vec<Dim>> x;
  std::vector<Real> weight;
  for (const Bytes& bytes : ranks.all_gather((Packer() << mine).take())) {
    std::vector<Weighted<Dim>> points;
    Unpacker(bytes) >> points;
    for (const auto& point : points) {
      const auto at = slot_of(point.id);
      if (at >= x.size()) x.resize(at + 1, Vec<Dim>::Zero()), weight.resize(at + 1, 0.0);
      x[at] = Vec<Dim>(point.x);
      weight[at] = point.weight;
    }
  }
  return make_partition<Dim>(ranks, x, weight);
}
}  // namespace

template <int Dim>
Balance<Dim>::Balance(const deck::Ranks& options, Build build, double cost)
    : options_(options), build_(std::move(build)), cost_(cost) {}

template <int Dim>
void Balance<Dim>::look(Scene<Dim>& scene, Real time) {
  threads_.look();
  if (scene.ranks->alone() || !options_.balance || ++steps_ < options_.balance_steps) return;
  steps_ = 0;
  // What is no number any more has no place in space: it stays where it is, and the run breaks
  // where it would on one rank.
  if (is_due(scene) && scene.is_sound(time)) repartition(scene);
  last_ = scene.phases;
}

/// True on all ranks alike: the ratio is beyond the threshold, and waiting has cost more by now
/// than a partition will. A threshold of 1 repartitions at every look.
template <int Dim>
bool Balance<Dim>::is_due(Scene<Dim>& scene) {
  struct Work {
    Real largest, sum, cost;
  };
  Work work{0, 0, cost_};
  for (const Phase phase : kWork)
    work.sum += scene.phases.of(phase).work() - last_.of(phase).work();
  work.largest = work.sum;
  work = scene.ranks->reduce(work, [](Work& a, const Work& b) {
    a.largest = std::max(a.largest, b.largest);
    a.cost = std::max(a.cost, b.cost);
    a.sum += b.sum;
  });
  const Real mean = work.sum / scene.ranks->size();
  ratio_ = mean > 0 ? work.largest / mean : 1;
  if (*options_.balance <= 1) return true;
  if (ratio_ <= *options_.balance) return false;
  lost_ += work.largest - mean;
  return lost_ > work.cost;
}

namespace {
/// Adds seconds to points in proportion to their shares.
void spread(std::span<const Real> shares, Real seconds, std::span<Real> points) {
  Real sum = 0;
  for (const Real share : shares) sum += share;
  if (sum <= 0) return;
  for (std::size_t i = 0; i < shares.size(); ++i) points[i] += seconds * shares[i] / sum;
}
}  // namespace

/// Seconds that each owned point, group by group, has cost this rank since the last look.
template <int Dim>
std::vector<Real> Balance<Dim>::weights(const Scene<Dim>& scene) const {
  const auto spent = [&](Phase phase) {
    return std::max(0.0, scene.phases.of(phase).work() - last_.of(phase).work());
  };
  std::vector<Real> all, contact, even;
  bool any_particles = false;
  for (const auto& solid : scene.solids) {
    const auto shares = solid->point_work();
    const std::size_t first = all.size();
    all.resize(first + shares.size(), 0.0);
    // Points of a rigid wall weigh nothing, or the wall would turn the cuts (make_partition).
    for (std::size_t i = 0; i < shares.size(); ++i) {
      even.push_back(solid->points().mass[i] > 0 ? 1 : 0);
    }
    const bool particles = solid->n_particles() > 0;
    any_particles = any_particles || particles;
    spread(shares,
           particles ? spent(Phase::particles) + spent(Phase::search) : spent(Phase::elements),
           std::span(all).subspan(first));
  }
  spread(even, spent(Phase::points) + spent(Phase::step_bound), all);
  if (!scene.contact) return all;
  for (const auto& shares : scene.contact->point_work()) {
    contact.insert(contact.end(), shares.begin(), shares.end());
  }
  spread(contact, spent(Phase::contact) + (any_particles ? 0 : spent(Phase::search)), all);
  return all;
}

template <int Dim>
void Balance<Dim>::repartition(Scene<Dim>& scene) {
  const auto start = std::chrono::steady_clock::now();
  const Communicator& ranks = *scene.ranks;
  const auto weight = weights(scene);
  std::vector<Weighted<Dim>> points;
  for (const auto& solid : scene.solids) {
    const auto& of = solid->points();
    for (std::size_t i = 0; i < of.owned(); ++i) {
      Weighted<Dim> one{of.id[i], {}, weight[points.size()]};
      for (int c = 0; c < Dim; ++c) one.x[c] = of.x[i][c];
      points.push_back(one);
    }
  }
  auto partition = std::make_unique<const Partition>(partition_of(points, ranks));
  std::vector<StateTable> tables;
  scene.save_state(tables);
  const StateTables state(of_all_ranks(tables, ranks));
  auto fresh = build_();
  distribute(*fresh, ranks, std::move(partition));
  fresh->phases = scene.phases;
  fresh->heat_windows = scene.heat_windows;
  scene = std::move(*fresh);
  scene.load_state(state);
  cost_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  lost_ = 0;
  ++repartitions_;
}

template class Balance<2>;
template class Balance<3>;

}  // namespace brunt
