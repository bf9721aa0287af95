#pragma once
/// From files and overrides to one tree: library, include, deck, --set, in this order.
#include <string>
#include <vector>

#include "io/deck/node.hpp"

namespace brunt {

/// Reads a deck file with all that it includes. Throws DeckError.
Node read_deck_file(const std::string& path);
/// The same from text; includes are relative to the folder of `name`.
Node read_deck_source(const std::string& text, const std::string& name);

/// One override of the command line, "KEY=VALUE".
struct Override {
  std::vector<std::string> path;  ///< keys, and indices of lists
  Node value;                     ///< null takes the key out
  SourcePlace place;              ///< "--set #2"
};
/// Splits and reads overrides; adds what is wrong with them to `problems`.
std::vector<Override> read_overrides(const std::vector<std::string>& texts,
                                     std::vector<DeckProblem>& problems);
/// Sets the key, makes maps on the way where there are none.
void apply_override(Node& root, const Override& change, std::vector<DeckProblem>& problems);

/// Replaces `library: NAME` in each entry of `map` (at `path`) by the values of the library, under
/// what stands beside. A key of `alternatives` whose deck value names other keys is replaced whole.
void expand_library(Node& map, const std::string& path, const Node& library,
                    const std::vector<std::string>& alternatives,
                    std::vector<DeckProblem>& problems);

/// "a.b.c" of keys.
std::string join_path(const std::string& path, const std::string& key);

}  // namespace brunt
