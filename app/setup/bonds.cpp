#include "app/setup/bonds.hpp"

#include <algorithm>

#include "app/setup/heat.hpp"

namespace brunt {

namespace {
bool is_of_particles(const deck::Body& body) {
  return body.method == deck::Method::sph && !body.rigid;
}

/// Options of each pair as the deck names them.
ContactOptions named_options(const Deck& deck) {
  ContactOptions options;
  options.fallback = deck.contact.fallback;
  options.search = deck.contact.search;
  options.skin = deck.contact.skin;
  options.safety = deck.time.safety;
  if (deck.has_gravity()) {
    options.gravity = deck::largest_gravity(deck.gravity, deck.time.end);
  }
  for (const auto& [name, pair] : deck.contact.pairs) {
    const Label first = *label_of(deck, pair.between[0]);
    const bool any = pair.between[1] == "any";
    const auto n = static_cast<Label>(deck.bodies.size());
    const Label begin = any ? 0 : *label_of(deck, pair.between[1]);
    for (Label other = begin; other < (any ? n : begin + 1); ++other) {
      const std::pair key{std::min(first, other), std::max(first, other)};
      if (any && options.pairs.count(key)) continue;  // a pair named in full has its own options
      options.pairs[key] = pair.options;
      // Contact counts the share of the body with the lower label.
      auto& split = options.pairs[key].friction_heat.split;
      if (split && first > other) split = 1 - *split;
      if (any) continue;
      options.pair_names[key] = name;
      if (first > other) options.turned.insert(key);
    }
  }
  return options;
}

const PairOptions& options_of(const ContactOptions& options, Label a, Label b) {
  const auto found = options.pairs.find({std::min(a, b), std::max(a, b)});
  return found == options.pairs.end() ? options.fallback : found->second;
}

/// The smallest label of those that are bonded with each body, over any way.
std::vector<Label> chains(const Deck& deck, const ContactOptions& options) {
  const auto n = static_cast<Label>(deck.bodies.size());
  std::vector<Label> toward(n);  // a smaller label of the same chain, or itself
  for (Label b = 0; b < n; ++b) toward[b] = b;
  const auto smallest_of = [&](Label b) {
    while (toward[b] != b) b = toward[b] = toward[toward[b]];
    return b;
  };
  const auto join = [&](Label a, Label b) {
    const auto [low, high] = std::minmax({smallest_of(a), smallest_of(b)});
    toward[high] = low;
  };
  for (const auto& [pair, of_pair] : options.pairs) {
    if (of_pair.bonded) join(pair.first, pair.second);
  }
  for (Label a = 0; options.fallback.bonded && a < n; ++a) {
    for (Label b = a + 1; b < n; ++b) {
      if (options_of(options, a, b).bonded) join(a, b);
    }
  }
  std::vector<Label> smallest(n);
  for (Label b = 0; b < n; ++b) smallest[b] = smallest_of(b);
  return smallest;
}

/// What must be the same in one sum; empty: nothing differs.
std::string difference(const SphOptions& a, const SphOptions& b) {
  if (a.kernel != b.kernel) return "kernel";
  if (a.smoothing != b.smoothing) return "smoothing";
  const bool viscosity =
      a.viscosity.alpha == b.viscosity.alpha && a.viscosity.beta == b.viscosity.beta;
  if (!viscosity) return "viscosity";
  if (a.formulation != b.formulation) return "formulation";
  if (a.hourglass != b.hourglass) return "hourglass";
  return a.xsph == b.xsph ? "" : "xsph";
}

/// Why two bodies cannot be bonded; empty: they can.
std::string obstacle(const Deck& deck, Label first, Label second) {
  for (const Label label : {first, second}) {
    const auto& [name, body] = deck.bodies[label];
    if (!is_of_particles(body)) {
      return "only bodies of particles (method: sph) share a sum, and '" + name + "' is not one";
    }
  }
  const auto &a = deck.bodies[first], &b = deck.bodies[second];
  const std::string differs = difference(a.value.sph, b.value.sph);
  if (!differs.empty()) {
    return "'" + a.name + "' and '" + b.name + "' share one sum and need the same `" + differs +
           "`";
  }
  if (group_kind(deck, a.value, a.name) == group_kind(deck, b.value, b.name)) return "";
  const bool first_conducts = group_kind(deck, a.value, a.name).conducts;
  return "'" + (first_conducts ? a : b).name + "' conducts heat and '" +
         (first_conducts ? b : a).name + "' does not: its material needs thermal with k and cp";
}
}  // namespace

ContactOptions contact_options(const Deck& deck) {
  ContactOptions options = named_options(deck);
  const auto chain = chains(deck, options);
  for (Label a = 0; a < chain.size(); ++a) {
    if (std::count(chain.begin(), chain.end(), chain[a]) == 1) continue;
    for (Label b = a; b < chain.size(); ++b) {
      if (chain[a] != chain[b]) continue;
      auto pair = options_of(options, a, b);
      pair.bonded = true;
      options.pairs[{a, b}] = pair;
    }
  }
  return options;
}

std::vector<Label> first_bonded(const Deck& deck) {
  const auto& pairs = deck.contact.pairs;
  const bool any = std::any_of(pairs.begin(), pairs.end(),
                               [](const auto& pair) { return pair.value.options.bonded; });
  // Asked for every body: without bonds the options of all pairs need not be put together.
  return chains(deck, any || deck.contact.fallback.bonded ? named_options(deck) : ContactOptions{});
}

std::vector<Label> bonded_with(const Deck& deck, Label body) {
  const auto chain = first_bonded(deck);
  std::vector<Label> bodies;
  for (Label b = 0; b < chain.size(); ++b) {
    if (chain[b] == chain[body]) bodies.push_back(b);
  }
  return bodies;
}

template <int Dim>
std::vector<Label> sums_of_pieces(const Deck& deck, const std::vector<BodyGeometry<Dim>>& bodies) {
  const ContactOptions options = contact_options(deck);
  const auto chain = chains(deck, options);
  std::vector<Label> first_piece(deck.bodies.size()), sums;
  for (const auto& body : bodies) {
    const Label whole = chain[body.label];
    const Label begin = static_cast<Label>(sums.size());
    first_piece[body.label] = begin;
    const bool one = options_of(options, body.label, body.label).bonded;
    for (Label piece = begin; piece < begin + body.piece_names.size(); ++piece) {
      sums.push_back(one ? first_piece[whole] : piece);
    }
  }
  return sums;
}

void check_bonds(const LoadedDeck& loaded, std::vector<DeckProblem>& problems) {
  const Deck& deck = loaded.deck;
  const auto n = static_cast<Label>(deck.bodies.size());
  const auto refuse = [&](const std::string& path, Label first, Label second) {
    const std::string why = obstacle(deck, first, second);
    if (!why.empty()) problems.push_back(loaded.places.problem(path + ".bonded", why));
    return !why.empty();
  };
  const auto refuse_any = [&](const std::string& path, Label first) {
    for (Label other = 0; other < n; ++other) {
      if (refuse(path, first, other)) return true;
    }
    return false;
  };
  if (deck.contact.fallback.bonded) {
    for (Label body = 0; body < n; ++body) {
      if (refuse_any("contact.default", body)) return;
    }
  }
  for (const auto& [name, pair] : deck.contact.pairs) {
    if (!pair.options.bonded || deck.contact.fallback.bonded) continue;
    const Label first = *label_of(deck, pair.between[0]);
    if (pair.between[1] == "any") {
      refuse_any("contact.pairs." + name, first);
    } else {
      refuse("contact.pairs." + name, first, *label_of(deck, pair.between[1]));
    }
  }
}

template std::vector<Label> sums_of_pieces<2>(const Deck&, const std::vector<BodyGeometry<2>>&);
template std::vector<Label> sums_of_pieces<3>(const Deck&, const std::vector<BodyGeometry<3>>&);

}  // namespace brunt
