#pragma once
/// What contacts carry from step to step, as tables of rows: several contacts of one face or
/// particle stand in as many tables, so that each row has an id of its own.
#include <string>
#include <vector>

#include "contact/contacts/friction.hpp"
#include "contact/surfaces/entities.hpp"
#include "core/state.hpp"

namespace brunt {

/// Table of the contacts that are the place-th of their lower face, or of their particle, with
/// faces or with particles. kind  of_particle of their keys
inline std::string keyed_table(const std::string& name, std::uint32_t kind, std::size_t place) {
  static constexpr const char* kKinds[] = {".face.", ".particle.", ".particles."};
  return name + kKinds[kind] + std::to_string(place);
}

/// Adds the tables of contacts in the order of their keys.
/// visit(row, contact)  hands every value but of_particle and first of its key to row
template <class Contact, class Visit>
void save_keyed(const std::string& name, const std::vector<const Contact*>& contacts,
                const Visit& visit, std::vector<StateTable>& tables) {
  std::vector<std::vector<const Contact*>> by_place[3];
  std::size_t place = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactKey& key = contacts[i]->key;
    const bool same = i > 0 && contacts[i - 1]->key.first == key.first &&
                      contacts[i - 1]->key.of_particle == key.of_particle;
    place = same ? place + 1 : 0;
    auto& places = by_place[key.of_particle];
    if (places.size() <= place) places.resize(place + 1);
    places[place].push_back(contacts[i]);
  }
  for (std::uint32_t kind = 0; kind < 3; ++kind) {
    const auto& places = by_place[kind];
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto& chosen = places[p];
      save_rows(
          keyed_table(name, kind, p), chosen.size(),
          [&](std::size_t k) { return chosen[k]->key.first; },
          [&](auto& row, std::size_t k) { visit(row, *chosen[k]); }, tables);
    }
  }
}

/// Appends the contacts of one face or particle, in the order of their keys.
template <class Contact, class Visit>
void load_keyed(const std::string& name, std::uint32_t kind, GlobalId first,
                const StateTables& tables, const Visit& visit, std::vector<Contact>& contacts) {
  for (std::size_t place = 0; tables.has(keyed_table(name, kind, place)); ++place) {
    const auto& rows = tables.rows(keyed_table(name, kind, place));
    if (!rows.has(first)) return;
    auto& contact = contacts.emplace_back();
    contact.key.of_particle = kind;
    contact.key.first = first;
    StateCounter counter;
    visit(counter, contact);
    StateReader row(rows.row(first, counter.count));
    visit(row, contact);
  }
}

/// Appends all contacts that are evaluated here, in the order of their keys.
template <int Dim, class Contact, class Visit>
void load_keyed(const std::string& name, const Entities<Dim>& entities, const StateTables& tables,
                const Visit& visit, std::vector<Contact>& contacts) {
  for (const auto& face : entities.faces) {
    if (face.owned) load_keyed(name, 0, face.id, tables, visit, contacts);
  }
  for (const std::uint32_t kind : {1, 2}) {
    for (const auto& particle : entities.particles) {
      if (particle.owned) load_keyed(name, kind, particle.id, tables, visit, contacts);
    }
  }
}

}  // namespace brunt
// Tested by tests/unit/contact/first_touch_test.cpp.
