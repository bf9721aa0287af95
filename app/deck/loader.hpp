#pragma once
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "io/deck/node.hpp"
#include "io/deck/units.hpp"

namespace brunt::deck {

/// Loads decks, and keeps the databases of units and materials between them.
class DeckLoader {
 public:
  DeckLoader();
  /// A tree of all sources to a checked deck; problems (appended): all that is wrong.
  LoadedDeck read(Node root, const std::vector<std::string>& override_texts,
                  std::vector<DeckProblem>& problems) const;
  /// The same; throws DeckError with all that is wrong.
  LoadedDeck load(Node root, const std::vector<std::string>& overrides) const;
  LoadedDeck load_text(const std::string& text, const std::string& name,
                       const std::vector<std::string>& overrides = {}) const;

 private:
  Units units_;
  Node library_;
};

}  // namespace brunt::deck
