#include "app/cli/plan_pairs.hpp"

#include <algorithm>
#include <cmath>

#include "app/deck/findings.hpp"
#include "app/setup/bonds.hpp"
#include "app/setup/heat.hpp"

namespace brunt {

namespace {
/// A body's box and the mean velocity of its points.
struct MovingBox {
  std::array<Real, 3> low{}, high{}, velocity{};
  bool any = false;
};

MovingBox moving_box(const BodyView& view) {
  MovingBox box;
  const std::size_t n = view.position.size() / 3;
  const Field* velocity = field_named(view.point_fields, "velocity");
  for (std::size_t i = 0; i < n; ++i) {
    const Real radius = view.point_radius.empty() ? 0.0 : view.point_radius[i];
    for (std::size_t c = 0; c < 3; ++c) {
      const Real x = view.position[3 * i + c];
      if (!box.any) box.low[c] = x - radius, box.high[c] = x + radius;
      box.low[c] = std::min(box.low[c], x - radius);
      box.high[c] = std::max(box.high[c], x + radius);
      if (velocity != nullptr)
        box.velocity[c] += velocity->values[3 * i + c] / static_cast<Real>(n);
    }
    box.any = true;
  }
  return box;
}

const PairOptions& planned_options(const ContactOptions& options, Label a, Label b) {
  const auto found = options.pairs.find({std::min(a, b), std::max(a, b)});
  return found == options.pairs.end() ? options.fallback : found->second;
}

/// Why nothing acts between two bodies, "" where contact does.
std::string why_not(const deck::Body& a, const deck::Body& b, const PairOptions& options) {
  if (options.ignore) return "ignored by the deck";
  if (options.bonded) return "bonded: their particles are one sum";
  const bool still = a.rigid && b.rigid && !deck::follows_forces(a) && !deck::follows_forces(b);
  return still ? "both rigid, and no force moves them" : "";
}

std::string what_acts(const Deck& deck, std::size_t a, std::size_t b, const PairOptions& options) {
  const auto conducts = [&](std::size_t body) {
    return heat_mode(deck, deck.bodies[body].value, deck.bodies[body].name) == HeatMode::conducts ||
           is_heated_surface(deck, deck.bodies[body].value);
  };
  std::string text = options.has_friction() ? "friction" : "no friction";
  if (!options.passes_heat()) return text + ", no heat: none is given";
  const bool both = conducts(a) && conducts(b);
  return text + (both ? ", heat passes" : ", no heat: one of them keeps no temperature");
}

std::string when_they_meet(const Deck& deck, const MovingBox& a, const MovingBox& b) {
  if (!a.any || !b.any) return "";
  std::array<Real, 3> speed{};
  for (std::size_t c = 0; c < 3; ++c) speed[c] = b.velocity[c] - a.velocity[c];
  const Real time = meeting_time({a.low, b.low}, {a.high, b.high}, speed);
  if (time == 0) return "; near at time 0";
  if (time > deck.time.end) return "; apart, and as they move at time 0 they do not meet";
  return "; apart until about " + deck::time_text(deck.time.real(time));
}
}  // namespace

Real meeting_time(const std::array<std::array<Real, 3>, 2>& low,
                  const std::array<std::array<Real, 3>, 2>& high,
                  const std::array<Real, 3>& speed) {
  // Boxes that touch to a part of their sizes are near: neither rounding nor a first gap counts.
  constexpr Real kNear = 1e-3;
  Real enter = 0, leave = kInfinity;
  for (std::size_t c = 0; c < 3; ++c) {
    const Real room = kNear * std::max(high[0][c] - low[0][c], high[1][c] - low[1][c]);
    // low_2 + v t <= high_1 and high_2 + v t >= low_1
    const Real to_touch = high[0][c] + room - low[1][c], to_part = low[0][c] - room - high[1][c];
    if (speed[c] == 0) {
      if (to_touch < 0 || to_part > 0) return kInfinity;
      continue;
    }
    const Real one = to_touch / speed[c], other = to_part / speed[c];
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
  }
  return enter <= leave ? enter : kInfinity;
}

template <int Dim>
std::vector<PlannedPair> planned_pairs(const Deck& deck, const Scene<Dim>& scene) {
  const ContactOptions options = contact_options(deck);
  std::vector<MovingBox> boxes;
  for (Label body = 0; body < deck.bodies.size(); ++body) {
    boxes.push_back(moving_box(scene.view(body)));
  }
  std::vector<PlannedPair> pairs;
  for (Label a = 0; a < deck.bodies.size(); ++a) {
    for (Label b = a + 1; b < deck.bodies.size(); ++b) {
      const PairOptions& chosen = planned_options(options, a, b);
      PlannedPair pair{deck.bodies[a].name + "-" + deck.bodies[b].name, true, ""};
      pair.what = why_not(deck.bodies[a].value, deck.bodies[b].value, chosen);
      pair.modelled = pair.what.empty();
      if (pair.modelled) {
        pair.what = what_acts(deck, a, b, chosen) + when_they_meet(deck, boxes[a], boxes[b]);
      }
      pairs.push_back(std::move(pair));
    }
  }
  return pairs;
}

template std::vector<PlannedPair> planned_pairs(const Deck&, const Scene<2>&);
template std::vector<PlannedPair> planned_pairs(const Deck&, const Scene<3>&);

}  // namespace brunt
