#pragma once
/// What contacts carry from step to step, as tables of rows: several contacts of one face or
/// particle stand in as many tables, so that each row has an id of its own.
#include <string>
#include <vector>

#include "contact/friction.hpp"
#include "core/state.hpp"

namespace brunt {

/// Table of the contacts that are the place-th of their lower face, or of their particle.
inline std::string keyed_table(const std::string& name, bool of_particle, std::size_t place) {
  return name + (of_particle ? ".particle." : ".face.") + std::to_string(place);
}

/// Adds the tables of contacts in the order of their keys.
/// key(contact)  its key;  visit(row, contact)  hands every value but of_particle and first to row
template <class Contact, class Key, class Visit>
void save_keyed(const std::string& name, const std::vector<const Contact*>& contacts,
                const Key& key, const Visit& visit, std::vector<StateTable>& tables) {
  std::vector<std::vector<const Contact*>> by_place[2];
  std::size_t place = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const ContactKey& one = key(*contacts[i]);
    const bool same = i > 0 && key(*contacts[i - 1]).first == one.first &&
                      key(*contacts[i - 1]).of_particle == one.of_particle;
    place = same ? place + 1 : 0;
    auto& places = by_place[one.of_particle ? 1 : 0];
    if (places.size() <= place) places.resize(place + 1);
    places[place].push_back(contacts[i]);
  }
  for (const bool of_particle : {false, true}) {
    const auto& places = by_place[of_particle ? 1 : 0];
    for (std::size_t p = 0; p < places.size(); ++p) {
      const auto& chosen = places[p];
      save_rows(
          keyed_table(name, of_particle, p), chosen.size(),
          [&](std::size_t k) { return key(*chosen[k]).first; },
          [&](auto& row, std::size_t k) { visit(row, *chosen[k]); }, tables);
    }
  }
}

/// Appends the contacts of one face or particle, in the order of their keys; with their of_particle
/// and first.
template <class Contact, class Visit>
void load_keyed(const std::string& name, bool of_particle, GlobalId first,
                const StateTables& tables, const Visit& visit, std::vector<Contact>& contacts) {
  for (std::size_t place = 0; tables.has(keyed_table(name, of_particle, place)); ++place) {
    const auto& rows = tables.rows(keyed_table(name, of_particle, place));
    if (!rows.has(first)) return;
    auto& contact = contacts.emplace_back();
    contact.key.of_particle = of_particle ? 1 : 0;
    contact.key.first = first;
    StateCounter counter;
    visit(counter, contact);
    StateReader row(rows.row(first, counter.count));
    visit(row, contact);
  }
}

}  // namespace brunt
