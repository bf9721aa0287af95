#pragma once
#include <span>
#include <string>
#include <string_view>

namespace brunt {

/// Insertions, deletions, changes and swaps of neighbours that make `b` of `a`
/// (optimal string alignment, Damerau 1964).
int edit_distance(std::string_view a, std::string_view b);
/// The word that was probably meant, or "".
std::string nearest_word(std::string_view word, std::span<const std::string> known);
/// "; did you mean 'x'?", else "; known are a, b, c", else "".
std::string suggestion(std::string_view word, std::span<const std::string> known);

}  // namespace brunt
