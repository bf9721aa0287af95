#pragma once
#include <string>
#include <vector>

#include "app/deck/deck.hpp"

namespace brunt::deck {

/// What checks find in a deck, each at its place.
class Findings {
 public:
  /// problems, warnings  appended to; what `problems` holds already is what could not be read.
  Findings(const DeckPlaces& places, std::vector<DeckProblem>& problems,
           std::vector<DeckProblem>& warnings);

  void wrong(const std::string& path, const std::string& message);
  /// A key that is wrong by what is reported at another.
  void also_wrong(const std::string& path);
  const std::vector<std::string>& reported_elsewhere() const { return also_wrong_; }
  void warn(const std::string& path, const std::string& message);
  /// False where something at, below or above the key could not be read: its values are then
  /// defaults, and nothing can be said of them.
  bool sound(const std::string& path) const;
  /// True where a warning was given of the key, or of one below it.
  bool warned(const std::string& path) const;
  /// True where the key itself stands in the deck.
  bool stands(const std::string& path) const;
  /// The line of the key in its file.
  int line(const std::string& path) const;

 private:
  const DeckPlaces& places_;
  std::vector<DeckProblem>& problems_;
  std::vector<DeckProblem>& warnings_;
  std::vector<std::string> unread_, also_wrong_;
  bool section_unknown_ = false;
};

/// True where one of the two keys is the other, or stands below it.
bool related(const std::string& a, const std::string& b);

/// Numbers for messages, of four digits: "2.5 mm", "10 us".
std::string short_text(Real value);
std::string length_text(Real length);  ///< length [m]
std::string time_text(Real time);      ///< time [s]

}  // namespace brunt::deck
