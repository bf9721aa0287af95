#include <algorithm>
#include <cmath>

#include "app/deck/findings.hpp"
#include "app/setup/bonds.hpp"
#include "app/setup/suspicious.hpp"

namespace brunt {

namespace {
/// A body as its box flies in a straight line.
template <int Dim>
struct Flight {
  BodyBox<Dim> box;                      ///< [m] at time 0, and what turns or rounds around it
  Vec<Dim> velocity = Vec<Dim>::Zero();  ///< [m/s]
  bool straight = true;                  ///< it flies so; else it may go anywhere

  BodyBox<Dim> swept(const Vec<Dim>& speed, Real time) const {
    BodyBox<Dim> all = box;
    all.add({box.low + speed * time, box.high + speed * time});
    return all;
  }
};

/// True where something may take a body off its straight line before it meets anything.
bool is_led(const Deck& deck, const std::string& name) {
  return std::any_of(deck.boundaries.begin(), deck.boundaries.end(), [&](const auto& boundary) {
    bool pushes = false;
    visit_given(boundary.value, [&](const auto& kind) { pushes = pushes || may_push(kind); });
    return boundary.value.body == name && pushes;
  });
}

template <int Dim>
Flight<Dim> flight_of(const Deck& deck, const Named<deck::Body>& named, const BodyBox<Dim>& box) {
  const auto& body = named.value;
  Flight<Dim> flight;
  flight.box = box;
  const bool prescribed = body.rigid && body.motion;
  const auto& spin = prescribed && body.motion->spin ? body.motion->spin : body.spin;
  flight.straight = !is_led(deck, named.name) && !(prescribed && spin) && !box.empty() &&
                    !deck::has_velocity_field(body) && !deck::has_changing_velocity(body);
  const auto take = [&](const std::vector<Real>& velocity) {
    for (std::size_t c = 0; c < std::min<std::size_t>(Dim, velocity.size()); ++c) {
      if (!std::isnan(velocity[c])) flight.velocity[static_cast<int>(c)] = velocity[c];
    }
  };
  take(body.velocity);
  if (prescribed) take(body.motion->velocity);
  Real more = body.size && !body.rigid ? *std::max_element(body.size->begin(), body.size->end())
                                       : 0.0;  // particles reach beyond their centres
  if (body.method == deck::Method::fe) more = 0;
  if (spin) more += box.lengths().norm();
  flight.box.low.array() -= more, flight.box.high.array() += more;
  return flight;
}

/// The time [s] at which two boxes meet on their ways, infinite where they never do.
template <int Dim>
Real meeting(const Flight<Dim>& a, const Flight<Dim>& b, const Vec<Dim>& speed) {
  Real from = 0, to = kInfinity;
  for (int c = 0; c < Dim; ++c) {
    const Real v = speed[c] - b.velocity[c];
    const Real up = b.box.low[c] - a.box.high[c], down = b.box.high[c] - a.box.low[c];
    if (v == 0) {
      if (up > 0 || down < 0) return kInfinity;
      continue;
    }
    from = std::max(from, std::min(up / v, down / v));
    to = std::min(to, std::max(up / v, down / v));
  }
  return from <= to ? from : kInfinity;
}

/// What was probably meant by a body that meets none of the others, "" where nothing is near.
template <int Dim>
std::string what_was_meant(const Deck& deck, const std::vector<Flight<Dim>>& flights,
                           std::size_t at, const std::vector<std::size_t>& others) {
  const auto& flight = flights[at];
  std::size_t nearest = others.front();
  Real least = kInfinity, later = kInfinity, opposite = kInfinity;
  std::size_t met_later = 0, met_opposite = 0;
  for (const std::size_t b : others) {
    const auto keep = [&](Real time, Real& first, std::size_t& who) {
      if (time < first) first = time, who = b;
    };
    keep(meeting<Dim>(flight, flights[b], flight.velocity), later, met_later);
    keep(meeting<Dim>(flight, flights[b], -flight.velocity), opposite, met_opposite);
    const Real gap = flight.swept(flight.velocity, deck.time.end).gap(flights[b].box).norm();
    keep(gap, least, nearest);
  }
  const auto name = [&](std::size_t b) { return "'" + deck.bodies[b].name + "'"; };
  if (later < kInfinity) {
    return "it would meet " + name(met_later) + " at " + deck::time_text(deck.time.real(later)) +
           ": a longer time.end or a smaller distance was probably meant";
  }
  if (opposite < kInfinity) {
    return name(met_opposite) + " lies behind it: the opposite direction was probably meant";
  }
  return "it passes " + name(nearest) + " at " + deck::length_text(least) +
         ": see where both stand, and the direction";
}
}  // namespace

template <int Dim>
void warn_of_missed_aims(const LoadedDeck& loaded, const Scene<Dim>& scene, const Warn& warn) {
  const Deck& deck = loaded.deck;
  if (deck.has_gravity()) return;
  const ContactOptions options = contact_options(deck);
  const auto boxes = boxes_of_bodies(scene);
  std::vector<Flight<Dim>> flights;
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    flights.push_back(flight_of<Dim>(deck, deck.bodies[b], boxes[b]));
  }
  const auto ignored = [&](std::size_t a, std::size_t b) {
    const auto found = options.pairs.find(
        {static_cast<Label>(std::min(a, b)), static_cast<Label>(std::max(a, b))});
    return found == options.pairs.end() ? options.fallback.ignore : found->second.ignore;
  };
  for (std::size_t a = 0; a < flights.size(); ++a) {
    const auto& flight = flights[a];
    if (!flight.straight || flight.velocity.isZero(0)) continue;
    std::vector<std::size_t> others;
    bool meets = false;
    for (std::size_t b = 0; b < flights.size(); ++b) {
      if (b == a || ignored(a, b)) continue;
      others.push_back(b);
      const auto way = flight.swept(flight.velocity, deck.time.end);
      const auto other = flights[b].swept(flights[b].velocity, deck.time.end);
      meets = meets || !flights[b].straight || way.gap(other).isZero(0);
    }
    if (meets || others.empty()) continue;
    const auto& [name, body] = deck.bodies[a];
    warn("bodies." + name + (body.rigid && body.motion ? ".motion.velocity" : ".velocity"),
         "in a straight line the body meets nothing until " +
             deck::time_text(deck.time.real(deck.time.end)) +
             " (time.end): " + what_was_meant<Dim>(deck, flights, a, others));
  }
}

template void warn_of_missed_aims<2>(const LoadedDeck&, const Scene<2>&, const Warn&);
template void warn_of_missed_aims<3>(const LoadedDeck&, const Scene<3>&, const Warn&);

}  // namespace brunt
