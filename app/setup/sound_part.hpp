#pragma once
#include <string>
#include <vector>

#include "app/deck/deck.hpp"

namespace brunt {

/// What of a wrong deck can still be built: bodies, boundaries and measures without a wrong key
/// that name nothing wrong. wrong: key paths, as "bodies.bar.size".
LoadedDeck sound_part(const LoadedDeck& loaded, const std::vector<std::string>& wrong);

/// Adds what building the sound part of a wrong deck finds, so that a user reads all at once.
void add_build_problems(const LoadedDeck& loaded, std::vector<DeckProblem>& problems);

/// Reads a deck for a command: prints its warnings; where it is wrong, throws DeckError with all
/// that reading and building find.
LoadedDeck load_or_tell_all(const std::string& path, const std::vector<std::string>& overrides,
                            bool print_warnings = true);

}  // namespace brunt
