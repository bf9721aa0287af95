#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/deck/deck.hpp"
#include "app/trade/convergence.hpp"
#include "app/trade/variants.hpp"

namespace brunt {

/// What the command line says about a run with error bars.
struct RefineArguments {
  std::string deck;
  std::vector<std::string> overrides;
  std::string key;  ///< what the sizes differ in; empty: found
  std::filesystem::path out;
  int sizes = 3;
  bool force = false, resume = false, quiet = false, json = false;
  int threads = 0;
  std::vector<std::string> flags;  ///< of each run besides
};

/// How a deck is made coarser or finer: by a key, or by the sizes of all bodies that deform.
struct SizeLever {
  std::vector<std::string> keys;
  /// Overrides with which elements and particles are about `factor` times as large. Numbers of
  /// cells are whole and at least 1.
  std::vector<std::string> at(const LoadedDeck& deck, Real factor) const;
};

/// Finds what changes the sizes of a deck: the key asked for, else the parameter that all sizes
/// follow, or the most of them, else `size` or `cells` of each body. Throws DeckError where the key
/// changes no size, or the deck has none.
SizeLever find_size_lever(const std::string& deck, const std::vector<std::string>& overrides,
                          const LoadedDeck& loaded, const std::string& key);

/// The sizes and cells of all bodies, each by its own key; no keys where one that deforms has
/// neither, as those of mesh files. Rigid faces grow with the elements that they meet.
SizeLever own_sizes(const LoadedDeck& loaded);

/// The deck with overrides that change sizes, or nothing where it is then wrong or has an axis of a
/// single cell that had more.
std::optional<LoadedDeck> resized_deck(const std::string& deck,
                                       const std::vector<std::string>& overrides,
                                       const LoadedDeck& loaded);

/// The deck as it stands first, then the other sizes: each a square root of two coarser, or finer
/// where a coarser one cannot be built.
std::vector<Variant> size_variants(const RefineArguments& arguments);

/// `brunt run --refine`: runs the deck and other sizes, adds to the summary in `out` what size does
/// to each measure. The other runs are kept in OUT.refine. Returns the exit status of the deck's
/// own run, else of the worst.
int refine_command(const RefineArguments& arguments);

}  // namespace brunt
