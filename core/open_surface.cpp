#include "core/open_surface.hpp"

#include <map>
#include <set>
#include <utility>

namespace brunt {

template <int Dim>
void mark_open(std::span<Facet<Dim>> facets) {
  using Edge = std::pair<LocalIndex, LocalIndex>;
  using Piece = std::pair<Label, Label>;
  std::map<Edge, int> holders;
  const auto for_edges = [](const Facet<Dim>& facet, const auto& visit) {
    const auto n = static_cast<std::size_t>(facet.n_nodes());
    for (std::size_t c = 0; c < n; ++c) {
      const LocalIndex a = facet.node[c], b = Dim == 3 ? facet.node[(c + 1) % n] : a;
      visit(Edge(std::minmax(a, b)));
    }
  };
  for (const auto& facet : facets) {
    for_edges(facet, [&](const Edge& edge) { ++holders[edge]; });
  }
  std::set<Piece> open;
  for (const auto& facet : facets) {
    for_edges(facet, [&](const Edge& edge) {
      if (holders[edge] == 1) open.insert({facet.body, facet.piece});
    });
  }
  for (auto& facet : facets) facet.open = open.count({facet.body, facet.piece}) != 0;
}

template void mark_open<2>(std::span<Facet<2>>);
template void mark_open<3>(std::span<Facet<3>>);

}  // namespace brunt
