#pragma once
/// `time.process_speed: s`: a process of little inertia, cutting or forming, is stepped s times
/// faster than it runs. The deck is written in real times and speeds, and so are results; in
/// between stands the deck that is stepped, whose second is s seconds of the process.
///
/// What decides is a unit. Mass, length, temperature, force, energy and with them stress keep
/// theirs; each second left in a unit counts: a time is divided by s, a velocity, a rate and a
/// power are multiplied. Inertia alone is wrong then: it takes s^2 times the force.
#include <string_view>

#include "app/deck/deck.hpp"

namespace brunt::deck {

/// The power of time in an SI unit, with kg, N, J and Pa as units of their own: 1 of s, -1 of m/s,
/// W and kg m/s, -2 of m/s^2, 0 of Pa. Throws std::logic_error where it does not know the unit.
int time_power(std::string_view unit);

/// The deck that is stepped for a deck of real times: it with process_speed 1.
/// Left as they are: gravity, sound speeds of equations of state, wall times, references of
/// measures and columns of stop.when, which are real.
Deck stepped_deck(const Deck& given);

}  // namespace brunt::deck
