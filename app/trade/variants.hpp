#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"

namespace brunt {

/// What --vary says: keys that change together, and the values that they take.
struct Vary {
  std::vector<std::string> keys;  ///< one, or more where the call joins them by '+'
  std::vector<std::string> values;
  std::string label;  ///< the end of the first key that tells it from those of others
};

/// Reads "KEY=V1,V2" or "KEY+KEY=V1,V2" of each --vary; commas in brackets belong to a value.
/// Throws DeckError with all that is wrong, naming --vary and its number.
std::vector<Vary> read_varies(const std::vector<std::string>& texts);

/// Which combinations of values are run.
enum class Design {
  grid,           ///< all of them
  one_at_a_time,  ///< the deck as it stands, and each value alone
};

/// One deck of a study.
struct Variant {
  std::string label;                   ///< "size 0.6 mm, integration q1p0"; "as it stands"
  std::string folder;                  ///< the same as a name of a folder
  std::vector<int> choices;            ///< the value of each --vary, -1: as the deck has it
  std::vector<std::string> overrides;  ///< "KEY=VALUE" of the call and of the variant
  LoadedDeck loaded;
};

/// The variants of a deck, each read and checked; of two that come to the same deck the first is
/// kept. Throws DeckError with what is wrong with any.
std::vector<Variant> make_variants(const std::string& deck,
                                   const std::vector<std::string>& overrides,
                                   const std::vector<Vary>& varies, Design design);

/// How many times as large the elements and particles of a deck are as those of another; nothing
/// where no size differs, or where bodies differ by other ratios than each other.
std::optional<Real> size_ratio(const Deck& deck, const Deck& other);

/// Variants that differ in the size alone, by one --vary.
struct SizeSeries {
  std::size_t vary = 0;
  std::vector<std::size_t> variants;
  std::vector<Real> sizes;  ///< of each, over that of the first
};
/// All series of two variants or more.
std::vector<SizeSeries> size_series(const std::vector<Variant>& variants, std::size_t n_varies);

}  // namespace brunt
