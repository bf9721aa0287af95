#include "app/deck/quality.hpp"

#include <algorithm>

#include "app/deck/deck.hpp"
#include "io/deck/node.hpp"

namespace brunt::deck {

const Levers& levers_of(Quality quality) {
  static const std::array<Levers, 3> kLevers{{
      {PairOptions{}.stiffness, Integration::one_point, 1.5},
      {PairOptions{}.stiffness, ElementOptions{}.integration, SphOptions{}.smoothing},
      {2, Integration::automatic, 1.7},
  }};
  return kLevers[slot_of(quality)];
}

Quality quality_of(const Node& root) {
  const Node* node = root.find("quality");
  const auto found =
      node ? std::find(kQualities.begin(), kQualities.end(), node->text) : kQualities.end();
  if (found == kQualities.end()) return Quality::standard;
  return static_cast<Quality>(found - kQualities.begin());
}

Deck deck_of(Quality quality) {
  Deck deck;
  deck.quality = quality;
  deck.contact.fallback.stiffness = levers_of(quality).contact_stiffness;
  return deck;
}

Body body_of(Quality quality) {
  Body body;
  body.element.integration = levers_of(quality).integration;
  body.sph.smoothing = levers_of(quality).smoothing;
  return body;
}

}  // namespace brunt::deck
