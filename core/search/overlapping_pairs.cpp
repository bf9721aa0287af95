#include <algorithm>
#include <cmath>

#include "core/parallel/threads.hpp"
#include "core/search/cell_grid.hpp"
#include "core/search/search.hpp"

namespace brunt {

namespace {

template <int Dim>
struct PairQuery {
  std::span<const SearchBox<Dim>> boxes;
  const std::function<bool(LocalIndex, LocalIndex)>& admits;

  void append_if_met(LocalIndex i, LocalIndex j, std::vector<IndexPair>& out) const {
    const auto [a, b] = std::minmax(i, j);
    if (boxes[a].meets(boxes[b]) && admits(a, b)) out.emplace_back(a, b);
  }
};

template <int Dim>
std::vector<IndexPair> all_pairs(const PairQuery<Dim>& query) {
  std::vector<IndexPair> pairs;
  const auto n = static_cast<LocalIndex>(query.boxes.size());
  for (LocalIndex i = 0; i < n; ++i) {
    for (LocalIndex j = i + 1; j < n; ++j) query.append_if_met(i, j, pairs);
  }
  return pairs;
}

/// Pairs of one cell: within it, with the cells that touch it, with what lies in no cell.
template <int Dim>
void append_pairs_of_cell(const CellGrid<Dim>& grid, LocalIndex cell, const PairQuery<Dim>& query,
                          std::vector<IndexPair>& out) {
  const auto own = grid.members(cell);
  for (const LocalIndex other : grid.forward(cell)) {
    const auto theirs = grid.members(other);
    for (std::size_t k = 0; k < own.size(); ++k) {
      for (std::size_t m = other == cell ? k + 1 : 0; m < theirs.size(); ++m) {
        query.append_if_met(own[k], theirs[m], out);
      }
    }
  }
  for (const LocalIndex i : own) {
    for (const LocalIndex j : grid.oversize()) query.append_if_met(i, j, out);
  }
}

/// Sorts by buckets of the first index: linear in the number of pairs.
std::vector<IndexPair> sorted(const std::vector<std::vector<IndexPair>>& parts, std::size_t n) {
  std::vector<std::int64_t> begin(n + 1, 0);
  for (const auto& part : parts) {
    for (const auto& pair : part) ++begin[slot_of(pair.first) + 1];
  }
  for (std::size_t i = 0; i < n; ++i) begin[i + 1] += begin[i];
  std::vector<IndexPair> pairs(slot_of(begin[n]));
  std::vector<std::int64_t> next(begin.begin(), begin.end() - 1);
  for (const auto& part : parts) {
    for (const auto& pair : part) pairs[next[pair.first]++] = pair;
  }
  for_each(n, 4096, [&](std::size_t i) {
    std::sort(pairs.begin() + begin[i], pairs.begin() + begin[i + 1]);
  });
  return pairs;
}

}  // namespace

template <int Dim>
std::vector<IndexPair> overlapping_pairs(std::span<const SearchBox<Dim>> boxes,
                                         const std::function<bool(LocalIndex, LocalIndex)>& admits,
                                         SearchMode mode) {
  const PairQuery<Dim> query{boxes, admits};
  if (mode == SearchMode::brute) return all_pairs(query);
  std::vector<Vec<Dim>> corner(boxes.size());
  std::vector<Real> extent(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Real widest = 0;
    bool ordered = true;
    for (int c = 0; c < Dim; ++c) {
      corner[i][c] = boxes[i].lo[c];
      widest = std::max(widest, boxes[i].hi[c] - boxes[i].lo[c]);
      ordered = ordered && boxes[i].lo[c] <= boxes[i].hi[c];
    }
    extent[i] = ordered ? widest : -1;
  }
  const CellGrid<Dim> grid(corner, extent);
  constexpr LocalIndex kChunk = 256;
  const LocalIndex n_chunks = (grid.n_cells() + kChunk - 1) / kChunk;
  std::vector<std::vector<IndexPair>> parts(slot_of(n_chunks) + 1);
  on_threads(n_chunks > 4, [&] {
#pragma omp for schedule(dynamic, 1)
    for (LocalIndex chunk = 0; chunk < n_chunks; ++chunk) {
      const LocalIndex end = std::min(grid.n_cells(), (chunk + 1) * kChunk);
      for (LocalIndex cell = chunk * kChunk; cell < end; ++cell) {
        append_pairs_of_cell(grid, cell, query, parts[chunk]);
      }
    }
  });
  const auto oversize = grid.oversize();
  for (std::size_t k = 0; k < oversize.size(); ++k) {
    for (std::size_t m = k + 1; m < oversize.size(); ++m) {
      query.append_if_met(oversize[k], oversize[m], parts.back());
    }
  }
  return sorted(parts, boxes.size());
}

template std::vector<IndexPair> overlapping_pairs<2>(
    std::span<const SearchBox<2>>, const std::function<bool(LocalIndex, LocalIndex)>&, SearchMode);
template std::vector<IndexPair> overlapping_pairs<3>(
    std::span<const SearchBox<3>>, const std::function<bool(LocalIndex, LocalIndex)>&, SearchMode);

}  // namespace brunt
// Tested by tests/unit/core/search_test.cpp.
