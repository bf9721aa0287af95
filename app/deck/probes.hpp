#pragma once
/// What is watched in every row of history.csv, as the deck gives it.
#include <string>
#include <vector>

#include "app/deck/boundaries.hpp"

namespace brunt::deck {

/// Fields at a place of time 0: between points (point fields) or of its element (element fields).
struct Probe {
  std::string body;
  std::vector<Real> at;             ///< [m]
  std::vector<std::string> fields;  ///< "temperature", "stress.xx"
};

/// The force that material carries through a plane of it at time 0.
struct Section {
  std::string body;
  WherePlane plane;
};

void describe(Schema& s, Probe& probe);
void describe(Schema& s, Section& section);

}  // namespace brunt::deck
