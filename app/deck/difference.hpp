#pragma once
#include <string>
#include <vector>

namespace brunt {

/// What a restart may not change and two resolved decks do not share, one line a key:
/// "materials.copper.density: 8960 in the checkpoint, 8900 in the deck". The end of the run, where
/// it stops, its output and its title may differ. Throws DeckError where a text is no deck.
/// where  what holds the first: "checkpoint", "folder"
std::vector<std::string> deck_differences(const std::string& checkpoint, const std::string& deck,
                                          const std::string& where = "checkpoint");

}  // namespace brunt
