#include "core/search/cell_grid.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel/threads.hpp"

namespace brunt {

namespace {

/// Cells are wider than what they hold by this part, so that rounding of x / width, at most
/// 2^-12 up to kLargestCoordinate, never moves an entity out of reach of the stencil.
constexpr Real kMargin = 0x1p-10;
constexpr Real kLargestCoordinate = 0x1p41;
constexpr int kMaxLevel = 40;        ///< levels run from -kMaxLevel to kMaxLevel
constexpr int kFewestOfALevel = 32;  ///< fewer than this are cheaper to keep with coarser ones

/// Value in the middle of the sorted list; 0 if it is empty.
Real median(std::vector<Real> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Smallest level whose cells, 2^level times the base, hold an extent.
int level_of(Real extent, Real base) {
  const Real ratio = extent * (1 + kMargin) / base;
  if (!(ratio > 0)) return -kMaxLevel;
  int exponent = 0;
  const Real mantissa = std::frexp(ratio, &exponent);
  return std::max(-kMaxLevel, mantissa == 0.5 ? exponent - 1 : exponent);
}

template <std::size_t Dim>
bool same(const std::array<std::int64_t, Dim>& a, const std::array<std::int64_t, Dim>& b) {
  std::int64_t difference = 0;
  for (std::size_t c = 0; c < Dim; ++c) difference |= a[c] ^ b[c];
  return difference == 0;
}

bool usable(Real extent) { return extent >= 0 && extent < kInfinity; }

/// Starts of rows from their lengths, which stand in counts[1..n]; counts[0] is 0.
void accumulate_rows(std::vector<LocalIndex>& counts) {
  for (std::size_t k = 1; k < counts.size(); ++k) counts[k] += counts[k - 1];
}

}  // namespace

template <int Dim>
struct CellGrid<Dim>::LevelChoice {
  Real base = 1;                                     ///< [m] width of the cells of level 0
  std::array<Real, 2 * kMaxLevel + 1> per_length{};  ///< [1/m] cells a length; exact halves
  std::array<int, 2 * kMaxLevel + 1> merged{};       ///< level used for each size class
  std::vector<int> used;                             ///< ascending
  static constexpr int kOversize = kMaxLevel + 1;    ///< in `merged`: compare with all
};

template <int Dim>
CellGrid<Dim>::CellGrid(std::span<const Vec<Dim>> anchor, std::span<const Real> extent) {
  const LevelChoice choice = choose_levels(anchor, extent);
  table_.assign(1024, -1);
  insert_all(anchor, extent, choice);
  link_cells(choice.used);
}

/// Level 0 fits the median size: its cells are as wide as the largest extent up to 1.5 medians, so
/// that a spread of sizes about the median does not double the cells. A class with few members goes
/// to the next coarser one; if there is none, its members are compared with all.
template <int Dim>
typename CellGrid<Dim>::LevelChoice CellGrid<Dim>::choose_levels(
    std::span<const Vec<Dim>> anchor, std::span<const Real> extent) const {
  LevelChoice choice;
  std::vector<Real> sizes;
  sizes.reserve(extent.size());
  Real furthest = 0;
  for (std::size_t i = 0; i < extent.size(); ++i) {
    if (extent[i] > 0 && usable(extent[i])) sizes.push_back(extent[i]);
    furthest = std::max(furthest, anchor[i].cwiseAbs().maxCoeff());
  }
  const Real middle = median(sizes);
  Real base = middle;
  for (const Real size : sizes) {
    if (size <= 1.5 * middle) base = std::max(base, size);
  }
  base *= 1 + kMargin;
  if (!(furthest <= base * kLargestCoordinate) || !(base > 0)) {
    std::vector<Real> distances;
    for (const auto& x : anchor) {
      const Real distance = x.cwiseAbs().maxCoeff();
      if (distance < kInfinity) distances.push_back(distance);
    }
    base = std::max(base, median(std::move(distances)) * (base > 0 ? 0x1p-39 : 0x1p-20));
  }
  choice.base = base > 0 ? base : 1;
  for (int level = -kMaxLevel; level <= kMaxLevel; ++level) {
    choice.per_length[level + kMaxLevel] = std::ldexp(1 / choice.base, -level);
  }

  std::array<int, 2 * kMaxLevel + 1> count{};
  for (const Real size : extent) {
    if (!usable(size)) continue;
    const int level = level_of(size, choice.base);
    if (level <= kMaxLevel) ++count[level + kMaxLevel];
  }
  int carried = 0, first = -kMaxLevel;
  choice.merged.fill(LevelChoice::kOversize);
  for (int level = -kMaxLevel; level <= kMaxLevel; ++level) {
    carried += count[level + kMaxLevel];
    if (carried < kFewestOfALevel) continue;
    for (int l = first; l <= level; ++l) {
      choice.merged[l + kMaxLevel] = level;
    }
    choice.used.push_back(level);
    carried = 0;
    first = level + 1;
  }
  return choice;
}

template <int Dim>
void CellGrid<Dim>::insert_all(std::span<const Vec<Dim>> anchor, std::span<const Real> extent,
                               const LevelChoice& choice) {
  const auto n = static_cast<LocalIndex>(anchor.size());
  std::vector<LocalIndex> cell_of(anchor.size(), -1);
  LocalIndex last = -1;  // neighbours in memory mostly share their cell
  for (LocalIndex i = 0; i < n; ++i) {
    int level = usable(extent[i]) ? level_of(extent[i], choice.base) : LevelChoice::kOversize;
    if (level <= kMaxLevel) level = choice.merged[level + kMaxLevel];
    bool inside = level <= kMaxLevel;
    Coords coords{};
    if (inside) {
      const Real per_length = choice.per_length[level + kMaxLevel];
      for (int c = 0; c < Dim; ++c) {
        const Real coordinate = std::floor(anchor[i][c] * per_length);
        inside = inside && std::fabs(coordinate) <= kLargestCoordinate;
        coords[c] = inside ? static_cast<std::int64_t>(coordinate) : 0;
      }
    }
    if (!inside) {
      oversize_.push_back(i);
      continue;
    }
    if (last < 0 || cells_[last].level != level || !same(cells_[last].coords, coords)) {
      last = find_or_add(coords, level);
    }
    cell_of[i] = last;
  }
  member_begin_.assign(cells_.size() + 1, 0);
  for (const LocalIndex cell : cell_of) {
    if (cell >= 0) ++member_begin_[cell + 1];
  }
  accumulate_rows(member_begin_);
  members_.resize(slot_of(member_begin_.back()));
  std::vector<LocalIndex> next(member_begin_.begin(), member_begin_.end() - 1);
  for (LocalIndex i = 0; i < n; ++i) {
    if (cell_of[i] >= 0) members_[next[cell_of[i]]++] = i;
  }
}

template <int Dim>
std::uint64_t CellGrid<Dim>::hash(const Coords& coords, int level) {
  auto h = static_cast<std::uint64_t>(level) * 0x9e3779b97f4a7c15u;
  for (const std::int64_t c : coords) {
    h = (h ^ static_cast<std::uint64_t>(c)) * 0xbf58476d1ce4e5b9u;
    h ^= h >> 29;
  }
  return h ^ (h >> 32);
}

/// The cell at these coordinates, or -1. Equal hashes are distinguished by the full coordinates.
template <int Dim>
LocalIndex CellGrid<Dim>::find(const Coords& coords, int level) const {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t slot = hash(coords, level) & mask;; slot = (slot + 1) & mask) {
    const LocalIndex cell = table_[slot];
    if (cell < 0) return -1;
    if (cells_[cell].level == level && same(cells_[cell].coords, coords)) return cell;
  }
}

template <int Dim>
LocalIndex CellGrid<Dim>::find_or_add(const Coords& coords, int level) {
  const LocalIndex found = find(coords, level);
  if (found >= 0) return found;
  const LocalIndex cell = n_cells();
  cells_.push_back({coords, level});
  if (2 * cells_.size() > table_.size()) {
    grow_table();
    return cell;
  }
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hash(coords, level) & mask;
  while (table_[slot] >= 0) slot = (slot + 1) & mask;
  table_[slot] = cell;
  return cell;
}

template <int Dim>
void CellGrid<Dim>::grow_table() {
  table_.assign(2 * table_.size(), -1);
  const std::size_t mask = table_.size() - 1;
  for (LocalIndex cell = 0; cell < n_cells(); ++cell) {
    std::size_t slot = hash(cells_[cell].coords, cells_[cell].level) & mask;
    while (table_[slot] >= 0) slot = (slot + 1) & mask;
    table_[slot] = cell;
  }
}

/// Half of the stencil on the cell's own level, all of it on every coarser level in use.
template <int Dim>
void CellGrid<Dim>::append_touching(LocalIndex cell, std::span<const int> levels,
                                    std::vector<LocalIndex>& out) const {
  constexpr int kStencil = Dim == 2 ? 9 : 27;
  const Cell& own = cells_[cell];
  for (const int level : levels) {
    if (level < own.level) continue;
    const int shift = std::min(level - own.level, 62);
    // The middle of the stencil is the cell itself; what comes after it is the forward half.
    for (int s = level == own.level ? kStencil / 2 : 0; s < kStencil; ++s) {
      Coords coords;
      for (int c = 0, rest = s; c < Dim; ++c, rest /= 3) {
        coords[c] = (own.coords[c] >> shift) + rest % 3 - 1;
      }
      const LocalIndex other = find(coords, level);
      if (other >= 0) out.push_back(other);
    }
  }
}

template <int Dim>
void CellGrid<Dim>::link_cells(std::span<const int> levels) {
  constexpr LocalIndex kChunk = 512;
  const LocalIndex n_chunks = (n_cells() + kChunk - 1) / kChunk;
  std::vector<std::vector<LocalIndex>> found(slot_of(n_chunks));
  forward_begin_.assign(cells_.size() + 1, 0);
  on_threads(n_chunks > 4, [&] {
#pragma omp for schedule(dynamic, 1)
    for (LocalIndex chunk = 0; chunk < n_chunks; ++chunk) {
      const LocalIndex end = std::min(n_cells(), (chunk + 1) * kChunk);
      for (LocalIndex cell = chunk * kChunk; cell < end; ++cell) {
        const std::size_t before = found[chunk].size();
        append_touching(cell, levels, found[chunk]);
        forward_begin_[cell + 1] = static_cast<LocalIndex>(found[chunk].size() - before);
      }
    }
  });
  accumulate_rows(forward_begin_);
  forward_.reserve(slot_of(forward_begin_.back()));
  for (const auto& part : found) forward_.insert(forward_.end(), part.begin(), part.end());

  backward_begin_.assign(cells_.size() + 1, 0);
  for (LocalIndex cell = 0; cell < n_cells(); ++cell) {
    for (const LocalIndex other : forward(cell)) backward_begin_[other + 1] += other != cell;
  }
  accumulate_rows(backward_begin_);
  backward_.resize(slot_of(backward_begin_.back()));
  std::vector<LocalIndex> next(backward_begin_.begin(), backward_begin_.end() - 1);
  for (LocalIndex cell = 0; cell < n_cells(); ++cell) {
    for (const LocalIndex other : forward(cell)) {
      if (other != cell) backward_[next[other]++] = cell;
    }
  }
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace brunt
// Tested by tests/unit/core/search_cell_grid_test.cpp.
