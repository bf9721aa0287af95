#pragma once
/// Errors that reach the user. Each says where, what is wrong, and what would be right.
#include <stdexcept>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace brunt {

/// A place in a deck: file, line and column (from 1), or an override such as "--set #2".
struct SourcePlace {
  std::string file;
  int line = 0;
  int column = 0;
  std::string text() const;  ///< "file:line:column", or the file alone where line is 0
};

/// One thing that is wrong with a deck.
struct DeckProblem {
  SourcePlace place;
  std::string path;     ///< key path, e.g. "materials.copper.density"
  std::string message;  ///< what is wrong and what would be right
  std::string text() const;
};

/// All that is wrong with a deck, collected before it stops; exit status 2.
class DeckError : public std::runtime_error {
 public:
  explicit DeckError(std::vector<DeckProblem> problems);
  const std::vector<DeckProblem>& problems() const { return problems_; }

 private:
  std::vector<DeckProblem> problems_;
};

/// The physics broke; exit status 3.
struct PhysicsFailure {
  Real time = 0;         ///< [s]
  std::string body;      ///< name of the body
  std::string entity;    ///< "element 1234", "particle 7", "step"
  std::string quantity;  ///< what is wrong: "volume", "velocity", "energy drift"
  Real value = 0;        ///< its value, SI
  std::string cause;     ///< the likely cause, and what to try
  /// Of what breaks at once on several ranks the first is said: by group of the scene, then by id.
  std::size_t group = 0;
  GlobalId id = 0;
};
class PhysicsError : public std::runtime_error {
 public:
  explicit PhysicsError(PhysicsFailure failure);
  const PhysicsFailure& failure() const { return failure_; }

 private:
  PhysicsFailure failure_;
};

/// The machine failed (disk, memory); exit status 4. Names the file.
class MachineError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace brunt
