#include "app/scene/sections.hpp"

#include <algorithm>
#include <span>

#include "core/exact_sum.hpp"

namespace brunt {

template <int Dim>
bool Sections<Dim>::cuts(std::size_t solid) const {
  return std::any_of(all_.begin(), all_.end(), [&](const auto& section) {
    return std::find(section.solids.begin(), section.solids.end(), solid) != section.solids.end();
  });
}

template <int Dim>
void Sections<Dim>::join(std::size_t solid, std::size_t riders) {
  for (auto& section : all_) {
    if (section.solids.front() == solid) section.solids.push_back(riders);
  }
}

template <int Dim>
void Sections<Dim>::before_internal(std::size_t solid, const Points<Dim>& points) {
  if (!cuts(solid)) return;
  if (internal_.size() <= solid) internal_.resize(solid + 1);
  internal_[solid].assign(points.f.begin(), points.f.begin() + points.n_owned);
}

template <int Dim>
void Sections<Dim>::after_internal(std::size_t solid, const Points<Dim>& points) {
  if (!cuts(solid)) return;
  auto& internal = internal_[solid];
  for (std::size_t i = 0; i < internal.size(); ++i) internal[i] = points.f[i] - internal[i];
}

template <int Dim>
SectionForce Sections<Dim>::force(const MaterialSection<Dim>& section,
                                  const std::vector<std::unique_ptr<Solid<Dim>>>& solids,
                                  const Vec<Dim>& origin, const Communicator& ranks) const {
  std::array<ExactSum, 6> sums;
  for (const std::size_t solid : section.solids) {
    if (solid >= internal_.size()) continue;
    const Points<Dim>& points = solids[solid]->points();
    for (std::size_t i = 0; i < internal_[solid].size(); ++i) {
      if (points.body[i] != section.body || !(points.x_start[i][section.axis] > section.at))
        continue;
      const Vec3 f = in_space<Dim>(internal_[solid][i]);
      const Vec3 m = in_space<Dim>(Vec<Dim>(origin + points.x[i])).cross(f);
      for (int c = 0; c < 3; ++c) {
        sums[c].add(-f[c]);
        sums[3 + c].add(-m[c]);
      }
    }
  }
  ranks.reduce_all(std::span<ExactSum>(sums), [](ExactSum& a, const ExactSum& b) { a.add(b); });
  SectionForce total;
  for (std::size_t c = 0; c < 3; ++c) {
    total.force[c] = sums[c].value();
    total.moment[c] = sums[3 + c].value();
  }
  return total;
}

template class Sections<2>;
template class Sections<3>;

}  // namespace brunt
