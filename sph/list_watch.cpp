#include "sph/list_watch.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel/threads.hpp"
#include "core/simd.hpp"
#include "sph/parallel.hpp"

namespace brunt {

namespace {
/// Width of a zone in units of the longest smoothing length: 2 of support, 2 that bodies may
/// deform.
constexpr Real kZoneWidth = 4;
/// What round-off may add to a distance, as a part of it.
constexpr Real kSpare = 1e-6;
}  // namespace

template <int Dim>
void ListWatch<Dim>::start(std::span<const Vec<Dim>> x, std::span<const Label> label,
                           std::vector<Real> reach, Real skin) {
  x_.assign(x.begin(), x.end());
  reach_ = std::move(reach);
  skin_ = skin;
  longest_ = reach_.empty() ? 0 : *std::max_element(reach_.begin(), reach_.end());
  width_ = kZoneWidth * longest_;
  std::vector<Zone> zone_of(x_.size());
  for_each(x_.size(), [&](std::size_t i) {
    zone_of[i].label = label[i];
    for (std::size_t d = 0; d < Dim; ++d) {
      // What is beyond 2^52 zones, or not a number, shares one
      const Real cell = std::floor(x_[i][static_cast<int>(d)] / width_);
      zone_of[i].cell[d] =
          static_cast<std::int64_t>(cell >= -0x1p52 ? std::min(cell, 0x1p52) : -0x1p52);
    }
  });
  // Neighbours along the curve share zones: runs of them are sorted, not particles
  struct Run {
    Zone zone;
    std::size_t begin, end;
    bool operator<(const Run& other) const {
      return zone < other.zone || (zone == other.zone && begin < other.begin);
    }
  };
  std::vector<Run> runs;
  for (std::size_t i = 0; i < zone_of.size(); ++i) {
    if (runs.empty() || runs.back().zone != zone_of[i]) runs.push_back({zone_of[i], i, i});
    ++runs.back().end;
  }
  std::sort(runs.begin(), runs.end());
  zones_.clear();
  member_.clear();
  member_begin_.clear();
  for (const Run& run : runs) {
    if (zones_.empty() || zones_.back() != run.zone) {
      zones_.push_back(run.zone);
      member_begin_.push_back(static_cast<LocalIndex>(member_.size()));
    }
    for (std::size_t i = run.begin; i < run.end; ++i) {
      member_.push_back(static_cast<LocalIndex>(i));
    }
  }
  member_begin_.push_back(static_cast<LocalIndex>(member_.size()));
  link_zones();
}

template <int Dim>
void ListWatch<Dim>::link_zones() {
  touching_.clear();
  constexpr int stencil = Dim == 2 ? 9 : 27;
  for (std::size_t a = 0; a < zones_.size(); ++a) {
    for (int k = stencil / 2; k < stencil; ++k) {  // itself, and each other zone from one side
      Zone other = zones_[a];
      for (int d = Dim - 1, rest = k; d >= 0; --d, rest /= 3) {
        other.cell[d] += rest % 3 - 1;
      }
      const auto b = std::lower_bound(zones_.begin(), zones_.end(), other);
      if (b == zones_.end() || *b != other) continue;
      touching_.push_back(
          {static_cast<LocalIndex>(a), static_cast<LocalIndex>(b - zones_.begin())});
    }
  }
}

template <int Dim>
std::vector<typename ListWatch<Dim>::Extent> ListWatch<Dim>::extents(
    std::span<const Vec<Dim>> x, std::span<const Real> reach) const {
  std::vector<Extent> extents(zones_.size());
  on_threads(x.size() >= 4096, [&] {
#pragma omp for schedule(static)
    for (std::size_t z = 0; z < zones_.size(); ++z) {
      Real lower[Dim], upper[Dim], growth = 0;  // in registers
      for (int d = 0; d < Dim; ++d) lower[d] = kInfinity, upper[d] = -kInfinity;
      for (const LocalIndex i : members(z)) {
        const auto k = slot_of(i);
        for (int d = 0; d < Dim; ++d) {
          const Real u = x[k][d] - x_[k][d];
          lower[d] = vmin(lower[d], u);  // takes in what is not a number
          upper[d] = vmax(upper[d], u);
        }
        growth = vmax(reach[k] - reach_[k], growth);
      }
      Extent extent;
      for (int d = 0; d < Dim; ++d) extent.lower[d] = lower[d], extent.upper[d] = upper[d];
      extent.growth = growth;
      extents[z] = extent;
    }
  });
  return extents;
}

template <int Dim>
bool ListWatch<Dim>::touching_zones_hold(const std::vector<Extent>& extents) const {
  for (const auto [a, b] : touching_) {
    const Extent &A = extents[a], &B = extents[b];
    Real approach2 = 0;
    for (int d = 0; d < Dim; ++d) {
      const Real relative = std::max(A.upper[d] - B.lower[d], B.upper[d] - A.lower[d]);
      approach2 += relative * relative;
    }
    const Real spent = std::sqrt(approach2) + A.growth + B.growth;
    if (!(spent <= (1 - kSpare) * skin_)) return false;
  }
  return true;
}

template <int Dim>
bool ListWatch<Dim>::far_zones_hold(const std::vector<Extent>& extents) const {
  for (std::size_t first = 0, z = 0; first < zones_.size(); first = z) {
    Extent body = extents[first];
    for (z = first; z < zones_.size() && zones_[z].label == zones_[first].label; ++z) {
      body.lower = body.lower.cwiseMin(extents[z].lower);
      body.upper = body.upper.cwiseMax(extents[z].upper);
      body.growth = std::max(body.growth, extents[z].growth);
    }
    const Real approach = (body.upper - body.lower).maxCoeff();
    if (!(approach + 2 * (longest_ + body.growth) <= (1 - kSpare) * width_)) return false;
  }
  return true;
}

template <int Dim>
bool ListWatch<Dim>::covers(std::span<const Vec<Dim>> x, std::span<const Real> reach) const {
  const auto moved = extents(x, reach);
  return touching_zones_hold(moved) && far_zones_hold(moved);
}

template class ListWatch<2>;
template class ListWatch<3>;

}  // namespace brunt
