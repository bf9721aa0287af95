#include "core/state.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace brunt {

namespace {
std::string quoted(const std::string& name) { return "the state '" + name + "'"; }
}  // namespace

StateRows::StateRows(std::vector<const StateTable*> parts) {
  if (parts.empty()) return;
  name_ = parts.front()->name;
  width_ = parts.front()->width;
  const auto width = slot_of(width_);
  for (const StateTable* part : parts) {
    if (part->width != width_ || width_ < 1 || part->value.size() != part->id.size() * width) {
      throw StateError(quoted(name_) + " has rows of different lengths");
    }
    for (std::size_t k = 0; k < part->id.size(); ++k) {
      place_.push_back({part->id[k], part->value.data() + k * width});
    }
  }
  const auto by_id = [](const Place& a, const Place& b) { return a.id < b.id; };
  if (!std::is_sorted(place_.begin(), place_.end(), by_id)) {
    std::stable_sort(place_.begin(), place_.end(), by_id);
  }
  // What is not of one entity alone is written by every rank: each must say the same.
  const auto same = [&](const Place& a, const Place& b) {
    if (a.id != b.id) return false;
    if (std::memcmp(a.values, b.values, width * sizeof(Real)) == 0) return true;
    throw StateError(quoted(name_) + " has two rows of entity " + std::to_string(a.id));
  };
  place_.erase(std::unique(place_.begin(), place_.end(), same), place_.end());
}

std::span<const Real> StateRows::row(GlobalId id, std::size_t width) const {
  if (width != slot_of(width_)) {
    throw StateError(quoted(name_) + " has " + std::to_string(width_) + " values an entity, not " +
                     std::to_string(width));
  }
  const auto found =
      std::lower_bound(place_.begin(), place_.end(), id,
                       [](const Place& a, GlobalId wanted) { return a.id < wanted; });
  if (found == place_.end() || found->id != id) {
    throw StateError(quoted(name_) + " has no row of entity " + std::to_string(id));
  }
  return {found->values, width};
}

bool StateRows::has(GlobalId id) const {
  const auto found =
      std::lower_bound(place_.begin(), place_.end(), id,
                       [](const Place& a, GlobalId wanted) { return a.id < wanted; });
  return found != place_.end() && found->id == id;
}

StateTables::StateTables(std::vector<StateTable> tables) : tables_(std::move(tables)) {
  std::map<std::string, std::vector<const StateTable*>> parts;
  for (const auto& table : tables_) parts[table.name].push_back(&table);
  for (auto& [name, of_name] : parts) rows_.emplace(name, StateRows(std::move(of_name)));
}

const StateRows& StateTables::rows(const std::string& name) const {
  const auto found = rows_.find(name);
  if (found == rows_.end()) throw StateError(quoted(name) + " is missing");
  return found->second;
}

}  // namespace brunt
