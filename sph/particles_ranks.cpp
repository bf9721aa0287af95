/// The particles of one rank among others: which are its own, and copies of its neighbours'.
#include <algorithm>

#include "core/parallel/boxes.hpp"
#include "core/parallel/packing.hpp"
#include "sph/particles.hpp"

namespace brunt {

namespace {
/// All that a copy needs when lists are made; the rest comes with refresh_state.
template <int Dim>
struct Visitor {
  GlobalId id;
  Label body, piece;
  Real mass, h, volume;     // [kg], [m], [m^3]
  Real x[Dim], v[Dim];      // [m], [m/s]
  Real start[Dim];          // [m] position at time 0
  Real start_volume, seen;  // [m^3] of formulation: total, at time 0 and in sums; else 0
};

/// One with what its point knows.
template <int Dim>
Visitor<Dim> visitor(const Points<Dim>& points, std::size_t k) {
  Visitor<Dim> one{};
  one.id = points.id[k], one.body = points.body[k], one.piece = points.piece[k];
  for (int d = 0; d < Dim; ++d) {
    one.x[d] = points.x[k][d], one.v[d] = points.v[k][d], one.start[d] = points.x_start[k][d];
  }
  return one;
}

}  // namespace

template <int Dim>
SphParticles<Dim>::SphParticles(const SphParticles& whole, const Partition& partition,
                                const Communicator& ranks)
    : depth_(whole.depth_),
      sum_of_piece_(whole.sum_of_piece_),
      mirrors_(whole.mirrors_),
      unit_(whole.unit_),
      held_(whole.held_),
      ranks_(&ranks),
      skin_ratio_(whole.skin_ratio_),
      search_(whole.search_) {
  for (std::size_t i = 0; i < whole.points_.x.size(); ++i) {
    const Label body = whole.points_.body[i];
    sums_.push_back(sum_of_piece_.empty() ? body : sum_of_piece_[whole.points_.piece[i]]);
  }
  std::sort(sums_.begin(), sums_.end());
  sums_.erase(std::unique(sums_.begin(), sums_.end()), sums_.end());
  std::vector<LocalIndex> kept, place(whole.points_.x.size(), -1);
  for (LocalIndex i = 0; i < whole.points_.size(); ++i) {
    const auto k = slot_of(i);
    if (partition.of(whole.points_.id[k]) != ranks.rank()) continue;
    place[k] = static_cast<LocalIndex>(kept.size());
    kept.push_back(i);
  }
  points_ = whole.points_.subset(kept, static_cast<LocalIndex>(kept.size()));
  std::vector<Real> spacing;
  spacing.reserve(kept.size());
  for (const LocalIndex i : kept) spacing.push_back(whole.spacing_[i]);
  std::vector<ParticleSet> sets;
  for (const auto& block : whole.blocks_) {
    auto& set = sets.emplace_back(block.set);
    set.particle.clear();
    for (const LocalIndex i : block.set.particle) {
      const LocalIndex here = place[i];
      if (here >= 0) set.particle.push_back(here);
    }
  }
  take_sets(std::move(sets), spacing);
  for (std::size_t k = 0; k < kept.size() && whole.rides(); ++k) {
    node_id_.push_back(whole.node_id_[kept[k]]);  // of the whole, until it rides on a part
  }
  rearrange();
  seed_step_limits();
  if (points_.conducts) start_conduction();
}

namespace {
template <int Dim>
struct Arrived {
  Visitor<Dim> one;
  std::size_t rank, index;  ///< where it came from, and its place in that message
};

/// What other ranks sent, by id. counts out: how many came from each rank
template <int Dim>
std::vector<Arrived<Dim>> sorted_arrivals(const std::vector<Bytes>& from, int own_rank,
                                          std::vector<std::size_t>& counts) {
  std::vector<Arrived<Dim>> arrived;
  for (std::size_t r = 0; r < from.size(); ++r) {
    if (static_cast<int>(r) == own_rank) continue;
    std::vector<Visitor<Dim>> visitors;
    Unpacker(from[r]) >> visitors;
    counts[r] = visitors.size();
    for (std::size_t k = 0; k < visitors.size(); ++k) arrived.push_back({visitors[k], r, k});
  }
  std::sort(arrived.begin(), arrived.end(),
            [](const auto& a, const auto& b) { return a.one.id < b.one.id; });
  return arrived;
}
}  // namespace

/// Copies of all particles of other ranks that may come within reach of an own one before the
/// lists are renewed.
template <int Dim>
void SphParticles<Dim>::renew_ghosts(Real skin, Real reach) {
  const std::size_t n = n_owned();
  std::vector<SearchBox<Dim>> boxes;
  std::vector<std::size_t> awake;
  for (std::size_t i = 0; i < n; ++i) {
    if (sleeps(i)) continue;
    awake.push_back(i);
    boxes.push_back(SearchBox<Dim>::about(places()[i], smoothing_length_[i] + 0.5 * skin));
  }
  auto wanted = boxes;
  add_mirrored(wanted, skin, reach);
  auto send = who_wants<Dim>(*ranks_, boxes, wanted);
  std::vector<Bytes> to;
  for (auto& list : send) {
    std::vector<Visitor<Dim>> visitors;
    for (LocalIndex& place : list) {
      const std::size_t k = awake[place];
      place = static_cast<LocalIndex>(k);
      Visitor<Dim> one = visitor<Dim>(points_, k);
      one.mass = weighed_mass(k), one.h = smoothing_length_[k], one.volume = state_[k].volume;
      if (is_total(k)) one.start_volume = total_[k].volume, one.seen = total_[k].seen;
      visitors.push_back(one);
    }
    to.push_back((Packer() << visitors).take());
  }
  const auto from = ranks_->exchange(to);
  std::vector<std::size_t> counts(from.size(), 0);
  const auto arrived = sorted_arrivals<Dim>(from, ranks_->rank(), counts);
  ghosts_ = {};
  std::vector<std::vector<LocalIndex>> fill(from.size());
  for (std::size_t r = 0; r < fill.size(); ++r) fill[r].resize(counts[r]);
  std::vector<LocalIndex> own(n);
  for (std::size_t i = 0; i < n; ++i) own[i] = static_cast<LocalIndex>(i);
  points_.keep(own, points_.n_owned);
  hold(n + arrived.size(), n + arrived.size());
  for (std::size_t k = 0; k < arrived.size(); ++k) {
    const auto& one = arrived[k].one;
    fill[arrived[k].rank][arrived[k].index] = static_cast<LocalIndex>(n + k);
    points_.append_ghost(one.id, one.body, one.piece, one.mass, Vec<Dim>(one.x), Vec<Dim>(one.v));
    smoothing_length_[n + k] = one.h;
    points_.x_start[n + k] = Vec<Dim>(one.start);
    if (any_total()) total_[n + k].volume = one.start_volume, total_[n + k].seen = one.seen;
    state_[n + k].volume = one.volume;
  }
  for (std::size_t r = 0; r < from.size(); ++r) {
    if (send[r].empty() && fill[r].empty()) continue;
    ghosts_.peers.push_back({static_cast<int>(r), std::move(send[r]), std::move(fill[r])});
  }
  if (!points_.conducts) return;
  refresh_ghosts(
      *ranks_, ghosts_, 1, [&](std::size_t i, Real* out) { *out = points_.temperature[i]; },
      [&](std::size_t i, const Real* in) { points_.temperature[i] = *in; });
}

template <int Dim>
void SphParticles<Dim>::refresh_ghost_positions() {
  if (ranks_->alone()) return;
  refresh_ghosts(
      *ranks_, ghosts_, Dim,
      [&](std::size_t i, Real* out) {
        for (int c = 0; c < Dim; ++c) out[c] = points_.x[i][c];
      },
      [&](std::size_t i, const Real* in) {
        for (int c = 0; c < Dim; ++c) points_.x[i][c] = in[c];
      });
}

template <int Dim>
void SphParticles<Dim>::refresh_state() {
  if (ranks_->alone() || held_) return;
  constexpr std::size_t n_stress = std::size(StressRecord<Dim>{}.data);
  constexpr std::size_t n_artificial = std::size(ArtificialRecord<Dim>{}.data);
  const bool has_artificial = !artificial_.empty();  // of this rank: others may have some
  refresh_total_ghosts();
  refresh_ghosts(
      *ranks_, ghosts_, n_stress + n_artificial + 2,
      [&](std::size_t i, Real* out) {
        out = std::copy_n(stress_[i].data, n_stress, out);
        out = has_artificial ? std::copy_n(artificial_[i].data, n_artificial, out)
                             : std::fill_n(out, n_artificial, 0.0);
        out[0] = state_[i].volume;
        out[1] = smoothing_length_[i];
      },
      [&](std::size_t i, const Real* in) {
        std::copy_n(in, n_stress, stress_[i].data);
        if (is_stressed(stress_[i]) || state_[i].volume != in[n_stress + n_artificial]) {
          still_.stir(i);
        }
        if (has_artificial) std::copy_n(in + n_stress, n_artificial, artificial_[i].data);
        state_[i].volume = in[n_stress + n_artificial];
        smoothing_length_[i] = in[n_stress + n_artificial + 1];
      });
}

/// True if the lists of all ranks hold, and no particle without a copy here can have come within
/// reach of an own one: no two particles of a sum have moved against each other by more than the
/// skin.
template <int Dim>
bool SphParticles<Dim>::sums_hold(bool mine_hold) const {
  constexpr std::size_t width = 2 * Dim + 1;
  std::vector<Real> extremes(sums_.size() * width + 1, -kInfinity);
  if (!mine_hold) extremes.back() = 1;
  for (std::size_t i = 0; i < n_owned(); ++i) {
    if (sleeps(i)) continue;
    const auto sum = std::lower_bound(sums_.begin(), sums_.end(), sum_[i]);
    Real* own = extremes.data() + slot_of(sum - sums_.begin()) * width;
    const MirrorAxes across = mirrors_.across(sum_[i]);
    for (int c = 0; c < Dim; ++c) {
      const Real u = places()[i][c] - watch_.x()[i][c];
      const Real opposite = is_across(across, c) ? std::fabs(u) : -kInfinity;  // of an image
      own[2 * c] = std::max({own[2 * c], -u, opposite});
      own[2 * c + 1] = std::max({own[2 * c + 1], u, opposite});
    }
    own[2 * Dim] = std::max(own[2 * Dim], smoothing_length_[i] - watch_.reach()[i]);
  }
  ranks_->max(extremes);
  if (extremes.back() > 0) return false;
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const Real* of = extremes.data() + b * width;
    Real approach = 0;
    for (int c = 0; c < Dim; ++c) approach = std::max(approach, of[2 * c] + of[2 * c + 1]);
    if (!(approach + 2 * std::max(of[2 * Dim], 0.0) <= watch_.skin())) return false;
  }
  return true;
}

template <int Dim>
std::vector<Real> SphParticles<Dim>::point_work() const {
  std::vector<Real> work(n_owned());
  for (std::size_t i = 0; i < work.size(); ++i) {
    if (sleeps(i)) continue;
    work[i] = 1.0 + rows_.count(static_cast<LocalIndex>(i));
  }
  return work;
}

template std::vector<Real> SphParticles<2>::point_work() const;
template std::vector<Real> SphParticles<3>::point_work() const;
template SphParticles<2>::SphParticles(const SphParticles&, const Partition&, const Communicator&);
template SphParticles<3>::SphParticles(const SphParticles&, const Partition&, const Communicator&);
template void SphParticles<2>::renew_ghosts(Real, Real);
template void SphParticles<3>::renew_ghosts(Real, Real);
template void SphParticles<2>::refresh_ghost_positions();
template void SphParticles<3>::refresh_ghost_positions();
template void SphParticles<2>::refresh_state();
template void SphParticles<3>::refresh_state();
template bool SphParticles<2>::sums_hold(bool) const;
template bool SphParticles<3>::sums_hold(bool) const;

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
