#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "core/parallel/threads.hpp"
#include "fe/element_block.hpp"

namespace brunt {

/// Where forces and mechanical heat of elements go: to one row of kSumRow values a node, the force
/// [N] and behind it, at kHeatOfRow, the heat rate [W].
struct CornerSums {
  /// First value in `row` of each corner's, [element - first][corner].
  const std::uint16_t* place = nullptr;
  std::size_t first = 0;  ///< element that place begins with
  Real* row = nullptr;
};
inline constexpr std::size_t kSumRow = kLanes, kHeatOfRow = 3;

/// Adds the forces and the mechanical heat of elements to their nodes, in an order that ids alone
/// decide: elements of a block whose ids have the same quotient by kChunkIds are a chunk. The
/// forces at a node are summed within each chunk by ascending id and corner; then the sums of its
/// chunks by ascending block and id. A rank that owns a node has all elements about it, and so the
/// same sums. docs/layout.md
///
/// A chunk's rows stay in the cache while its tiles are computed. Tiles that several chunks share
/// come first; theirs are rows of their own, a row a corner.
template <int Dim>
class ForceChunks {
 public:
  static constexpr GlobalId kChunkIds = 1024;

  ForceChunks() = default;
  /// Sums for the first n_owned of n_points points: ghosts behind them get none.
  ForceChunks(const std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_owned,
              LocalIndex n_points);

  /// f += forces of all elements, heat_rate += their heat; it is empty where none is given.
  /// advance(b, tile, sums) computes a tile of block b, each once, and adds what is of its corners
  /// to the sums; it is called by several threads.
  template <class Advance>
  void add(const Advance& advance, std::vector<Vec<Dim>>& f, std::vector<Real>& heat_rate);

 private:
  struct Chunk {
    std::size_t block = 0;
    std::size_t first = 0, last = 0;    ///< elements
    int first_tile = 0, last_tile = 0;  ///< tiles that are all its own
    std::size_t head = 0, tail = 0;     ///< rows of what is before and after them, in shared_row_
    std::size_t head_last = 0,
                tail_first = 0;               ///< elements: [first, head_last), [tail_first, last)
    std::size_t first_node = 0, n_nodes = 0;  ///< in node_; node k has row k + 1
  };
  struct SharedTile {
    std::size_t block = 0;
    int tile = 0;
    std::size_t first = 0;  ///< element
    std::size_t row = 0;    ///< in shared_row_
  };
  static constexpr std::size_t kRow = kSumRow;

  void cut(const std::vector<ElementBlock<Dim>>& blocks);
  std::size_t shared_row_of(const ElementBlock<Dim>& block, std::size_t b, std::size_t element);
  void number_nodes(const std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_owned,
                    LocalIndex n_points);
  void add_shared(const Chunk& chunk, std::size_t first, std::size_t last, std::size_t row,
                  Real* sum) const;
  void hand_over(const Chunk& chunk, const Real* sum, std::vector<Vec<Dim>>& f,
                 std::vector<Real>& heat_rate);
  void add_borders(std::vector<Vec<Dim>>& f, std::vector<Real>& heat_rate) const;

  std::vector<Chunk> chunks_;
  std::vector<SharedTile> shared_;
  std::vector<std::size_t> corners_;      ///< of an element, by block
  std::vector<std::size_t> first_place_;  ///< of each block in place_
  std::vector<std::uint16_t> place_;      ///< of each corner, as in CornerSums; 0: nobody's row
  std::vector<std::uint16_t> own_place_;  ///< a row a corner: of shared tiles
  std::vector<LocalIndex> node_;          ///< of each chunk's rows; ~k: k-th of border_row_
  std::vector<LocalIndex> border_node_;   ///< ascending
  std::vector<std::size_t> border_;       ///< first of border_row_ of each, and the end
  std::vector<Real> border_row_, shared_row_;
  std::size_t most_rows_ = 0;  ///< of a chunk
};

template <int Dim>
template <class Advance>
void ForceChunks<Dim>::add(const Advance& advance, std::vector<Vec<Dim>>& f,
                           std::vector<Real>& heat_rate) {
  const std::size_t n_shared = shared_.size(), n_chunks = chunks_.size();
  on_threads(n_chunks > 1, [&] {
#pragma omp for schedule(static)
    for (std::size_t k = 0; k < n_shared; ++k) {
      const SharedTile& at = shared_[k];
      Real* row = shared_row_.data() + at.row * kRow;
      const std::size_t end = k + 1 < n_shared ? shared_[k + 1].row * kRow : shared_row_.size();
      std::fill(row, shared_row_.data() + end, 0.0);
      advance(at.block, at.tile, CornerSums{own_place_.data(), at.first, row});
    }
    const auto sum = std::make_unique_for_overwrite<Real[]>(most_rows_ * kRow);
#pragma omp for schedule(static)
    for (std::size_t k = 0; k < n_chunks; ++k) {
      const Chunk& chunk = chunks_[k];
      std::fill_n(sum.get(), (chunk.n_nodes + 1) * kRow, 0.0);
      const CornerSums sums{place_.data() + first_place_[chunk.block], 0, sum.get()};
      add_shared(chunk, chunk.first, chunk.head_last, chunk.head, sum.get());
      for (int t = chunk.first_tile; t < chunk.last_tile; ++t) advance(chunk.block, t, sums);
      add_shared(chunk, chunk.tail_first, chunk.last, chunk.tail, sum.get());
      hand_over(chunk, sum.get(), f, heat_rate);
    }
  });
  add_borders(f, heat_rate);
}

}  // namespace brunt
