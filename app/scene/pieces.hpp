#pragma once
/// Pieces of bodies by name: bricks of a wall, parts of a mesh file that do not hang together.
#include <optional>
#include <string>
#include <vector>

#include "core/view.hpp"

namespace brunt {

struct NamedPiece {
  Label body = 0;
  std::string name;  ///< "wall.1.0"; "": it is all of its body
};

/// A body, or one piece of it.
struct BodyPart {
  Label body = 0;
  std::optional<Label> piece;  ///< none: all of the body
};

/// The body, or the piece, of that name.
/// bodies  names, by label;  pieces  by label
std::optional<BodyPart> part_named(const std::vector<std::string>& bodies,
                                   const std::vector<NamedPiece>& pieces, const std::string& name);

/// What is wrong with a name of a piece of a body that is there; "": nothing.
std::string piece_problem(const std::vector<std::string>& bodies,
                          const std::vector<NamedPiece>& pieces, const std::string& name);

/// Leaves of a view the points and cells of one piece.
/// pieces  the same body at the same instant, with the field `piece`
void keep_piece(Label piece, const BodyView& pieces, BodyView& view);

}  // namespace brunt
// Tested by tests/verification/bricks_test.cpp.
