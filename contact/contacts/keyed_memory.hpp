#pragma once
/// What contacts remember from step to step, by their keys. A memory is a struct with
///   ContactKey key;
///   static constexpr const char* kTable = "contact.NAME";
///   template <class Visitor, class Memory>  // this struct, or a const one
///   static void visit(Visitor& visitor, Memory& memory);
/// visit is the one function that names its values: it hands to visitor.carry(values...) what a
/// restart needs beside the key, and to visitor.hash(values...) what distinguishes two states.
/// Checkpoints, migration between ranks (it goes through the same tables) and the hash of the state
/// follow from it.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contact/contacts/key.hpp"
#include "contact/surfaces/entities.hpp"
#include "core/state.hpp"
#include "core/state_hash.hpp"

namespace brunt {

/// Hands what a memory carries to a row of a table.
template <class Row>
struct CarriedValues {
  Row& row;
  template <class... Values>
  void carry(Values&... values) {
    (row(values), ...);
  }
  template <class... Values>
  void hash(const Values&...) {}
};

/// Takes what distinguishes two states into a hash.
struct HashedValues {
  EntityHash sum;
  template <class... Values>
  void carry(const Values&...) {}
  template <class... Values>
  void hash(const Values&... values) {
    (add(values), ...);
  }

 private:
  void add(Real value) { sum.add(value); }
  void add(std::uint64_t bits) { sum.add(bits); }
  template <int Dim>
  void add(const Eigen::Matrix<Real, Dim, 1>& vector) {
    for (int c = 0; c < Dim; ++c) sum.add(vector[c]);
  }
};

/// Mixed bits of one memory; those of many are summed, in any order.
template <class Memory>
std::uint64_t hash_of(const Memory& memory) {
  HashedValues values{EntityHash(memory.key.first)};
  values.hash(memory.key.second);
  Memory::visit(values, memory);
  return values.sum.value();
}

/// All values of a row: what is left of the key once table and id are known, then the memory's.
template <class Row, class AnyMemory>
void visit_row(Row& row, AnyMemory& memory) {
  row(memory.key.second);
  row(memory.key.ordinal);
  CarriedValues<Row> values{row};
  AnyMemory::visit(values, memory);
}

/// Several contacts of one face or particle stand in as many tables, so that each row has an id of
/// its own: this one holds the place-th of their first face or particle.
inline std::string keyed_table(const char* name, ContactKind kind, std::size_t place) {
  static constexpr const char* kKinds[] = {".face.", ".particle.", ".particles."};
  return name + std::string(kKinds[slot_of(kind)]) + std::to_string(place);
}

/// Adds the tables of memories in the order of their keys.
template <class Memory>
void save_memories(const std::vector<const Memory*>& memories, std::vector<StateTable>& tables) {
  std::array<std::vector<std::vector<const Memory*>>, kContactKinds> by_place;
  std::size_t place = 0;
  for (std::size_t i = 0; i < memories.size(); ++i) {
    const ContactKey& key = memories[i]->key;
    const bool same =
        i > 0 && memories[i - 1]->key.first == key.first && memories[i - 1]->key.kind == key.kind;
    place = same ? place + 1 : 0;
    auto& places = by_place[slot_of(key.kind)];
    if (places.size() <= place) places.resize(place + 1);
    places[place].push_back(memories[i]);
  }
  for (std::size_t kind = 0; kind < kContactKinds; ++kind) {
    const auto& places = by_place[kind];
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto& chosen = places[p];
      save_rows(
          keyed_table(Memory::kTable, static_cast<ContactKind>(kind), p), chosen.size(),
          [&](std::size_t k) { return chosen[k]->key.first; },
          [&](auto& row, std::size_t k) { visit_row(row, *chosen[k]); }, tables);
    }
  }
}

/// Appends the memories of one face or particle, in the order of their keys.
template <class Memory>
void load_memories(ContactKind kind, GlobalId first, const StateTables& tables,
                   std::vector<Memory>& memories) {
  for (std::size_t place = 0; tables.has(keyed_table(Memory::kTable, kind, place)); ++place) {
    const auto& rows = tables.rows(keyed_table(Memory::kTable, kind, place));
    if (!rows.has(first)) return;
    auto& memory = memories.emplace_back();
    memory.key.kind = kind;
    memory.key.first = first;
    StateCounter counter;
    visit_row(counter, memory);
    StateReader row(rows.row(first, counter.count));
    visit_row(row, memory);
  }
}

/// Those of all contacts that are evaluated here, in the order of their keys.
template <class Memory, int Dim>
std::vector<Memory> load_memories(const Entities<Dim>& entities, const StateTables& tables) {
  std::vector<Memory> memories;
  for (const auto& face : entities.faces) {
    if (face.owned) load_memories(ContactKind::face_face, face.id, tables, memories);
  }
  for (const auto kind : {ContactKind::particle_face, ContactKind::particle_particle}) {
    for (const auto& particle : entities.particles) {
      if (particle.owned) load_memories(kind, particle.id, tables, memories);
    }
  }
  return memories;
}

/// Memories in the order of their keys.
template <class Memory>
class KeyedMemory {
 public:
  KeyedMemory() = default;
  /// memories  in the order of keys
  explicit KeyedMemory(std::vector<Memory> memories) : memories_(std::move(memories)) {}
  bool empty() const { return memories_.empty(); }
  void clear() { memories_.clear(); }
  /// Of a key beyond all others.
  void add(const Memory& memory) { memories_.push_back(memory); }
  /// Of any key; one that has a memory keeps it.
  void add_if_new(const Memory& memory) {
    const auto at = place_of(memory.key);
    if (!is_at(at, memory.key)) memories_.insert(at, memory);
  }
  /// Forgets those of which condition(memory) is true.
  template <class Condition>
  void remove(const Condition& condition) {
    std::erase_if(memories_, condition);
  }
  /// nullptr where there is none.
  const Memory* find(const ContactKey& key) const {
    if (memories_.empty()) return nullptr;
    const auto at = place_of(key);
    return is_at(at, key) ? &*at : nullptr;
  }
  /// Those from one key up to before another.
  std::span<const Memory> range(const ContactKey& first, const ContactKey& before) const {
    if (memories_.empty()) return {};
    return {place_of(first), place_of(before)};
  }
  /// Takes those of keys that it has in place of its own, and the others too. updates  in the order
  /// of keys
  void update(const std::vector<Memory>& updates) {
    std::vector<Memory> both;
    both.reserve(memories_.size() + updates.size());
    auto own = memories_.begin();
    for (const auto& update : updates) {
      while (own != memories_.end() && own->key < update.key) both.push_back(*own++);
      if (own != memories_.end() && own->key == update.key) ++own;
      both.push_back(update);
    }
    both.insert(both.end(), own, memories_.end());
    memories_.swap(both);
  }
  auto begin() const { return memories_.begin(); }
  auto end() const { return memories_.end(); }

  std::uint64_t hash() const {
    std::uint64_t sum = 0;
    for (const auto& memory : memories_) sum += hash_of(memory);
    return sum;
  }
  void save(std::vector<StateTable>& tables) const {
    std::vector<const Memory*> all;
    all.reserve(memories_.size());
    for (const auto& memory : memories_) all.push_back(&memory);
    save_memories(all, tables);
  }
  template <int Dim>
  void load(const Entities<Dim>& entities, const StateTables& tables) {
    memories_ = load_memories<Memory>(entities, tables);
  }

 private:
  using Place = typename std::vector<Memory>::const_iterator;
  Place place_of(const ContactKey& key) const {
    return std::lower_bound(
        memories_.begin(), memories_.end(), key,
        [](const Memory& one, const ContactKey& wanted) { return one.key < wanted; });
  }
  bool is_at(Place at, const ContactKey& key) const {
    return at != memories_.end() && at->key == key;
  }

  std::vector<Memory> memories_;
};

}  // namespace brunt
