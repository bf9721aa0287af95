#include "app/deck/boundaries.hpp"

#include <string>

namespace brunt::deck {

namespace {
/// "fix, velocity or force": the keys of all kinds.
std::string all_keys(const BoundaryKinds& kinds) {
  std::string keys;
  const auto add = [&](const auto& kind) {
    keys += (keys.empty() ? "" : ", ") + std::string(kind.deck_keys);
  };
  std::apply([&](const auto&... kind) { (add(kind), ...); }, kinds);
  return keys.replace(keys.rfind(", "), 2, " or ");
}
}  // namespace

void describe(Schema& s, Boundary& boundary) {
  s.text({"body", "name of a body", Need::required}, boundary.body);
  s.one_of({"where", "which of its points, at time 0", Need::required}, boundary.where);
  std::apply([&](auto&... kind) { (describe(s, kind), ...); }, boundary.kinds);
  s.real({"from", "acts from this time"}, boundary.from, {"s", at_least(0)});
  s.real({"to", "acts until this time; default: for ever"}, boundary.to, {"s", at_least(0)});
  bool acts = false;
  visit_given(boundary, [&](const auto&) { acts = true; });
  s.require(acts, "", "needs " + all_keys(boundary.kinds));
  s.require(boundary.from < boundary.to, "to", "must be after from");
}

void describe(Schema& s, Damping& damping) {
  s.real({"rate", "force is minus rate times mass times velocity", Need::required}, damping.rate,
         {"1/s", at_least(0)});
  s.real({"until", "acts until this time; default: for ever"}, damping.until, {"s", positive()});
}

}  // namespace brunt::deck
