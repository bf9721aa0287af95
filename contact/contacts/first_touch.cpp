#include "contact/contacts/first_touch.hpp"

#include <algorithm>

namespace brunt {

const FirstTouch* FirstTouches::find(const ContactKey& key) const {
  const auto at = std::lower_bound(
      touches_.begin(), touches_.end(), key,
      [](const FirstTouch& one, const ContactKey& wanted) { return one.key < wanted; });
  return at == touches_.end() || !(at->key == key) ? nullptr : &*at;
}

const FirstTouch* FirstTouches::of_faces(GlobalId lower, GlobalId upper) const {
  return touches_.empty() ? nullptr : find({0, 0, lower, upper});
}

const FirstTouch* FirstTouches::of_particles(GlobalId lower, GlobalId upper) const {
  return touches_.empty() ? nullptr : find({2, 0, lower, upper});
}

const FirstTouch* FirstTouches::of_particle(GlobalId particle, Label body, Label piece) const {
  return touches_.empty() ? nullptr : find({1, 0, particle, surface_of(body, piece)});
}

}  // namespace brunt
