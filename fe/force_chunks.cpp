#include "fe/force_chunks.hpp"

#include <algorithm>

#include "core/parallel/threads.hpp"

namespace brunt {
namespace {
[[maybe_unused]] constexpr std::size_t kBordersWorthThreads = 2048;  // nodes
}

template <int Dim>
ForceChunks<Dim>::ForceChunks(const std::vector<ElementBlock<Dim>>& blocks, LocalIndex n_owned,
                              LocalIndex n_points) {
  cut(blocks);
  number_nodes(blocks, n_owned, n_points);
}

/// Row of an element in shared_row_: its tile is shared from now on.
template <int Dim>
std::size_t ForceChunks<Dim>::shared_row_of(const ElementBlock<Dim>& block, std::size_t b,
                                            std::size_t element) {
  const auto per_tile = slot_of(block.elements_per_tile());
  const std::size_t tile = element / per_tile, rows = per_tile * corners_[b];
  if (shared_.empty() || shared_.back().block != b ||
      shared_.back().tile != static_cast<int>(tile)) {
    shared_.push_back({b, static_cast<int>(tile), tile * per_tile, shared_row_.size() / kRow});
    shared_row_.resize(shared_row_.size() + rows * kRow);
    if (own_place_.size() < rows) own_place_.resize(rows);
  }
  return shared_.back().row + (element - shared_.back().first) * corners_[b];
}

/// Finds chunks, and the tiles that are theirs alone.
template <int Dim>
void ForceChunks<Dim>::cut(const std::vector<ElementBlock<Dim>>& blocks) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const ElementBlock<Dim>& block = blocks[b];
    const auto n = slot_of(block.n);
    const auto per_tile = slot_of(block.elements_per_tile());
    corners_.push_back(slot_of(block.corners));
    for (std::size_t e = 0; e < n;) {
      Chunk chunk;
      chunk.block = b, chunk.first = e;
      while (e < n && block.id[e] / kChunkIds == block.id[chunk.first] / kChunkIds) ++e;
      chunk.last = e;
      const std::size_t from = (chunk.first + per_tile - 1) / per_tile;
      const std::size_t to = e == n ? slot_of(block.n_tiles()) : e / per_tile;
      if (from < to) {
        chunk.first_tile = static_cast<int>(from), chunk.last_tile = static_cast<int>(to);
      }
      chunk.head_last = std::min(chunk.last, from * per_tile);
      chunk.tail_first = std::max(chunk.head_last, std::min(chunk.last, to * per_tile));
      if (chunk.first < chunk.head_last) chunk.head = shared_row_of(block, b, chunk.first);
      if (chunk.tail_first < chunk.last) chunk.tail = shared_row_of(block, b, chunk.tail_first);
      chunks_.push_back(chunk);
    }
  }
  for (std::size_t c = 0; c < own_place_.size(); ++c) {
    own_place_[c] = static_cast<std::uint16_t>(c * kRow);
  }
}

/// Gives rows to the nodes of chunks, and finds those of several.
template <int Dim>
void ForceChunks<Dim>::number_nodes(const std::vector<ElementBlock<Dim>>& blocks,
                                    LocalIndex n_owned, LocalIndex n_points) {
  std::vector<std::size_t> in_chunk(slot_of(n_points), 0);  // its number + 1
  std::vector<std::uint16_t> row(slot_of(n_points), 0);
  std::vector<std::size_t> count(slot_of(n_owned), 0);
  for (const auto& block : blocks) {
    first_place_.push_back(place_.size());
    place_.resize(place_.size() + block.corner.size(), 0);
  }
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    Chunk& chunk = chunks_[k];
    const std::size_t n = corners_[chunk.block];
    chunk.first_node = node_.size();
    for (std::size_t c = chunk.first * n; c < chunk.last * n; ++c) {
      const LocalIndex node = blocks[chunk.block].corner[c];
      if (node >= n_owned) continue;
      if (in_chunk[node] != k + 1) {
        in_chunk[node] = k + 1;
        ++count[node];
        node_.push_back(node);
        row[node] = static_cast<std::uint16_t>((node_.size() - chunk.first_node) * kRow);
      }
      place_[first_place_[chunk.block] + c] = row[node];
    }
    chunk.n_nodes = node_.size() - chunk.first_node;
    most_rows_ = std::max(most_rows_, chunk.n_nodes + 1);
  }
  std::vector<std::size_t> next(count.size(), 0);
  border_.push_back(0);
  for (LocalIndex node = 0; node < n_owned; ++node) {
    if (count[node] < 2) continue;
    next[node] = border_.back();
    border_node_.push_back(node);
    border_.push_back(border_.back() + count[node]);
  }
  border_row_.resize(border_.back() * kRow);
  for (LocalIndex& node : node_) {
    if (count[node] > 1) node = ~static_cast<LocalIndex>(next[node]++);
  }
}

/// Adds the rows of elements of shared tiles, from `row` on, to the sums of a chunk.
template <int Dim>
void ForceChunks<Dim>::add_shared(const Chunk& chunk, std::size_t first, std::size_t last,
                                  std::size_t row, Real* sum) const {
  const std::size_t n = corners_[chunk.block];
  const std::uint16_t* place = place_.data() + first_place_[chunk.block];
  const Real* from = shared_row_.data() + row * kRow;
  for (std::size_t c = first * n; c < last * n; ++c, from += kRow) {
    Real* to = sum + place[c];
    store(to, load(to) + load(from));
  }
}

/// Adds a row to the force of a node, and to its heat rate.
template <int Dim>
void add_row(const Real* row, LocalIndex node, std::vector<Vec<Dim>>& f,
             std::vector<Real>& heat_rate) {
  for (int i = 0; i < Dim; ++i) f[node][i] += row[i];
  if (!heat_rate.empty()) heat_rate[slot_of(node)] += row[kHeatOfRow];
}

/// Sums of nodes that no other chunk has go to their forces, others to their rows.
template <int Dim>
void ForceChunks<Dim>::hand_over(const Chunk& chunk, const Real* sum, std::vector<Vec<Dim>>& f,
                                 std::vector<Real>& heat_rate) {
  const LocalIndex* node = node_.data() + chunk.first_node;
  for (std::size_t k = 0; k < chunk.n_nodes; ++k) {
    sum += kRow;
    if (node[k] >= 0) {
      add_row(sum, node[k], f, heat_rate);
    } else {
      std::copy_n(sum, kRow, border_row_.data() + slot_of(~node[k]) * kRow);
    }
  }
}

template <int Dim>
void ForceChunks<Dim>::add_borders(std::vector<Vec<Dim>>& f, std::vector<Real>& heat_rate) const {
  const std::size_t n = border_node_.size();
  for_each(n, kBordersWorthThreads, [&](std::size_t k) {
    Pack sum{};
    for (std::size_t r = border_[k]; r < border_[k + 1]; ++r) {
      sum += load(border_row_.data() + r * kRow);
    }
    Real row[kRow];
    store(row, sum);
    add_row(row, border_node_[k], f, heat_rate);
  });
}

template class ForceChunks<2>;
template class ForceChunks<3>;

}  // namespace brunt
// Tested by tests/unit/fe/force_chunks_test.cpp.
