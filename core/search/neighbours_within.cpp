#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/search/cell_grid.hpp"
#include "core/search/search.hpp"
#include "core/simd.hpp"

namespace brunt {

namespace {

template <int Dim>
struct PointQuery {
  std::span<const Vec<Dim>> x;  ///< [m]
  std::span<const Real> reach;  ///< [m]
  std::span<const Label> label;
  Real skin;          ///< [m]
  LocalIndex n_rows;  ///< points with a row: the first
};

/// The one expression that decides, in both modes: symmetric in i and j to the last bit.
template <class V, int Dim>
BRUNT_INLINE auto within(const std::array<V, Dim>& d, V reach_i, V reach_j, V skin) {
  V square = d[0] * d[0];
  for (int c = 1; c < Dim; ++c) square = square + d[c] * d[c];
  const V limit = (reach_i + reach_j) + skin;
  return square <= limit * limit;
}

template <int Dim>
bool are_neighbours(const PointQuery<Dim>& q, LocalIndex i, LocalIndex j) {
  std::array<Real, Dim> d;
  for (int c = 0; c < Dim; ++c) d[c] = q.x[j][c] - q.x[i][c];
  return q.label[i] == q.label[j] && within<Real, Dim>(d, q.reach[i], q.reach[j], q.skin);
}

/// Bounds of the points of one cell. The gap between two such boxes is computed as the distance of
/// two points is: rounding is monotone, so no pair within reach is ever passed over.
template <int Dim>
struct Bounds {
  std::array<Real, Dim> lo, hi;  ///< [m]
  Real reach = 0;                ///< [m] largest

  bool may_hold_neighbours_of(const Bounds& other, Real skin) const {
    std::array<Real, Dim> gap;
    for (int c = 0; c < Dim; ++c) {
      gap[c] = std::max(0.0, std::max(other.lo[c] - hi[c], lo[c] - other.hi[c]));
    }
    return within<Real, Dim>(gap, reach, other.reach, skin);
  }
};

template <int Dim>
Bounds<Dim> bounds_of(const PointQuery<Dim>& q, std::span<const LocalIndex> points) {
  Bounds<Dim> b;
  b.lo.fill(kInfinity);
  b.hi.fill(-kInfinity);
  for (const LocalIndex i : points) {
    for (int c = 0; c < Dim; ++c) {
      b.lo[c] = std::min(b.lo[c], q.x[i][c]);
      b.hi[c] = std::max(b.hi[c], q.x[i][c]);
    }
    b.reach = std::max(b.reach, q.reach[i]);
  }
  return b;
}

/// Everything a cell's points are compared with, side by side; full packs of four.
template <int Dim>
struct Candidates {
  std::array<std::vector<Real>, Dim> x;  ///< [m]
  std::vector<Real> reach;               ///< [m]
  std::vector<Real> label;
  std::vector<LocalIndex> index;
  std::vector<LocalIndex> row;            ///< room for the longest row
  std::vector<LocalIndex> around, spare;  ///< points of the cells around, ascending; room to sort
  std::size_t n = 0;

  /// Takes the points of `around`, and fills the last pack with entries of a label that no point
  /// has.
  void take_around(const PointQuery<Dim>& q) {
    reserve(around.size() + kLanes);
    n = 0;
    for (const LocalIndex j : around) {
      for (int c = 0; c < Dim; ++c) x[c][n] = q.x[j][c];
      reach[n] = q.reach[j];
      label[n] = static_cast<Real>(q.label[j]);
      index[n] = j;
      ++n;
    }
    for (; n % kLanes != 0; ++n) {
      for (auto& component : x) component[n] = 0;
      reach[n] = 0;
      label[n] = -1;
    }
  }

 private:
  void reserve(std::size_t total) {
    if (total <= index.size()) return;
    for (auto& component : x) component.resize(2 * total);
    reach.resize(2 * total);
    label.resize(2 * total);
    index.resize(2 * total);
    row.resize(2 * total);
  }
};

using Bits = decltype(Pack{} <= Pack{});  ///< 64-bit lanes: all ones where true

/// Which of the candidates first ... first + 63 are neighbours of point i, itself included: one
/// bit each.
template <int Dim>
BRUNT_INLINE std::uint64_t neighbour_bits(const Candidates<Dim>& candidates, std::size_t first,
                                          const std::array<Pack, Dim>& x_i, Pack reach_i,
                                          Pack label_i, Pack skin) {
  Bits bits{0, 0, 0, 0};
  Bits bit{1, 2, 4, 8};
  const std::size_t end = std::min(candidates.n, first + 64);
  for (std::size_t k = first; k < end; k += kLanes) {
    std::array<Pack, Dim> d;
    for (int c = 0; c < Dim; ++c) d[c] = load(&candidates.x[c][k]) - x_i[c];
    const Bits near = within<Pack, Dim>(d, reach_i, load(&candidates.reach[k]), skin);
    const Bits same = load(&candidates.label[k]) == label_i;
    bits |= near & same & bit;
    bit <<= kLanes;
  }
  return static_cast<std::uint64_t>((bits[0] | bits[1]) | (bits[2] | bits[3]));
}

/// Writes the row of point i, ascending, into candidates.row; returns its length.
template <int Dim>
std::size_t select_row(const PointQuery<Dim>& q, LocalIndex i, Candidates<Dim>& candidates) {
  std::array<Pack, Dim> x_i;
  for (int c = 0; c < Dim; ++c) x_i[c] = broadcast<Pack>(q.x[i][c]);
  const Pack reach_i = broadcast<Pack>(q.reach[i]), skin = broadcast<Pack>(q.skin);
  const Pack label_i = broadcast<Pack>(static_cast<Real>(q.label[i]));
  LocalIndex* row = candidates.row.data();
  std::size_t length = 0;
  for (std::size_t first = 0; first < candidates.n; first += 64) {
    std::uint64_t bits = neighbour_bits<Dim>(candidates, first, x_i, reach_i, label_i, skin);
    const LocalIndex* index = candidates.index.data() + first;
    for (; bits != 0; bits &= bits - 1) {
      const LocalIndex j = index[std::countr_zero(bits)];
      row[length] = j;
      length += j != i;
    }
  }
  return length;
}

/// Sorts by bytes, the lowest first: the candidates of a cell are sorted once for the rows of all
/// its points. `spare` holds as many.
void sort_indices(std::vector<LocalIndex>& index, std::vector<LocalIndex>& spare) {
  constexpr int kBits = 8, kBins = 1 << kBits;
  const auto digit = [](LocalIndex i, int shift) {
    return slot_of(static_cast<std::uint32_t>(i) >> shift & (kBins - 1));
  };
  if (index.empty()) return;
  const auto largest = static_cast<std::uint32_t>(*std::max_element(index.begin(), index.end()));
  spare.resize(index.size());
  for (int shift = 0; shift < 32 && largest >> shift != 0; shift += kBits) {
    std::array<std::uint32_t, kBins> next{};
    for (const LocalIndex i : index) ++next[digit(i, shift)];
    std::uint32_t before = 0;
    for (auto& bin : next) before += std::exchange(bin, before);
    for (const LocalIndex i : index) spare[next[digit(i, shift)]++] = i;
    index.swap(spare);
  }
}

/// Rows of a run of cells, one after the other, in the order of the cells' points.
struct RowChunk {
  std::vector<LocalIndex> points;
  std::vector<LocalIndex> neighbours;
};

template <int Dim>
void append_row(const PointQuery<Dim>& q, LocalIndex i, Candidates<Dim>& candidates,
                std::span<std::int64_t> count, RowChunk& chunk) {
  const std::size_t length = select_row(q, i, candidates);
  const std::size_t before = chunk.neighbours.size();
  chunk.neighbours.resize(before + length);
  std::copy_n(candidates.row.data(), length, chunk.neighbours.data() + before);
  chunk.points.push_back(i);
  count[i] = static_cast<std::int64_t>(length);
}

/// Rows of all points of a cell: its surroundings are gathered once.
template <int Dim>
void append_rows_of_cell(const PointQuery<Dim>& q, const CellGrid<Dim>& grid,
                         std::span<const Bounds<Dim>> bounds, LocalIndex cell,
                         Candidates<Dim>& candidates, std::span<std::int64_t> count,
                         RowChunk& chunk) {
  const auto members = grid.members(cell);
  if (members.empty() || members.front() >= q.n_rows) return;  // ascending
  candidates.around.clear();
  const auto gather = [&](std::span<const LocalIndex> points) {
    candidates.around.insert(candidates.around.end(), points.begin(), points.end());
  };
  for (const auto& list : {grid.forward(cell), grid.backward(cell)}) {
    for (const LocalIndex other : list) {
      if (bounds[cell].may_hold_neighbours_of(bounds[other], q.skin)) gather(grid.members(other));
    }
  }
  gather(grid.oversize());
  sort_indices(candidates.around, candidates.spare);
  candidates.take_around(q);
  for (const LocalIndex i : members) {
    if (i < q.n_rows) append_row(q, i, candidates, count, chunk);
  }
}

/// Rows of points that lie in no cell: compared with all.
template <int Dim>
void append_oversize_rows(const PointQuery<Dim>& q, const CellGrid<Dim>& grid,
                          std::span<std::int64_t> count, RowChunk& chunk) {
  const auto n = static_cast<LocalIndex>(q.x.size());
  for (const LocalIndex i : grid.oversize()) {
    if (i >= q.n_rows) continue;
    const std::size_t before = chunk.neighbours.size();
    for (LocalIndex j = 0; j < n; ++j) {
      if (j != i && are_neighbours(q, i, j)) chunk.neighbours.push_back(j);
    }
    chunk.points.push_back(i);
    count[i] = static_cast<std::int64_t>(chunk.neighbours.size() - before);
  }
}

/// Puts the rows of all chunks into the order of the points; the list's offsets hold the lengths.
void assemble(std::span<const RowChunk> chunks, NeighbourList& list) {
  for (std::size_t i = 1; i < list.offset.size(); ++i) list.offset[i] += list.offset[i - 1];
  list.neighbour.resize(slot_of(list.offset.back()));
#pragma omp parallel for schedule(static) if (chunks.size() > 4)
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    const LocalIndex* from = chunks[k].neighbours.data();
    for (const LocalIndex i : chunks[k].points) {
      const auto length = list.offset[i + 1] - list.offset[i];
      std::copy(from, from + length, list.neighbour.begin() + list.offset[i]);
      from += length;
    }
  }
}

template <int Dim>
NeighbourList all_neighbours(const PointQuery<Dim>& q) {
  NeighbourList list;
  const auto n = static_cast<LocalIndex>(q.x.size());
  list.offset.push_back(0);
  for (LocalIndex i = 0; i < q.n_rows; ++i) {
    for (LocalIndex j = 0; j < n; ++j) {
      if (i != j && are_neighbours(q, i, j)) list.neighbour.push_back(j);
    }
    list.offset.push_back(static_cast<std::int64_t>(list.neighbour.size()));
  }
  return list;
}

}  // namespace

template <int Dim>
NeighbourList neighbours_within(std::span<const Vec<Dim>> x, std::span<const Real> reach,
                                std::span<const Label> label, Real skin, LocalIndex n_rows,
                                SearchMode mode) {
  const PointQuery<Dim> q{x, reach, label, skin, n_rows};
  if (mode == SearchMode::brute) return all_neighbours(q);
  std::vector<Real> extent(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) extent[i] = 2 * reach[i] + skin;
  const CellGrid<Dim> grid(x, extent);
  std::vector<Bounds<Dim>> bounds(slot_of(grid.n_cells()));
#pragma omp parallel for schedule(static) if (grid.n_cells() > 1024)
  for (LocalIndex cell = 0; cell < grid.n_cells(); ++cell) {
    bounds[cell] = bounds_of(q, grid.members(cell));
  }
  NeighbourList list;
  list.offset.assign(slot_of(n_rows) + 1, 0);
  const std::span<std::int64_t> count(list.offset.data() + 1, slot_of(n_rows));
  constexpr LocalIndex kChunk = 64;
  const LocalIndex n_chunks = (grid.n_cells() + kChunk - 1) / kChunk;
  std::vector<RowChunk> chunks(slot_of(n_chunks) + 1);
#pragma omp parallel if (n_chunks > 4)
  {
    Candidates<Dim> candidates;
#pragma omp for schedule(dynamic, 1)
    for (LocalIndex chunk = 0; chunk < n_chunks; ++chunk) {
      const LocalIndex end = std::min(grid.n_cells(), (chunk + 1) * kChunk);
      for (LocalIndex cell = chunk * kChunk; cell < end; ++cell) {
        append_rows_of_cell<Dim>(q, grid, bounds, cell, candidates, count, chunks[chunk]);
      }
    }
  }
  append_oversize_rows(q, grid, count, chunks.back());
  assemble(chunks, list);
  return list;
}

template NeighbourList neighbours_within<2>(std::span<const Vec<2>>, std::span<const Real>,
                                            std::span<const Label>, Real, LocalIndex, SearchMode);
template NeighbourList neighbours_within<3>(std::span<const Vec<3>>, std::span<const Real>,
                                            std::span<const Label>, Real, LocalIndex, SearchMode);

}  // namespace brunt
// Tested by tests/unit/core/search_test.cpp.
