#pragma once
#include <map>
#include <string>
#include <vector>

#include "contact/manager/manager.hpp"

namespace brunt {

/// What a user reads of the contacts of a pair that did not hold: the first of them, what it means
/// and what to do.
/// dim  of the place
std::string lost_text(const LostPair& pair, int dim);
/// How many there have been, for the end of a run.
std::string lost_count_text(const LostPair& pair);

/// Warns of each pair of bodies the first time that contacts of it did not hold.
class LostContactWarnings {
 public:
  explicit LostContactWarnings(int dim) : dim_(dim) {}

  /// What is to be reported of the pairs as they stand now, of which each has lost contacts.
  std::vector<std::string> take(const std::vector<LostPair>& pairs);
  /// One text a pair, of the first contact and of how many there were, by the name of the pair.
  std::map<std::string, std::string> all() const;

 private:
  int dim_;
  std::map<std::string, LostPair> warned_;  // as they stood last
};

}  // namespace brunt
