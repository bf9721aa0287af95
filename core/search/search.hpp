#pragma once
/// The one broad phase, for SPH neighbour lists and for contact: hashed cells
/// by size class, no cell array, cost independent of the domain; brute force beside it to compare.
#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace brunt {

enum class SearchMode : int { grid, brute };

template <int Dim>
struct SearchBox {
  std::array<Real, Dim> lo, hi;  ///< [m]

  static SearchBox about(const Vec<Dim>& x, Real reach) {
    SearchBox box;
    for (std::size_t c = 0; c < Dim; ++c) {
      box.lo[c] = x[static_cast<int>(c)] - reach;
      box.hi[c] = x[static_cast<int>(c)] + reach;
    }
    return box;
  }
  /// Holds nothing, meets nothing; what it encloses is what it becomes.
  static SearchBox empty() {
    SearchBox box;
    box.lo.fill(kInfinity), box.hi.fill(-kInfinity);
    return box;
  }
  /// Closed boxes that touch meet; one that is not a number meets nothing.
  bool meets(const SearchBox& other) const {
    for (std::size_t c = 0; c < Dim; ++c) {
      if (!(lo[c] <= other.hi[c] && other.lo[c] <= hi[c])) return false;
    }
    return true;
  }
  void enclose(const SearchBox& other) {
    for (std::size_t c = 0; c < Dim; ++c) {
      lo[c] = std::min(lo[c], other.lo[c]);
      hi[c] = std::max(hi[c], other.hi[c]);
    }
  }
};

using IndexPair = std::pair<LocalIndex, LocalIndex>;

/// All pairs i < j of boxes that overlap (closed boxes), sorted, that `admits` accepts. The mask is
/// asked before the box test: bodies that may not touch are never compared. It is called with
/// i < j, from several threads at once.
template <int Dim>
std::vector<IndexPair> overlapping_pairs(std::span<const SearchBox<Dim>> boxes,
                                         const std::function<bool(LocalIndex, LocalIndex)>& admits,
                                         SearchMode mode);

/// Neighbours of each point, compressed rows; within a row ascending.
struct NeighbourList {
  std::vector<std::int64_t> offset;  ///< size rows + 1
  std::vector<LocalIndex> neighbour;
};

/// Rows that points side by side have in common.
struct SharedNeighbours {
  NeighbourList list;
  std::vector<LocalIndex> row_of;  ///< of each point
  std::vector<LocalIndex> points;  ///< of each row, one after the other
  std::vector<LocalIndex> begin;   ///< of the points of each row; one more at the end

  std::size_t n_rows() const { return begin.empty() ? 0 : begin.size() - 1; }
  std::span<const LocalIndex> points_of(std::size_t row) const {
    return std::span(points).subspan(slot_of(begin[row]), slot_of(begin[row + 1] - begin[row]));
  }
  std::span<const LocalIndex> neighbours_of(std::size_t row) const {
    const auto first = slot_of(list.offset[row]);
    return std::span(list.neighbour).subspan(first, slot_of(list.offset[row + 1]) - first);
  }
};

/// Full lists of the first n_rows points: j, any point, is a neighbour of i if
/// |x_i - x_j| <= reach_i + reach_j + skin, i != j and both have the same label. Boundary cases are
/// decided by the same expression in both modes. Up to `most` points of one label that lie side by
/// side share a row: it holds what any of them needs, and the points themselves unless there is but
/// one. Rows are in the order of their first points. Brute force shares none.
/// reach, skin  [m], not negative;  most  1: a row for each point
template <int Dim>
SharedNeighbours shared_neighbours(std::span<const Vec<Dim>> x, std::span<const Real> reach,
                                   std::span<const Label> label, Real skin, LocalIndex n_rows,
                                   std::size_t most, SearchMode mode);

}  // namespace brunt
