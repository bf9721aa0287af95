#include "contact/contacts/lost.hpp"

#include <algorithm>

namespace brunt {

template <int Dim>
void LostContacts<Dim>::add(const LostContact<Dim>& contact) {
  const auto at = std::lower_bound(
      contacts_.begin(), contacts_.end(), contact.key,
      [](const LostContact<Dim>& one, const ContactKey& wanted) { return one.key < wanted; });
  if (at == contacts_.end() || !(at->key == contact.key)) contacts_.insert(at, contact);
}

template class LostContacts<2>;
template class LostContacts<3>;

}  // namespace brunt
