/// The part of a whole that one rank computes.
#include <algorithm>
#include <span>

#include "fe/erosion.hpp"
#include "fe/finite_elements.hpp"
#include "fe/part.hpp"

namespace brunt {

template <int Dim>
std::vector<ElementSet<Dim>> elements_of(const std::vector<ElementBlock<Dim>>& blocks,
                                         const std::vector<int>& owner, int rank) {
  std::vector<ElementSet<Dim>> sets;
  for (const auto& block : blocks) {
    auto& set = sets.emplace_back();
    set.material = block.material, set.options = block.options;
    set.temperature = block.temperature, set.adiabatic = block.adiabatic;
    set.conducts = block.conducts, set.held = block.held, set.rigid = block.rigid;
    set.stress = block.stress, set.temperature_field = block.temperature_field;
    for (LocalIndex e = 0; e < block.n; ++e) {
      ElementCorners corners;
      bool mine = false;
      for (const LocalIndex node : block.corners_of(e)) {
        corners[corners.n++] = node;
        mine = mine || owner[node] == rank;
      }
      if (!mine) continue;
      set.corners.push_back(corners);
      set.id.push_back(block.id[e]);
      set.body.push_back(block.body[e]);
      set.piece.push_back(block.piece[e]);
      // One rank counts an element: the owner of its first corner.
      set.owned.push_back(owner[corners[0]] == rank);
    }
  }
  return sets;
}

namespace {
/// Which points of the whole are kept: owned ones first, then copies, each in their order.
template <int Dim>
std::vector<LocalIndex> points_of(const std::vector<ElementSet<Dim>>& sets,
                                  const std::vector<int>& owner, int rank, LocalIndex& n_owned) {
  std::vector<char> touched(owner.size(), 0);
  for (const auto& set : sets) {
    for (const auto& corners : set.corners) {
      for (const LocalIndex node : corners) touched[node] = 1;
    }
  }
  std::vector<LocalIndex> kept;
  for (const bool owned : {true, false}) {
    for (std::size_t i = 0; i < owner.size(); ++i) {
      const bool mine = owner[i] == rank;
      if (mine == owned && (mine || touched[i])) kept.push_back(static_cast<LocalIndex>(i));
    }
    if (owned) n_owned = static_cast<LocalIndex>(kept.size());
  }
  return kept;
}
}  // namespace

template <int Dim>
std::vector<Facet<Dim>> facets_of(const std::vector<Facet<Dim>>& whole,
                                  const std::vector<ElementSet<Dim>>& sets,
                                  const std::vector<LocalIndex>& place, LocalIndex n_owned) {
  std::vector<GlobalId> elements;
  for (const auto& set : sets) elements.insert(elements.end(), set.id.begin(), set.id.end());
  std::sort(elements.begin(), elements.end());
  std::vector<Facet<Dim>> facets;
  for (Facet<Dim> facet : whole) {
    if (!std::binary_search(elements.begin(), elements.end(), facet.id >> 3)) continue;
    for (auto& node : facet.node) {
      if (node >= 0) node = place[node];
    }
    facet.owned = facet.node[0] < n_owned;  // so that anybody knows whose it is
    facets.push_back(facet);
  }
  return facets;
}

template <int Dim>
FiniteElements<Dim>::FiniteElements(const FiniteElements& whole, const Partition& partition,
                                    const Communicator& ranks)
    : thickness_(whole.thickness_), held_(whole.held_), ranks_(&ranks) {
  std::vector<int> owner;
  for (const GlobalId id : whole.points_.id) owner.push_back(partition.of(id));
  auto sets = elements_of(whole.blocks_, owner, ranks.rank());
  LocalIndex n_owned = 0;
  const auto kept = points_of(sets, owner, ranks.rank(), n_owned);
  std::vector<LocalIndex> place(owner.size(), -1);
  for (std::size_t k = 0; k < kept.size(); ++k) {
    place[kept[k]] = static_cast<LocalIndex>(k);
  }
  surface_.facets = facets_of(whole.surface_.facets, sets, place, n_owned);
  renumber_corners(place, sets);
  for (const LocalIndex node : whole.surface_.axis) {
    const LocalIndex here = place[node];
    if (here >= 0) surface_.axis.push_back(here);
  }
  points_ = whole.points_.subset(kept, n_owned);
  surface_.points = &points_;
  surface_.held = held_;
  averages_volumes_ = whole.averages_volumes_;
  make_blocks(std::move(sets));
  if (whole.erosion_) {
    surface_.erodes = true;
    surface_.may_free = whole.surface_.may_free;
    erosion_ = std::make_unique<ErosionState<Dim>>(*whole.erosion_);
    erosion_->owner = std::move(owner), erosion_->place = std::move(place);
    erosion_->rank = ranks.rank();
  }
  std::vector<GlobalId> ids;
  std::vector<LocalIndex> places;
  std::vector<int> owners;
  for (LocalIndex i = n_owned; i < points_.size(); ++i) {
    ids.push_back(points_.id[i]);
    places.push_back(i);
    owners.push_back(partition.of(ids.back()));
  }
  ghosts_ = plan_ghosts(ranks, ids, places, owners, points_.owned_ids());
  refresh_steps();
  if (erosion_) order_corners();
  if (points_.conducts) start_conduction();
}

template <int Dim>
std::vector<Real> FiniteElements<Dim>::point_work() const {
  std::vector<Real> work(points_.owned(), 0.0);
  for (const auto& block : blocks_) {
    for (LocalIndex e = 0; e < block.n; ++e) {
      const auto corners = block.corners_of(e);
      const auto is_owned = [&](LocalIndex node) { return node < points_.n_owned; };
      const auto owned = std::count_if(corners.begin(), corners.end(), is_owned);
      for (const LocalIndex node : corners) {
        if (!is_owned(node)) continue;
        work[node] += static_cast<Real>(block.gauss) / static_cast<Real>(owned);
      }
    }
  }
  return work;
}

template std::vector<ElementSet<2>> elements_of(const std::vector<ElementBlock<2>>&,
                                                const std::vector<int>&, int);
template std::vector<ElementSet<3>> elements_of(const std::vector<ElementBlock<3>>&,
                                                const std::vector<int>&, int);
template std::vector<Facet<2>> facets_of(const std::vector<Facet<2>>&,
                                         const std::vector<ElementSet<2>>&,
                                         const std::vector<LocalIndex>&, LocalIndex);
template std::vector<Facet<3>> facets_of(const std::vector<Facet<3>>&,
                                         const std::vector<ElementSet<3>>&,
                                         const std::vector<LocalIndex>&, LocalIndex);
template std::vector<Real> FiniteElements<2>::point_work() const;
template std::vector<Real> FiniteElements<3>::point_work() const;
template FiniteElements<2>::FiniteElements(const FiniteElements&, const Partition&,
                                           const Communicator&);
template FiniteElements<3>::FiniteElements(const FiniteElements&, const Partition&,
                                           const Communicator&);

}  // namespace brunt
// Tested by tests/parallel/ranks.sh.
