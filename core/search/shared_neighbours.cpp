#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "core/parallel/threads.hpp"
#include "core/search/cell_grid.hpp"
#include "core/search/found_rows.hpp"
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

/// Writes what is within reach of any of a group, ascending, into candidates.row; returns its
/// length. Of several points each is in reach of itself.
template <int Dim>
std::size_t select_row(const PointQuery<Dim>& q, std::span<const LocalIndex> group,
                       Candidates<Dim>& candidates) {
  const Pack skin = broadcast<Pack>(q.skin);
  const Pack label = broadcast<Pack>(static_cast<Real>(q.label[group.front()]));
  const LocalIndex left_out = group.size() == 1 ? group.front() : -1;
  LocalIndex* row = candidates.row.data();
  std::size_t length = 0;
  for (std::size_t first = 0; first < candidates.n; first += 64) {
    std::uint64_t bits = 0;
    for (const LocalIndex i : group) {
      std::array<Pack, Dim> x_i;
      for (int c = 0; c < Dim; ++c) x_i[c] = broadcast<Pack>(q.x[i][c]);
      bits |= neighbour_bits<Dim>(candidates, first, x_i, broadcast<Pack>(q.reach[i]), label, skin);
    }
    const LocalIndex* index = candidates.index.data() + first;
    for (; bits != 0; bits &= bits - 1) {
      const LocalIndex j = index[std::countr_zero(bits)];
      row[length] = j;
      length += j != left_out;
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

/// Points of a cell in the order of their labels, and of each label along a curve through the cell,
/// so that those that follow each other lie side by side.
template <int Dim>
class OrderInCell {
 public:
  /// points  those that have rows
  std::span<const LocalIndex> of(const PointQuery<Dim>& q, const Bounds<Dim>& bounds,
                                 std::span<const LocalIndex> points) {
    keyed_.clear();
    for (const LocalIndex i : points) {
      if (i < q.n_rows) keyed_.push_back({q.label[i], place(q.x[i], bounds), i});
    }
    std::sort(keyed_.begin(), keyed_.end());
    ordered_.clear();
    for (const auto& one : keyed_) ordered_.push_back(one.point);
    return ordered_;
  }

 private:
  struct Keyed {
    Label label;
    std::uint32_t place;
    LocalIndex point;
    auto operator<=>(const Keyed&) const = default;
  };
  /// Morton's curve through 8 parts of each side.
  static std::uint32_t place(const Vec<Dim>& x, const Bounds<Dim>& bounds) {
    constexpr int kBits = 3;
    std::uint32_t along = 0;
    for (int c = 0; c < Dim; ++c) {
      const Real width = bounds.hi[c] - bounds.lo[c];
      const Real part = width > 0 ? (x[c] - bounds.lo[c]) / width * (1 << kBits) : 0;
      const auto cell = static_cast<std::uint32_t>(std::min<Real>(part, (1 << kBits) - 1));
      for (int bit = 0; bit < kBits; ++bit) along |= (cell >> bit & 1U) << (bit * Dim + c);
    }
    return along;
  }
  std::vector<Keyed> keyed_;
  std::vector<LocalIndex> ordered_;
};

/// The next group: as many points of one label as there are, in equal parts of at most `most`.
template <int Dim>
std::size_t group_size(const PointQuery<Dim>& q, std::span<const LocalIndex> points,
                       std::size_t most) {
  const auto other = std::find_if(points.begin(), points.end(), [&](LocalIndex i) {
    return q.label[i] != q.label[points.front()];
  });
  const auto same = static_cast<std::size_t>(other - points.begin());
  const std::size_t parts = (same + most - 1) / most;
  return (same + parts - 1) / parts;
}

/// Rows of all points of a cell: its surroundings are gathered once.
template <int Dim>
void append_rows_of_cell(const PointQuery<Dim>& q, const CellGrid<Dim>& grid,
                         std::span<const Bounds<Dim>> bounds, LocalIndex cell,
                         Candidates<Dim>& candidates, OrderInCell<Dim>& order, std::size_t most,
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
  for (auto left = order.of(q, bounds[cell], members); !left.empty();) {
    const auto group = left.first(group_size(q, left, most));
    const std::size_t length = select_row(q, group, candidates);
    chunk.append(group, std::span<const LocalIndex>(candidates.row).first(length));
    left = left.subspan(group.size());
  }
}

/// The row of a point that is compared with all.
template <int Dim>
void append_own_row(const PointQuery<Dim>& q, LocalIndex i, RowChunk& chunk) {
  std::vector<LocalIndex> row;
  const auto n = static_cast<LocalIndex>(q.x.size());
  for (LocalIndex j = 0; j < n; ++j) {
    if (j != i && are_neighbours(q, i, j)) row.push_back(j);
  }
  chunk.append({&i, 1}, row);
}
}  // namespace

template <int Dim>
SharedNeighbours shared_neighbours(std::span<const Vec<Dim>> x, std::span<const Real> reach,
                                   std::span<const Label> label, Real skin, LocalIndex n_rows,
                                   std::size_t most, SearchMode mode) {
  const PointQuery<Dim> q{x, reach, label, skin, n_rows};
  if (mode == SearchMode::brute) {
    RowChunk all;
    for (LocalIndex i = 0; i < n_rows; ++i) append_own_row(q, i, all);
    return in_order({&all, 1}, n_rows);
  }
  std::vector<Real> extent(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) extent[i] = 2 * reach[i] + skin;
  const CellGrid<Dim> grid(x, extent);
  std::vector<Bounds<Dim>> bounds(slot_of(grid.n_cells()));
  for_each(grid.n_cells(), 1024,
           [&](LocalIndex cell) { bounds[cell] = bounds_of(q, grid.members(cell)); });
  constexpr LocalIndex kChunk = 64;
  const LocalIndex n_chunks = (grid.n_cells() + kChunk - 1) / kChunk;
  std::vector<RowChunk> chunks(slot_of(n_chunks) + 1);
  on_threads(n_chunks > 4, [&] {
    Candidates<Dim> candidates;
    OrderInCell<Dim> order;
#pragma omp for schedule(dynamic, 1)
    for (LocalIndex chunk = 0; chunk < n_chunks; ++chunk) {
      const LocalIndex end = std::min(grid.n_cells(), (chunk + 1) * kChunk);
      for (LocalIndex cell = chunk * kChunk; cell < end; ++cell) {
        append_rows_of_cell<Dim>(q, grid, bounds, cell, candidates, order, most, chunks[chunk]);
      }
    }
  });
  for (const LocalIndex i : grid.oversize()) {
    if (i < n_rows) append_own_row(q, i, chunks.back());
  }
  return in_order(chunks, n_rows);
}

template SharedNeighbours shared_neighbours<2>(std::span<const Vec<2>>, std::span<const Real>,
                                               std::span<const Label>, Real, LocalIndex,
                                               std::size_t, SearchMode);
template SharedNeighbours shared_neighbours<3>(std::span<const Vec<3>>, std::span<const Real>,
                                               std::span<const Label>, Real, LocalIndex,
                                               std::size_t, SearchMode);

}  // namespace brunt
// Tested by tests/unit/core/search_test.cpp.
