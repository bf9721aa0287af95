#pragma once
/// Hashed cells by size class. Every entity lies in one cell, of the level whose
/// cells are at least as large as it is; two entities whose anchors are no further apart, by
/// component, than the larger of their extents lie in cells that touch. No cell array: memory and
/// time depend on the number of entities alone, wherever they are.
#include <array>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace brunt {

template <int Dim>
class CellGrid {
 public:
  using Coords = std::array<std::int64_t, Dim>;

  /// anchor  a fixed point of each entity [m]: its centre or its lower corner
  /// extent  how far the anchors of two entities that meet may be apart, by component: no further
  ///         than the larger of their extents [m]; negative, infinite or NaN: compare with all
  CellGrid(std::span<const Vec<Dim>> anchor, std::span<const Real> extent);

  LocalIndex n_cells() const { return static_cast<LocalIndex>(cells_.size()); }
  /// Entities of a cell, ascending.
  std::span<const LocalIndex> members(LocalIndex cell) const {
    return row(member_begin_, members_, cell);
  }
  /// The cell itself, then touching cells of its own or a coarser level: each pair of touching
  /// cells stands in one of the two lists.
  std::span<const LocalIndex> forward(LocalIndex cell) const {
    return row(forward_begin_, forward_, cell);
  }
  /// Touching cells in whose list this one stands.
  std::span<const LocalIndex> backward(LocalIndex cell) const {
    return row(backward_begin_, backward_, cell);
  }
  /// Entities that are in no cell and must be compared with all: too few of their size to be worth
  /// a level, or too far out for their coordinates to tell cells apart. Ascending.
  std::span<const LocalIndex> oversize() const { return oversize_; }

 private:
  struct Cell {
    Coords coords;
    int level;
  };
  struct LevelChoice;  ///< size of the cells and levels in use

  static std::span<const LocalIndex> row(const std::vector<LocalIndex>& begin,
                                         const std::vector<LocalIndex>& entries, LocalIndex cell) {
    const auto first = slot_of(begin[cell]);
    return {entries.data() + first, slot_of(begin[cell + 1]) - first};
  }
  static std::uint64_t hash(const Coords& coords, int level);
  LevelChoice choose_levels(std::span<const Vec<Dim>> anchor, std::span<const Real> extent) const;
  void insert_all(std::span<const Vec<Dim>> anchor, std::span<const Real> extent,
                  const LevelChoice& choice);
  LocalIndex find(const Coords& coords, int level) const;
  LocalIndex find_or_add(const Coords& coords, int level);
  void grow_table();
  void link_cells(std::span<const int> levels);
  void append_touching(LocalIndex cell, std::span<const int> levels,
                       std::vector<LocalIndex>& out) const;

  std::vector<Cell> cells_;
  std::vector<LocalIndex> table_;  ///< open addressing: cell or -1; a power of two long
  std::vector<LocalIndex> member_begin_, members_;
  std::vector<LocalIndex> forward_begin_, forward_;
  std::vector<LocalIndex> backward_begin_, backward_;
  std::vector<LocalIndex> oversize_;
};

}  // namespace brunt
// Tested by tests/unit/core/search_cell_grid_test.cpp.
