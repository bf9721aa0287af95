#include "core/errors.hpp"

#include <cmath>
#include <sstream>

namespace brunt {

std::string SourcePlace::text() const {
  if (line == 0) return file;
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

std::string DeckProblem::text() const {
  std::string head = place.text();
  if (!head.empty()) head += ": ";
  if (!path.empty()) head += path + ": ";
  return head + message;
}

namespace {
std::string join(const std::vector<DeckProblem>& problems) {
  std::string all;
  for (const auto& problem : problems) all += problem.text() + "\n";
  return all;
}

std::string sentence(const PhysicsFailure& failure) {
  std::ostringstream out;
  out << "at t = " << failure.time << " s";
  if (!failure.body.empty()) out << ", body " << failure.body;
  if (!failure.entity.empty()) out << ", " << failure.entity;
  out << ": " << failure.quantity;
  if (std::isfinite(failure.value)) {
    out << " = " << failure.value;
  } else {
    out << " is no finite number any more";
  }
  if (!failure.cause.empty()) out << "; " << failure.cause;
  return out.str();
}
}  // namespace

DeckError::DeckError(std::vector<DeckProblem> problems)
    : std::runtime_error(join(problems)), problems_(std::move(problems)) {}

PhysicsError::PhysicsError(PhysicsFailure failure)
    : std::runtime_error(sentence(failure)), failure_(std::move(failure)) {}

}  // namespace brunt
