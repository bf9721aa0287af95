#include "core/search/found_rows.hpp"

#include <algorithm>

#include "core/parallel/threads.hpp"

namespace brunt {

namespace {
/// A row as it was found.
struct FoundRow {
  const LocalIndex* points;
  const LocalIndex* neighbours;
  RowChunk::Row size;
};
}  // namespace

SharedNeighbours in_order(std::span<const RowChunk> chunks, LocalIndex n_points) {
  std::vector<FoundRow> found;
  std::vector<LocalIndex> found_of(slot_of(n_points));
  for (const auto& chunk : chunks) {
    const LocalIndex* point = chunk.points.data();
    const LocalIndex* neighbour = chunk.neighbours.data();
    for (const auto& row : chunk.rows) {
      for (LocalIndex k = 0; k < row.n_points; ++k) {
        found_of[slot_of(point[k])] = static_cast<LocalIndex>(found.size());
      }
      found.push_back({point, neighbour, row});
      point += row.n_points, neighbour += row.length;
    }
  }
  SharedNeighbours shared;
  std::vector<LocalIndex> found_at;  // by row
  shared.row_of.assign(slot_of(n_points), -1);
  shared.points.reserve(slot_of(n_points));
  shared.begin.assign(1, 0);
  shared.list.offset.assign(1, 0);
  for (std::size_t i = 0; i < shared.row_of.size(); ++i) {
    if (shared.row_of[i] >= 0) continue;
    const FoundRow& row = found[slot_of(found_of[i])];
    for (LocalIndex k = 0; k < row.size.n_points; ++k) {
      shared.points.push_back(row.points[k]);
      shared.row_of[slot_of(row.points[k])] = static_cast<LocalIndex>(found_at.size());
    }
    shared.begin.push_back(static_cast<LocalIndex>(shared.points.size()));
    shared.list.offset.push_back(shared.list.offset.back() + row.size.length);
    found_at.push_back(found_of[i]);
  }
  constexpr std::size_t kRoom = 8;  // so that who reads the last row in eights need not copy all
  shared.list.neighbour.reserve(slot_of(shared.list.offset.back()) + kRoom);
  shared.list.neighbour.resize(slot_of(shared.list.offset.back()));
  for_each(found_at.size(), 1024, [&](std::size_t row) {
    const FoundRow& from = found[slot_of(found_at[row])];
    std::copy_n(from.neighbours, from.size.length,
                shared.list.neighbour.begin() + shared.list.offset[row]);
  });
  return shared;
}

}  // namespace brunt
// Tested by tests/unit/core/search_test.cpp.
