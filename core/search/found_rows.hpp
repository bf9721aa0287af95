#pragma once
/// Rows of neighbours as a search finds them, and put in order.
#include <span>
#include <vector>

#include "core/search/search.hpp"

namespace brunt {

/// Rows of a run of cells, one after the other, and the points of each.
struct RowChunk {
  struct Row {
    LocalIndex n_points, length;
  };
  std::vector<Row> rows;
  std::vector<LocalIndex> points;
  std::vector<LocalIndex> neighbours;

  void append(std::span<const LocalIndex> group, std::span<const LocalIndex> row) {
    rows.push_back({static_cast<LocalIndex>(group.size()), static_cast<LocalIndex>(row.size())});
    points.insert(points.end(), group.begin(), group.end());
    neighbours.insert(neighbours.end(), row.begin(), row.end());
  }
};

/// Puts the rows of all chunks into the order of their first points. Every one of the points 0 ..
/// n_points has a row in one of them.
SharedNeighbours in_order(std::span<const RowChunk> chunks, LocalIndex n_points);

}  // namespace brunt
// Tested by tests/unit/core/search_test.cpp.
