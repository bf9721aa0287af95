#include "core/open_surface.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace brunt {

namespace {
using Edge = std::pair<LocalIndex, LocalIndex>;

/// visit(edge, its number) of the edges of a facet, edge c from corner c to the next; in 2D the end
/// at corner c.
template <int Dim, class Visit>
void for_edges(const Facet<Dim>& facet, const Visit& visit) {
  const auto n = slot_of(facet.n_nodes());
  for (std::size_t c = 0; c < n; ++c) {
    const LocalIndex a = facet.node[c], b = Dim == 3 ? facet.node[(c + 1) % n] : a;
    visit(Edge(std::minmax(a, b)), c);
  }
}

/// A facet at an edge that it holds.
struct Holder {
  Edge edge;
  std::size_t facet = 0, number = 0;
};

/// visit(holders) of every edge, in the order of edges; holders in that of facets.
template <int Dim, class Visit>
void for_holders(std::span<Facet<Dim>> facets, const Visit& visit) {
  std::vector<Holder> all;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    for_edges(facets[f], [&](const Edge& edge, std::size_t c) { all.push_back({edge, f, c}); });
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const Holder& a, const Holder& b) { return a.edge < b.edge; });
  for (std::size_t k = 0; k < all.size();) {
    std::size_t end = k + 1;
    while (end < all.size() && all[end].edge == all[k].edge) ++end;
    visit(std::span<const Holder>(all).subspan(k, end - k));
    k = end;
  }
}

template <int Dim>
struct Side {
  Vec<Dim> center, normal;  ///< [m], unit
};
Side<2> side_of(const Facet<2>& facet, std::span<const Vec<2>> x) {
  const auto at = [&](std::size_t c) { return x[facet.node[c]]; };
  const Vec<2> edge = at(1) - at(0);
  return {0.5 * (at(0) + at(1)), Vec<2>(edge[1], -edge[0]).normalized()};
}
Side<3> side_of(const Facet<3>& facet, std::span<const Vec<3>> x) {
  const auto at = [&](std::size_t c) { return x[facet.node[c]]; };
  if (facet.n_nodes() == 3) {
    return {(at(0) + at(1) + at(2)) / 3, (at(1) - at(0)).cross(at(2) - at(0)).normalized()};
  }
  return {0.25 * (at(0) + at(1) + at(2) + at(3)),
          (at(2) - at(0)).cross(at(3) - at(1)).normalized()};
}

/// True where the second turns away from the first.
template <int Dim>
bool turns_away(const Side<Dim>& first, const Side<Dim>& second) {
  constexpr Real kSharp = 0.766;  // cosine of 40 degrees
  return first.normal.dot(second.normal) < kSharp &&
         first.normal.dot(second.center - first.center) < 0;
}
}  // namespace

template <int Dim>
void mark_open(std::span<Facet<Dim>> facets) {
  std::set<std::pair<Label, Label>> open;
  for_holders(facets, [&](std::span<const Holder> holders) {
    if (holders.size() > 1) return;
    const auto& facet = facets[holders[0].facet];
    open.insert({facet.body, facet.piece});
  });
  for (auto& facet : facets) facet.open = open.count({facet.body, facet.piece}) != 0;
}

template <int Dim>
void mark_borders(std::span<Facet<Dim>> facets, std::span<const Vec<Dim>> x) {
  constexpr Real kBlade = -0.866;  // faces of an edge of less than 30 degrees
  for (auto& facet : facets) facet.borders = 0;
  for_holders(facets, [&](std::span<const Holder> holders) {
    for (const auto& own : holders) {
      const auto side = side_of(facets[own.facet], x);
      const bool goes_on = std::any_of(holders.begin(), holders.end(), [&](const Holder& other) {
        return other.facet != own.facet && !turns_away(side, side_of(facets[other.facet], x));
      });
      if (goes_on) continue;
      auto& borders = facets[own.facet].borders;
      borders = static_cast<std::uint8_t>(borders | 1U << own.number);
      const bool blade = Dim == 3 && std::any_of(holders.begin(), holders.end(), [&](auto& other) {
                           return side.normal.dot(side_of(facets[other.facet], x).normal) < kBlade;
                         });
      if (blade) borders = static_cast<std::uint8_t>(borders | 16U << own.number);
    }
  });
}

template <int Dim>
void mark_sharpness(std::span<Facet<Dim>> facets, std::span<const Vec<Dim>> x) {
  constexpr Real kSharpest = 0.0043633;                // sine of a quarter of a degree
  std::vector<std::pair<LocalIndex, std::size_t>> at;  // corners, and facets that have them
  std::vector<Vec<Dim>> normals;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    facets[f].sharpness = kBoxSharpness;
    normals.push_back(side_of(facets[f], x).normal);
    for (int c = 0; c < facets[f].n_nodes(); ++c) {
      at.emplace_back(facets[f].node[c], f);
    }
  }
  std::sort(at.begin(), at.end());
  for (std::size_t k = 0, end = 0; k < at.size(); k = end) {
    Real least = 0;
    for (end = k; end < at.size() && at[end].first == at[k].first; ++end) {
      for (std::size_t other = k; other < end; ++other) {
        least = std::min(least, normals[at[other].second].dot(normals[at[end].second]));
      }
    }
    if (least == 0) continue;
    const Real sharpness = std::max(std::sqrt(std::max(0.5 * (1 + least), 0.0)), kSharpest);
    for (std::size_t i = k; i < end; ++i) {
      auto& facet = facets[at[i].second];
      facet.sharpness = std::min(facet.sharpness, sharpness);
    }
  }
}

template void mark_open<2>(std::span<Facet<2>>);
template void mark_open<3>(std::span<Facet<3>>);
template void mark_borders<2>(std::span<Facet<2>>, std::span<const Vec<2>>);
template void mark_borders<3>(std::span<Facet<3>>, std::span<const Vec<3>>);
template void mark_sharpness<2>(std::span<Facet<2>>, std::span<const Vec<2>>);
template void mark_sharpness<3>(std::span<Facet<3>>, std::span<const Vec<3>>);

}  // namespace brunt
