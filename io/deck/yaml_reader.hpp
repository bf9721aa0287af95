#pragma once
/// YAML text to Node. Refused with their places: duplicate keys, tabs, `<<`, anchors and aliases,
/// tags, a second document, trees that are too deep or too large.
#include <string>

#include "io/deck/node.hpp"

namespace brunt {

inline constexpr std::size_t kMaxDeckBytes = 16u << 20;
inline constexpr int kMaxDeckDepth = 48;

/// Reads one document; an empty one is null. `file` stands in the places. Throws DeckError.
Node read_yaml(const std::string& text, const std::string& file);
/// The same for a value of the command line: every place is `source`, without line and column.
Node read_yaml_value(const std::string& text, const std::string& source);

}  // namespace brunt
