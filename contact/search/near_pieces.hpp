#pragma once
#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "core/search/search.hpp"

namespace brunt {

/// A body, and a piece of it.
using PieceKey = std::pair<Label, Label>;

/// Entities whose boxes meet the bounds of a piece that they may touch, ascending: no others need
/// to be compared one by one. A body that touches with its foot costs a comparison an entity.
/// boxes  [m] of all entities;  piece_of(i)  the PieceKey of entity i;
/// may_meet(a, b)  whether pieces a and b may touch, or one piece itself (a == b)
template <int Dim, class PieceOf, class MayMeet>
std::vector<LocalIndex> near_pieces(std::span<const SearchBox<Dim>> boxes, const PieceOf& piece_of,
                                    const MayMeet& may_meet, SearchMode mode) {
  struct Piece {
    PieceKey key;
    bool meets_itself;
    std::vector<std::size_t> beside;
  };
  std::map<PieceKey, std::size_t> known;
  std::vector<Piece> pieces;
  std::vector<SearchBox<Dim>> bounds;
  std::vector<std::size_t> place(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const PieceKey key = piece_of(i);
    if (i > 0 && key == pieces[place[i - 1]].key) {
      place[i] = place[i - 1];
    } else {
      const auto [it, is_new] = known.try_emplace(key, pieces.size());
      if (is_new) {
        pieces.push_back({key, may_meet(key, key), {}});
        bounds.push_back(boxes[i]);
      }
      place[i] = it->second;
    }
    bounds[place[i]].enclose(boxes[i]);
  }
  const auto meet = [&](LocalIndex i, LocalIndex j) {
    return may_meet(pieces[slot_of(i)].key, pieces[slot_of(j)].key);
  };
  for (const auto& [i, j] : overlapping_pairs<Dim>(bounds, meet, mode)) {
    pieces[slot_of(i)].beside.push_back(slot_of(j));
    pieces[slot_of(j)].beside.push_back(slot_of(i));
  }
  std::vector<LocalIndex> near;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Piece& own = pieces[place[i]];
    const bool is_near = own.meets_itself ||
                         std::any_of(own.beside.begin(), own.beside.end(), [&](std::size_t other) {
                           return boxes[i].meets(bounds[other]);
                         });
    if (is_near) near.push_back(static_cast<LocalIndex>(i));
  }
  return near;
}

}  // namespace brunt
// Tested by tests/unit/contact/near_pieces_test.cpp.
